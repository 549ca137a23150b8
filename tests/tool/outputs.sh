# outputs.sh: what is written appears whole or not at all; what cannot be written is told before rendering (exit 3).
. "$(dirname "$0")/lib.sh"

root_can_write_anything() {
    [ "$(id -u)" = 0 ]
}

test_the_default_is_named_after_the_model() {
    mkdir models
    make_triangle models/some.model.obj
    expect 0 '^some.model.png: 800x600, 1 triangle: 1 drawn' render models/some.model.obj
    expect_files models models/some.model.obj some.model.png
    [ ! -s "$stdout" ] || failed 'something on standard output'
    head -c 8 some.model.png | od -An -tx1 | grep -q '89 50 4e 47 0d 0a 1a 0a' || failed 'no PNG'
}

test_formats_go_by_extension() {
    make_triangle
    expect 0 '' render t.obj --size 5x3 -o a.ppm
    expect 0 '' render t.obj --size 5x3 -o a.PFM
    expect 0 '' render t.obj --size 5x3 -o a.png
    [ "$(head -c 11 a.ppm | tr '\n' ' ')" = 'P6 5 3 255 ' ] || failed 'no PPM'
    [ "$(head -c 7 a.PFM | tr '\n' ' ')" = 'PF 5 3 ' ] || failed 'no PFM'
    expect 0 '' render t.obj --size 5x3 -o -
    same a.png "$stdout"
    expect 0 '' render t.obj --size 5x3 -o /dev/stdout
    same a.png "$stdout"
}

test_an_unknown_extension_is_a_usage_error() {
    make_triangle
    for name in a.jpg a.gif a noextension. .png.x a.pgm a.tga ''; do
        expect 2 '^error: --output' render t.obj -o "$name"
        expect 2 '^error: --output' render missing.obj -o "$name"
    done
    expect 2 '--camera-json-out' render t.obj --camera-json-out camera.txt
    expect_files t.obj
}

test_output_equal_to_input_is_a_usage_error() {
    mkdir d
    make_triangle t.png
    cp t.png before
    ln -s t.png link.png
    ln t.png hard.png
    for name in t.png ./t.png d/../t.png "$PWD/t.png" link.png hard.png; do
        expect 2 'is read too' render t.png -o "$name"
    done
    expect 2 'is read too' render t.png # the default name
    same t.png before
    mv t.png t.json
    expect 2 'is read too' render t.json -o p.png --camera-json-out t.json
    same t.json before
}

test_a_texture_is_not_written_over() {
    make_triangle plain.obj
    "$RASTER" render plain.obj --size 4x4 -q -o skin.png
    cp skin.png before
    printf 'newmtl m\nmap_Kd skin.png\n' >t.mtl
    printf 'mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n' >t.obj
    expect 2 'skin.png.*is read too' render t.obj -o skin.png
    same skin.png before
}

test_two_outputs_have_two_names() {
    make_triangle
    expect 2 'two outputs' render t.obj -o - --camera-json-out -
    expect 2 'several pictures' render t.obj -o - --aov depth
    expect 2 'several pictures' render t.obj -o - --turntable 3
    expect 2 'several pictures' render t.obj -o /dev/null --aov depth
    expect_files t.obj
}

test_a_missing_folder_is_told_before_the_model_is_read() {
    expect 3 '^error: no/p.png: .*No such file or directory' render missing.obj -o no/p.png
    make_triangle
    expect 3 'No such file or directory' render t.obj -o no/p.png
    expect 3 'No such file or directory' render t.obj --camera-json-out no/c.json
    expect 3 'Not a directory' render t.obj -o t.obj/p.png
    expect_files t.obj
}

test_a_read_only_folder_is_told() {
    mkdir d
    make_triangle
    chmod a-w d
    root_can_write_anything || expect 3 'Permission denied' render t.obj -o d/p.png
    # Where even root cannot write:
    expect 3 '^error: /proc/p.png: ' render t.obj -o /proc/p.png
    expect_files t.obj d
}

test_a_folder_as_target_is_told() {
    make_triangle
    mkdir d.png d
    expect 3 'Is a directory' render t.obj -o d.png
    expect 3 'Is a directory' render t.obj -o d
    expect 3 'Is a directory' render t.obj -o d/
    expect 3 'Is a directory' render t.obj -o .
    expect_files t.obj d d.png
}

