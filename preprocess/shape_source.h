#pragma once

#include <functional>
#include <string>
#include <variant>

#include "outlines/outline.h"
#include "preprocess/shape_plan.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The largest side of a map that is made of a drawing, in texels: that of the largest image that
/// can be read.
inline constexpr int kLargestShape = 32768;

/// Curves of drawings become polylines that are within this of them, in texels.
inline constexpr double kCurveTolerance = 0.01;

/// What a shape map is made of.
struct ShapeSource {
    /// The filled shapes of a drawing, or how much of each texel is inside, in [0,1].
    std::variant<outlines::Drawing, textures::Plane> content;
    int width = 0;  ///< of the map, in texels
    int height = 0;
    std::string hash;  ///< of the content: `relievo:source`
};

/// Reads `name`, a file that is an image (of any format that OpenImageIO reads) or an SVG drawing
/// (when it ends in .svg), or FONT:TEXT, a font file and a line of text. An image is coverage: its
/// values from 0 (black) to 1 (white) say how much of a texel is inside, as plan.isWhiteInside has
/// it. `notice` is called with one sentence when the reader had to choose.
///
/// Throws textures::InputError for files that are missing or cannot be read, for text that the font
/// cannot show or that is not UTF-8, for drawings whose shape does not fit the size of the plan
/// (texels would not be square), or are over kLargestShape.
ShapeSource readShapeSource(const std::string& name, const ShapePlan& plan,
                            const std::function<void(const std::string&)>& notice = {});

/// The width and height that the map of a drawing of this aspect (height over width) has by `plan`.
/// Throws textures::InputError, beginning with `name`, as above.
struct ShapeSize {
    int width = 0;
    int height = 0;
};
ShapeSize shapeSize(const std::string& name, double aspect, const ShapePlan& plan);

}  // namespace relievo::preprocess
