// How far the zero level of a sampled distance is from the true outline of a shape.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "reference/plane_outline.h"
#include "reference/shape_cell.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// A distance on texel centres, in texels, with codes of textures::ShapeCreases or without. Clamped
/// at the borders.
struct SampledDistance {
    textures::Plane distance;
    textures::Plane crease;  ///< without texels: none

    [[nodiscard]] bool hasCrease() const { return !crease.texels.empty(); }
    /// f at a place in texels.
    [[nodiscard]] double at(const glm::dvec2& place) const;
    /// f of a sample.
    [[nodiscard]] double sample(int i, int j) const;
};

/// Points where f = 0 on `lines` level and as many upright lines through every cell with both
/// coordinates of its first texel in [low, high): exact, as f is linear on them in pieces.
std::vector<glm::dvec2> zeroLevel(const SampledDistance& field, int lines, const glm::ivec2& low,
                                  const glm::ivec2& high);

/// Errors in texels.
struct ErrorSummary {
    double largest = 0.0;
    double mean = 0.0;
    double permille = 0.0;  ///< exceeded by one of a thousand points
    std::size_t count = 0;
};
ErrorSummary summaryOf(std::vector<double> errors);

/// Of points of the zero level to the outline and of points of the outline to the zero level.
struct OutlineErrors {
    ErrorSummary levelAway;
    ErrorSummary levelAtCorners;
    ErrorSummary outlineAway;
    ErrorSummary outlineAtCorners;
    [[nodiscard]] double away() const;
    [[nodiscard]] double atCorners() const;
};

/// A corner of an outline.
struct ContourCorner {
    std::size_t contour = 0;
    std::size_t vertex = 0;
    glm::dvec2 place{0.0};
};
/// Vertices where contours turn by more than 5°.
std::vector<ContourCorner> cornersOf(const std::vector<reference::OutlineContour>& contours);

/// Outline in texels. Corners reach two texels. Only what is within [low, high) counts.
OutlineErrors measureErrors(const SampledDistance& field,
                            const std::vector<reference::OutlineContour>& contours,
                            const reference::PlaneOutline& outline, const glm::ivec2& low,
                            const glm::ivec2& high, int lines = 16);

}  // namespace relievo::preprocess
