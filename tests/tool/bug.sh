# bug.sh: `raster render --bug`: the wrong picture, the difference, the first wrong step.
. "$(dirname "$0")/lib.sh"

test_every_bug_of_the_help_draws_explains_and_differs() {
    cp "$SOURCE/tests/fuzz/corpus/obj/cube.obj" m.obj
    run render m.obj --size 60x40 -o right.ppm -q
    run render --help
    bugs=$(sed -n '/--bug NAME/,/^Other/s/^ \{27\}\([a-z-]*\): .*/\1/p' "$stdout" | grep -E -- '-|affine')
    [ "$(echo "$bugs" | wc -w)" -ge 10 ] || failed "the help lists '$bugs'"
    for bug in $bugs; do
        # A camera before the near corner, so that something is clipped; one sheet edge on pixel centres does no harm.
        expect 0 "^$bug: " render m.obj --size 60x40 -o wrong.ppm --bug "$bug"
        grep -qE '^wrong.difference.png: [0-9,]+ pixels? differs?$' "$stderr" || failed "$bug: no word of the difference"
        grep -qE '^(first difference: [a-z_]+ of (triangle|vertex) [0-9]+|no step differs)' "$stderr" ||
            failed "$bug: no first difference"
        [ -s wrong.difference.png ] || failed "$bug: no difference picture"
        case $bug in
            z-flipped | wrong-cull | y-flipped | pixel-corner | whole-pixels) differ wrong.ppm right.ppm ;;
        esac
        rm -f wrong.*
    done
}

test_a_word_for_the_first_wrong_number() {
    make_triangle
    expect 0 'inclusive: true instead of false' render t.obj --size 20x20 --bug no-top-left
    expect_files t.obj t.png t.difference.png
    expect 0 'first difference: cull of triangle 1' render t.obj --size 20x20 --bug wrong-cull
    expect 0 'verdict: "culled" instead of "kept"' render t.obj --size 20x20 --bug wrong-cull
    expect 0 'warning: nothing of the model is in view' render t.obj --size 20x20 --bug wrong-cull
}

test_the_wrong_picture_is_the_same_every_time_and_quiet_is_quiet() {
    make_triangle
    expect 0 '' render t.obj --size 20x20 --bug affine -o a.png -q
    [ ! -s "$stderr" ] || failed 'not quiet'
    run render t.obj --size 20x20 --bug affine -o b.png
    same a.png b.png
    same a.difference.png b.difference.png
}

test_what_does_not_go_with_a_bug_is_told() {
    make_triangle
    expect 2 "^error: --bug: 'afine' is none of .*; did you mean affine" render t.obj --bug afine
    expect 2 'excludes' render t.obj --bug affine --turntable 3
    expect 2 'excludes' render t.obj --bug affine --aov depth
    expect 2 '8 bits' render t.obj --bug affine -o t.pfm
    expect 2 '' render t.obj --bug affine -o -
    expect_files t.obj
}

run_tests "$@"
