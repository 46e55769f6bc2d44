#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

#include "bench/figure_shapes.h"
#include "bench/solid_figures.h"

namespace relievo::bench {
namespace {

using materials::TextureSet;
using textures::ShapeMap;

constexpr glm::vec3 kIvory{0.75f, 0.66f, 0.48f};
constexpr glm::vec3 kRed{0.55f, 0.1f, 0.07f};
constexpr glm::vec3 kBlue{0.12f, 0.3f, 0.56f};
constexpr double kEdge = 0.008;  // thickness of edges
constexpr double kRim = 0.02;

// Edges of a box around one tile of a revolution whose tile is 1 wide.
glm::dvec3 revolvedSize(const ShapeMap& map) {
    return {1.0, 1.0, map.aspect()};
}

viewer::Picture repeatedPieces(FigureFrames& frames, float elevation, float distance) {
    const auto map = figureShape("pawn", frames.texels);
    FigureStage figure(frames);
    figure.addSunk(revolutionOf(map, {5, 5}), surfaces::makeQuad({5, 5}, 1), map->aspect(), kIvory);
    figure.eye.elevation = elevation;
    figure.eye.distance = distance;
    figure.eye.target = {0, 0, -0.15f};
    figure.throwsShadows = false;  // but by light rays
    return figure.draw();
}

// Balls in boxes of their own, half in a ring that stands upright.
viewer::Picture ballsOnRing(FigureFrames& frames, bool writesDepths) {
    constexpr int kBalls = 8;
    FigureStage figure(frames);
    figure.addGround(-0.5);
    figure.addBox(extrusionOf(figureShape("ring", frames.texels),
                              solids::makeProfile(-0.02, 0.02, 0.3, solids::ProfileShape::Round)),
                  {{1.1, 1.1, 0.12}, {0, 0, 0.05}, {90, 0, 0}}, kBlue);
    const auto ball = figureShape("ball", frames.texels / 2);
    for (int k = 0; k < kBalls; ++k) {
        const double angle = glm::radians(360.0) * k / kBalls;
        const glm::dvec3 position(0.44 * std::cos(angle), k % 2 == 0 ? 0.06 : -0.06,
                                  0.05 + 0.44 * std::sin(angle));
        figure.addBox(revolutionOf(ball), {glm::dvec3(0.22), position}, kRed);
    }
    figure.eye = {.azimuth = 32, .elevation = 14, .distance = 2.3f, .fieldOfView = 30};
    figure.throwsShadows = false;
    return writesDepths ? figure.draw() : figure.drawInOrder();
}

viewer::Picture sunkOrWhole(FigureFrames& frames, bool isWhole) {
    const auto map = figureShape("vase", frames.texels);
    const BoxPlace place{revolvedSize(*map), glm::dvec3(0, 0, -0.5 * map->aspect())};
    FigureStage figure(frames);
    if (isWhole) {
        figure.addBox(revolutionOf(map), place, kRed);
    } else {
        figure.addSunk(revolutionOf(map), surfaces::makeQuad({1, 1}, 1), map->aspect(), kRed)
            .hasFloor = false;
    }
    for (const double side : {-0.5, 0.5}) {
        figure.addBlock({{1.0 + kRim, kRim, kRim}, {0, side, 0}}, kBlue);
        figure.addBlock({{kRim, 1.0 + kRim, kRim}, {side, 0, 0}}, kBlue);
    }
    figure.eye = {.azimuth = 20,
                  .elevation = 30,
                  .distance = 3.9f,
                  .fieldOfView = 28,
                  .target = {0, 0, static_cast<float>(-0.5 * map->aspect())}};
    figure.throwsShadows = false;  // but by light rays
    return figure.draw();
}

// A map as a picture: blue inside, grey outside and darker with the distance. A share of its width.
TextureSet pictureOf(const ShapeMap& map, double share) {
    const auto width = static_cast<int>(share * map.width());
    TextureSet set;
    std::vector<textures::Plane>& albedo = set.pictures["albedo"];
    for (const float inside : {0.2f, 0.4f, 0.75f}) {
        textures::Plane& plane = albedo.emplace_back(width, map.height());
        for (int j = 0; j < map.height(); ++j)
            for (int i = 0; i < width; ++i) {
                const float outside = 0.95f - 1.6f * std::max(map.distance.at(i, j), 0.0f);
                const float inner = map.shape.at(i, j);
                plane.at(i, j) = std::clamp(inner * inside + (1 - inner) * outside, 0.0f, 1.0f);
            }
    }
    return set;
}

void aimAtBox(FigureStage& figure) {
    figure.eye = {.azimuth = 28, .elevation = 24, .distance = 4.1f, .fieldOfView = 28};
}

viewer::Picture extrusionBox(FigureFrames& frames, bool showsMap) {
    const auto map = figureShape("heart", frames.texels);
    const BoxPlace place{{1.0, 1.0, 0.6}};
    FigureStage figure(frames);
    figure.addBox(extrusionOf(map), place, kRed);
    FigureStage alone(frames);
    FigureStage& shown = showsMap ? alone : figure;
    if (showsMap) {
        const glm::mat4 top = glm::translate(glm::mat4(1), glm::vec3(0, 0, 0.3f));
        alone.stage().addPlain(surfaces::placed(surfaces::makeQuad({1, 1}, 1), top),
                               glm::vec3(1.0f), pictureOf(*map, 1.0));
        alone.throwsShadows = false;
    }
    shown.addEdges(place, kEdge);
    aimAtBox(shown);
    shown.eye.distance = 3.0f;
    shown.throwsShadows = false;
    return shown.draw();
}

viewer::Picture revolutionBox(FigureFrames& frames, bool showsMap) {
    const auto map = figureShape("goblet", frames.texels);
    const BoxPlace place{revolvedSize(*map)};
    FigureStage figure(frames);
    if (showsMap) {
        // From the axis, where u = ½, to u = 1, upright.
        const auto aspect = static_cast<float>(map->aspect());
        const glm::mat4 upright = glm::rotate(glm::translate(glm::mat4(1), glm::vec3(0.25f, 0, 0)),
                                              glm::radians(90.0f), glm::vec3(1, 0, 0));
        figure.stage().addPlain(surfaces::placed(surfaces::makeQuad({1, 1}, 2 * aspect),
                                                 glm::scale(upright, glm::vec3(0.5f))),
                                glm::vec3(1.0f), pictureOf(*map, 0.5));
    } else {
        figure.addBox(revolutionOf(map), place, kRed);
    }
    figure.addEdges(place, kEdge);
    aimAtBox(figure);
    figure.throwsShadows = false;
    return figure.draw();
}

// Fluted columns, an extrusion that is repeated in one box, from between them.
viewer::Picture insideOfBox(FigureFrames& frames, bool showsBox) {
    FigureStage figure(frames);
    const BoxPlace place{{8.0, 8.0, 2.4}, {0, 0, 1.2}};
    if (showsBox)
        figure.addBox(extrusionOf(figureShape("column", frames.texels, textures::WrapMode::Repeat),
                                  solids::makeProfile(0.0), {6, 6}),
                      place, kIvory);
    figure.addGround(0);
    figure.eye = {.azimuth = 14,
                  .elevation = 8,
                  .distance = 0.9f,
                  .fieldOfView = 55,
                  .target = {0.0f, -1.2f, 0.8f}};
    figure.light = {-20, 60};
    figure.throwsShadows = false;
    return figure.draw();
}

}  // namespace

std::vector<FigureRow> boxFigures(FigureFrames& frames) {
    return {
        {{repeatedPieces(frames, 30, 2.3f), "4.11 a piece, revolved", "repeated 5 by 5 on a plane"},
         {repeatedPieces(frames, 42, 0.8f), "4.11 nearer", "two triangles"},
         {ballsOnRing(frames, false), "4.12 depths not written", "the balls are drawn last"},
         {ballsOnRing(frames, true), "4.12 depths written",
          "balls and ring pass through each other"}},
        {{sunkOrWhole(frames, false), "4.13 sunk in a plane", "seen only through its rectangle"},
         {sunkOrWhole(frames, true), "4.13 in a shape box", "whole, from all sides"},
         {insideOfBox(frames, false), "4.15 front faces", "none face an eye inside of the box"},
         {insideOfBox(frames, true), "4.15 back faces", "the same box, drawn from within"}},
        {{extrusionBox(frames, true), "4.14 box of an extrusion", "u red, v green, z blue"},
         {extrusionBox(frames, false), "4.14 the extrusion", "the shape is on top"},
         {revolutionBox(frames, true), "4.14 box of a revolution", "u red, v green, z blue"},
         {revolutionBox(frames, false), "4.14 the revolution", "the section stands upright"}}};
}

}  // namespace relievo::bench
