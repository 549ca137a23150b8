#!/bin/bash
# run.sh: installs what is missing, builds, and runs every test. From a fresh Debian 12 with git to the verdict.
#
#   bash tests/run.sh            the release run without the tests that are labelled slow, as CI does
#   bash tests/run.sh release    every test of this run; several runs may be named
#
#   release   on an optimised build by g++
#   fuzz      unit tests and fuzz targets under the address and undefined behaviour sanitizers, by clang
#   tsan      the tests of what runs on several threads, under the thread sanitizer
set -euo pipefail
cd "$(dirname "$0")/.."
. demos/setup.sh

runs=("$@") left_out=()
[ $# -gt 0 ] || runs=(release) left_out=(--label-exclude slow)
for run in "${runs[@]}"; do
    case $run in
        release | fuzz | tsan) ;;
        *)
            echo "usage: bash tests/run.sh [release] [fuzz] [tsan]" >&2
            exit 2
            ;;
    esac
done

install_packages "${build_packages[@]}" "${model_packages[@]}" "${test_packages[@]}"

failed=0
summary=()
for run in "${runs[@]}"; do
    start=$SECONDS
    echo "== $run: build"
    configure_and_build "$run" ${RASTER_CMAKE_OPTIONS:-}
    echo "== $run: test ($((SECONDS - start)) s)"
    ctest --preset "$run" -j "$(nproc)" "${left_out[@]}" | tee "build/$run/ctest.log" || failed=1
    verdict=$(grep -E '^[0-9]+% tests passed' "build/$run/ctest.log" || echo "no test ran")
    summary=("$run, $((SECONDS - start)) s:" "$verdict" "${summary[@]}")
done

# The first run's verdict, the fullest, is the last line.
echo "== summary"
printf '%s\n' "${summary[@]}"
exit $failed
