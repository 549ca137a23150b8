# compare.sh: raster compare.
. "$(dirname "$0")/lib.sh"

test_our_picture_and_opengls_are_close() {
    local shade
    for shade in flat gouraud phong; do
        run compare "$SOURCE/models/teapot.obj" --size 320x240 --shade "$shade" --json
        if [ "$status" = 3 ]; then
            check 3 'apt-get install libosmesa6' "compare without OSMesa"
            return
        fi
        check 0 '' "compare --shade $shade"
        expect_out '"coverage_differs": 0'
        expect_out '"depth_differs": 0'
        expect_out '"color_max": [01]'
    done
    expect_files teapot.raster.png teapot.opengl.png teapot.difference.png
    run compare "$SOURCE/models/checker_cube.obj" --size 320x240 --texture-filter nearest -o x.png
    expect_out 'coverage differs +0 pixels'
    expect_out 'colour differs .*at most [01]/255'
    [ -e x.opengl.png ] || failed "no x.opengl.png"
}

test_wireframes_and_points_are_close_too() {
    local style shade
    for style in wireframe points; do
        for shade in flat gouraud phong; do
            run compare "$SOURCE/models/torus.obj" --size 200x150 --style $style --shade $shade --line-width 3 --json -o x.png
            [ "$status" != 3 ] || return
            check 0 '' "compare --style $style"
            expect_out '"coverage_differs": 0'
            expect_out '"depth_differs": 0'
            expect_out '"color_max": [01]'
        done
    done
}

test_what_cannot_be_compared_is_told() {
    expect 3 '(OSMesa|libosmesa6|no such|cannot)' compare no-such-model.obj
    expect 2 '' compare "$SOURCE/models/cube.obj" --shade nonsense
}

run_tests
