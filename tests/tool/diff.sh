# diff.sh: raster diff and raster approve.
. "$(dirname "$0")/lib.sh"

# A PGM of WIDTH x HEIGHT grey pixels, but pixel number INDEX (from the top left) has the value VALUE:
# grey FILE WIDTH HEIGHT GREY [INDEX VALUE]...
grey() {
    perl -e '($w, $h, $v, %at) = @ARGV; print "P5\n$w $h\n255\n"; print chr($at{$_} // $v) for 0 .. $w * $h - 1' \
        "${@:2}" >"$1"
}

# A 16-bit grey PNG of one row: deep FILE VALUE...
deep() {
    perl -MCompress::Zlib -e 'sub chunk { print pack("N", length $_[1]), $_[0], $_[1], pack("N", crc32($_[0] . $_[1])) }
        print "\x89PNG\r\n\x1a\n"; chunk("IHDR", pack("NNC5", scalar @ARGV, 1, 16, 0, 0, 0, 0));
        chunk("IDAT", compress("\0" . pack("n*", @ARGV))); chunk("IEND", "")' "${@:2}" >"$1"
}

# answer STATUS WORDS ARGUMENT...: runs `raster diff`; the exit code and words of standard output must be as given.
answer() {
    local expected=$1 words=$2
    shift 2
    run diff "$@"
    [ "$status" = "$expected" ] || failed "diff $*: exit code $status, not $expected"
    [ -z "$words" ] || grep -qE -- "$words" "$stdout" || failed "diff $*: no '$words' on standard output"
}

# A PFM of 2 x 1 grey floats, the first as four bytes from printf, the other 0.5.
floats() {
    { printf 'Pf\n2 1\n-1\n'; printf "$2"; printf '\000\000\000\077'; } >"$1"
}

test_equal_pictures_leave_nothing_behind() {
    grey a.pgm 8 4 90
    cp a.pgm b.pgm
    answer 0 'all same: 1 picture' a.pgm b.pgm
    expect_files a.pgm b.pgm
}

test_the_difference_alone_where_the_output_is_a_picture() {
    grey a.pgm 8 4 90
    grey b.pgm 8 4 90 9 96
    answer 1 'written +\./d\.png' a.pgm b.pgm -o d.png
    expect_out '1 of 1 picture failed$'
    expect_files a.pgm b.pgm d.png
    mv d.png alone.png
    answer 1 'different' a.pgm b.pgm
    same alone.png diff-out/a.pgm.diff.png
    rm -r diff-out
    mkdir sub
    answer 1 'written +sub/d\.png' a.pgm b.pgm --out sub/d.png
    answer 0 'all same' a.pgm a.pgm --out sub/d.png
    expect_files a.pgm b.pgm alone.png sub # what is not true any more is gone
    grey wide.pgm 9 4 90
    answer 1 'size' a.pgm wide.pgm -o d.png
    expect_files a.pgm b.pgm wide.pgm alone.png sub # there is no difference to draw
    answer 2 '' sub sub -o d.png
}

test_all_figures_are_told_and_what_would_pass() {
    grey a.pgm 8 4 90
    grey b.pgm 8 4 90 9 96
    answer 1 'different: a.pgm' a.pgm b.pgm
    for words in '1 of 32 pixels differ' 'max 6 at \(1,1\)' 'mean ' 'RMS ' 'PSNR ' 'SSIM ' 'FLIP 0\.[0-9]' \
        'would pass +--max-delta 6, or --max-pixels 1,' 'approve diff-out'; do
        expect_out "$words"
    done
    expect_files a.pgm b.pgm diff-out diff-out/a.pgm.actual.pgm diff-out/a.pgm.diff.png diff-out/a.pgm.triptych.png \
        diff-out/diff.json diff-out/report.html
    answer 0 'all same' a.pgm a.pgm
    expect_files a.pgm b.pgm # what is not true any more is gone
}

test_each_gate() {
    grey a.pgm 16 8 90
    grey b.pgm 16 8 90 20 96 21 93
    answer 0 'all pass: 1 picture, 1 within the gates' a.pgm b.pgm --max-delta 6
    answer 1 'would pass' a.pgm b.pgm --max-delta 5
    answer 0 '' a.pgm b.pgm --max-pixels 2
    answer 1 '' a.pgm b.pgm --max-pixels 1
    answer 0 '' a.pgm b.pgm --max-pixels 1 --max-delta 3
    answer 0 '' a.pgm b.pgm --flip 0.2
    answer 1 '' a.pgm b.pgm --flip 0
    answer 1 '' a.pgm b.pgm --flip 0.2 --max-delta 5
    grey c.pgm 16 8 90 37 200
    grey d.pgm 16 8 90 38 200
    answer 0 '' c.pgm d.pgm --max-shift 1
    answer 1 'would pass.*--max-shift 1' c.pgm d.pgm
    answer 1 '' a.pgm d.pgm --max-shift 3
    answer 0 'warning +--max-delta 60 is far looser than needed: 6 would pass' a.pgm b.pgm --max-delta 60
    answer 0 'warning +--flip 1 is far looser' a.pgm b.pgm --flip 1
    for wrong in '--max-delta -1' '--max-delta x' '--max-pixels 1.5' '--max-shift 17' '--flip 2'; do
        # shellcheck disable=SC2086
        answer 2 '' a.pgm b.pgm $wrong
    done
}

