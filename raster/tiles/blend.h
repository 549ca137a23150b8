// blend.h: draws that blend: shade and mix each triangle's pixels when it passes, in submission order.
#pragma once

#include <raster/tiles/resolve.h>
#include <raster/tiles/shade.h>

namespace raster::tiles {

/// Shades pixels of one triangle after the other; it alone knows the shader.
class TriangleShader {
public:
    /// The triangle of the calls that follow.
    virtual void begin(const Slot& slot) = 0;
    /// The pixels of `mask`, as shade_block takes them, in the block at pixel (x, y) of the target.
    virtual void shade(int x, int y, std::uint64_t mask) = 0;
    /// All pixels of `blocks` blocks beside each other, the first of them there.
    virtual void shade_run(int x, int y, int blocks) = 0;

protected:
    ~TriangleShader() = default;
};

/// Puts a tile's triangles, in order, through coverage and depth into a shader. The target's pending clear was written
/// before.
void raster_blended(const DrawContext& draw, std::span<const ChunkBins> chunks, std::size_t tile_index,
                    TileBuffer& tile, Target& target, TriangleShader& shader);

/// The TriangleShader of a draw.
template <HasFragment S>
class BlendingShader final : public TriangleShader {
public:
    BlendingShader(const ShadingContext<S>& context, Target& target) : context_(context), target_(target) {}

    void begin(const Slot& slot) override {
        planes_ = make_shading_planes(context_, slot);
        color_ = constant_color(context_.shader, planes_, target_);
    }
    void shade(int x, int y, std::uint64_t mask) override {
        if (color_) return fill_block(target_, context_.draw.state.blend, *color_, x, y, mask);
        shade_block(context_.shader, planes_, target_, context_.draw.state.blend, x, y, mask);
    }
    void shade_run(int x, int y, int blocks) override {
        if (color_) return fill_run(target_, context_.draw.state.blend, *color_, x, y, blocks);
        tiles::shade_run(context_.shader, planes_, target_, context_.draw.state.blend, x, y, blocks);
    }

private:
    const ShadingContext<S>& context_;
    Target& target_;
    ShadingPlanes<S> planes_;
    std::optional<std::uint32_t> color_;  ///< of all its pixels, where they have one
};

}  // namespace raster::tiles
