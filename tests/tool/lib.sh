# lib.sh: what the tests of the command share. Sourced by bash; ends with `run_tests`.
#
# $RASTER is the program, $SOURCE the source tree. A test is a function test_*; it runs in an empty folder of its own. What
# the program printed is in $stdout and $stderr (files beside that folder), its exit code in $status.

set -u
export LC_ALL=C
scratch=$(mktemp -d "${TMPDIR:-/tmp}/raster-tool-test.XXXXXX")
trap 'chmod -R u+w "$scratch" 2>/dev/null; rm -rf "$scratch"' EXIT
stdout=$scratch/stdout
stderr=$scratch/stderr
failures=0

failed() {
    echo "FAILED $current: $*"
    sed 's/^/    stderr: /' "$stderr" | head -5
    failures=$((failures + 1))
}

# run ARGUMENT...: the program.
run() {
    "$RASTER" "$@" >"$stdout" 2>"$stderr" </dev/null
    status=$?
}

# expect STATUS WORDS ARGUMENT...: runs; the exit code and some words of standard error (a pattern for grep -E) must be as
# given. WORDS may be empty.
expect() {
    local expected=$1 words=$2
    shift 2
    run "$@"
    check "$expected" "$words" "raster $*"
}

# check STATUS WORDS WHAT: the same for what has run.
check() {
    [ "$status" = "$1" ] || failed "$3: exit code $status, not $1"
    [ -z "$2" ] || grep -qE -- "$2" "$stderr" || failed "$3: no '$2' on standard error"
    if [ "$1" != 0 ]; then
        grep -q '^error: ' "$stderr" || failed "$3: no line 'error: ...'"
    fi
}

# expect_files NAME...: these are in the folder, and no others, hidden ones included.
expect_files() {
    local found expected
    found=$(find . -mindepth 1 -printf '%P\n' | sort | tr '\n' ' ')
    expected=$([ $# = 0 ] || printf '%s\n' "$@" | sort | tr '\n' ' ')
    [ "$found" = "$expected" ] || failed "files are '$found', not '$expected'"
}

same() {
    cmp -s "$1" "$2" || failed "$1 and $2 differ"
}
differ() {
    if cmp -s "$1" "$2"; then failed "$1 and $2 are the same"; fi
}
expect_out() {
    grep -qE -- "$1" "$stdout" || failed "no '$1' on standard output"
}

# A triangle that fills the lower left half of what an automatic camera sees.
make_triangle() {
    printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"${1:-t.obj}"
}

# Ends the script as ctest expects it of a test that cannot run here, with the reason.
skip() {
    echo "SKIPPED: $*"
    exit 77
}

# need_npm PACKAGE...: sets $modules to a folder node_modules with these npm packages, which are fetched once into the
# build folder; skips the script where that cannot be.
need_npm() {
    local folder package
    folder=${RASTER_NPM:-${XDG_CACHE_HOME:-$HOME/.cache}/raster-npm}/$1
    modules=$folder/node_modules
    command -v node >/dev/null || skip "node is not here"
    for package in "$@"; do
        [ ! -d "$modules/$package" ] || continue
        command -v npm >/dev/null || skip "npm, which would fetch $*, is not here"
        mkdir -p "$folder"
        timeout 120 npm install --prefix "$folder" --no-audit --no-fund --loglevel=error "$@" >"$stderr" 2>&1 ||
            skip "npm cannot fetch $*: $(tail -1 "$stderr")"
        return 0
    done
}

# Its own line, because sanitizers reserve terabytes of addresses.
skip_with_sanitizers() {
    [ -z "${RASTER_SANITIZED:-}" ]
}

run_tests() {
    local tests
    tests=$(compgen -A function | grep '^test_')
    for current in ${1:-$tests}; do
        mkdir "$scratch/$current" && cd "$scratch/$current" || exit 2
        : >"$stderr"
        "$current"
        cd "$scratch" || exit 2
        chmod -R u+w "$current" && rm -rf "$current"
    done
    [ "$failures" = 0 ] && echo "all passed: $(echo "$tests" | wc -w)"
    exit $((failures > 0))
}
