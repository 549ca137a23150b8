# gallery.sh: pictures of models, into out/. Sourced by run.sh, which sets march.
install_packages "${build_packages[@]}" "${model_packages[@]}"
configure_and_build demo -DRASTER_MARCH="$march"
raster=build/demo/raster/tool/raster
mkdir -p out

# render NAME MODEL [OPTION...]
render() {
    local picture=out/$1.png model=$2
    shift 2
    "$raster" render "$model" -o "$picture" --size 800x600 "$@"
    pictures+=("$picture")
}

pictures=()
render teapot models/teapot.obj
render bunny /usr/share/glmark2/models/bunny.obj
render spider /usr/share/assimp/models/OBJ/spider.obj
render cornell_box models/cornell_box.obj
render torus-flat models/torus.obj --shade flat
render torus-gouraud models/torus.obj --shade gouraud
render torus-phong models/torus.obj --shade phong

echo
echo "Pictures:"
printf '  %s\n' "${pictures[@]}"
echo "Next:"
echo "  $raster render models/teapot.obj --turntable 36 -o out/turn.png"
echo "  $raster info /usr/share/assimp/models/OBJ/spider.obj"
echo "  $raster --help"
