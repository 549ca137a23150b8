#!/bin/bash
# everywhere.sh: draws the scenes of tests/everywhere with many compilers, levels and processors; compares their hashes.
#
#   bash tests/everywhere.sh                   installs what is missing, runs all, prints a table
#   bash tests/everywhere.sh g++-O0 wasm       some builds only, by their names in the table
#   bash tests/everywhere.sh --list            the names
#
# Each build compiles the library and tests/everywhere/ from their sources, on one thread and with stand-ins for the
# libraries that a foreign processor would need. Exit code 0 when every scene of every build has the hash that stands in
# tests/everywhere/hashes.txt, else 1.
set -uo pipefail
shopt -s extglob
cd "$(dirname "$0")/.."
. demos/setup.sh

# name | compiler and flags | what runs the program
builds=(
    "g++-O0|g++-12 -O0"
    "g++-O1|g++-12 -O1"
    "g++-O2|g++-12 -O2"
    "g++-O3|g++-12 -O3"
    "g++-O3-avx2|g++-12 -O3 -mavx2 -mno-fma"
    "g++-O3-avx2-fma|g++-12 -O3 -march=x86-64-v3"
    "g++-O3-avx512|g++-12 -O3 -march=x86-64-v4 -mprefer-vector-width=256"
    "g++-O1-no-vectors|g++-12 -O1 -DRASTER_NO_VECTOR_EXTENSIONS"
    "clang14-O0|clang++-14 -O0"
    "clang14-O1|clang++-14 -O1"
    "clang14-O2|clang++-14 -O2"
    "clang14-O3|clang++-14 -O3"
    "clang14-O3-avx2|clang++-14 -O3 -mavx2 -mno-fma"
    "clang14-O3-avx2-fma|clang++-14 -O3 -march=x86-64-v3"
    "clang19-O0|clang++-19 -O0"
    "clang19-O1|clang++-19 -O1"
    "clang19-O2|clang++-19 -O2"
    "clang19-O3|clang++-19 -O3"
    "clang19-O3-avx2|clang++-19 -O3 -mavx2 -mno-fma"
    "clang19-O3-avx2-fma|clang++-19 -O3 -march=x86-64-v3"
    "i386-O0|i686-linux-gnu-g++ -O0 -msse2 -mfpmath=sse -static"
    "i386-O2|i686-linux-gnu-g++ -O2 -msse2 -mfpmath=sse -static"
    "aarch64-O2|aarch64-linux-gnu-g++ -O2 -static|qemu-aarch64"
    "aarch64-O3|aarch64-linux-gnu-g++ -O3 -static|qemu-aarch64"
    "wasm-O2|em++ -O2 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1|node --no-experimental-fetch"
    "wasm-O2-simd|em++ -O2 -msimd128 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1|node --no-experimental-fetch"
)
packages=(g++-12 clang-14 clang-19 g++-i686-linux-gnu g++-aarch64-linux-gnu qemu-user emscripten nodejs
    libglm-dev libtinyobjloader-dev libdeflate-dev libstb-dev libeigen3-dev)

if [ "${1:-}" = --list ]; then
    printf '%s\n' "${builds[@]%%|*}"
    exit 0
fi
wanted=("$@")
[ $# -gt 0 ] || install_packages "${packages[@]}" || exit 1

out=build/everywhere
mkdir -p "$out/include"
# Foreign compilers do not look into /usr/include; these headers have no code for one processor in them.
for header in glm stb tiny_obj_loader.h libdeflate.h eigen3/Eigen; do
    ln -sfn "/usr/include/$header" "$out/include/${header##*/}"
done
export NODE_PATH=/usr/share/nodejs
unset EM_CACHE

# A room is compiled at one go, as in the project's own builds; what takes long is compiled alone.
alone=(tests/everywhere/*.cpp raster/scene/render_*.cpp raster/shading/*_bake.cpp raster/target.cpp)
rooms=("tiles raster/tiles/*.cpp" "visibility raster/visibility/*.cpp" "shading raster/shading/!(*_bake).cpp"
    "scene raster/scene/!(observe*|render_*).cpp" "image raster/image/{decode,file,pages,png_filters,png_reader,pnm,stb_reader}.cpp")
mkdir -p "$out/rooms"
sources=("${alone[@]}")
for room in "${rooms[@]}"; do
    eval "files=(${room#* })"
    printf '#include "../../../%s"\n' "${files[@]}" >"$out/rooms/${room%% *}.cpp"
    sources+=("$out/rooms/${room%% *}.cpp")
done

# build NAME COMMAND...: the program, $out/NAME/everywhere
build() {
    local name=$1 folder=$out/$1 program=everywhere link=()
    shift
    [[ $name != wasm* ]] || program=everywhere.js
    rm -rf "$folder"
    mkdir -p "$folder"
    local word command=()
    for word in "$@"; do
        case $word in
            -static | -s*) link+=("$word") ;;
            *) command+=("$word") ;;
        esac
    done
    command+=(-std=c++20 -ffp-contract=off -DRASTER_NO_THREADS -w -I. -Itests -Imodels -isystem "$out/include")
    # Precompiled: g++ and clang find common.h.gch when common.h is included first.
    cp tests/everywhere/common.h "$folder/common.h"
    "${command[@]}" -x c++-header "$folder/common.h" -o "$folder/common.h.gch" || return 1
    printf '%s\n' "${sources[@]}" | xargs -P "${RASTER_JOBS:-$(nproc)}" -I{} bash -c \
        'source=$1; folder=$2; shift 2; exec "$@" -include "$folder/common.h" -c "$source" -o "$folder/${source//\//_}.o"' \
        - {} "$folder" "${command[@]}" &&
        "${command[@]}" "${link[@]}" "$folder"/*.o -o "$folder/$program"
}

printf '%-22s %-64s %s\n' build "compiler and flags" scenes
failed=0
for entry in "${builds[@]}"; do
    IFS='|' read -r name flags runner <<<"$entry"
    [ $# -eq 0 ] || [[ " ${wanted[*]} " = *" $name "* ]] || continue
    read -r -a command <<<"$flags"
    log=$out/$name.log
    if [[ $flags = *avx2* || $flags = *v3* ]] && ! has_x86_64_v3; then
        verdict="not run: this processor has no AVX2 and FMA"
    elif [[ $flags = *v4* ]] && ! has_x86_64_v4; then
        verdict="not run: this processor has no AVX-512"
    elif ! command -v "${command[0]}" >/dev/null; then
        verdict="not run: no ${command[0]}"
        failed=1
    elif ! build "$name" "${command[@]}" >"$log" 2>&1; then
        verdict="DOES NOT COMPILE, see $log"
        failed=1
    else
        program=$out/$name/everywhere
        [[ $name != wasm* ]] || program+=.js
        # shellcheck disable=SC2086
        $runner "$program" tests/everywhere/hashes.txt --models=models >"$log" 2>&1 || failed=1
        verdict=$(tail -n 1 "$log")
    fi
    printf '%-22s %-64s %s\n' "$name" "${command[*]}" "$verdict"
done
exit $failed
