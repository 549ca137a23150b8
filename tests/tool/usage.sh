# usage.sh: wrong flags and values are usage errors (exit 2), told before anything is read or written.
. "$(dirname "$0")/lib.sh"

test_a_size_is_strict() {
    make_triangle
    for size in 12x x12 12 0x10 10x0 -5x5 5x-5 65536x65536 16385x1 1x16385 16384x16384 12x12x12 1.5x2 '' ' 8x8' 8X8 \
        99999999999999999999x1 1x99999999999999999999 0x0 nanxnan 1e2x1e2 '8x8 '; do
        expect 2 '^error: --size' render t.obj --size "$size"
    done
    expect_files t.obj
    run render --help
    expect_out '16384'
}

test_a_wrong_size_is_told_before_memory_is_taken() {
    skip_with_sanitizers || return 0
    make_triangle
    (
        ulimit -v 400000
        "$RASTER" render t.obj --size 65536x65536
    ) >"$stdout" 2>"$stderr"
    status=$?
    check 2 'size' 'under ulimit -v'
    expect_files t.obj
}

test_threads_are_counted_from_1() {
    make_triangle
    for threads in 0 -1 1000000 257 1.5 two '' 99999999999999999999; do
        expect 2 '^error: --threads' render t.obj --threads "$threads"
    done
    expect_files t.obj
    expect 0 '' render t.obj --threads 256 --size 8x8
}

test_numbers_are_finite() {
    make_triangle
    for bad in nan,0,0 0,inf,0 1e999,0,0 1,2 1,2,3,4 '' a,b,c 1,,2; do
        expect 2 '^error: --camera-position' render t.obj --camera-position "$bad"
        expect 2 '^error: --camera-focal-point' render t.obj --camera-focal-point "$bad"
        expect 2 '^error: --up' render t.obj --up "$bad"
    done
    expect_files t.obj
}

test_a_camera_that_sees_nothing_is_named() {
    make_triangle
    expect 2 '^error: --camera-position' render t.obj --camera-position 1,2,3 --camera-focal-point 1,2,3
    expect 2 '^error: --up' render t.obj --camera-position 0,5,0 --camera-focal-point 0,0,0 --up +Y
    expect 2 '^error: --up' render t.obj --camera-position 0,-5,0 --camera-focal-point 0,0,0
    expect 2 '^error: --up' render t.obj --up 0,0,0
    for angle in 0 -30 180 200 nan inf ''; do
        expect 2 '^error: --camera-view-angle' render t.obj --camera-view-angle "$angle"
    done
    for distance in 0 -1 nan inf; do
        expect 2 '^error: --near' render t.obj --near "$distance"
        expect 2 '^error: --far' render t.obj --far "$distance"
    done
    expect 2 '^error: --far' render t.obj --near 2 --far 2
    expect 2 '^error: --far' render t.obj --near 3 --far 2
    expect 2 '^error: --far' render t.obj --near 1e6
    expect_files t.obj
}

test_a_camera_mistake_is_told_before_the_model_is_read() {
    expect 2 '^error: --camera-position' render missing.obj --camera-position 1,2,3 --camera-focal-point 1,2,3
    expect 2 '^error: --up' render missing.obj --camera-position 0,5,0 --camera-focal-point 0,0,0
    expect 2 '^error: --far' render missing.obj --near 3 --far 2
}

test_the_nearest_flag_is_suggested() {
    make_triangle
    expect 2 "unknown flag '--siez'; did you mean --size" render t.obj --siez 8x8
    expect 2 "unknown flag '--siez'; did you mean --size" render --siez=8x8
    expect 2 "unknown flag '--camera-positon'; did you mean --camera-position" render t.obj --camera-positon 1,2,3
    expect 2 "unknown flag '--xyzzy'$" render t.obj --xyzzy
    expect 2 "unknown flag '-z'" render t.obj -z
    expect 2 "unknown command 'rendr'; did you mean render" rendr t.obj
    expect 2 "did you mean raster render t.obj" t.obj
    expect 2 'one argument too many' render t.obj u.obj
    expect 2 'MODEL' render
    expect 2 'size.*missing|missing' render t.obj --size
    expect_files t.obj
}

