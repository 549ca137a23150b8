// limit.h: the least work that a fill needs, measured.
#pragma once

#include <cstdint>
#include <vector>

#include "scenes.h"

namespace bench {

/// The limit of one scene at one size, drawn by no renderer: vector stores into rows of the picture or into a tile of
/// 64 x 64 pixels that stays in the cache, the tiles spread over the threads.
///
///     clear      every colour of the picture written once
///     fill       every colour and every depth written once
///     s6b, s6f   64 layers: each pixel's depth tested, its colour and depth replaced; then all copied to the picture
///     s6a        64 layers: each pixel's colour read, blended in 8 bits and written, then as s6b; no depth test
class Limit {
public:
    Limit(const Scene& scene, int width, int height);
    /// Whether a limit of this scene is known.
    bool known() const { return kind_ != Kind::none; }
    void frame();

private:
    enum class Kind { none, clear, fill, tested, blended };
    void write_rows(int first, int count);
    void tile(int x, int y);

    Kind kind_ = Kind::none;
    int width_, height_, layers_;
    bool front_to_back_;
    std::vector<std::int32_t> color_, depth_;
};

}  // namespace bench
