#pragma once

#include <glm/vec3.hpp>

#include "viewer/error_image.h"
#include "viewer/picture.h"

namespace relievo::viewer {

/// The range of the heat map's logarithmic scale, in texels of distance along the ray. Smaller
/// errors are black, larger ones white.
inline constexpr float kHeatMinimum = 1.0f / 64.0f;
inline constexpr float kHeatMaximum = 64.0f;

/// The colour of an error of `texels` (sign ignored), sRGB: black, violet, red, orange, white.
glm::vec3 heatColor(float texels);

/// The absolute distance error of every pixel. Mismatches (hit against miss) are cyan, searches
/// that ran out magenta, uncovered pixels dark grey.
Picture heatMap(const ErrorImage& image);

/// The scale with its numbers and the meaning of the special colours, `width` ≥ 300 pixels wide and
/// kHeatScaleHeight high.
inline constexpr int kHeatScaleHeight = 44;
Picture heatScale(int width);

}  // namespace relievo::viewer
