# explain.sh: `raster diff --explain`: two pictures of a model, and why they differ.
. "$(dirname "$0")/lib.sh"

# Two sheets, one before the other, of different materials.
make_sheets() {
    printf 'newmtl red\nKd 0.9 0.1 0.1\nnewmtl blue\nKd 0.1 0.2 0.9\n' >m.mtl
    cat >m.obj <<'OBJ'
mtllib m.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
v -0.5 -0.6 0.5
v 1.4 -0.6 0.5
v 1.4 0.7 0.5
v -0.5 0.7 0.5
usemtl red
f 1 2 3 4
usemtl blue
f 5 6 7 8
OBJ
}

draw() { # draw FILE FLAG...
    local out=$1
    shift
    run render m.obj --size 60x45 --camera-position 0,0,5 --camera-focal-point 0,0,0 -q -o "$out" "$@"
    [ "$status" = 0 ] || failed "render $out"
}
camera='--camera-position 0,0,5 --camera-focal-point 0,0,0'

test_equal_pictures_need_no_explanation() {
    make_sheets
    draw a.png
    draw b.png
    # shellcheck disable=SC2086
    expect 0 '' diff a.png b.png --explain m.obj $camera
    grep -q why "$stdout" && failed 'something is explained'
}

test_a_missing_triangle_is_named() {
    make_sheets
    draw a.png
    sed 's/^f 5 6 7 8/f 5 6 7/' m.obj >less.obj
    run render less.obj --size 60x45 --camera-position 0,0,5 --camera-focal-point 0,0,0 -q -o b.png --near 4 --far 6
    run render m.obj --size 60x45 --camera-position 0,0,5 --camera-focal-point 0,0,0 -q -o a.png --near 4 --far 6
    # shellcheck disable=SC2086
    run diff a.png b.png --explain m.obj $camera --near 4 --far 6
    [ "$status" = 1 ] || failed "exit code $status"
    expect_out '1. missing triangle: the actual picture shows what lies below triangle 4'
    expect_out 'pixel \([0-9]+,[0-9]+\): WON, triangle 4 by depth; 1 other lost'
    # shellcheck disable=SC2086
    run diff a.png b.png --explain m.obj $camera --near 4 --far 6 --json
    expect_out '"cause": *"missing triangle"'
    ! command -v python3 >/dev/null || python3 -m json.tool "$stdout" >/dev/null || failed 'not JSON'
}

test_another_colour_is_shading() {
    make_sheets
    draw a.png
    sed -i 's/Kd 0.1 0.2 0.9/Kd 0.1 0.8 0.3/' m.mtl
    draw b.png
    # shellcheck disable=SC2086
    run diff a.png b.png --explain m.obj $camera
    [ "$status" = 1 ] || failed "exit code $status"
    expect_out '1. shading: triangle [34] has another colour in the expected picture'
}

test_mistakes_are_told() {
    make_sheets
    draw a.png
    draw b.png --shade flat --light ambient:color=0.5
    run diff a.png b.png --explain missing.obj
    [ "$status" = 2 ] || failed "exit code $status for a missing model"
    grep -q '^error: missing.obj' "$stderr" || failed 'the missing model is not named'
    run diff a.png b.png --explain m.obj --size 50x50
    [ "$status" = 2 ] || failed "exit code $status for another size"
    mkdir x y
    cp a.png x
    cp b.png y/a.png
    run diff x y --explain m.obj
    [ "$status" = 2 ] || failed "exit code $status for folders"
}

run_tests "$@"
