#!/bin/sh
# pkg_config.sh: builds triangle.cpp with nothing but a compiler and what pkg-config says, and runs it.
# usage: pkg_config.sh COMPILER FOLDER-OF-raster.pc WORK-FOLDER
set -eu
compiler=$1 work=$3
export PKG_CONFIG_PATH="$2"
mkdir -p "$work"
# shellcheck disable=SC2046 # the flags are words
"$compiler" -std=c++20 -O1 $(pkg-config --cflags raster) "$(dirname "$0")/triangle.cpp" -o "$work/triangle" \
    $(pkg-config --libs raster) -Wl,-rpath,"$2/.."
"$work/triangle"
