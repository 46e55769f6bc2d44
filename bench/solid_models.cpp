#include "bench/solid_models.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "outlines/outline.h"
#include "preprocess/shape_baker.h"
#include "reference/sample_outlines.h"

namespace relievo::bench {
namespace {

constexpr std::array<std::string_view, 9> kSolids{
    "basic", "extended",   "bevel",         "chamfer",          "chamfer-large",
    "round", "revolution", "revolution-10", "revolution-10-off"};
constexpr std::array<std::string_view, 5> kShapes{"star", "annulus", "comb", "torus", "vase"};

constexpr int kReplicas = 10;

bool isRevolution(std::string_view solid) {
    return solid.starts_with("revolution");
}

bool isSection(std::string_view shape) {
    return shape == "torus" || shape == "vase";
}

reference::SampleOutline outlineOf(std::string_view shape) {
    for (auto& outline : isSection(shape) ? reference::sampleSections() : reference::sampleShapes())
        if (outline.name == shape)
            return outline;
    assert(false);
    return {};
}

solids::Profile profileOf(std::string_view solid) {
    if (solid == "extended")
        return solids::makeProfile(0.03);
    if (solid == "bevel")
        return solids::makeProfile(0.0, 0.08);
    if (solid == "chamfer")
        return solids::makeProfile(0.0, 0.04, 0.25);
    if (solid == "chamfer-large")
        return solids::makeProfile(0.0, 0.16, 0.4);
    if (solid == "round")
        return solids::makeProfile(0.0, 0.04, 0.25, solids::ProfileShape::Round);
    return solids::makeProfile(0.0);
}

// Where an extrusion begins that is `distance` from its outline.
double depthAt(const solids::Profile& profile, double distance) {
    for (const solids::ProfilePiece& piece : profile.pieces) {
        if (distance <= piece.topOffset)
            return piece.top;
        if (distance <= piece.bottomOffset)
            return piece.top + (distance - piece.topOffset) / piece.slope();
    }
    return 1.0;
}

}  // namespace

std::span<const std::string_view> solidModelNames() {
    return kSolids;
}

std::span<const std::string_view> solidShapeNames() {
    return kShapes;
}

bool fitsSolid(std::string_view shape, std::string_view solid) {
    return isSection(shape) == isRevolution(solid);
}

std::shared_ptr<const textures::ShapeMap> makeSolidShape(std::string_view shape, int size,
                                                         bool hasSharpCorners) {
    const reference::SampleOutline sample = outlineOf(shape);
    const outlines::Outline outline{sample.contours, sample.filling == reference::Filling::NonZero
                                                         ? outlines::FillRule::NonZero
                                                         : outlines::FillRule::EvenOdd};
    preprocess::ShapePlan plan;
    plan.wrap = isSection(shape) ? textures::WrapMode::Clamp : textures::WrapMode::Repeat;
    plan.width = plan.height = size;
    plan.hasSharpCorners = hasSharpCorners;
    return std::make_shared<textures::ShapeMap>(
        preprocess::bakeShape({outlines::Drawing{{outline}, 1.0}, size, size, ""}, plan));
}

solids::SolidPart makeSolidModel(std::string_view solid,
                                 std::shared_ptr<const textures::ShapeMap> shape) {
    constexpr double kUnbounded = std::numeric_limits<double>::infinity();
    solids::SolidPart part;
    part.solid.shape = std::move(shape);
    if (isRevolution(solid)) {
        const double replicas = solid == "revolution" ? 1 : kReplicas;
        part.solid.kind = solids::SolidKind::Revolution;
        part.windowMaximum = {replicas, replicas, 1.0};
        if (solid == "revolution-10-off")
            part.solid.axis = {0.65, 0.65};
    } else {
        part.solid.profile = profileOf(solid);
        part.windowMinimum = {-kUnbounded, -kUnbounded, 0.0};
        part.windowMaximum = {kUnbounded, kUnbounded, 1.0};
    }
    return part;
}

textures::DepthMap reliefOf(const solids::Solid& extrusion) {
    textures::DepthMap relief;
    relief.wrap = extrusion.shape->wrap;
    relief.depth = extrusion.shape->distance;
    for (float& texel : relief.depth.texels)
        texel = static_cast<float>(depthAt(extrusion.profile, double{texel}));
    return relief;
}

}  // namespace relievo::bench
