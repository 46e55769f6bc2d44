#pragma once

#include "reference/map_search.h"
#include "textures/bilinear.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// The part of a ray between a point above the surface and one below it, by their depths.
struct Bracket {
    double above = 0.0;
    double below = 1.0;
};

/// Whether the ray's point at depth z is on the surface or below it: one lookup.
inline bool isBelow(const textures::DepthMap& relief, const DescendingRay& ray, double z) {
    const glm::dvec2 place = ray.at(z);
    return z >= textures::sampleBilinear(relief.depth, place.x, place.y, relief.wrap);
}

/// Halves a bracket, keeping a crossing of the surface in it: one lookup.
inline void halve(const textures::DepthMap& relief, const DescendingRay& ray, Bracket& bracket) {
    const double middle = 0.5 * (bracket.above + bracket.below);
    (isBelow(relief, ray, middle) ? bracket.below : bracket.above) = middle;
}

}  // namespace relievo::reference
