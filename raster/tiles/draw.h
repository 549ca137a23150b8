#pragma once
#include <raster/shader.h>
#include <raster/target.h>
namespace raster::tiles { 
template <Shader S>
DrawCounts draw(Target& , const S& , const Mesh<typename S::template Vertex<float>>& , const State& ){return {};}
}
