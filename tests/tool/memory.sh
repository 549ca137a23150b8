# memory.sh: where memory runs out there is a message and exit code 3, and no abort, at whatever place it happens.
. "$(dirname "$0")/lib.sh"

# limited KILOBYTES ARGUMENT...: the program with so much address space.
limited() {
    local limit=$1
    shift
    (
        ulimit -v "$limit"
        ulimit -c 0
        "$RASTER" "$@"
    ) >"$stdout" 2>"$stderr"
    status=$?
}

# The least that the program needs to say anything at all, in steps of 4 MB.
least_memory() {
    local limit=16000
    until limited $limit --version && [ "$status" = 0 ]; do limit=$((limit + 4000)); done
    echo $limit
}

test_a_picture_larger_than_memory() {
    skip_with_sanitizers || return 0
    make_triangle
    limited 500000 render t.obj --size 11000x11000
    check 3 'not enough memory' 'a picture of 121 megapixels in 500 MB'
    limited 500000 render t.obj --size 2000x2000 --aov normal --turntable 2
    [ "$status" = 0 ] || [ "$status" = 3 ] || failed "exit code $status"
    rm -f t.000* t.001*
    expect_files t.obj
}

# From hardly any memory to enough: each run succeeds, or fails with exit code 3 and leaves nothing.
test_at_every_limit() {
    skip_with_sanitizers || return 0
    awk 'BEGIN { n = 120
        for (y = 0; y < n; y++) for (x = 0; x < n; x++) print "v", x, y, (x * y) % 7
        for (y = 1; y < n; y++) for (x = 1; x < n; x++) { i = (y - 1) * n + x; print "f", i, i + 1, i + n + 1, i + n } }' >t.obj
    local least limit succeeded=0 refused=0
    least=$(least_memory)
    for ((limit = least; limit < least + 240000; limit += 5000)); do
        limited $limit render t.obj --size 1200x900 -o p.png --threads $((limit / 5000 % 3 + 1)) --aov depth
        if [ "$status" = 0 ]; then
            succeeded=$((succeeded + 1))
        else
            refused=$((refused + 1))
            check 3 '' "under $limit kB"
            [ ! -e p.png ] || [ -e p.depth.png ] || rm p.png
        fi
        compgen -G '.raster-*' >/dev/null && failed 'a temporary file is left'
        rm -f p.png p.depth.png
    done
    [ $refused -gt 0 ] && [ $succeeded -gt 0 ] || failed "$refused refused, $succeeded succeeded: the limits are chosen badly"
}

run_tests "$@"
