# bench.sh: this library against llvmpipe behind OSMesa. Sourced by run.sh, which sets march.
install_packages "${build_packages[@]}" "${model_packages[@]}" "${bench_packages[@]}"
configure_and_build demo -DRASTER_MARCH="$march" -DRASTER_BUILD_BENCH=ON
build/demo/demos/bench/raster_bench "$@"
