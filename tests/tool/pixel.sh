# pixel.sh: `raster pixel` as a program: the right pixel of the right picture, in words and as JSON.
. "$(dirname "$0")/lib.sh"

json() { # json EXPRESSION: of d, the JSON that was printed
    python3 -c "import json,sys; d=json.load(open(sys.argv[1])); print($1)" "$stdout"
}
has_python() { command -v python3 >/dev/null; }

test_it_says_who_won() {
    make_triangle
    expect 0 '' pixel t.obj 300 400
    expect_out '^pixel \(300,400\) = #[0-9A-F]{6}   VERDICT: WON, triangle 1 alone$'
    expect_out '^ #1 +covered +e=\([0-9]+,[0-9]+,[0-9]+\)  z=[0-9.]+ < 1.0000  pass  -> #'
    expect_files t.obj
}

test_it_says_why_nothing_is_there() {
    make_triangle
    expect 0 '' pixel t.obj 0 0
    expect_out 'VERDICT: BACKGROUND, nothing is here; the nearest is triangle 1, [0-9.]+ pixels away'
    expect 0 '' pixel t.obj 300 400 --cull front
    expect_out 'VERDICT: CULLED, triangle 1 would be here'
    expect 0 '' pixel t.obj 300 400 --near 50 --far 60
    expect_out 'VERDICT: CLIPPED\(near\), triangle 1 would be here'
}

test_its_colour_is_the_pictures_with_the_same_flags() {
    has_python || return 0
    cp "$SOURCE/tests/fuzz/corpus/obj/star.obj" m.obj
    for flags in '' '--shade flat' '--shade gouraud --hidden painter' '--fill-rule direct3d --material alpha=0.4'; do
        # shellcheck disable=SC2086
        run render m.obj --size 40x30 -o m.ppm $flags
        for place in '20 15' '12 9' '0 29' '31 4'; do
            # shellcheck disable=SC2086
            expect 0 '' pixel m.obj $place --size 40x30 --json $flags
            color=$(json 'bytes(round(255*c) for c in d["color"][:3]).hex()')
            # shellcheck disable=SC2086
            set -- $place
            drawn=$(tail -c +$((1 + $(stat -c %s m.ppm) - 3 * 40 * 30 + 3 * ($2 * 40 + $1))) m.ppm | head -c 3 | od -An -tx1 | tr -d ' ')
            [ "$color" = "$drawn" ] || failed "pixel $place $flags: history says $color, the picture has $drawn"
        done
    done
}

test_light_for_an_srgb_screen_is_shown_as_the_picture_has_it() {
    has_python || return 0
    cp "$SOURCE/tests/fuzz/corpus/obj/star.obj" m.obj
    run render m.obj --size 40x30 -o m.ppm --material gold --exposure 0.5
    for place in '20 15' '12 9' '0 29'; do
        # shellcheck disable=SC2086
        expect 0 '' pixel m.obj $place --size 40x30 --json --material gold --exposure 0.5
        color=$(json 'bytes(round(255*c) for c in d["shown"][:3]).hex()')
        # shellcheck disable=SC2086
        set -- $place
        drawn=$(tail -c +$((1 + $(stat -c %s m.ppm) - 3 * 40 * 30 + 3 * ($2 * 40 + $1))) m.ppm | head -c 3 | od -An -tx1 | tr -d ' ')
        [ "$color" = "$drawn" ] || failed "pixel $place: history says $color, the picture has $drawn"
    done
}

test_gouraud_shading_tells_the_corners_light() {
    has_python || return 0
    make_triangle
    expect 0 '' pixel t.obj 300 400 --shade gouraud
    expect_out '^           v2 +[0-9.]+ x light, diffuse \([0-9., ]+\) specular \('
    expect 0 '' pixel t.obj 300 400 --shade gouraud --json
    [ "$(json 'abs(sum(c["weight"] for c in d["entries"][0]["corner_light"]) - 1) < 1e-4')" = True ] || failed 'the weights are not 1'
    expect 0 '' pixel t.obj 300 400 --json
    [ "$(json 'd["entries"][0]["corner_light"]')" = None ] || failed 'Phong shading has no light at the corners'
}

test_json_has_every_stage() {
    has_python || return 0
    make_triangle
    expect 0 '' pixel t.obj 300 400 --json
    [ "$(json 'd["format"], d["verdict"], d["entries"][d["decisive_entry"]]["triangle"]')" = "raster-pixel WON 1" ] ||
        failed 'the JSON is not what is expected'
    [ "$(json 'all(d["entries"][0][s] is not None for s in "vertex clip project cull setup coverage depth interpolate fragment blend terms".split())')" = True ] ||
        failed 'a stage is missing'
    expect 0 '' pixel t.obj 300 400 --json --cull front
    [ "$(json 'd["verdict"], d["entries"][0]["coverage"], d["entries"][0]["cull"]["verdict"]')" = "CULLED None culled" ] ||
        failed 'a stage that was not reached is not null'
}

test_a_pixel_outside_the_picture_is_wrong_usage() {
    make_triangle
    expect 2 "^error: X: 800 is outside the picture of 800x600" pixel t.obj 800 0
    expect 2 "^error: Y: 600 is outside the picture of 800x600" pixel t.obj 0 600
    expect 2 "^error: X: 40 is outside the picture of 40x30" pixel missing.obj 40 0 --size 40x30
    expect 2 "^error: X" pixel t.obj -1 0
    expect 2 "^error: X" pixel t.obj 1.5 0
    expect 2 "" pixel t.obj 1
    expect 3 'missing.obj' pixel missing.obj 1 1
}

run_tests "$@"
