# trace.sh: `raster trace` as a program.
. "$(dirname "$0")/lib.sh"

test_a_trace_has_a_header_its_events_and_an_end() {
    make_triangle
    expect 0 't.trace.jsonl: [0-9,]+ lines' trace t.obj --size 12x10
    expect_files t.obj t.trace.jsonl
    head -1 t.trace.jsonl | grep -q '"format":"raster-trace","version":1' || failed 'no header'
    tail -1 t.trace.jsonl | grep -q '"stage":"end","submitted":1' || failed 'no end'
    grep -q '"stage":"blend","draw":0,"triangle":1' t.trace.jsonl || failed 'no pixel was written'
    expect 0 '' trace t.obj --size 12x10 -o - -q
    same "$stdout" t.trace.jsonl
}

test_filters_leave_the_rest_out() {
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 -1\nf 1 2 3\nf 2 4 3\n' >t.obj
    run trace t.obj --size 12x10 -o all.jsonl -q
    run trace t.obj --size 12x10 -o - -q --triangle 2
    grep -q '"triangle":1,' "$stdout" && failed 'triangle 1 is there'
    diff <(grep '"triangle":2,' all.jsonl) <(grep '"triangle":2,' "$stdout") >/dev/null || failed 'triangle 2 is not complete'
    run trace t.obj --size 12x10 -o - -q --pixel 5,5
    diff <(grep '"x":5,"y":5,' all.jsonl) <(grep '"x":' "$stdout") >/dev/null || failed 'not the lines of pixel 5,5'
    run trace t.obj --size 12x10 -o - -q --rect 4,5,3,2 --stage coverage,blend
    diff <(grep -E '"stage":"(coverage|blend)".*"x":[456],"y":[56],' all.jsonl) <(grep '"x":' "$stdout") >/dev/null ||
        failed 'not the lines of the rectangle'
    grep -qE '"stage":"(vertex|depth|setup)"' "$stdout" && failed 'a stage that was not asked for'
}

test_the_same_trace_every_time_and_the_hash_tells_scenes_apart() {
    make_triangle
    run trace t.obj --size 12x10 -o a.jsonl -q
    cp t.obj other.obj
    run trace other.obj --size 12x10 -o b.jsonl -q
    same <(tail -n +2 a.jsonl) <(tail -n +2 b.jsonl)
    hash() { sed -n '1s/.*"scene_hash":"\([0-9a-f]*\)".*/\1/p' "$1"; }
    [ "$(hash a.jsonl)" = "$(hash b.jsonl)" ] || failed 'the same scene has another hash'
    run trace t.obj --size 12x10 --shade flat -o c.jsonl -q
    [ "$(hash a.jsonl)" != "$(hash c.jsonl)" ] || failed 'another scene has the same hash'
}

test_a_trace_for_an_srgb_screen_ends_in_the_history_s_light() {
    command -v python3 >/dev/null || return 0
    make_triangle
    expect 0 '' trace t.obj --size 12x10 --material gold --exposure 1 --pixel 5,6 -o t.jsonl
    head -1 t.jsonl | grep -q '"color_format":"rgba_float".*"display":{"srgb":true,"exposure":1}' || failed 'the header does not tell the display'
    run pixel t.obj 5 6 --size 12x10 --material gold --exposure 1 --json
    python3 - t.jsonl "$stdout" <<'END' || failed 'trace and history differ'
import json, sys
last = [e for e in map(json.loads, open(sys.argv[1])) if e.get("stage") == "blend"][-1]
sys.exit(last["after"] != json.load(open(sys.argv[2]))["color"])
END
}

test_mistakes_are_told_and_write_nothing() {
    make_triangle
    expect 2 "^error: --pixel: '5' is no pixel" trace t.obj --pixel 5
    expect 2 "^error: --pixel: '-1,2' is no pixel" trace t.obj --pixel -1,2
    expect 2 'beyond the picture of 800x600' trace t.obj --pixel 800,0
    expect 2 'beyond the picture of 8x8' trace t.obj --rect 4,4,5,1 --size 8x8
    expect 2 "^error: --rect: '1,2,3' is no rectangle" trace t.obj --rect 1,2,3
    expect 2 'there is no triangle 2; the model has 1' trace t.obj --triangle 2
    expect 2 '^error: --triangle' trace t.obj --triangle 0
    expect 2 "'deph' is none of .*; did you mean depth" trace t.obj --stage deph
    expect 2 '' trace t.obj --pixel 1,1 --rect 1,1,2,2
    expect 2 '' trace t.obj -o t.obj
    expect 3 '' trace t.obj -o no/where.jsonl
    expect_files t.obj
}

run_tests "$@"
