# gallery.sh: the figures of the lectures, into out/gallery/index.html. Sourced by run.sh, which sets march.
#
#   bash demos/run.sh gallery          full size
#   bash demos/run.sh gallery --docs   small ones and their page, docs/gallery.md
#
# $RASTER, $CURVES and $BSSRDF may name the programs raster, raster_curves and raster_bssrdf where they are built already.
small=
if [ "${1:-}" = --docs ]; then small=yes; fi
install_packages "${build_packages[@]}" "${model_packages[@]}" gnuplot-nox
raster=${RASTER:-build/demo/raster/tool/raster}
curves=${CURVES:-build/demo/demos/gallery/raster_curves}
bssrdf=${BSSRDF:-build/demo/demos/gallery/raster_bssrdf}
if [ -z "${RASTER:-}" ]; then
    configure_and_build demo -DRASTER_MARCH="$march"
    cmake --build build/demo --target raster_curves raster_bssrdf -j "$(nproc)"
fi
folder=out/gallery
page=out/gallery/index.html
if [ -n "$small" ]; then
    folder=docs/gallery
    page=docs/gallery.md
fi
mkdir -p "$folder"
new_page=$(mktemp)
data=$(mktemp -d)
trap 'rm -rf "$new_page" "$data"' EXIT

escaped() { sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' <<<"$*"; }

put() { printf '%s\n' "$@" >>"$new_page"; }

# figure ID TITLE TEXT: begins a figure; ID is the row's name in the lectures' table.
figure() {
    echo "  $1  $2"
    if [ -n "$small" ]; then
        put "" "## $2" "" "$3" ""
    else
        put "<h2 id=\"${1%% *}\">$2</h2>" "<p>$3</p>"
    fi
}

# shown FILE WIDTH CAPTION COMMAND: a picture and the command that makes it.
shown() {
    if [ -n "$small" ]; then
        put "![$3](gallery/$1)" "" "$3${4:+: \`$4\`}" ""
    else
        put "<figure><img src=\"$1\" alt=\"$(escaped "$3")\" width=\"$2\"><figcaption>$(escaped "$3")${4:+<code>$(
            escaped "$4")</code>}</figcaption></figure>"
    fi
}

# picture NAME WxH CAPTION MODEL [FLAG...]: draws it; the small ones are two fifths as large. $before is a command that
# was needed first.
picture() {
    local name=$1 width=${2%x*} height=${2#*x} caption=$3 command="raster render" word
    shift 3
    for word in "$@"; do
        case $word in
            *[!A-Za-z0-9_.,:=/+-]*) command+=" '$word'" ;;
            *) command+=" $word" ;;
        esac
    done
    command=${command//"$data/"/}
    [ -z "${before:-}" ] || command="$before && $command"
    [ -z "$small" ] || width=$((width * 2 / 5)) height=$((height * 2 / 5))
    "$raster" render "$@" --size "${width}x$height" -o "$folder/$name.png" --quiet
    shown "$name.png" "$width" "$caption" "$command"
}

# curve FILE ARGUMENT...: what raster_curves gives, in $data/FILE; sets $from to the command.
curve() {
    local file=$1
    shift
    from="raster_curves $*"
    from=${from//"$data/"/}
    "$curves" "$@" >"$data/$file"
}

# plot NAME CAPTION: commands for gnuplot on standard input; files are named from $data, and made by the command $from.
plot() {
    {
        echo "set terminal svg size 560,340 font 'sans-serif,13' background '#ffffff'"
        echo "set output '$folder/$1.svg'"
        echo "set grid lc rgb '#dddddd'; set key bottom left; set style data lines"
        cat
    } | gnuplot
    shown "$1.svg" 560 "$2" "${from:+$from; plotted by gnuplot}"
}

# floats_of FILE.pfm: the light of a picture of 401x401, one line a pixel: red, green, blue; the last row first.
floats_of() { tail -c $((401 * 401 * 12)) "$1" | od -An -v -w12 -tf4; }

# table FILE MATERIAL...: bakes a table $data/FILE, with flags of `raster brdf` among the materials; sets $before, and
# $said to what the command says.
table() {
    local file=$1
    shift
    before="raster brdf $* -o $file"
    before=${before//"$data/"/}
    said=$("$raster" brdf "$@" -o "$data/$file" 2>&1 | tail -1)
}

# row_of Y MODEL [FLAG...]: the light along row Y of a picture of 401x401, one line a pixel: its number from the left,
# red, green, blue.
row_of() {
    local y=$1
    shift
    from="raster render $* --size 401x401 -o row.pfm"
    "$raster" render "$@" --size 401x401 -o "$data/row.pfm" --quiet
    floats_of "$data/row.pfm" | awk -v first=$(((400 - y) * 401)) \
        'NR > first && NR <= first + 401 {print NR - 1 - first, $1, $2, $3}'
}

# color_at X Y MODEL [FLAG...]: a pixel of a picture of 101x101 as "R G B", 0 to 255.
color_at() {
    local from_end=$((3 * ((100 - $2) * 101 + 101 - $1)))
    shift 2
    "$raster" render "$@" --size 101x101 -o "$data/pixel.ppm" --quiet
    od -An -tu1 -j $(($(wc -c <"$data/pixel.ppm") - from_end)) -N 3 "$data/pixel.ppm" | awk '{print $1 ", " $2 ", " $3}'
}

if [ -n "$small" ]; then
    put "# Gallery" "" \
        "The figures of the lectures, drawn by the command. \`bash demos/run.sh gallery\` draws them large, into" \
        "\`out/gallery/index.html\`; this page comes from \`bash demos/run.sh gallery --docs\`. The numbers of" \
        "the curves come of the command too, or of \`raster_curves\` and \`raster_bssrdf\`, which the demo builds from" \
        "[curves.cpp](../demos/gallery/curves.cpp) and [bssrdf.cpp](../demos/gallery/bssrdf.cpp)."
else
    cat >"$new_page" <<'HTML'
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>raster: the gallery</title>
<style>
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 1060px; margin: 2em auto; padding: 0 1em; }
h2 { margin-top: 2em; border-top: 1px solid #8886; padding-top: 1em; }
p { max-width: 46em; }
figure { display: inline-block; vertical-align: top; margin: 0 1em 1em 0; max-width: 100%; }
img { max-width: 100%; height: auto; display: block; }
figcaption { font-size: 14px; contain: inline-size; }
code { display: block; font-size: 12px; overflow-wrap: anywhere; opacity: 0.8; }
</style></head><body>
<h1>The gallery</h1>
<p>The figures of the lectures, drawn by the command below each of them. The numbers of the curves come of the command
too, or of raster_curves and raster_bssrdf, which the demo builds from demos/gallery/curves.cpp and bssrdf.cpp.</p>
HTML
fi
echo "Figures:"
. demos/gallery/figures.sh
. demos/gallery/physical.sh
[ -n "$small" ] || put "</body></html>"
cp "$new_page" "$page"
chmod 644 "$page"

echo
echo "The page with all pictures: $page"
echo "Next, for example:"
echo "  $raster render models/teapot.obj -o out/turn.png --turntable 36"
echo "  $raster render shape:vase --material color=0.7,0.3,0.1 -o out/vase.png"
echo "  $raster render --help"
