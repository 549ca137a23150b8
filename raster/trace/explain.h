// explain.h: why two pictures of a model differ: the pixel history at each cluster of differing pixels.
#pragma once

#include <string>
#include <vector>

#include <raster/image/diff.h>
#include <raster/trace/history.h>

namespace raster {

/// Differing pixels that touch, sides or corners.
struct DiffCluster {
    PixelRect box;
    std::int64_t pixels = 0;
    float max_delta = 0;
    int x = 0, y = 0;                 ///< where that is: the first such pixel in reading order
    std::vector<glm::ivec2> samples;  ///< that pixel, and up to two others from all over the cluster
};

/// The clusters of pixels that differ by more than the gates allow, or if none does, of those that differ at all; the
/// largest first, of equal ones that which comes first. The pixels of each stand in no other.
std::vector<DiffCluster> diff_clusters(const Diff& diff);

enum class DiffCause {
    edge_tie,          ///< the pixel's centre lies on an edge, or within a subpixel of it
    depth_tie,         ///< two triangles have the same depth here, give or take two steps
    missing_triangle,  ///< one picture shows what one sees without a triangle
    rounding,          ///< the same triangle; the colours differ by one step
    shading,           ///< the same triangle, as far as can be told, in another colour
    other_scene,       ///< neither picture is what these options draw here
};
const char* to_string(DiffCause cause);

/// A cluster's cause: that of most of its samples, told for the first of these.
struct DiffExplanation {
    DiffCluster cluster;
    DiffCause cause{};
    int x = 0, y = 0;                                  ///< the pixel that the rest is about
    std::string reason;                                ///< the evidence, in words
    std::array<std::uint8_t, 3> expected{}, actual{};  ///< RGB of both pictures there
    PixelHistory history;                              ///< of our own picture there
};

/// Explains the `most` largest clusters of two pictures of this model. `expected` and `actual` are those that `diff`
/// was made from. Other renderers' pictures may be explained too, if camera and size are the same. Error of kind usage
/// when the pictures have another size than the target, which gives size and formats and is drawn to.
Result<std::vector<DiffExplanation>> explain_diff(Target& target, const AnyImage& expected, const AnyImage& actual,
                                                  const Diff& diff, const Model& model, const CameraMatrices& camera,
                                                  const RenderOptions& options, std::size_t most = 16);

}  // namespace raster
