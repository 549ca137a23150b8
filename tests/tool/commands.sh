# commands.sh: help, version, info, doctor, demo, progress.
. "$(dirname "$0")/lib.sh"

test_help_goes_to_standard_output() {
    for command in '' render step info pixel trace demo doctor; do
        # shellcheck disable=SC2086
        expect 0 '' $command --help
        expect_out '^Usage: raster '
        [ ! -s "$stderr" ] || failed 'something on standard error'
        # shellcheck disable=SC2086
        expect 0 '' $command -h
    done
    expect 0 '' render --help --size 12x
    run
    [ "$status" = 2 ] || failed "without a command: exit code $status"
    grep -q '^Usage: raster COMMAND' "$stderr" || failed 'no help on standard error'
}

test_help_fits_a_terminal() {
    for command in '' render step info pixel trace demo doctor; do
        # shellcheck disable=SC2086
        run $command --help
        if grep -nE '.{81,}' "$stdout"; then failed "$command --help has lines of more than 80 columns"; fi
        if grep -nE ' $' "$stdout"; then failed "$command --help has spaces at line ends"; fi
    done
}

test_the_page_in_docs_is_what_help_says() {
    bash "$SOURCE/tests/tool/command_page.sh" "$RASTER" "$SOURCE/docs/command.md" >"$stderr" 2>&1 ||
        failed 'docs/command.md is old; run: bash tests/tool/command_page.sh --update PROGRAM docs/command.md'
}

test_the_version_is_that_of_the_project() {
    expect 0 '' --version
    grep -qx "raster $(sed -n 's/^project(raster VERSION \([0-9.]*\).*/\1/p' "$SOURCE/CMakeLists.txt")" "$stdout" ||
        failed "version is $(cat "$stdout")"
}

test_info_counts_what_is_there() {
    printf 'newmtl red\nKd 1 0 0\nmap_Kd no.png\n' >t.mtl
    printf 'mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 -3\no wall\nusemtl red\nf 1 2 3 4\no roof\nf 1 2 2\nf 1 2 3\nl 1 2\n' >t.obj
    expect 0 '' info t.obj
    expect_out 'triangles +3$'
    expect_out '4 positions, 0 texture coordinates, 0 normals, 3 faces \(1 dropped\)'
    expect_out 'bounding box +0,0,-3 to 1,2,0$'
    expect_out 'wall +2 triangles, material red'
    expect_out 'red +diffuse 1,0,0'
    expect_out 'no.png'
    expect_out '1 lines'
    expect_out 'warnings \('
    run info t.obj --json
    expect_out '"triangles": 3'
    expect_out '"faces_dropped": 1'
    expect_out '"format": "raster-camera"'
    expect_files t.obj t.mtl
}

test_info_survives_any_name() {
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\no \377\376"\\\001\nf 1 2 3\n' >t.obj
    expect 0 '' info t.obj --json
    expect 0 '' info t.obj
    expect 3 'No such file' info missing.obj
}

test_doctor_answers() {
    expect 0 '' doctor
    for word in compiler 'build type' 'compiled for' lanes threads OSMesa 'models to try'; do expect_out "^  $word"; done
    expect 2 'one argument too many' doctor now
}

test_demo_needs_no_file() {
    expect 0 '' demo
    expect_files teapot.png teapot.obj teapot.step.html
    expect_out '^Try next:'
    [ "$(grep -c '^  raster ' "$stdout")" = 3 ] || failed 'not three commands'
    grep '^  raster ' "$stdout" >next
    # Each of them works.
    local command
    while read -r _ command; do
        # shellcheck disable=SC2086
        expect 0 '' $command
    done <next
}

test_demo_leaves_a_model_alone() {
    echo mine >teapot.obj
    expect 0 '' demo --size 40x30
    [ "$(cat teapot.obj)" = mine ] || failed 'teapot.obj was written over'
    expect 0 '' demo -o - --size 40x30
    same teapot.png "$stdout"
}

test_the_demo_is_the_model_that_it_writes() {
    expect 0 '' demo --size 200x150
    cp teapot.png demo.png
    expect 0 '' render teapot.obj --size 200x150
    same teapot.png demo.png
}

test_progress_for_programs_is_json() {
    make_triangle
    expect 0 '' render t.obj --size 8x8 --progress json -q
    [ "$(head -1 "$stderr")" = '{"stage":"load","done":0.000}' ] || failed 'first line'
    [ "$(tail -1 "$stderr")" = '{"stage":"render","done":1.000}' ] || failed 'last line'
    if grep -vqE '^\{"stage":"(load|render)","done":[01]\.[0-9]{3}\}$' "$stderr"; then failed 'another line'; fi
}

test_progress_for_people_is_for_terminals_only() {
    make_triangle
    for mode in auto none; do
        expect 0 '' render t.obj --size 8x8 --turntable 30 --progress $mode -q
        [ ! -s "$stderr" ] || failed "--progress $mode writes into a file"
    done
}

test_nothing_is_coloured() {
    make_triangle
    for command in 'render t.obj' 'info t.obj' doctor --help 'render --siez'; do
        # shellcheck disable=SC2086
        run $command
        if grep -q $'\033' "$stdout" "$stderr"; then failed "$command prints escape sequences"; fi
    done
}

run_tests "$@"
