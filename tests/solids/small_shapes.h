#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <random>
#include <vector>

#include "solids/solid.h"
#include "textures/shape_map.h"

namespace relievo::solids {

/// A map whose texels have the distance that `distance` gives at their centres: places in tile
/// widths, x = u, y = ρ·v; the other planes are left empty.
std::shared_ptr<const textures::ShapeMap> shapeOf(
    int width, int height, textures::WrapMode wrap,
    const std::function<double(const glm::dvec2&)>& distance);

struct Disc {
    glm::dvec2 centre;  // tile widths
    double radius;
};

/// The signed distance to discs as they repeat under the wrap mode (clamped: once).
std::shared_ptr<const textures::ShapeMap> discShape(int width, int height, textures::WrapMode wrap,
                                                    const std::vector<Disc>& discs);

/// A few discs of random places and sizes.
std::shared_ptr<const textures::ShapeMap> randomDiscs(int width, int height,
                                                      textures::WrapMode wrap,
                                                      std::mt19937_64& random);

/// Independent random texels in [−½, ½]: no distance to anything.
std::shared_ptr<const textures::ShapeMap> randomTexels(int width, int height,
                                                       textures::WrapMode wrap,
                                                       std::mt19937_64& random);

/// The distance to a star of random place and turn, with creases at its corners.
std::shared_ptr<const textures::ShapeMap> randomStar(int width, int height, textures::WrapMode wrap,
                                                     std::mt19937_64& random);

/// Independent random texels with creases anywhere, of one kind: no distance to anything.
std::shared_ptr<const textures::ShapeMap> randomCreases(int width, int height,
                                                        textures::WrapMode wrap,
                                                        std::mt19937_64& random);

/// A part with an extrusion in the window [0,1]³.
SolidPart extrusion(std::shared_ptr<const textures::ShapeMap> shape, Profile profile);
/// A part with a revolution in the window [0,1]³.
SolidPart revolution(std::shared_ptr<const textures::ShapeMap> shape, double extension = 0.0,
                     glm::dvec2 axis = glm::dvec2(0.5));

/// d of the solid at a place of its tile space, by textures::sampleBilinear of the distances of
/// both sides of a crease: another way than the tracer's.
double plainDistance(const Solid& solid, const glm::dvec3& place);
/// d − o(z) or d − e there.
double plainClearance(const Solid& solid, const glm::dvec3& place);
/// Whether a point of the whole's space is in the part.
bool plainInside(const SolidPart& part, const glm::dvec3& point);
/// The same of the whole.
bool plainInside(const Compound& compound, const glm::dvec3& point);

/// The profiles that tests go through: basic, extended, bevels of both signs, chamfer, round,
/// cove, ogee, and one with steps.
std::vector<Profile> manyProfiles();

}  // namespace relievo::solids
