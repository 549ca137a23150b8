// strokes.h: the fast draw of lines and points: set up in chunks, drawn in bands of rows, each on all threads.
//
// A pixel is drawn by the very function that an observed draw calls; what is saved is the search for pixels.
#pragma once

#include <vector>

#include <raster/pixel.h>
#include <raster/stages/assemble.h>
#include <raster/stages/stroke.h>
#include <raster/tiles/parallel.h>

namespace raster::tiles {

/// The pixels x0 to x1 of row y inside all edges; none when x0 > x1.
template <Shader S>
inline std::pair<int, int> covered_in_row(const Stroke<S>& stroke, int y) {
    std::int64_t x0 = stroke.box.min_x, x1 = stroke.box.max_x;
    for (int i = 0; i < stroke.edge_count; ++i) {
        // Inside where start + step x >= 0; both divisions round towards the inside.
        const Edge<float>& edge = stroke.edges[std::size_t(i)];
        const std::int64_t start = pixel_origin(edge) + std::int64_t(edge.step_y) * y, step = edge.step_x;
        if (step > 0 && start < 0) x0 = std::max(x0, (-start + step - 1) / step);
        if (step < 0) x1 = start < 0 ? x0 - 1 : std::min(x1, start / -step);
        if (step == 0 && start < 0) x1 = x0 - 1;
    }
    return {int(x0), int(std::max(x1, x0 - 1))};
}

template <Shader S>
DrawCounts draw_strokes(Target& target, const S& shader, const Mesh<typename S::template Vertex<float>>& mesh,
                        const State& state) {
    const Viewport viewport = effective_viewport(state.viewport, target.width(), target.height());
    const std::size_t indices = mesh.indices.empty() ? mesh.vertices.size() : mesh.indices.size();
    const std::size_t count = primitive_count(state.topology, indices);
    DrawCounts counts;
    if (!is_valid(viewport) || count == 0) return counts;

    constexpr std::size_t chunk = 4096;
    const auto chunks = [](std::size_t n) { return (n + chunk - 1) / chunk; };
    std::vector<ShadedVertex<float, std::size_t(varying_count<S>)>> shaded(mesh.vertices.size());
    parallel_for(chunks(shaded.size()), [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, shaded.size()); ++i)
            shaded[i] = shade_vertex<S, float>(shader, mesh.vertices[i]);
    });

    const StrokeContext context{state, ViewportTransform(viewport), target.width(), target.height(),
                                drawable_pixels(state, target.width(), target.height())};
    const auto vertex = [&](std::size_t k) {
        const std::size_t v = mesh.indices.empty() ? k : mesh.indices[k];
        return v < shaded.size() ? &shaded[v] : nullptr;
    };
    std::vector<std::vector<Stroke<S>>> strokes(chunks(count));
    std::vector<DrawCounts> chunk_counts(strokes.size());
    parallel_for(strokes.size(), [&](std::size_t c) {
        for (std::size_t i = c * chunk; i < std::min((c + 1) * chunk, count); ++i)
            if (const auto stroke = make_stroke<S>(context, i, indices, vertex, chunk_counts[c]);
                stroke && !stroke->box.empty())
                strokes[c].push_back(*stroke);
    });
    for (const DrawCounts& c : chunk_counts) counts += c;

    constexpr int band_rows = 32;
    (void)target.depth();  // writes a pending clear
    NoObserver nobody;
    parallel_for(std::size_t((target.height() + band_rows - 1) / band_rows), [&](std::size_t band) {
        const int first = int(band) * band_rows, last = first + band_rows - 1;
        for (const auto& some : strokes)
            for (const Stroke<S>& stroke : some)
                for (int y = std::max(stroke.box.min_y, first); y <= std::min(stroke.box.max_y, last); ++y) {
                    const auto [x0, x1] = covered_in_row(stroke, y);
                    for (int x = x0; x <= x1; ++x)
                        draw_pixel<S>(target, shader, state, {stroke.primitive, 0, x, y, true}, stroke.depth,
                                      stroke.varyings, nobody);
                }
    });
    return counts;
}

}  // namespace raster::tiles
