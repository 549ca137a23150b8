#!/bin/bash
# run.sh: installs what is missing, builds, and runs every test. From a fresh Debian 12 with git to the verdict.
#
#   bash tests/run.sh            as CI does: the release run without the tests that are labelled slow, and brief-fuzz
#   bash tests/run.sh release    every test of this run; several runs may be named
#
#   release      on an optimised build by g++; some programs of it are compiled with sanitizers
#   brief-fuzz   the fuzz targets alone, by clang, under the address and undefined behaviour sanitizers
#   fuzz         these and all unit tests, with the sanitizers
#   tsan         the tests of what runs on several threads, under the thread sanitizer
set -euo pipefail
cd "$(dirname "$0")/.."
. demos/setup.sh

runs=("$@") left_out=()
[ $# -gt 0 ] || runs=(release brief-fuzz) left_out=(--label-exclude slow)
for run in "${runs[@]}"; do
    case $run in
        release | brief-fuzz | fuzz | tsan) ;;
        *)
            echo "usage: bash tests/run.sh [release] [brief-fuzz] [fuzz] [tsan]" >&2
            exit 2
            ;;
    esac
done

install_packages "${build_packages[@]}" "${model_packages[@]}" "${test_packages[@]}"

failed=0
summary=()
for run in "${runs[@]}"; do
    start=$SECONDS preset=$run targets=() chosen=("${left_out[@]}")
    [ "$run" != brief-fuzz ] || preset=fuzz targets=(--target raster_fuzzers) chosen=(--label-regex libfuzzer)
    echo "== $run: build"
    configure "$preset" ${RASTER_CMAKE_OPTIONS:-}
    build "$preset" "${targets[@]}"
    echo "== $run: test ($((SECONDS - start)) s)"
    ctest --preset "$preset" -j "$(nproc)" "${chosen[@]}" | tee "build/$preset/ctest.log" || failed=1
    verdict=$(grep -E '^[0-9]+% tests passed' "build/$preset/ctest.log" || echo "no test ran")
    summary=("$run, $((SECONDS - start)) s:" "$verdict" "${summary[@]}")
done

# The first run's verdict, the fullest, is the last line.
echo "== summary"
printf '%s\n' "${summary[@]}"
exit $failed
