#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "materials/solid_material.h"
#include "viewer/measured_frame.h"

namespace relievo::viewer {

/// A ray in the space of a whole solid.
struct HostileSolidRay {
    glm::vec3 origin;
    glm::vec3 direction;
    std::string_view regime;
};

/// Rays of all kinds around the box between two corners, in turn: any, grazing, along an axis,
/// level, straight down or up, from inside, from far away, along texel borders, and with directions
/// of lengths from 1e−6 to 1e6. Always the same ones for a number.
std::vector<HostileSolidRay> hostileSolidRays(const glm::dvec3& low, const glm::dvec3& high,
                                              int count);

/// Rays with numbers that are none, infinite, zero or far out of range.
std::vector<HostileSolidRay> absurdSolidRays();

/// The program that searches one ray a pixel with a material's search. `change` may break its text.
gl::Program solidRayProgram(const materials::SolidMaterial& material,
                            const std::function<std::string(std::string)>& change = {});

/// What the material's search answers of each ray, clipped to the material's box first; in their
/// order. `program` is that of a material with parts of the same kinds.
std::vector<MeasuredPixel> searchRays(const materials::SolidMaterial& material,
                                      gl::Program& program, std::span<const HostileSolidRay> rays);

}  // namespace relievo::viewer
