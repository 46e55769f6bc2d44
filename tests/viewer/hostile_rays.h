#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "materials/relief_material.h"
#include "textures/cone_encoding.h"
#include "textures/depth_map.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// A relief that breaks searches.
struct HostileMap {
    std::string_view name;
    textures::DepthMap map;
    textures::ConeEncoding encoding = textures::ConeEncoding::Ratio;
};

/// Level, binary, noisy, single spikes; one texel, one row, one column, 64:1.
std::vector<HostileMap> hostileMaps();

/// How rays are drawn; elevations in degrees above the surface.
struct HostileRegime {
    std::string_view name;
    double lowest;
    double highest;
    bool isAlongAxis = false;
    double farthest = 3.0;  ///< places in the plane of the tiles
    bool isInside = false;  ///< they begin at any depth, in the solid or not, and half of them rise
};

std::span<const HostileRegime> hostileRegimes();

/// The number of the regime of ray number `ray`: they take turns.
std::size_t regimeOfRay(std::size_t ray);

/// A frame in which every pixel is another ray; always the same ones for a size. Needs a current
/// context.
class HostileFrame {
  public:
    explicit HostileFrame(int size);

    /// What the material's search answers, in the order of the rays. `program` is that of a
    /// material with the same technique and maps.
    MeasuredFrame search(const materials::ReliefMaterial& material, gl::Program& program);

    /// What the material's shadow method answers of light that comes against each ray to the point
    /// of the relief where that begins: `light`, `lift`, `side`, `lightShare` and `shadowFetches`,
    /// with the point as `origin`. The light spans `radius` radians to each side. Rays that rise
    /// stand for light from below. `program` is hostileLightProgram of such a material.
    MeasuredFrame light(const materials::ReliefMaterial& material, gl::Program& program,
                        float radius);

  private:
    MeasuredFrame draw(gl::Program& program, GLuint unit);

    gl::Texture places_;
    gl::Texture views_;
    gl::Framebuffer target_;
};

/// The program that searches hostile rays with a material's technique.
gl::Program hostileProgram(const materials::ReliefMaterial& material);

/// The program that lights the relief by a material's shadow method, which must not be null.
gl::Program hostileLightProgram(const materials::ReliefMaterial& material);

}  // namespace relievo::viewer
