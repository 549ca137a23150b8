// draw_plan.h: the draw calls that make a picture of a model, for whoever wants to make, watch or change them.
#pragma once

#include <functional>

#include <raster/scene/render.h>
#include <raster/shading/flat_shader.h>
#include <raster/shading/gouraud_shader.h>
#include <raster/shading/pixel_shader.h>
#include <raster/shading/sunlit_shader.h>

namespace raster {

/// One draw call, all but the type of its shader. Spans are valid during the visit only.
struct PlannedDraw {
    ShadingFrequency frequency;
    Detail level;
    ShadingUniforms uniforms;
    AnyReflectance reflectance;  ///< with the material's parameters
    std::span<const FaceLight> faces;  ///< for flat shading, one a primitive
    Mesh<SurfaceVertex<float>> mesh;
    State state;
    /// Of a wireframe and of points: three indices a primitive, the triangle that it was taken from.
    std::span<const std::uint32_t> triangles;
};

/// What a picture needs besides a camera. The model outlives the plan.
class DrawPlan {
public:
    /// `terms`: for targets with extra planes.
    DrawPlan(const Model& model, const RenderOptions& options, bool terms);

    /// Calls visit for every draw, in order: with the z-buffer first what is opaque, part after part, then what is
    /// see-through from back to front; with the painter's algorithm everything from back to front.
    void for_each(const CameraMatrices& camera, const std::function<void(const PlannedDraw&)>& visit) const;

private:
    /// A material's shading and whether one can see through it.
    struct PreparedMaterial {
        SurfaceMaterial surface;
        AnyReflectance reflectance;
        bool transparent;
        glm::vec3 grain_object;
        glm::vec2 grain_turn;  ///< cosine and sine
    };
    /// Neighbouring triangles of one material.
    struct Run {
        std::size_t material;  ///< index into materials_
        std::size_t first_triangle, triangle_count;
    };
    /// Triangles in another order than the model's.
    struct SortedTriangles {
        std::vector<std::uint32_t> indices;
        std::vector<std::int32_t> numbers;  ///< in the model
        std::vector<Run> runs;              ///< over these
    };

    PreparedMaterial prepare(const Material& material) const;
    TextureView view(int texture, const Material& material, bool color) const;
    State state_for(const Run& run) const;
    SortedTriangles sort(std::span<const Run> runs, const glm::mat4& eye_from_object) const;
    void emit(PlannedDraw& draw, const Run& run, const std::function<void(const PlannedDraw&)>& visit) const;
    /// The lines or points instead of a draw of triangles.
    void emit_outline(const PlannedDraw& surface, const std::function<void(const PlannedDraw&)>& visit) const;

    const Model& model_;
    RenderOptions options_;
    bool terms_;
    bool has_vertex_colors_ = false;
    std::vector<PackedTexture> textures_;      ///< parallel to the model's
    std::vector<PreparedMaterial> materials_;  ///< parallel to the model's, and the default material
    std::vector<Run> opaque_, transparent_;
};

/// Calls visit(shader, mesh, state) with the shader that a planned draw asks for. This is the one place where what is
/// chosen while running becomes a type.
template <class Visit>
void with_flat_shader(const PlannedDraw& d, const Visit& visit) {
    switch (d.level) {
        case Detail::plain: return visit(FlatShader<Detail::plain>{d.uniforms, d.faces}, d.mesh, d.state);
        case Detail::mapped: return visit(FlatShader<Detail::mapped>{d.uniforms, d.faces}, d.mesh, d.state);
        case Detail::terms: return visit(FlatShader<Detail::terms>{d.uniforms, d.faces}, d.mesh, d.state);
    }
}
template <class Visit>
void with_gouraud_shader(const PlannedDraw& d, const Visit& visit) {
    const RuntimeModel model{d.reflectance};
    switch (d.level) {
        case Detail::plain: return visit(GouraudShader<Detail::plain>{d.uniforms, model}, d.mesh, d.state);
        case Detail::mapped: return visit(GouraudShader<Detail::mapped>{d.uniforms, model}, d.mesh, d.state);
        case Detail::terms: return visit(GouraudShader<Detail::terms>{d.uniforms, model}, d.mesh, d.state);
    }
}
template <class Visit>
void with_pixel_shader(const PlannedDraw& d, const Visit& visit) {
    const RuntimeModel any{d.reflectance};
    if (d.level == Detail::terms)
        return visit(PixelShader<RuntimeModel, Detail::terms>{d.uniforms, any}, d.mesh, d.state);
    const auto with_model = [&]<class M>(const M& model) {
        if (d.level == Detail::plain) {
            visit(PixelShader<M, Detail::plain>{d.uniforms, model}, d.mesh, d.state);
        } else {
            visit(PixelShader<M, Detail::mapped>{d.uniforms, model}, d.mesh, d.state);
        }
    };
    const auto with_own_shader = [&]<class M>(const M& model) {
        if constexpr (is_specialised<M>) {
            if (d.level == Detail::plain && is_sunlit(d.uniforms)) {
                visit(SunlitShader<M>(d.uniforms, model), d.mesh, d.state);
            } else {
                with_model(model);
            }
        }
        return is_specialised<M>;
    };
    if (!std::visit(with_own_shader, d.reflectance)) with_model(any);
}
/// The same for draws that need not be fast: one shader for all reflectance models, which gives the same bits.
template <class Visit>
void with_runtime_pixel_shader(const PlannedDraw& d, const Visit& visit) {
    const RuntimeModel model{d.reflectance};
    switch (d.level) {
        case Detail::plain: return visit(PixelShader<RuntimeModel, Detail::plain>{d.uniforms, model}, d.mesh, d.state);
        case Detail::mapped:
            return visit(PixelShader<RuntimeModel, Detail::mapped>{d.uniforms, model}, d.mesh, d.state);
        case Detail::terms: return visit(PixelShader<RuntimeModel, Detail::terms>{d.uniforms, model}, d.mesh, d.state);
    }
}
template <class Visit>
void with_shader(const PlannedDraw& d, const Visit& visit) {
    switch (d.frequency) {
        case ShadingFrequency::flat: return with_flat_shader(d, visit);
        case ShadingFrequency::gouraud: return with_gouraud_shader(d, visit);
        case ShadingFrequency::phong: return with_pixel_shader(d, visit);
    }
}

/// raster::draw with the shader of a planned draw, one shading frequency a source file: each compiles several shaders.
DrawCounts draw_flat(Target& target, const PlannedDraw& planned);
DrawCounts draw_gouraud(Target& target, const PlannedDraw& planned);
DrawCounts draw_pixel_shaded(Target& target, const PlannedDraw& planned);

}  // namespace raster
