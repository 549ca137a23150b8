# trace_schema.sh: what `raster trace` writes is what docs/trace.schema.json promises, by the npm package ajv.
. "$(dirname "$0")/lib.sh"

test_every_line_is_as_the_schema_says() {
    local modules=/usr/share/nodejs  # Debian's node-ajv does as well
    [ -d $modules/ajv ] && ! command -v npm >/dev/null || need_npm ajv
    cp "$SOURCE/tests/fuzz/corpus/obj/cube.obj" m.obj
    run trace m.obj --size 14x10 -o phong.jsonl
    run trace m.obj --size 14x10 -o flat.jsonl --shade flat --hidden painter --cull back --fill-rule direct3d
    run trace m.obj --size 14x10 -o gouraud.jsonl --shade gouraud --material alpha=0.5 --rect 2,2,9,7
    run trace m.obj --size 14x10 -o clipped.jsonl --camera-position 0.4,0.5,0.3 --camera-focal-point 0,0,-1 --near 0.1 --triangle 1
    run trace m.obj --size 14x10 -o cut.jsonl --near 2.5
    run trace m.obj --size 14x10 -o light.jsonl --material gold --exposure 0.5 --pixel 7,5
    node "$SOURCE/tests/tool/check_trace.js" "$modules" "$SOURCE/docs/trace.schema.json" ./*.jsonl >"$stderr" 2>&1 ||
        failed 'a line is not as the schema says, or the schema takes anything'
}

run_tests "$@"
