#include "preprocess/shape_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "outlines/svg_outline.h"
#include "outlines/text_outline.h"
#include "textures/content_hash.h"
#include "textures/file_extension.h"
#include "textures/height_image.h"
#include "textures/input_error.h"

namespace relievo::preprocess {
namespace {

using outlines::Drawing;
using textures::InputError;
using textures::Plane;

struct Text {
    std::string font;
    std::string text;
};

// FONT:TEXT: the first colon behind which the name of a file ends, or else the first one.
std::optional<Text> textOf(const std::string& name) {
    std::optional<Text> first;
    for (std::size_t colon = name.find(':'); colon != std::string::npos;
         colon = name.find(':', colon + 1)) {
        const Text text{name.substr(0, colon), name.substr(colon + 1)};
        if (std::filesystem::is_regular_file(text.font))
            return text;
        if (!first)
            first = text;
    }
    return first;
}

// What makes a drawing, so that one that changed is baked again.
std::string hashOf(const Drawing& drawing) {
    Plane numbers;
    for (const outlines::Outline& outline : drawing.shapes) {
        numbers.texels.push_back(outline.rule == outlines::FillRule::EvenOdd ? 1.0f : 0.0f);
        for (const outlines::Contour& contour : outline.contours) {
            numbers.texels.push_back(static_cast<float>(contour.size()));
            for (const glm::dvec2& point : contour)
                for (const double place : {point.x, point.y}) {
                    const auto rounded = static_cast<float>(place);
                    numbers.texels.push_back(rounded);
                    numbers.texels.push_back(static_cast<float>(place - rounded));
                }
        }
    }
    numbers.width = static_cast<int>(numbers.texels.size());
    numbers.height = 1;
    return textures::contentHash(numbers);
}

ShapeSource drawingSource(Drawing drawing, const std::string& name, const ShapePlan& plan) {
    const ShapeSize size = shapeSize(name, drawing.aspect, plan);
    std::string hash = hashOf(drawing);
    return {std::move(drawing), size.width, size.height, std::move(hash)};
}

ShapeSource imageSource(const std::string& name, const ShapePlan& plan,
                        const std::function<void(const std::string&)>& notice) {
    textures::HeightImageOptions options;
    options.isDepth = plan.isWhiteInside;  // height is turned over: black becomes 1
    options.channel = plan.channel;
    options.wrap = plan.wrap;
    options.notice = notice;
    textures::HeightImage image = textures::readHeightImage(name, options);
    Plane& coverage = image.depth.depth;
    const int width = coverage.width;
    const int height = coverage.height;
    return {std::move(coverage), width, height, std::move(image.source)};
}

}  // namespace

ShapeSize shapeSize(const std::string& name, double aspect, const ShapePlan& plan) {
    const double height = std::max(1.0, std::nearbyint(plan.width * aspect));
    if (!(std::max<double>(plan.width, height) <= kLargestShape))
        throw InputError(
            fmt::format("{}: is {:.6g} times as high as wide, which makes {} × {:.0f} texels, "
                        "expected at most {} a side",
                        name, aspect, plan.width, height, kLargestShape));
    const int fitting = static_cast<int>(height);
    if (plan.height != 0 && plan.height != fitting)
        throw InputError(fmt::format(
            "{}: is {:.6g} times as high as wide, so its texels are squares in a map of {}x{}, but "
            "{}x{} was asked for",
            name, aspect, plan.width, fitting, plan.width, plan.height));
    return {plan.width, fitting};
}

ShapeSource readShapeSource(const std::string& name, const ShapePlan& plan,
                            const std::function<void(const std::string&)>& notice) {
    const double tolerance = kCurveTolerance / plan.width;
    const bool isFile = std::filesystem::exists(name);
    if (isFile && textures::lowerExtension(name) == ".svg")
        return drawingSource(outlines::readSvgDrawing(name, tolerance), name, plan);
    if (isFile)
        return imageSource(name, plan, notice);
    const std::optional<Text> text = textOf(name);
    if (!text)
        throw InputError(fmt::format(
            "{}: there is no such file, expected an image, an SVG file, or FONT:TEXT with a font "
            "file and a text",
            name));
    return drawingSource(outlines::readTextDrawing(text->font, text->text, tolerance), name, plan);
}

}  // namespace relievo::preprocess
