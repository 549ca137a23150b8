# camera.sh: the camera file: the same matrices to the last bit, there and back; and what is no camera file.
. "$(dirname "$0")/lib.sh"

teapot=$SOURCE/models/teapot.obj

test_a_camera_file_draws_the_same_picture() {
    local view=(--camera-position 3,4,9 --camera-focal-point 0,1,0 --camera-view-angle 37.3 --near 0.7 --far 33 --up 0.1,1,0)
    expect 0 '' render "$teapot" --size 123x77 "${view[@]}" -o a.png --camera-json-out c.json
    expect 0 '123x77' render "$teapot" --camera-json c.json -o b.png --camera-json-out d.json
    same a.png b.png
    same c.json d.json
    # Decimal numbers alone give the same floats.
    grep -v rows_hexadecimal c.json | grep -v '"0x\|"-0x\|^ *\],\?$' >/dev/null
    run info "$teapot" --size 123x77 "${view[@]}" --json
    cp "$stdout" i.json
    expect 0 '' render "$teapot" --camera-json i.json -o b.png --camera-json-out d.json
    same a.png b.png
    same c.json d.json
    expect 0 '' render "$teapot" --camera-json c.json -o b.png --camera-json-out -
    same c.json "$stdout"
}

test_automatic_framing_is_in_the_file_too() {
    expect 0 '' render "$teapot" --size 100x80 -o a.png
    run info "$teapot" --size 100x80 --json
    cp "$stdout" i.json
    expect 0 '' render "$teapot" --camera-json i.json -o b.png
    same a.png b.png
}

test_decimal_numbers_are_enough() {
    run render "$teapot" --size 64x48 -o a.png --camera-json-out c.json
    # "0x1.8p+1" and the like taken out: the member gets another name.
    sed 's/rows_hexadecimal/ignored/' c.json >decimal.json
    sed 's/"rows"/"ignored"/' c.json >hexadecimal.json
    sed 's/"matrices"/"ignored"/' c.json >parameters.json
    for file in decimal hexadecimal parameters; do
        expect 0 '' render "$teapot" --camera-json $file.json -o b.png
        same a.png b.png
    done
}

test_hexadecimal_numbers_win() {
    run render "$teapot" --size 64x48 -o a.png --camera-json-out c.json
    sed '/"rows": \[/,/\]$/ s/[0-9]\.[0-9]*/7/' c.json >other.json
    differ c.json other.json
    expect 0 '' render "$teapot" --camera-json other.json -o b.png
    same a.png b.png
}

test_another_size_of_the_same_shape_is_allowed() {
    run render "$teapot" --size 64x48 -o a.png --camera-json-out c.json
    expect 0 ': 128x96' render "$teapot" --camera-json c.json --size 128x96 -o b.png
    expect 2 '^error: --size: 100x100 has another shape than the 64x48' render "$teapot" --camera-json c.json --size 100x100
    expect 2 '^error: --near and --camera-json exclude' render "$teapot" --camera-json c.json --near 1
    expect 2 '^error: --turntable' render "$teapot" --camera-json c.json --turntable 3
}

test_what_is_no_camera_file_is_bad_input() {
    make_triangle
    "$RASTER" render t.obj --size 64x48 -q -o a.png --camera-json-out c.json
    rm a.png
    expect 3 '^error: no.json: .*No such file' render t.obj --camera-json no.json
    expect 3 '' render t.obj --camera-json .
    local text
    while read -r text; do
        printf '%s' "$text" >bad.json
        expect 1 '^error: bad.json' render t.obj --camera-json bad.json
    done <<'TEXTS'

{
nonsense
[]
1
"raster-camera"
{"format": 5}
{"format": "raster-camera"}
{"format": "raster-camera", "version": 2}
{"format": "raster-camera", "version": 1}
{"format": "raster-camera", "version": 1, "viewport": 5}
{"format": "raster-camera", "version": 1, "viewport": {"width": 0, "height": 1}, "parameters": {}}
{"format": "raster-camera", "version": 1, "viewport": {"width": 99999999999999999999, "height": 1}}
{"format": "raster-camera", "version": 1, "viewport": {"width": 8, "height": 8}}
{"format": "raster-camera", "version": 1, "viewport": {"width": 8, "height": 8}, "parameters": {"position": [0,0,1]}}
{"format": "raster-camera", "version": 1, "viewport": {"width": 8, "height": 8}, "matrices": {"eye_from_world": {"rows": 1}}}
{"format": "raster-camera", "version": 1, "viewport": {"width": 8, "height": 8}, "matrices": []}
{"format": "raster-info", "version": 1, "camera": 3}
TEXTS
    local change
    while read -r change; do
        sed "$change" c.json >bad.json
        differ c.json bad.json
        expect 1 '^error: bad.json' render t.obj --camera-json bad.json
    done <<'CHANGES'
s/"0x[0-9a-f.]*p[-+0-9]*"/"0xzz"/
s/"0x[0-9a-f.]*p[-+0-9]*"/"0x1p+999"/
s/"0x[0-9a-f.]*p[-+0-9]*"/"nan"/
s/"0x[0-9a-f.]*p[-+0-9]*"/null/
s/rows_hexadecimal/x/;s/"rows": \[/"rows": [1e999,/
s/"width": 64/"width": -64/
s/"width": 64/"width": 64.5/
s/"width": 64/"width": 1000000/
CHANGES
    printf '{\n"format":\n\n}' >bad.json
    expect 1 '^error: bad.json:4: ' render t.obj --camera-json bad.json
    head -c 200000 /dev/zero | tr '\0' '[' >bad.json
    expect 1 '^error: bad.json' render t.obj --camera-json bad.json
    expect_files t.obj c.json bad.json
}

test_parameters_of_a_file_are_checked() {
    make_triangle
    printf '{"format":"raster-camera","version":1,"viewport":{"width":8,"height":8},"parameters":{"position":[0,0,1],
"focal_point":[0,0,1],"up":[0,1,0],"view_angle_degrees":30,"near":1,"far":2}}' >c.json
    expect 1 '^error: c.json: parameters: camera-position' render t.obj --camera-json c.json
}

run_tests "$@"
