# picture.sh: what flags do to the picture, and what must not change it.
. "$(dirname "$0")/lib.sh"

# The colour of a pixel of a PPM: ppm_pixel FILE X Y gives "r g b".
ppm_pixel() {
    local width height offset
    read -r width height < <(sed -n 2p "$1")
    offset=$(($(wc -c <"$1") - 3 * width * height + 3 * ($3 * width + $2)))
    od -An -tu1 -j "$offset" -N 3 "$1" | tr -s ' ' | sed 's/^ //'
}

# draw NAME FLAG...: the teapot in small.
draw() {
    local name=$1
    shift
    expect 0 '' render "$SOURCE/models/teapot.obj" --size 160x120 -o "$name" "$@"
}

test_the_same_bytes_for_every_number_of_threads() {
    for format in png ppm pfm; do
        draw 1.$format --threads 1 --aov depth.pfm,normal.pfm,triangle.pfm,overdraw.pfm,diffuse
        for threads in 2 3 7; do
            draw $threads.$format --threads $threads --aov depth.pfm,normal.pfm,triangle.pfm,overdraw.pfm,diffuse
            same 1.$format $threads.$format
            for plane in depth.pfm normal.pfm triangle.pfm overdraw.pfm diffuse.png; do same 1.$plane $threads.$plane; done
        done
    done
    draw again.png --threads 3
    draw default.png
    same 1.png again.png
    same 1.png default.png
}

test_the_same_bytes_where_things_are_seen_through() {
    local flags=(--material alpha=0.5 --cull none)
    draw 1.png --threads 1 "${flags[@]}"
    draw 3.png --threads 3 "${flags[@]}"
    same 1.png 3.png
    draw 1.png --threads 1 --hidden painter "${flags[@]}"
    draw 3.png --threads 3 --hidden painter "${flags[@]}"
    same 1.png 3.png
}

test_planes_do_not_change_the_picture() {
    for shade in flat gouraud phong; do
        draw a.png --shade $shade
        draw b.png --shade $shade --aov normal,ambient,specular.pfm,emission,overdraw
        same a.png b.png
    done
}

test_the_hash_is_of_the_pixels() {
    draw a.png --hash
    expect_out '^[0-9a-f]{16}  a.png$'
    cut -c 1-16 "$stdout" >1
    draw a.ppm --hash
    cut -c 1-16 "$stdout" >2
    same 1 2
    draw a.ppm --hash --background 0.21
    cut -c 1-16 "$stdout" >3
    differ 1 3
    # FNV-1a of 1 0 0 0  1 0 0 0  51 51 51 255, computed by hand.
    make_triangle
    expect 0 '' render t.obj --size 1x1 --hash -o a.png --camera-position 0,0,5 --camera-focal-point 0,0,9
    expect_out '^75fb80ba0858d5cd  a.png$'
    run render t.obj --size 8x8 --hash -o -
    grep -qE '^[0-9a-f]{16}  -$' "$stderr" || failed 'no hash on standard error'
}

test_every_flag_changes_something() {
    draw plain.ppm
    local flags
    while read -r flags; do
        # shellcheck disable=SC2086
        draw other.ppm $flags
        if cmp -s plain.ppm other.ppm; then failed "$flags changes nothing"; fi
    done <<'FLAGS'
--shade flat
--shade gouraud
--reflectance phong
--reflectance lambert
--light directional:dir=-1,-1,-1
--light head:intensity=0.5
--light head:color=#ff8000
--light point:pos=0,9,9
--light spot:pos=0,9,9:dir=0,-1,-1:cutoff=20
--light ambient:color=0.4
--light head --light ambient:color=0.1
--material color=#ff0000
--material shininess=5
--material specular=0
--material emission=0.3
--material ambient=1,0,0
--material alpha=0.5
--material gold
--material clay:roughness=0.9
--material satin
--material reflectance=velvet
--material metallic=1
--material sheen=1
--material clearcoat=1
--material clearcoat=1:clearcoat_roughness=0.5
--reflectance he-torrance
--no-two-sided
--hidden painter
--cull back
--cull front
--background 1
--camera-position 0,3,12
--camera-focal-point 1,0,0
--up +Z
--up -Y
--camera-view-angle 60
--camera-azimuth-angle 40
--camera-azimuth 40
--camera-elevation-angle 20
--near 9
--far 9
FLAGS
    draw other.ppm --crease-angle 0
    same plain.ppm other.ppm # the file has normals
}

