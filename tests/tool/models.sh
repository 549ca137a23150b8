# models.sh: the OBJ files that Debian packages install, where they are, each drawn or refused in words.
. "$(dirname "$0")/lib.sh"

# not_blank FILE.ppm: more than a twentieth of the bytes are not background.
not_blank() {
    local size
    size=$(($(wc -c <"$1") - 15))
    [ "$(tail -c "$size" "$1" | tr -d '3' | wc -c)" -gt $((size / 20)) ] || failed "$1 is nearly blank"
}

test_the_models_of_the_tree_are_drawn() {
    local model
    for model in "$SOURCE"/models/*.obj; do
        expect 0 'drawn' render "$model" --size 320x240 -o p.ppm
        not_blank p.ppm
        if grep -q '^warning' "$stderr"; then failed "$model: $(grep -m1 warning "$stderr")"; fi
    done
}

test_the_models_of_debian_are_drawn() {
    local model
    for model in /usr/share/glmark2/models/bunny.obj /usr/share/assimp/models/OBJ/spider.obj \
        /usr/share/doc/embree3/models/cornell_box.obj; do
        [ -e "$model" ] || continue
        expect 0 'drawn' render "$model" --size 480x270 -o 1.ppm --threads 1
        expect 0 'drawn' render "$model" --size 480x270 -o 3.ppm --threads 3
        same 1.ppm 3.ppm
        not_blank 1.ppm
    done
}

test_each_test_model_of_assimp_is_drawn_or_refused_in_words() {
    local model
    for model in /usr/share/assimp/models/OBJ/*.obj /usr/share/assimp/models/invalid/*.obj; do
        [ -e "$model" ] || continue
        run render "$model" --size 64x48 -o p.png
        case $status in
            0) [ -s p.png ] || failed "$model: no picture" ;;
            1) check 1 "$(basename "$model")" "$model"; [ ! -e p.png ] || failed "$model: refused and drawn" ;;
            *) failed "$model: exit code $status" ;;
        esac
        rm -f p.png
        run info "$model" --json
        [ "$status" -le 1 ] || failed "info $model: exit code $status"
    done
}

run_tests "$@"
