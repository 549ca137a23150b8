// models.cpp: all reflectance models behind one call, compiled once.
#include <raster/shading/models.h>

namespace raster {

template Reflectance<float> RuntimeModel::evaluate(const Frame<float>&, const vec<3, float>&) const;
template Reflectance<FloatN> RuntimeModel::evaluate(const Frame<FloatN>&, const vec<3, FloatN>&) const;

}  // namespace raster
