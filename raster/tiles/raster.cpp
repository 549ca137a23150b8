// raster.cpp: opaque draws: remember at each pixel of a tile which triangle is visible.
#include <raster/tiles/raster.h>

namespace raster::tiles {

namespace {

/// The Sink that remembers. Without need of colours only uniform blocks keep their slots.
template <bool colors>
class RememberSink : public SlotMaker {
public:
    static constexpr bool remembers = true;

    using SlotMaker::SlotMaker;

    void cell(int i, MaskN passed) {
        if constexpr (colors)
            store_cell(tile_.slot + i, select(passed, IntN(slot()), load_cell<native_lanes>(tile_.slot + i)));
    }
    void row(int i, MaskN passed) {
        if constexpr (colors)
            store_int(tile_.slot + i, select(passed, IntN(slot()), load_int<FloatN>(tile_.slot + i)));
    }
    void pixel(int i) {
        if constexpr (colors) tile_.slot[i] = slot();
    }
    void end() {}
};

template <class Depth, bool colors>
RASTER_FLATTEN void raster_remembering(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index,
                                       TileBuffer& tile, const Depth& depth) {
    RememberSink<colors> sink(tile);
    raster_tile(draw, chunks, tile_index, tile, depth, sink);
}

}  // namespace

void raster_opaque(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index, TileBuffer& tile,
                   DepthFormat format, bool colors) {
    const State& state = draw.state;
    if (state.depth_compare == UsualDepth::compare && state.depth_write && format == UsualDepth::format) {
        if (colors) {
            raster_remembering<UsualDepth, true>(draw, chunks, tile_index, tile, {});
        } else {
            raster_remembering<UsualDepth, false>(draw, chunks, tile_index, tile, {});
        }
    } else {
        const AnyDepth depth{state.depth_compare, state.depth_write, format};
        if (colors) {
            raster_remembering<AnyDepth, true>(draw, chunks, tile_index, tile, depth);
        } else {
            raster_remembering<AnyDepth, false>(draw, chunks, tile_index, tile, depth);
        }
    }
}

}  // namespace raster::tiles
