# scenes.sh: scene files and generated shapes, as every command that takes a model takes them.
. "$(dirname "$0")/lib.sh"

# scene [MEMBER...]: a scene file s.json with a floor and a sphere, and more members.
scene() {
    {
        echo '{'
        echo '  "format": "raster-scene", "version": 1,'
        echo '  "objects": ['
        echo '    {"name": "floor", "shape": "plane", "transform": [{"scale": 3}]},'
        echo '    {"name": "ball", "shape": "sphere", "transform": [{"translate": [0, 1, 0]}]}'
        echo '  ]'
        printf '  , %s\n' "$@"
        echo '}'
    } >s.json
}

# The text between ```json and ``` of a page.
json_of() {
    sed -n '/^```json$/,/^```$/p' "$1" | sed '1d;$d'
}

test_the_scene_of_the_page_is_drawn_as_it_stands() {
    json_of "$SOURCE/docs/scene.md" >vases.json
    expect 0 '800x500, .* drawn' render vases.json
    expect_files vases.json vases.png
    if grep -q '^warning' "$stderr"; then failed 'it warns'; fi
}

test_the_scenes_of_the_tree_follow_the_schema_and_are_drawn() {
    json_of "$SOURCE/docs/scene.md" >page.json
    local scenes=(page.json) file
    for file in "$SOURCE"/demos/scenes/*.json; do [ ! -e "$file" ] || scenes+=("$file"); done
    for file in "${scenes[@]}"; do
        expect 0 'drawn' render "$file" --allow-outside --size 64x48 -o p.png
    done
    python3 -c 'import jsonschema' 2>/dev/null || { echo "no jsonschema: the schema is not tested"; return; }
    python3 - "$SOURCE/docs/scene.schema.json" "${scenes[@]}" >"$stdout" 2>"$stderr" <<'PYTHON' || failed 'the schema'
import json, sys
import jsonschema
schema = json.load(open(sys.argv[1]))
validator = jsonschema.validators.validator_for(schema)
validator.check_schema(schema)
for name in sys.argv[2:]:
    validator(schema).validate(json.load(open(name)))
bad = json.load(open(sys.argv[2]))
bad["objects"][0]["shap"] = bad["objects"][0].pop("shape")
assert not validator(schema).is_valid(bad), "a misspelt member passes"
PYTHON
}

test_a_scene_is_what_its_flags_say() {
    printf 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n' >t.obj
    echo '{"format": "raster-scene", "version": 1, "objects": [{"model": "t.obj"}],
           "lights": [{"kind": "point", "pos": [1, 2, 3], "color": [1, 0.5, 0.25]}, "ambient:color=0.1"],
           "camera": {"position": [0, 1, 4], "focal_point": [1, 0.5, 0], "view_angle": 40, "near": 1, "far": 20},
           "picture": {"size": [90, 60], "shade": "flat", "background": 0.3, "cull": "none", "two_sided": false}}' >s.json
    local flags=(--light point:pos=1,2,3:color=1,0.5,0.25 --light ambient:color=0.1 --camera-position 0,1,4
        --camera-focal-point 1,0.5,0 --camera-view-angle 40 --near 1 --far 20 --size 90x60 --shade flat
        --background 0.3 --no-two-sided)
    expect 0 '' render t.obj "${flags[@]}" -o a.png
    expect 0 '' render s.json -o b.png
    same a.png b.png
    expect 0 '' render t.obj "${flags[@]}" --material color=1,0,0:specular=0.5:shininess=7:reflectance=phong -o a.png
    sed -i -e 's/{"model": "t.obj"}/{"model": "t.obj", "material": "plastic"}/' -e 's/"lights"/"materials": {"plastic": \
        {"color": [1, 0, 0], "specular": 0.5, "shininess": 7, "reflectance": "phong"}}, &/' s.json
    expect 0 '' render s.json -o b.png
    same a.png b.png
}

test_a_flag_wins_over_the_scene() {
    scene '"picture": {"size": [64, 48], "shade": "flat"}' '"camera": {"position": [0, 2, 9]}' '"lights": ["head"]'
    expect 0 '64x48' render s.json -o flat.ppm
    expect 0 '32x24' render s.json --size 32x24 -o small.ppm
    expect 0 '' render s.json --shade phong -o phong.ppm
    differ flat.ppm phong.ppm
    expect 0 '' render s.json --light ambient:color=0.5 -o ambient.ppm
    differ flat.ppm ambient.ppm
    expect 0 '' render s.json --camera-position 0,1,9 -o moved.ppm
    differ flat.ppm moved.ppm
    # The default value, given, is given.
    scene '"picture": {"size": [64, 48], "shade": "phong"}' '"camera": {"position": [0, 2, 9]}' '"lights": ["head"]'
    expect 0 '' render s.json -o default.ppm
    same default.ppm phong.ppm
    # A camera file is the whole camera and the size of the picture.
    expect 0 '' render s.json --camera-json-out c.json -o a.ppm
    scene '"picture": {"size": [640, 480]}' '"camera": {"position": [5, 5, 5]}' '"lights": ["head"]'
    expect 0 '64x48' render s.json --camera-json c.json -o b.ppm
    same a.ppm b.ppm
}

test_no_lights_are_none() {
    scene '"lights": []' '"picture": {"background": 0, "size": [40, 30]}'
    expect 0 '' render s.json -o dark.ppm
    [ "$(tail -c 3600 dark.ppm | tr -d '\0' | wc -c)" = 0 ] || failed 'it is not dark'
}

test_transforms_are_done_in_their_order() {
    local transform expected
    while IFS='|' read -r transform expected; do
        echo '{"format": "raster-scene", "version": 1, "objects": [{"shape": "cube", "transform": '"$transform"'}]}' |
            sed 's/"cube"/{"kind": "box", "width": 2}/' >s.json
        expect 0 '' info s.json
        expect_out "bounding box +$expected"
    done <<'TRANSFORMS'
[]|-1,-1,-1 to 1,1,1
[{"translate": [1, 2, 3]}]|0,1,2 to 2,3,4
[{"scale": 2}, {"translate": [1, 0, 0]}]|-1,-2,-2 to 3,2,2
[{"translate": [1, 0, 0]}, {"scale": 2}]|0,-2,-2 to 4,2,2
[{"scale": [1, -3, 0.5]}]|-1,-3,-0.5 to 1,3,0.5
[{"translate": [4, 0, 0]}, {"rotate": {"axis": "+Z", "degrees": 90}}]|-1,3,-1 to 1,5,1
[{"translate": [4, 0, 0]}, {"rotate": {"axis": [0, 2, 0], "degrees": 90}}]|-1,-1,-5 to 1,1,-3
[{"matrix": [[1, 0, 0, 7], [0, 2, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]|6,-2,-1 to 8,2,1
TRANSFORMS
}

test_models_of_a_scene_keep_their_materials_and_textures() {
    mkdir m
    cp "$SOURCE"/models/checker* m/
    echo '{"format": "raster-scene", "version": 1, "objects": [
        {"name": "a", "model": "m/checker_cube.obj"},
        {"name": "b", "model": "m/checker_cube.obj", "transform": [{"translate": [0, 3, 0]}]}]}' >s.json
    expect 0 '' info s.json --json
    [ "$(grep -c '"m/checker.png"' "$stdout")" -ge 2 ] || failed 'textures are not named from the scene'
    expect 0 '' render s.json -o a.ppm
    expect 0 '' render s.json --no-textures -o b.ppm
    differ a.ppm b.ppm
    expect 2 'is read too' render s.json -o m/checker.png
}

test_models_outside_the_scenes_folder_are_refused() {
    mkdir in
    make_triangle
    echo '{"format": "raster-scene", "version": 1, "objects": [{"model": "../t.obj"}]}' >in/s.json
    expect 1 'in/s.json:1:64: ../t.obj: refused.*--allow-outside' render in/s.json -o p.png
    expect 0 '' render in/s.json -o p.png --allow-outside
    sed -i 's/"..\/t.obj"/"nix.obj"/' in/s.json
    expect 1 'nix.obj: not found' render in/s.json -o p.png
}

test_mistakes_are_told_with_line_and_column() {
    local change words
    scene '"lights": [{"kind": "point", "pos": [1, 2, 3]}]' '"camera": {"view_angle": 40}' '"picture": {"shade": "flat"}' \
        '"materials": {"glazed": {"specular": 0.6}}'
    cp s.json good.json
    while IFS='|' read -r change words; do
        sed "$change" good.json >s.json
        cmp -s good.json s.json && failed "$change changes nothing"
        expect 1 "^error: s.json:$words" render s.json -o p.png
        [ ! -e p.png ] || failed "$change: drawn all the same"
    done <<'CHANGES'
s/"version": 1/"version": 2/|2:40: .*version
s/"raster-scene"/"raster-camera"/|2:13: .*--camera-json
s/"objects"/"object"/|3:3: 'object' is none of .* did you mean objects
s/"plane"/"plain"/|4:32: there is no shape 'plain'
s/"plane"/{"kind": "plane", "divisions": 0}/|4:32: divisions of the shape plane
s/"shape": "plane"/"shape": "plane", "model": "x"/|4:5: an object has either
s/"scale": 3/"scale": 0/|4:65: scaled by 0
s/"scale": 3/"scal": 3/|4:56: 'scal' is none of
s/"scale": 3/"scale": "3"/|4:65: here a number or a list of three
s/"scale": 3/"scale": [3]/|4:65: here a list of three
s/"transform": \[{"sc/"material": "glased", &/|4:53: 'glased': 'glased' is none of glazed, .*gold.*; did you mean glazed
s/"transform": \[{"sc/"material": "glazed:alpha=1", &/|4:53: .*'glazed' is none of gold
s/\[0, 1, 0\]/[0, 1]/|5:69: here a list of three
s/"pos": \[1/"pos": [1, 1/|7:34: .*pos='1,1,2,3' is not X,Y,Z
s/"kind": "point"/"kind": "pint"/|7:25: .*did you mean point
s/"pos"/"size"/|7:34: .*has no 'size'
s/"view_angle": 40/"view_angle": 180/|8:30: --camera-view-angle
s/"flat"/"flatt"/|9:26: --shade: 'flatt' is none of
s/"name": "ball",/"name": "ball", "name": "x",/|5:22: 'name' is given twice
s/"ball",/"ball"/|5:21: this is no JSON: '"shape"'
s/^}//|12:1: this is no JSON: the file ends too early
CHANGES
    echo '[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[' >s.json
    expect 1 's.json:1:33: nested too deeply' render s.json
    echo '{"format": "raster-scene", "version": 1, "objects": []}' >s.json
    expect 1 's.json:1:53: there is no object in "objects"' render s.json
    echo '{"format": "raster-scene", "version": 1}' >s.json
    expect 1 's.json:1:1: a scene has "objects", a list' render s.json
    printf '\377\376' >s.json
    expect 1 's.json:1:1: this is no JSON' render s.json
    : >s.json
    expect 1 's.json:1:1: this is no JSON: the file ends' render s.json
    expect 3 'nix.json: cannot read' render nix.json
}

test_a_profile_is_turned() {
    echo '{"format": "raster-scene", "version": 1, "objects": [{"shape": {"kind": "revolution", "segments": 4,
        "steps": 1, "profile": [[1, 0], [1, 2]]}}]}' >s.json
    expect 0 '' info s.json
    expect_out 'triangles +8$'
    expect_out 'bounding box +-1,0,-1 to 1,2,1'
    sed -i 's/\[1, 2\]/[-1, 2]/' s.json
    expect 1 's.json:2:42: a radius is 0 or more' info s.json
}

test_shapes_are_models() {
    expect 0 '^vase.png: .* drawn' render shape:vase --size 80x60
    expect 0 '' info shape:sphere:segments=5:rings=2
    expect_out 'triangles +10$'
    expect 2 "no shape 'vas'" render shape:vas
    expect 2 "has no 'size'" render shape:vase:size=2
    expect 2 'from 3 to 1024' render shape:vase:segments=2
    expect 2 "segments='x' is no" render shape:vase:segments=x
    expect 2 "'vase:segments=4:segments=5' has 'segments' twice" render shape:vase:segments=4:segments=5
}

run_tests "$@"