test_masks_and_ignored_rectangles() {
    grey a.pgm 8 4 90
    grey b.pgm 8 4 90 9 200 31 200
    answer 1 '2 of 32' a.pgm b.pgm
    answer 1 '1 of 28' a.pgm b.pgm --ignore 0,0,2,2
    answer 0 '' a.pgm b.pgm --ignore 0,0,2,2 --ignore 7,3,100,100
    grey mask.pgm 8 4 255 9 0 31 0
    answer 0 '' a.pgm b.pgm --mask mask.pgm
    grey mask.pgm 8 4 255 9 0
    answer 1 '1 of 31' a.pgm b.pgm --mask mask.pgm
    grey small.pgm 4 4 255
    answer 2 '' a.pgm b.pgm --mask small.pgm
    answer 2 '' a.pgm b.pgm --ignore 0,0,8,4
}

test_named_failures_pass_no_gate() {
    local gates=(--max-delta 255 --max-pixels 1000000 --max-shift 16 --flip 1)
    grey a.pgm 8 4 90
    grey wide.pgm 9 4 90
    answer 1 'size mismatch' a.pgm wide.pgm "${gates[@]}"
    expect_out 'expected 8x4, actual 9x4'
    floats nan.pfm '\000\000\300\177'
    floats one.pfm '\000\000\200\077'
    answer 1 'not a number' one.pfm nan.pfm "${gates[@]}"
    ! grep -q approve "$stdout" || failed "a picture with NaN cannot be approved"
    answer 1 'not a number' nan.pfm nan.pfm "${gates[@]}"
    grey two.pgm 2 1 90
    answer 1 'type mismatch' two.pgm one.pfm "${gates[@]}"
    echo no picture >bad.png
    answer 2 'unreadable' a.pgm bad.png "${gates[@]}"
    answer 2 '' a.pgm none.png
    mkdir folder
    answer 2 '' a.pgm folder
}

test_folders_are_matched_by_name() {
    mkdir -p want/sub got/sub
    grey want/same.pgm 4 4 10
    cp want/same.pgm got
    grey want/sub/other.pgm 4 4 10
    grey got/sub/other.pgm 4 4 10 3 11
    grey want/gone.pgm 4 4 10
    grey got/new.pgm 4 4 10
    answer 1 'different: sub/other.pgm' want got --junit junit.xml
    for words in 'missing: gone.pgm' 'added: new.pgm' '3 of 4 pictures failed'; do expect_out "$words"; done
    grep -q 'tests="4" failures="3" errors="0"' junit.xml || failed "$(cat junit.xml)"
    expect 0 '' approve
    cmp -s want/new.pgm got/new.pgm || failed "the new picture is not among the goldens"
    rm want/gone.pgm
    answer 0 'all same: 3 pictures' want got
}

test_sixteen_bits_and_floats_are_compared_in_their_own_steps() {
    deep a.png 1000 2000
    deep b.png 1000 2007
    answer 1 'max 7 at \(1,0\)' a.png b.png
    answer 0 '' a.png b.png --max-delta 7
    floats a.pfm '\000\000\200\077'
    floats b.pfm '\001\000\200\077'
    answer 1 'max 1.1920929e-0?7' a.pfm b.pfm
    answer 0 '' a.pfm b.pfm --max-delta 1.1920929e-7
}

test_what_programs_read() {
    grey a.pgm 8 4 90
    grey b.pgm 8 4 90 9 96
    answer 1 '"schema":"raster-diff"' a.pgm b.pgm --json --junit junit.xml
    same "$stdout" diff-out/diff.json
    python3 - diff-out/diff.json junit.xml diff-out/report.html <<'PYTHON' || failed "files for programs"
import json, re, sys
import xml.etree.ElementTree as xml
pair = json.load(open(sys.argv[1]))["pairs"][0]
figures = pair["figures"]
assert pair["verdict"] == "different" and figures["max"] == 6 and figures["max_at"] == [1, 1], pair
assert {"compared", "differing", "failing", "mean", "rms", "psnr", "ssim", "flip"} <= set(figures)
assert pair["would_pass"][0] == {"max_delta": 6, "options": "--max-delta 6"}, pair["would_pass"]
suite = xml.parse(sys.argv[2]).getroot()[0]
assert suite.attrib["failures"] == "1" and "max 6 at (1,1)" in suite[0][0].text
page = open(sys.argv[3]).read()
assert not re.search(r'(src|href)="(?!data:|#)', page) and "http://" not in page.replace("http://www.w3.org", "")
PYTHON
}

test_approval() {
    grey golden.pgm 8 4 90
    grey new.pgm 8 4 90 9 96
    answer 1 '' golden.pgm new.pgm
    cp golden.pgm before.pgm
    expect 0 '' approve --list
    same golden.pgm before.pgm
    CI=true run approve
    check 2 'CI' "approve where CI is set"
    same golden.pgm before.pgm
    printf 'x' >>diff-out/golden.pgm.actual.pgm
    run approve
    [ "$status" = 1 ] || failed "a picture that changed since was approved"
    same golden.pgm before.pgm
    answer 1 '' golden.pgm new.pgm
    if [ "$(id -u)" != 0 ]; then
        chmod a-w .
        run approve
        [ "$status" = 3 ] || failed "approved in a folder that cannot be written"
        chmod u+w .
        same golden.pgm before.pgm
    fi
    CI= expect 0 '' approve diff-out
    expect_out 'golden.pgm'
    same golden.pgm new.pgm
    answer 0 '' golden.pgm new.pgm
    [ -z "$(find . -name '*.tmp*' -o -name '.*.pgm*')" ] || failed "temporary files: $(ls -a)"
}

unset CI
run_tests
