#!/bin/bash
# bench.sh: times `raster diff` beside idiff, ImageMagick's compare, pixelmatch and odiff on the same pairs of 8 megapixels.
#
#   bash tests/diff_cross/bench.sh [path of raster]
#
# Needs imagemagick (which makes the pictures); idiff is in openimageio-tools; the other two are found on PATH or in
# $RASTER_DIFF_TOOLS/node_modules/.bin (npm install --prefix FOLDER pixelmatch odiff-bin). Each is run five times, in turn
# with the others, and its best times count: from start to end, and of the processor. All write their picture of the
# difference; `report` is `raster diff` as it comes, which writes a whole report. The last column is the time from start to
# end by that of `raster`.
set -euo pipefail
cd "$(dirname "$0")/../.."
raster=$(realpath "${1:-build/release/raster/tool/raster}")
[ -n "${RASTER_DIFF_TOOLS:-}" ] && PATH=$PATH:$RASTER_DIFF_TOOLS/node_modules/.bin
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Debian's own names first: others may stand before these on PATH.
first_of() {
    local name
    for name in "$@"; do
        if command -v "$name"; then return; fi
    done
    echo "$1"
}
convert=$(first_of convert-im6.q16 magick convert)

echo "making pictures of 3840x2160" >&2
"$convert" -size 3840x2160 -seed 5 plasma:red-blue -blur 0x2 -fill white -draw "circle 1900,1000 2300,1300" \
    -fill '#336699' -draw "rectangle 300,300 1200,900" -alpha off PNG24:expected.png
cp expected.png equal.png
"$convert" expected.png -fill '#ff8800' -draw "rectangle 2000,1200 2100,1260" -draw "point 10,10" PNG24:few.png
"$convert" expected.png -evaluate add 600 PNG24:all.png
"$convert" expected.png -attenuate 0.3 -seed 3 +noise Gaussian PNG24:noise.png

declare -A command=(
    [raster]="$raster diff expected.png ACTUAL -o raster.png"
    [report]="$raster diff expected.png ACTUAL"
    [odiff]="odiff expected.png ACTUAL odiff.png -t 0"
    [pixelmatch]="pixelmatch expected.png ACTUAL pixelmatch.png 0 true"
    [compare]="$(first_of compare-im6.q16 compare) -metric AE expected.png ACTUAL compare.png"
    [idiff]="idiff -o idiff.png expected.png ACTUAL"
)
# took COMMAND...: milliseconds from start to end and of the processor.
took() {
    local TIMEFORMAT='%R %U %S'
    { time "$@" >output.txt 2>&1 || true; } 2>&1 | awk '{ printf "%.0f %.0f\n", $1 * 1000, ($2 + $3) * 1000 }'
}

printf '%-8s %-12s %8s %8s %10s\n' pair program ms cpu-ms "by ours"
for actual in equal few all noise; do
    declare -A best=() cpu=()
    for round in 1 2 3 4 5; do
        for name in raster report odiff pixelmatch compare idiff; do
            read -ra words <<<"${command[$name]//ACTUAL/$actual.png}"
            command -v "${words[0]}" >/dev/null || continue
            rm -rf diff-out
            read -r wall used < <(took "${words[@]}")
            if [ -z "${best[$name]:-}" ] || [ "$wall" -lt "${best[$name]}" ]; then best[$name]=$wall; fi
            if [ -z "${cpu[$name]:-}" ] || [ "$used" -lt "${cpu[$name]}" ]; then cpu[$name]=$used; fi
        done
    done
    for name in raster report odiff pixelmatch compare idiff; do
        [ -n "${best[$name]:-}" ] || continue
        printf '%-8s %-12s %8d %8d %9sx\n' "$actual" "$name" "${best[$name]}" "${cpu[$name]}" \
            "$(awk "BEGIN { printf \"%.1f\", ${best[$name]} / ${best[raster]} }")"
    done
done
