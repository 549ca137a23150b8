# step_page.sh: the stepper page in headless Chromium, driven by the npm package playwright-core and judged by axe-core.
. "$(dirname "$0")/lib.sh"

test_the_page_in_a_browser() {
    [ -z "${RASTER_SANITIZED:-}" ] || skip "the pages are the same with sanitizers"
    command -v chromium >/dev/null || skip "chromium is not here"
    need_npm playwright-core axe-core
    expect 0 '' demo
    expect 0 '' step teapot.obj --camera-position 2,3,4 --camera-focal-point 0,1.5,0 --near 3 --far 100 -o clipped.html
    expect 0 '' step teapot.obj --size 400x300 --quiz 6 -o worksheet.html
    expect 0 '' step teapot.obj --size 400x300 --bug affine -o bug.html
    expect 0 '' step teapot.obj --size 400x300 --shade gouraud -o gouraud.html
    expect 0 '' step teapot.obj --size 400x300 --material gold --exposure 0.5 -o gold.html
    (cd "$modules" && node "$SOURCE/tests/tool/step_page.mjs" "$OLDPWD"/{teapot.step,clipped,worksheet,bug,gouraud,gold}.html) \
        >browser.log 2>&1 || failed "$(cat browser.log)"
}

run_tests "$@"
