#include <string>

#include "bench/figure_shapes.h"
#include "bench/solid_figures.h"

namespace relievo::bench {
namespace {

using solids::makeProfile;
using solids::Profile;
using solids::ProfileShape;
using textures::WrapMode;

constexpr glm::vec3 kIvory{0.75f, 0.66f, 0.48f};
constexpr glm::vec3 kStone{0.5f, 0.47f, 0.42f};
constexpr glm::vec3 kRed{0.55f, 0.1f, 0.07f};
constexpr glm::vec3 kBlue{0.12f, 0.3f, 0.56f};
constexpr glm::vec3 kGreen{0.14f, 0.4f, 0.2f};
constexpr glm::vec3 kBrass{0.62f, 0.42f, 0.12f};

struct Pattern {
    const char* shape;
    Profile profile;
    glm::vec3 color;
    bool isOnBox;
    const char* title;
    const char* subtitle;
};

viewer::SheetCell patternCell(FigureFrames& frames, const Pattern& pattern) {
    constexpr double kDepth = 0.15;
    constexpr float kTiles = 3.0f;
    const auto map = figureShape(pattern.shape, frames.texels, WrapMode::Repeat);
    const auto part = extrusionOf(map, pattern.profile, glm::dvec2(kTiles));
    const surfaces::SurfaceMesh mesh =
        pattern.isOnBox ? surfaces::makeBox({kTiles, kTiles})
                        : surfaces::makeQuad({kTiles, kTiles}, static_cast<float>(map->aspect()));
    FigureStage figure(frames);
    figure.addSunk(part, mesh, kDepth, pattern.color);
    figure.light = {-50, 60};
    figure.eye = {.azimuth = 28, .elevation = 38, .distance = 2.2f, .fieldOfView = 30};
    figure.eye.target = {0, 0, -0.03f};
    if (pattern.isOnBox)
        figure.eye = {.azimuth = 28, .elevation = 24, .distance = 3.0f, .fieldOfView = 30};
    figure.throwsShadows = false;  // but by light rays
    return {figure.draw(), std::string("4.20 ") + pattern.title, pattern.subtitle};
}

struct Extruded {
    const char* shape;
    Profile profile;
    double depth;
    glm::vec3 color;
    const char* title;
    const char* subtitle;
    glm::dvec2 tiles{1.0};
};

// Standing on the ground, or lying on it when it is deep.
viewer::SheetCell extrudedCell(FigureFrames& frames, const Extruded& model) {
    const auto map = figureShape(model.shape, frames.texels,
                                 model.tiles.x > 1 ? WrapMode::Repeat : WrapMode::Clamp);
    const double height = map->aspect() * model.tiles.y / model.tiles.x;
    FigureStage figure(frames);
    figure.addBox(extrusionOf(map, model.profile, model.tiles),
                  {{1.0, height, model.depth}, {0, 0, 0.5 * height}, {90, 0, 0}}, model.color);
    figure.addGround(0);
    figure.eye = {.azimuth = 30,
                  .elevation = 18,
                  .distance = 2.5f,
                  .fieldOfView = 30,
                  .target = {0, 0, static_cast<float>(0.48 * height)}};
    return {figure.draw(), std::string("4.21 ") + model.title, model.subtitle};
}

struct Revolved {
    const char* shape;
    glm::vec3 color;
    const char* title;
    const char* subtitle;
    glm::dvec3 scale{1.0};
};

viewer::SheetCell revolvedCell(FigureFrames& frames, const Revolved& model) {
    const auto map = figureShape(model.shape, frames.texels);
    const glm::dvec3 size = model.scale * glm::dvec3(1.0, 1.0, map->aspect());
    FigureStage figure(frames);
    figure.addBox(revolutionOf(map), {size, {0, 0, 0.5 * size.z}}, model.color);
    figure.addGround(0);
    figure.eye = {.azimuth = 20,
                  .elevation = 24,
                  .distance = static_cast<float>(1.3 + 1.5 * std::max(size.z, 0.9 * size.x)),
                  .fieldOfView = 30,
                  .target = {0, 0, static_cast<float>(0.46 * size.z)}};
    return {figure.draw(), std::string("4.22 ") + model.title, model.subtitle};
}

template <typename Model, typename Cell>
void addRows(std::vector<FigureRow>& rows, FigureFrames& frames, const std::vector<Model>& models,
             Cell cell) {
    constexpr std::size_t kColumns = 4;
    for (std::size_t k = 0; k < models.size(); ++k) {
        if (k % kColumns == 0)
            rows.emplace_back();
        rows.back().push_back(cell(frames, models[k]));
    }
}

}  // namespace

std::vector<FigureRow> collectionFigures(FigureFrames& frames) {
    std::vector<FigureRow> rows;
    addRows<Pattern>(
        rows, frames,
        {{"lattice", makeProfile(0), kStone, false, "a lattice on a plane", "straight walls"},
         {"flower", makeProfile(-0.12, 0.12, 0.7, ProfileShape::Round), kBlue, false,
          "flowers on a plane", "rounded"},
         {"meander", makeProfile(-0.02, 0.03), kRed, true, "meanders on a box", "bevelled"},
         {"star", makeProfile(-0.05, 0.06, 0.5), kBrass, true, "stars on a box", "chamfered"}},
        patternCell);
    addRows<Extruded>(
        rows, frames,
        {{"ampersand", makeProfile(-0.012, 0.012, 0.1), 0.3, kRed, "a letter", "chamfered"},
         {"R", makeProfile(0, 0, 1), 0.5, kStone, "a letter", "straight walls"},
         {"gear", makeProfile(-0.02, 0.02, 0.15), 0.3, kBrass, "a gear", "chamfered"},
         {"star", makeProfile(-0.16, 0.16), 0.3, kBlue, "a star", "bevelled"},
         {"heart", makeProfile(-0.12, 0.12, 0.5, ProfileShape::Round), 0.35, kRed, "a heart",
          "rounded"},
         {"lattice", makeProfile(0), 0.06, kIvory, "a screen", "3 by 3 tiles of a lattice", {3, 3}},
         {"flower", makeProfile(-0.12, 0.12, 0.6, ProfileShape::Ogee), 0.3, kGreen, "a flower",
          "hollow, then round"},
         {"ring", makeProfile(-0.06, 0.06, 0.6, ProfileShape::Cove), 0.3, kBrass, "a ring",
          "hollow"}},
        extrudedCell);
    addRows<Revolved>(rows, frames,
                      {{"goblet", kBrass, "a goblet", ""},
                       {"vase", kRed, "a vase", ""},
                       {"baluster", kIvory, "a baluster", ""},
                       {"pawn", kStone, "a pawn", ""},
                       {"bell", kBrass, "a bell", ""},
                       {"top", kGreen, "a top", ""},
                       {"torus", kBlue, "a ring", "of a circle"},
                       {"bowl", kIvory, "an elliptic bowl", "edges 1.6 : 0.9", {1.6, 0.9, 1.0}}},
                      revolvedCell);
    return rows;
}

}  // namespace relievo::bench
