#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "preprocess/shape_plan.h"
#include "preprocess/shape_source.h"
#include "textures/map_set.h"
#include "textures/shape_map.h"

namespace relievo::preprocess {

/// The distance in a map without an outline: so many diagonals of the tile, below 0 inside.
inline constexpr double kUnlimitedDiagonals = 4.0;

/// The shape map of a drawing or a bitmap (specification 7.1), for the wrap mode, sign, gradient
/// and number format of `plan`.
///
/// Signed distances are exact ones to the outline: that of the drawing, whose shapes are united
/// and cut off at the tile, or the one of half coverage that traceCoverage and sharpenCorners find
/// in a bitmap. Unsigned ones are those from texel centre to texel centre of the thesis. They are
/// stored rounded towards 0, and `slack` is what that takes from them at most; it includes what the
/// measurement in floats may be off. Without an outline, when the shape is empty or fills
/// everything, all distances are kUnlimitedDiagonals, or minus that inside (0 when unsigned), and
/// the gradient is (0,0).
///
/// Exact gradients point away from the nearest point of the outline outside and to it inside, on it
/// along its normal: nowhere (0,0). Prewitt's are those of the stored distances, and (0,0) where
/// these are level. `shape` is the coverage of a bitmap, or of drawings what a straight outline at
/// that distance covers of the texel; where it contradicts the texel's centre it is drawn to 1/2,
/// so that distances of at most 0 go with at least a half, and others with at most a half. Unsigned
/// with Prewitt's gradients, as in the thesis, it is 1 or 0.
///
/// `advance`, when given, is called from any thread with the number of texels just finished. The
/// same for any number of threads. Throws textures::InputError for coordinates that make no sense.
textures::ShapeMap bakeShape(const ShapeSource& source, const ShapePlan& plan,
                             const std::function<void(std::size_t)>& advance = {});

/// readShapeSource and bakeShape in one.
textures::ShapeMap bakeShapeFile(const std::string& name, const ShapePlan& plan);

/// All of `plan` that changes the map: the attribute `relievo:options`.
std::string optionWords(const ShapePlan& plan);

/// What a shape file holds: the channels and the metadata, with `relievo:options`,
/// `relievo:gradient` and `relievo:tau` = 1 / greatest distance.
textures::MapSet shapeFileOf(const textures::ShapeMap& shape, const ShapePlan& plan,
                             const std::string& source);

}  // namespace relievo::preprocess
