# brdf.sh: tables of reflectance: baked, read back, compressed, broken.
. "$(dirname "$0")/lib.sh"

small=(--table-size 30x20x24)

test_a_table_has_the_layout_of_the_database() {
    expect 0 'gold.binary: 30x20x24 cells' brdf gold:roughness=0.2 -o gold.binary "${small[@]}"
    expect_files gold.binary
    [ "$(stat -c %s gold.binary)" = $((12 + 30 * 20 * 24 * 3 * 8)) ] || failed 'size of the file'
    [ "$(od -An -tu4 -N12 gold.binary | tr -s ' ')" = ' 30 20 24' ] || failed 'its three numbers'
}

test_the_full_size_is_that_of_the_database() {
    expect 0 '' brdf paper -o p.binary --quiet
    [ "$(stat -c %s p.binary)" = 34992012 ] || failed 'size of the file'
    [ ! -s "$stderr" ] || failed 'it talks'
}

test_a_table_looks_like_what_it_was_baked_from() {
    expect 0 '' brdf clay -o clay.binary
    expect 0 '' render shape:sphere --size 64x64 --material clay --light directional:dir=-1,-1,-1 -o model.png
    expect 0 '' render shape:sphere --size 64x64 --material brdf=clay.binary --light directional:dir=-1,-1,-1 -o table.png
    expect 0 '' diff model.png table.png --max-delta 4
    expect 0 '' brdf paper -o paper.binary --table-size 4x4x4
    expect 0 '' render shape:sphere --size 64x64 --material brdf=paper.binary --light directional:dir=-1,-1,-1 -o wrong.png
    run diff model.png wrong.png --max-delta 4
    [ "$status" = 1 ] || failed 'another material is not seen'
}

test_a_metal_keeps_its_colour_under_a_model_without_fresnel() {
    local as=(--size 64x64 --light directional:dir=-1,-1,-1 --display plain)
    expect 0 '' brdf gold:reflectance=phong -o gold.binary
    expect 0 '' render shape:sphere --material gold:reflectance=phong "${as[@]}" -o model.png
    expect 0 '' render shape:sphere --material brdf=gold.binary "${as[@]}" -o table.png
    expect 0 '' diff model.png table.png --max-delta 8
}

test_layers_are_in_the_table_too() {
    local as=(--size 64x64 --light directional:dir=-1,-1,-1 --display srgb) coated=clay:clearcoat=1:clearcoat_roughness=0.5:sheen=0.5
    expect 0 '' brdf $coated -o coated.binary
    expect 0 '' render shape:sphere --material $coated "${as[@]}" -o model.png
    expect 0 '' render shape:sphere --material brdf=coated.binary "${as[@]}" -o table.png
    expect 0 '' diff model.png table.png --max-delta 6 --max-pixels 8
    expect 0 '' render shape:sphere --material clay "${as[@]}" -o bare.png
    run diff bare.png table.png --max-delta 6 --max-pixels 8
    [ "$status" = 1 ] || failed 'the layers are not seen'
}

test_a_table_can_be_baked_of_a_table() {
    expect 0 '' brdf iron -o a.binary "${small[@]}"
    expect 0 '' brdf a.binary -o b.binary
    same a.binary b.binary
}

test_all_components_give_the_table_back_and_fewer_a_larger_error() {
    local k last=10 error
    for k in 0 1 2 3; do
        expect 0 ", $k of 3 components with [01]\.[0-9]+ of the variance, relative error" \
            brdf plastic:roughness=0.3 paper gold:roughness=0.5 velvet -o few.binary --components $k "${small[@]}"
        error=$(grep -oE '[0-9.]+$' "$stderr")
        awk "BEGIN { exit !($error <= $last) }" || failed "error $error of $k, $last before"
        last=$error
    done
    awk "BEGIN { exit !($last < 0.001) }" || failed "error $last of all components"
    expect 0 '' render shape:sphere --size 16x16 --material brdf=few.binary -o p.png
}

test_what_cannot_be_done_is_told() {
    expect 2 'required' brdf
    expect 2 '--output is required' brdf gold
    expect 2 "'silver' is one material too many without --components" brdf gold silver -o g.binary
    expect 2 "'goldd' is none of .*gold" brdf goldd -o g.binary
    expect 2 'not HxDxP' brdf gold -o g.binary --table-size 90x90
    expect 2 'from 2 to 360' brdf gold -o g.binary --table-size 1x90x180
    expect 2 'too many cells' brdf gold -o g.binary --table-size 360x360x360
    expect 2 'components' brdf gold -o g.binary --components 65
    expect 3 'no-such-folder' brdf gold -o no-such-folder/g.binary "${small[@]}"
    expect 3 'missing.binary' brdf missing.binary -o g.binary
    expect_files
}

test_tables_of_different_sizes_do_not_mix() {
    expect 0 '' brdf gold -o small.binary --table-size 4x4x4
    expect 2 'another size' brdf gold small.binary -o g.binary --components 1 "${small[@]}"
}

test_broken_tables_are_told() {
    expect 0 '' brdf gold -o gold.binary --table-size 4x4x4
    head -c 100 gold.binary >cut.binary
    : >empty.binary
    { printf '\377\377\377\377'; tail -c +5 gold.binary; } >huge.binary
    local file
    for file in cut empty huge; do
        expect 1 "$file.binary: " brdf $file.binary -o g.binary
        expect 1 "^error: $file.binary: " render shape:sphere --material brdf=$file.binary -o p.png
    done
    expect 3 "^error: missing.binary: " render shape:sphere --material brdf=missing.binary -o p.png
    rm ./*.binary
    expect_files
}

test_a_scene_finds_tables_beside_itself_and_nowhere_else() {
    mkdir in
    expect 0 '' brdf gold -o in/gold.binary --table-size 4x4x4
    cp in/gold.binary outside.binary
    scene() {
        printf '{"format": "raster-scene", "version": 1, "objects": [\n {"shape": "sphere", "material": %s}]}\n' "$1" \
            >in/s.json
    }
    scene '{"brdf": "gold.binary"}'
    expect 0 '' render in/s.json --size 16x16 -o p.png
    scene '"brdf=gold.binary"'
    expect 0 '' render in/s.json --size 16x16 -o p.png
    scene '{"color": 0.5, "brdf": "../outside.binary"}'
    expect 1 "in/s.json:2:49: .*../outside.binary: refused.*--allow-outside" render in/s.json -o p.png
    expect 0 '' render in/s.json --size 16x16 -o p.png --allow-outside
    scene '{"brdf": "missing.binary"}'
    expect 1 'in/s.json:2:35: .*missing.binary: not found' render in/s.json -o p.png
}

run_tests "${1:-}"
