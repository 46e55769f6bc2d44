#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "bench/figure_shapes.h"
#include "bench/solid_figures.h"

namespace relievo::bench {
namespace {

// A plane in the middle of a picture, from black at `low` to white at `high`.
viewer::Picture pictureOf(const textures::Plane& plane, const FigureFrames& frames, float low,
                          float high) {
    viewer::Picture picture(frames.width, frames.height);
    const double zoom = std::max(plane.width / static_cast<double>(frames.width),
                                 plane.height / static_cast<double>(frames.height));
    for (int y = 0; y < frames.height; ++y)
        for (int x = 0; x < frames.width; ++x) {
            const double i = zoom * (x + 0.5 - 0.5 * frames.width) + 0.5 * plane.width;
            const double j = zoom * (y + 0.5 - 0.5 * frames.height) + 0.5 * plane.height;
            float value = 0.13f;  // the sheet's background
            if (i >= 0 && j >= 0 && i < plane.width && j < plane.height)
                value = (plane.at(static_cast<int>(i), static_cast<int>(j)) - low) / (high - low);
            std::fill_n(picture.pixel(x, y), 3, std::clamp(value, 0.0f, 1.0f));
            picture.pixel(x, y)[3] = 1.0f;
        }
    return picture;
}

FigureRow shapeMapRow(FigureFrames& frames) {
    const auto map = figureShape("gear", frames.texels);
    const float farthest = *std::ranges::max_element(map->distance.texels);
    FigureStage figure(frames);
    figure.addBox(extrusionOf(map), {{1.0, 1.0, 0.3}, {0, 0, 0.15}}, {0.62f, 0.4f, 0.12f});
    figure.addGround(0);
    figure.eye.elevation = 38;
    figure.eye.distance = 2.2f;
    return {{pictureOf(map->shape, frames, 1, 0), "4.1 shape", "a gear, how much is inside"},
            {pictureOf(map->distance, frames, -farthest, farthest), "4.1 distance",
             "grey: the outline, darker: inside"},
            {pictureOf(map->gradientX, frames, -1, 1), "4.1 gradient, u",
             "from -1 (black) to 1 (white)"},
            {pictureOf(map->gradientY, frames, -1, 1), "4.1 gradient, v",
             "from -1 (black) to 1 (white)"},
            {figure.draw(), "4.1 the extrusion", "one map, one box"}};
}

FigureRow extensionRow(FigureFrames& frames) {
    const auto map = figureShape("arrow", frames.texels);
    FigureRow row;
    for (const double extension : {-0.04, 0.0, 0.04, 0.08, 0.12}) {
        FigureStage figure(frames);
        figure.addBox(extrusionOf(map, solids::makeProfile(extension)),
                      {{1.0, 1.0, 0.16}, {0, 0, 0.08}}, {0.15f, 0.36f, 0.58f});
        figure.addGround(0);
        figure.eye.elevation = 38;
        figure.eye.distance = 2.2f;
        row.push_back({figure.draw(), fmt::format("4.5 extension {:g}", extension),
                       "tile widths from the outline"});
    }
    return row;
}

}  // namespace

std::vector<FigureRow> mapFigures(FigureFrames& frames) {
    return {shapeMapRow(frames), extensionRow(frames)};
}

}  // namespace relievo::bench
