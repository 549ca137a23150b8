// fragment.h: stage 10, run the shader's fragment function: from varyings to a colour and extra values.
#pragma once

#include <raster/shader.h>

namespace raster {

namespace detail {
template <class S, class F>
inline auto call_fragment(const S& shader, const typename S::template Varyings<F>& in, const FragmentInput<F>& at) {
    if constexpr (HasPlacedFragment<S>) {
        return shader.fragment(in, at);
    } else {
        return shader.fragment(in);
    }
}
template <HasFragment S>
using FragmentResult = decltype(call_fragment<S, float>(std::declval<const S&>(),
                                                        std::declval<typename S::template Varyings<float>>(),
                                                        std::declval<FragmentInput<float>>()));
}  // namespace detail

/// How many floats a fragment returns: four of colour, then those of the extra planes.
template <HasFragment S>
inline constexpr int output_count = detail::float_count<detail::FragmentResult<S>>;

/// What a fragment returns, as numbers: red, green, blue, alpha, then the extra planes' values.
template <HasFragment S, class F>
using OutputArray = std::array<F, std::size_t(output_count<S>)>;

/// Whether all fragments of a triangle return the same: no varying changes across it, and the shader is not told where a
/// fragment lies.
template <HasFragment S>
inline constexpr bool is_constant_fragment = [] {
    if (HasPlacedFragment<S>) return false;
    for (int i = 0; i < varying_count<S>; ++i)
        if (interpolation_of<S>(i) != Interpolation::flat) return false;
    return true;
}();

template <HasFragment S, class F>
inline OutputArray<S, F> shade_fragment(const S& shader, const VaryingArray<S, F>& varyings,
                                        const FragmentInput<F>& at) {
    static_assert(output_count<S> >= 4, "a fragment function returns vec<4, F> or a struct that begins with one");
    const auto result = detail::call_fragment<S, F>(shader, from_array<S, F>(varyings), at);
    OutputArray<S, F> array;
    std::memcpy(static_cast<void*>(array.data()), &result, sizeof array);
    return array;
}

}  // namespace raster
