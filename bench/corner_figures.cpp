#include <fmt/format.h>

#include "bench/figure_shapes.h"
#include "bench/solid_figures.h"

namespace relievo::bench {
namespace {

// The letter R upright, with a bevel that leans outwards, and a star from above its tips.
FigureRow cornerRow(FigureFrames& frames, bool isSharp) {
    const int texels = frames.texels / 4;
    const auto letter = figureShape("R", texels, textures::WrapMode::Clamp, isSharp);
    const auto star = figureShape("star", texels, textures::WrapMode::Clamp, isSharp);
    const double high = letter->aspect();
    const std::string title = isSharp ? "sharp corners" : "round corners";
    const std::string note = fmt::format("{} texels wide", texels);
    FigureRow row;
    for (const double bevel : {0.0, 0.05}) {
        FigureStage figure(frames);
        figure.addBox(extrusionOf(letter, solids::makeProfile(0.0, bevel, 0.4)),
                      {{1.0, high, 0.3}, {0, 0, 0.15}}, {0.62f, 0.4f, 0.12f});
        figure.addGround(0);
        figure.eye.elevation = 48;
        figure.eye.distance = 2.5f;
        row.push_back({figure.draw(), title, note + (bevel > 0.0 ? ", bevelled" : ", upright")});
    }
    FigureStage figure(frames);
    figure.addBox(extrusionOf(star, solids::makeProfile(0.0, 0.08)),
                  {{1.0, 1.0, 0.3}, {0, 0, 0.15}}, {0.15f, 0.36f, 0.58f});
    figure.addGround(0);
    figure.eye.elevation = 62;
    figure.eye.distance = 2.2f;
    row.push_back({figure.draw(), title, note + ", bevelled to the ground"});
    return row;
}

}  // namespace

std::vector<FigureRow> cornerFigures(FigureFrames& frames) {
    return {cornerRow(frames, true), cornerRow(frames, false)};
}

}  // namespace relievo::bench
