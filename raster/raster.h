// raster.h: all of the library in one include.
#pragma once

#include <raster/lanes.h>
#include <raster/math.h>
#include <raster/pipeline.h>
#include <raster/result.h>
#include <raster/shader.h>
#include <raster/state.h>
#include <raster/target.h>
