# input.sh: bad models through the command: the right exit code, FILE:LINE, and no picture.
. "$(dirname "$0")/lib.sh"

# bad STATUS WORDS: t.obj gives this, and nothing is written.
bad() {
    expect "$1" "$2" render t.obj --size 8x8
    [ ! -e t.png ] || failed 'a picture was written'
}
# good WORDS
good() {
    expect 0 "$1" render t.obj --size 8x8
    [ -s t.png ] || failed 'no picture'
    rm -f t.png
}

test_a_missing_model() {
    bad 3 '^error: t.obj: .*No such file or directory'
    expect 3 'directory' render . -o p.png
    mkfifo fifo.obj
    expect 3 'device or pipe' render fifo.obj
    expect 3 'device or pipe' render /dev/zero -o p.png
    expect 3 '' render /dev/full -o p.png
}

test_no_drawable_geometry_is_an_error() {
    : >t.obj
    bad 1 '^error: t.obj: .*no drawable geometry'
    printf 'v 0 0 0\nv 1 0 0\nl 1 2\np 1\n' >t.obj
    bad 1 'no drawable geometry'
    printf '\377\376v\0 \0001\0\n\0' >t.obj
    bad 1 '^error: t.obj'
}

test_a_bad_index_names_its_line() {
    for index in 0 4 -4 99999999999999999999 x; do
        printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 %s\n' "$index" >t.obj
        bad 1 '^error: t.obj:5: '
    done
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n' >t.obj
    good '1 drawn'
}

test_faults_are_counted_and_strict_makes_them_errors() {
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1e999 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\nf 1 2\n' >t.obj
    good '^warning: t.obj: 2 faces dropped'
    good '; [0-9]+ warnings?$'
    expect 1 '^error: t.obj:[0-9]+: ' render t.obj --strict
    expect_files t.obj
}

test_missing_materials_are_one_warning_a_name() {
    printf 'mtllib no.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl gold\nf 1 2 3\nusemtl gold\nf 3 2 1\n' >t.obj
    good "^warning: .*no.mtl"
    good "^warning: .*gold"
    [ "$(grep -c gold "$stderr")" = 1 ] || failed 'more than one warning for gold'
}

test_files_outside_are_refused_unless_allowed() {
    mkdir in
    printf 'newmtl m\nKd 1 0 0\n' >out.mtl
    printf 'mtllib ../out.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n' >in/t.obj
    expect 0 'warning: .*out.mtl' render in/t.obj --size 8x8 -o a.ppm
    expect 0 '' render in/t.obj --size 8x8 -o b.ppm --allow-outside
    if grep -q 'warning: .*out.mtl' "$stderr"; then failed 'refused although allowed'; fi
    differ a.ppm b.ppm
}

test_line_ends_do_not_matter() {
    make_triangle
    "$RASTER" render t.obj --size 20x20 -q -o lf.ppm
    printf 'v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3' >t.obj
    "$RASTER" render t.obj --size 20x20 -q -o crlf.ppm
    printf '\357\273\277v 0 0 0\rv 1\t0 0\rv 0 1 \\\r0\rf 1 2 3\r' >t.obj
    "$RASTER" render t.obj --size 20x20 -q -o cr.ppm
    same lf.ppm crlf.ppm
    same lf.ppm cr.ppm
}

test_binary_junk_ends() {
    head -c 300000 "$RASTER" >t.obj
    run render t.obj --size 8x8
    [ "$status" = 1 ] || failed "exit code $status"
    head -c 20000000 /dev/zero | tr '\0' '1' >t.obj
    run render t.obj --size 8x8
    [ "$status" = 1 ] || failed "a line of 20 MB: exit code $status"
    [ "$(wc -c <"$stderr")" -lt 8000 ] || failed 'a very long message'
}

test_huge_coordinates_give_a_picture_or_nothing() {
    printf 'v -1e38 0 0\nv 1e38 0 0\nv 0 1e38 0\nf 1 2 3\n' >t.obj
    run render t.obj --size 64x64
    [ "$status" -le 2 ] || failed "exit code $status"
    make_triangle
    expect 0 '' render t.obj --size 64x64 --camera-position 0,0,1e-3 --camera-focal-point 0,0,0 --near 1e-4 --far 1e4
    expect 0 'nothing of the model is in view' render t.obj --size 8x8 --camera-position 0,0,5 --camera-focal-point 0,0,9
}

run_tests "$@"
