# step.sh: the stepper page as a file.
. "$(dirname "$0")/lib.sh"

data_of() {
    sed -n 's/.*<script type="application\/json" id="data">\(.*\)<\/script>.*/\1/p' "$1"
}

test_step_writes_one_page() {
    make_triangle
    expect 0 't.step.html: [0-9,]+ bytes' step t.obj --size 60x40
    expect_files t.obj t.step.html
    if grep -qE '(src|href)="(https?:)?//|@import|url\(' t.step.html; then failed 'the page refers to a network'; fi
    run step t.obj --size 60x40 -o - -q
    same t.step.html "$stdout"
    [ ! -s "$stderr" ] || failed '--quiet is not quiet'
}

test_the_same_command_writes_the_same_page() {
    make_triangle
    expect 0 '' step t.obj --size 60x40 -o a.html
    expect 0 '' step t.obj --size 60x40 -o b.html --threads 1
    same a.html b.html
}

test_the_demo_page_is_small() {
    expect 0 '' demo
    [ "$(wc -c <teapot.step.html)" -le 1500000 ] || failed "the demo page has $(wc -c <teapot.step.html) bytes"
    data_of teapot.step.html | grep -q '"left_out":\["' || failed 'the page does not say what was left out'
}

test_the_stages_are_an_animation() {
    make_triangle
    expect 0 '' step t.obj --size 60x40 --apng t.png
    expect_files t.obj t.step.html t.png
    grep -qa acTL t.png || failed 'no animation'
    expect 2 '' step t.obj --apng t.obj
    expect 2 '' step t.obj -o x --apng x
}

test_a_shape_needs_no_file() {
    expect 0 '' step shape:box --size 60x40
    expect_files box.step.html
}

test_the_pixel_the_triangle_and_the_stage_are_kept() {
    make_triangle
    expect 0 '' step t.obj --size 60x40 --pixel 29,21 --triangle 1 --stage depth
    data_of t.step.html | grep -q '"focus":{"pixel":\[29,21\],"triangle":1,"stage":"depth"}' || failed 'the focus is another'
}

test_a_page_of_a_bug_has_both_pictures_and_the_first_difference() {
    cp "$SOURCE/tests/fuzz/corpus/obj/cube.obj" m.obj
    local bug
    for bug in no-top-left affine no-near-clip z-flipped wrong-cull no-renormalise whole-pixels; do
        expect 0 '' step m.obj --size 60x40 --bug "$bug" -o wrong.html
        data_of wrong.html | grep -q "\"bug\":{\"name\":\"$bug\"" || failed "$bug: the page does not name it"
        data_of wrong.html | grep -q '"right":"data:image/png' || failed "$bug: no right picture"
        data_of wrong.html | grep -q '"difference":"data:image/png' || failed "$bug: no difference"
        data_of wrong.html | grep -qF "\"command\":\"raster step m.obj --bug $bug --size 60x40\"" || failed "$bug: another command"
        # The same first difference as `render --bug` tells.
        run render m.obj --size 60x40 --bug "$bug" -o wrong.png
        local place
        place=$(sed -n 's/^first difference: \([a-z_]*\) of triangle \([0-9]*\).*/"stage":"\1","triangle":\2/p' "$stderr")
        [ -z "$place" ] || data_of wrong.html | grep -qF "$place" || failed "$bug: the page does not open at $place"
    done
    expect 2 "'afine' is none of .*; did you mean affine" step m.obj --bug afine
    expect 2 'exclude --bug' step m.obj --bug affine --quiz 3
    expect 2 'exclude --bug' step m.obj --bug affine --apng a.png
}

test_what_is_not_there_is_said() {
    make_triangle
    expect 2 'pixel 60,0 lies outside the picture of 60x40' step t.obj --size 60x40 --pixel 60,0
    expect 2 'no triangle 2; the model has 1' step t.obj --triangle 2
    expect 2 "'raster' is none of vertex" step t.obj --stage raster
    expect 2 '' step t.obj --pixel 3
    expect 2 '' step t.obj --quiz 0
    expect_files t.obj
}

test_strange_names_stay_text() {
    make_triangle 'a<b>&.obj'
    expect 0 '' step 'a<b>&.obj' --size 40x30 -o t.html
    grep -qF '<title>a&lt;b&gt;&amp;.obj step by step' t.html || failed 'the name is no text'
    if grep -qF 'a<b>' t.html; then failed 'the name is markup'; fi
}

test_the_lessons_can_be_followed_and_their_figures_are_the_pages() {
    local lesson command count=0 missing
    for lesson in "$SOURCE"/docs/lessons/[0-9]*.md; do
        rm -f ./*.step.html
        while read -r command; do
            # shellcheck disable=SC2086
            expect 0 '' ${command#raster }
            count=$((count + 1))
        done < <(sed -n '/^```sh$/,/^```$/{/^raster /p}' "$lesson")
        command -v python3 >/dev/null || continue
        missing=$(python3 "$SOURCE/tests/tool/check_lesson.py" "$lesson" ./*.step.html 2>&1)
        # Worked out on the way in the lesson itself.
        missing=${missing/108579.56/}
        [ -z "${missing// /}" ] || failed "$(basename "$lesson"): the page has no $missing"
    done
    [ "$count" -ge 12 ] || failed "only $count commands in the lessons"
}

run_tests "$@"