test_both_fill_rules_own_each_pixel_once() {
    # Two triangles of a square whose edges meet pixel centres: 4x4 pixels, corners on centres.
    printf 'v -0.5 -0.5 0\nv 0.5 -0.5 0\nv 0.5 0.5 0\nv -0.5 0.5 0\nf 1 2 3\nf 1 3 4\n' >t.obj
    local camera=(--size 4x4 --camera-position 0,0,1 --camera-focal-point 0,0,0 --camera-view-angle 90 --near 0.5 --far 2)
    for rule in opengl direct3d; do
        expect 0 '' render t.obj "${camera[@]}" --fill-rule $rule -o $rule.ppm --aov overdraw.pfm
        # The counts are 0 or 1, never 2 (0x40000000), and 4 are 1 (0x3f800000).
        tail -c 64 $rule.overdraw.pfm | od -An -v -w4 -tx4 | tr -d ' ' | sort | uniq -c | tr -s ' ' >counts
        if grep -q 40000000 counts; then failed 'a pixel was drawn twice'; fi
    done
}

test_a_transparent_background_gives_an_alpha_channel() {
    make_triangle
    expect 0 '' render t.obj --size 8x8 -o a.png
    od -An -tu1 -j 25 -N 1 a.png | grep -q 2 || failed 'an opaque picture is not RGB'
    for background in transparent 0,0,0,0 '#00000080' '1,1,1,0.5'; do
        expect 0 '' render t.obj --size 8x8 -o a.png --background "$background"
        od -An -tu1 -j 25 -N 1 a.png | grep -q 6 || failed 'a transparent picture is not RGBA'
    done
}

test_the_background_is_what_is_asked_for() {
    make_triangle
    local color
    while read -r color expected; do
        expect 0 '' render t.obj --size 9x9 -o a.ppm --background "$color"
        [ "$(ppm_pixel a.ppm 8 0)" = "$expected" ] || failed "$color gives $(ppm_pixel a.ppm 8 0)"
    done <<'COLORS'
#ff8001 255 128 1
#f80 255 136 0
1,0.5,0 255 128 0
0.2 51 51 51
0 0 0 0
COLORS
    expect 0 '' render t.obj --size 9x9 -o a.ppm
    [ "$(ppm_pixel a.ppm 8 0)" = '51 51 51' ] || failed 'the default background'
}

test_lit_from_the_front_a_white_wall_is_white() {
    printf 'v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n' >t.obj
    local camera=(--size 3x3 --camera-position 0,0,5 --camera-focal-point 0,0,0)
    expect 0 '' render t.obj "${camera[@]}" -o a.ppm --light directional:dir=-Z --material color=1:specular=0
    [ "$(ppm_pixel a.ppm 1 1)" = '255 255 255' ] || failed "white is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render t.obj "${camera[@]}" -o a.ppm --light directional:dir=-Z:intensity=0.5:color=1,0.5,0 \
        --material color=1:specular=0
    [ "$(ppm_pixel a.ppm 1 1)" = '128 64 0' ] || failed "half of orange is $(ppm_pixel a.ppm 1 1)"
    # min(1 / (c1 + c2 d + c3 d^2), 1) with d = 2: 1/(1 + 2 + 2) = 0.2
    expect 0 '' render t.obj "${camera[@]}" -o a.ppm --light point:pos=0,0,2:decay=1,1,0.5 --material color=1:specular=0
    [ "$(ppm_pixel a.ppm 1 1)" = '51 51 51' ] || failed "a fifth is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render t.obj "${camera[@]}" -o a.ppm --light ambient:color=0.2 --material color=1
    [ "$(ppm_pixel a.ppm 1 1)" = '51 51 51' ] || failed "ambient light gives $(ppm_pixel a.ppm 1 1)"
}