test_a_full_device_gives_the_words_of_the_system() {
    make_triangle
    expect 3 'No space left on device' render t.obj -o /dev/full
    for command in '--help' '--version' 'render --help' 'info t.obj' 'info t.obj --json' 'doctor' 'render t.obj -o -' \
        'render t.obj --camera-json-out -' 'render t.obj --hash' 'demo'; do
        # shellcheck disable=SC2086
        "$RASTER" $command >/dev/full 2>"$stderr"
        status=$?
        check 3 'No space left on device' "$command"
    done
}

test_a_closed_standard_output_gives_the_words_of_the_system() {
    make_triangle
    for command in '--help' '--version' 'info t.obj' 'doctor' 'render t.obj -o -' 'render t.obj --hash'; do
        # shellcheck disable=SC2086
        "$RASTER" $command >&- 2>"$stderr"
        status=$?
        check 3 'standard output.*Bad file descriptor' "$command"
    done
}

test_a_reader_who_leaves_is_an_error_and_no_signal() {
    make_triangle
    { "$RASTER" render t.obj --size 2000x2000 -o - -q 2>"$stderr"; echo $? >"$scratch/status"; } | head -c 1 >/dev/null
    status=$(cat "$scratch/status")
    # The whole picture may fit into the pipe before the reader leaves.
    [ "$status" = 0 ] || check 3 'Broken pipe' 'into head'
}

test_messages_do_not_end_up_in_a_picture() {
    make_triangle
    run render t.obj --size 9x9 -o a.png
    "$RASTER" render t.obj --size 9x9 -o b.png 2>&-
    "$RASTER" render t.obj --size 9x9 -o c.png <&- >&- 2>&-
    same a.png b.png
    same a.png c.png
}

test_a_limit_on_file_sizes_leaves_the_old_file() {
    make_triangle
    echo old >p.ppm
    cp p.ppm before
    (
        ulimit -f 1
        "$RASTER" render t.obj -o p.ppm
    ) >"$stdout" 2>"$stderr"
    status=$?
    check 3 'File too large' 'under ulimit -f'
    same p.ppm before
    expect_files t.obj p.ppm before
}

test_a_full_disk_leaves_the_old_file() {
    mkdir disk
    # Only root may, and not in every container.
    mount -t tmpfs -o size=64k tmpfs disk 2>/dev/null || return 0
    make_triangle
    echo old >disk/p.ppm
    cp disk/p.ppm before
    expect 3 'No space left on device' render t.obj -o disk/p.ppm
    same disk/p.ppm before
    [ "$(ls -A disk)" = p.ppm ] || failed "a temporary file is left: $(ls -A disk)"
    umount disk
}

test_a_killed_writer_leaves_the_old_file_or_the_new_one() {
    make_triangle
    "$RASTER" render t.obj --size 1500x1500 -q -o old.ppm
    "$RASTER" render t.obj --size 1500x1500 -q -o new.ppm --background 1
    for _ in 1 2 3 4 5 6 7 8; do
        cp old.ppm p.ppm
        "$RASTER" render t.obj --size 1500x1500 -q -o p.ppm --background 1 &
        # Strike while the temporary file is there, or when all is over.
        tries=0
        while kill -0 $! 2>/dev/null && [ $((tries += 1)) -lt 100000 ] && ! compgen -G '.raster-*.tmp' >/dev/null; do :; done
        kill -9 $! 2>/dev/null
        wait $! 2>/dev/null
        cmp -s p.ppm old.ppm || cmp -s p.ppm new.ppm || failed 'neither the old nor the new file'
        rm -f .raster-*.tmp
    done
}

test_an_old_file_is_replaced_and_keeps_its_mode() {
    make_triangle
    echo old >p.png
    chmod 640 p.png
    expect 0 '' render t.obj -o p.png --size 8x8
    [ "$(stat -c %a p.png)" = 640 ] || failed "mode $(stat -c %a p.png)"
    expect_files t.obj p.png
}

test_a_turntable_is_numbered() {
    make_triangle
    expect 0 't.000.png to t.002.png' render t.obj --size 8x8 --turntable 3 --aov depth,triangle.pfm
    expect_files t.obj t.00{0,1,2}.png t.00{0,1,2}.depth.png t.00{0,1,2}.triangle.pfm
    differ t.000.png t.001.png
}

test_quiet_says_nothing() {
    make_triangle
    expect 0 '' render t.obj --size 8x8 -q
    [ ! -s "$stderr" ] || failed 'something on standard error'
}

run_tests "$@"
