#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "outlines/outline.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Plane shapes of polygons, in texels: what is inside an odd number of them. For discs polygons of
/// very many corners.
using Polygons = std::vector<std::vector<glm::dvec2>>;

Polygons discOf(const glm::dvec2& centre, double radius);
Polygons annulusOf(const glm::dvec2& centre, double inner, double outer);
Polygons squareOf(const glm::dvec2& centre, double halfSide, double angle);
Polygons starOf(const glm::dvec2& centre, double inner, double outer, int points, double angle);

/// The same as a drawing on a map of this size.
outlines::Drawing drawingOf(const Polygons& shape, int width, int height);

/// Exactly how much of each texel is inside.
textures::Plane exactCoverage(const Polygons& shape, int width, int height);

/// The distance to the nearest side by brute force, below 0 inside.
double signedDistance(const Polygons& shape, const glm::dvec2& place);

/// The distance to the nearest corner.
double cornerDistance(const Polygons& shape, const glm::dvec2& place);

}  // namespace relievo::preprocess