test_the_display_encodes_light_and_leaves_the_background() {
    printf 'v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n' >t.obj
    local grey=(t.obj --size 3x3 --camera-position 0,0,5 --camera-focal-point 0,0,0 --light ambient:color=0.25
        --material color=1)
    expect 0 '' render "${grey[@]}" -o a.ppm
    [ "$(ppm_pixel a.ppm 1 1)" = '64 64 64' ] || failed "plain light is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render "${grey[@]}" -o b.ppm --display plain
    same a.ppm b.ppm
    expect 0 '' render "${grey[@]}" -o a.ppm --display srgb
    [ "$(ppm_pixel a.ppm 1 1)" = '137 137 137' ] || failed "encoded light is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render "${grey[@]}" -o a.ppm --exposure 1
    [ "$(ppm_pixel a.ppm 1 1)" = '128 128 128' ] || failed "a stop more is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render "${grey[@]}" -o a.ppm --exposure 1 --display srgb
    [ "$(ppm_pixel a.ppm 1 1)" = '188 188 188' ] || failed "a stop more, encoded, is $(ppm_pixel a.ppm 1 1)"
    expect 0 '' render "${grey[@]}" -o a.pfm --display srgb --exposure -1
    [ "$(tail -c 4 a.pfm | od -An -tf4 | tr -d ' ')" = 0.125 ] || failed 'a PFM file does not hold light'

    make_triangle
    for flags in '--display plain' '--display srgb' '--exposure 3' '--exposure -2 --display srgb'; do
        # shellcheck disable=SC2086
        expect 0 '' render t.obj --size 9x9 -o a.ppm --background 0.2 $flags
        [ "$(ppm_pixel a.ppm 8 0)" = '51 51 51' ] || failed "$flags: the background is $(ppm_pixel a.ppm 8 0)"
    done
    expect 2 "'sRGB' is none of auto, srgb, plain" render t.obj --display sRGB
    expect 2 'STOPS|from -30 to 30' render t.obj --exposure 31
}

test_the_display_is_srgb_where_a_material_is_physical() {
    draw plain.ppm --display plain
    draw auto.ppm
    same plain.ppm auto.ppm
    for flags in '--material gold' '--reflectance oren-nayar'; do
        # shellcheck disable=SC2086
        draw auto.ppm $flags
        # shellcheck disable=SC2086
        draw srgb.ppm $flags --display srgb
        same auto.ppm srgb.ppm
    done
    printf 'newmtl a\nKd 0.5 0.5 0.5\nPr 0.5\n' >t.mtl
    printf 'mtllib t.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >t.obj
    expect 0 '' render t.obj --size 32x24 -o auto.ppm
    expect 0 '' render t.obj --size 32x24 -o srgb.ppm --display srgb
    same auto.ppm srgb.ppm
    sed -i /Pr/d t.mtl
    expect 0 '' render t.obj --size 32x24 -o auto.ppm
    expect 0 '' render t.obj --size 32x24 -o srgb.ppm --display srgb
    differ auto.ppm srgb.ppm
}

test_textures_are_decoded_for_an_srgb_display_only() {
    cp "$SOURCE"/models/checker* .
    expect 0 '' render checker_cube.obj --size 40x30 -o plain.pfm --display plain
    expect 0 '' render checker_cube.obj --size 40x30 -o srgb.pfm --display srgb
    differ plain.pfm srgb.pfm
    expect 0 '' render checker_cube.obj --size 40x30 -o plain.pfm --display plain --no-textures
    expect 0 '' render checker_cube.obj --size 40x30 -o srgb.pfm --display srgb --no-textures
    differ plain.pfm srgb.pfm # in the background
}

# Pixels of a PPM of the cube that are not the background.
cube_pixels() {
    expect 0 '' render "$SOURCE/models/cube.obj" --size 100x100 --background 0 -o cube.ppm "$@"
    tail -c 30000 cube.ppm | od -An -v -tu1 -w3 | grep -cv ' 0 *0 *0'
}

test_wireframes_and_points() {
    local surface wide thin front points
    surface=$(cube_pixels)
    wide=$(cube_pixels --style wireframe --line-width 5)
    thin=$(cube_pixels --style wireframe)
    front=$(cube_pixels --style wireframe --cull back)
    points=$(cube_pixels --style points --point-size 4)
    [ "$surface" -gt "$wide" ] && [ "$wide" -gt "$thin" ] && [ "$thin" -gt "$front" ] && [ "$front" -gt "$points" ] ||
        failed "pixels: $surface $wide $thin $front $points"
    [ "$points" = $((8 * 16)) ] || failed "$points pixels in 8 points of 4 x 4"
    expect 0 '12 triangles: 30 edges drawn' render "$SOURCE/models/cube.obj" --style wireframe
    expect 0 '' render "$SOURCE/models/cube.obj" --style wireframe --hidden painter -o painter.png
    expect 2 'is none of surface, wireframe, points' render "$SOURCE/models/cube.obj" --style lines
    expect 2 '1 to 100' render "$SOURCE/models/cube.obj" --style points --point-size 0
    expect 2 'whole|1 to 100' render "$SOURCE/models/cube.obj" --line-width 1.5
    expect 2 '' render "$SOURCE/models/cube.obj" --style wireframe --bug no-cull
}

run_tests "$@"
