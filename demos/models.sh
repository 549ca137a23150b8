# models.sh: pictures of real models, into out/. Sourced by run.sh, which sets march.
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
render teapot models/teapot.obj --material color=0.75,0.3,0.12:specular=0.6:shininess=80 \
    --light head --light directional:dir=-1,0.2,0.3:color=0.25,0.35,0.6:ambient=0
render bunny /usr/share/glmark2/models/bunny.obj
render spider /usr/share/assimp/models/OBJ/spider.obj
render cornell_box models/cornell_box.obj --light point:pos=278,500,280:ambient=0.25 \
    --camera-position 278,273,-800 --camera-focal-point 278,273,0 --camera-view-angle 40
render torus-flat models/torus.obj --shade flat
render torus-gouraud models/torus.obj --shade gouraud
render torus-phong models/torus.obj --shade phong

echo
echo "Pictures:"
printf '  %s\n' "${pictures[@]}"
echo "Next, for example:"
echo "  $raster step models/teapot.obj   # a page to step through the pipeline"
echo "  $raster pixel /usr/share/glmark2/models/bunny.obj 400 300"
echo "  bash demos/run.sh gallery   # the figures of the lectures, into out/gallery/"