test_words_are_checked() {
    make_triangle
    expect 2 "--shade: 'fong' is none of flat, gouraud, phong; did you mean phong" render t.obj --shade fong
    expect 2 "--reflectance: 'blin-phong'.*did you mean blinn-phong" render t.obj --reflectance blin-phong
    expect 2 "--hidden: 'scanline' is not yet possible; what works: zbuffer, painter" render t.obj --hidden scanline
    for samples in 4 8 16; do
        expect 2 "--samples: '$samples' is not yet possible; what works: 1" render t.obj --samples $samples
    done
    for samples in 0 2 -1 '' one; do expect 2 '--samples' render t.obj --samples "$samples"; done
    expect 2 '--cull' render t.obj --cull both
    expect 2 '--fill-rule' render t.obj --fill-rule vulkan
    expect 2 '--texture-filter' render t.obj --texture-filter linear
    expect 2 '--texture-wrap' render t.obj --texture-wrap border
    expect 2 '--progress' render t.obj --progress yes
    for angle in -1 181 nan ''; do expect 2 '--crease-angle' render t.obj --crease-angle "$angle"; done
    for count in 0 -1 3601 x; do expect 2 '--turntable' render t.obj --turntable "$count"; done
    for color in red 1,2 -1 '#12' '#gggggg' 2 0.5,0.5,1.5 nan; do
        expect 2 '--background' render t.obj --background "$color"
    done
    expect 2 "--aov: 'dept' is none of .*; did you mean depth" render t.obj --aov dept
    expect 2 '--aov' render t.obj --aov depth.jpg
    expect 2 '--aov' render t.obj --aov ''
    expect_files t.obj
}

test_lights_and_materials_are_checked() {
    make_triangle
    for light in sun '' directional:dir=0,0,0 directional:dir=1,2 directional:pos=0,0,0 point:pos=nan,0,0 \
        point:decay=0,0,0 point:decay=-1,0,0 spot:cutoff=181 spot:cutoff=-1 spot:falloff=-1 point:color=-1 \
        point:intensity=-1 point:space=moon head:dir=0,0,1 ambient:color= point:pos point:=1 point::; do
        expect 2 '^error: --light' render t.obj --light "$light"
    done
    expect 2 "did you mean directional" render t.obj --light directionl
    for material in gould gold:x=1 reflectance=shiny color shininess=1001 shininess=-1 alpha=2 color=-1 colour=1 '' x=1 =; do
        expect 2 '^error: --material' render t.obj --material "$material"
    done
    expect 2 "'gold:alpha=1:alpha=0.5' has 'alpha' twice" render t.obj --material gold:alpha=1:alpha=0.5
    expect 2 "has 'pos' twice" render t.obj --light point:pos=1,2,3:pos=1,2,3
    expect 2 "did you mean shininess" render t.obj --material shinines=5
    expect 2 "did you mean gold" render t.obj --material golt
    expect 2 "did you mean oren-nayar" render t.obj --material reflectance=oren-naya
    expect_files t.obj
}

test_a_light_takes_one_value_and_no_file_names() {
    make_triangle
    expect 0 '' render --size 8x8 --light head --light ambient:color=0.1 t.obj
    expect_files t.obj t.png
}

test_values_may_begin_with_a_minus() {
    make_triangle
    expect 0 '' render t.obj --size 8x8 --camera-position -3,-1,5 --up -Y
    expect 0 '' render t.obj --size=8x8 --camera-position=-3,-1,5
}

test_a_file_name_may_begin_with_a_minus() {
    make_triangle ./-t.obj
    expect 0 '' render --size 8x8 -- -t.obj
    [ -f ./-t.png ] || failed "no -t.png"
}

test_the_last_one_counts() {
    make_triangle
    expect 0 ': 8x9,' render t.obj --size 100x100 --size 8x9
}

test_help_knows_the_commands() {
    local command
    for command in render diff approve; do
        expect 0 '' help $command
        cp "$stdout" by_word
        expect 0 '' $command --help
        same by_word "$stdout"
    done
    expect 0 '' help
    expect_out 'render +'
}

run_tests "$@"
