#pragma once

#include <glad/gl.h>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "materials/relief_maps.h"
#include "materials/shadow_registry.h"
#include "materials/slope_sources.h"
#include "materials/technique_registry.h"
#include "shaders/shader_library.h"

namespace relievo::materials {

/// As many rays as keep a receding plane from sparkling (docs/measurements.md, "What sparkles").
inline constexpr int kUsualPixelRays = 4;

/// A relief shown with one technique: what a renderer needs to draw it with a program of its own.
///
/// The renderer's fragment shader includes `files()` and then "relievo/material.glsl", with
/// `defines()` in front, and calls traceRelief; before drawing it calls `bind`. See
/// materials/examples/own_renderer.cpp.
class ReliefMaterial {
  public:
    /// Parameters take their defaults, and slopes come from the best source that `maps` has. Throws
    /// textures::InputError when `maps` lacks a channel that the technique needs.
    ReliefMaterial(std::shared_ptr<ReliefMaps> maps, const Technique& technique);

    /// The same relief in the same place, with the same slopes and shadow, by another technique;
    /// parameters that both have keep their values. Throws as the constructor does.
    [[nodiscard]] ReliefMaterial shownBy(const Technique& technique) const;

    /// Lets the relief cast shadows on itself by `method` (which must stay there; null: none).
    /// Throws textures::InputError when the maps lack a channel that it needs, or the technique
    /// searches nothing that could be in the way of light.
    void setShadow(const ShadowMethod* method);

    /// Sets a parameter of the technique, or of the shadow method. Throws textures::InputError for
    /// an unknown name, a value out of range (the message says the range), or a fraction where an
    /// integer is expected.
    void setParameter(std::string_view name, double value);
    [[nodiscard]] double parameter(std::string_view name) const;

    /// Takes the slopes from `source`, for shading and for searches that follow them. Throws
    /// textures::InputError when the relief lacks its map, or the number that tells what it means.
    void setSlopeSource(SlopeSource source);
    [[nodiscard]] SlopeSource slopeSource() const noexcept { return slopes_; }

    /// The files of the shader library that the shader text must include, in this order.
    [[nodiscard]] std::vector<std::string_view> files() const;
    /// What the shader text must define for this relief and technique.
    [[nodiscard]] std::vector<shaders::Define> defines() const;

    /// Binds the maps to texture units from `firstUnit` and sets the uniforms of `program` (which
    /// need not be current). Returns the first unit that stays free. Throws gl::GlError naming a
    /// uniform that the program lacks.
    GLuint bind(GLuint program, GLuint firstUnit = 0) const;
    /// The same for a program that only searches (relievo/trace.glsl), to write depths for one. It
    /// may lack any of the uniforms: where nothing is looked up, little is needed.
    GLuint bindSearch(GLuint program, GLuint firstUnit = 0) const;

    [[nodiscard]] const Technique& technique() const noexcept { return *technique_; }
    /// The shadow method, or null.
    [[nodiscard]] const ShadowMethod* shadow() const noexcept { return shadow_; }
    [[nodiscard]] const ReliefMaps& maps() const noexcept { return *maps_; }

    /// a: the depth of D = 1 in tile widths, ≥ 0. It may change every frame.
    float depthScale = 0.1f;
    /// The part of (u,v) where the relief exists: minimum u, v, maximum u, v.
    glm::vec4 window{
        -std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
        std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    /// The first and the last MIP level that pixels may take, counted from 0; only a relief that
    /// has levels looks at them.
    glm::vec2 levels{0.0f, std::numeric_limits<float>::infinity()};
    /// The most rays in a pixel, ≥ 1, for programs that take several where a pixel covers several
    /// texels (relievo/pixel_rays.glsl).
    int pixelRays = kUsualPixelRays;

  private:
    struct ParameterValue {
        const TechniqueParameter* info;
        double value;
    };

    enum class Use { Shading, Search };
    GLuint bindFor(Use use, GLuint program, GLuint firstUnit) const;
    /// Whether the technique's search reads the map of that name.
    [[nodiscard]] bool reads(std::string_view mapName) const;
    /// The maps of the technique, the shading and the shadow method, each once.
    [[nodiscard]] std::vector<std::string_view> mapNames() const;
    void addParameters(std::span<const TechniqueParameter> parameters);
    /// Throws textures::InputError, listing the names, for an unknown one.
    [[nodiscard]] const ParameterValue& find(std::string_view parameterName) const;

    std::shared_ptr<ReliefMaps> maps_;
    const Technique* technique_;
    SlopeSource slopes_;
    const ShadowMethod* shadow_ = nullptr;
    std::vector<ParameterValue> values_;  // of the technique, then of the shadow method
};

}  // namespace relievo::materials
