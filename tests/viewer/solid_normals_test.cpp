// The normals of solids from exact gradients against those of the true outlines in double
// precision, away from edges.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "hostile_solid_rays.h"
#include "materials/solid_registry.h"
#include "reference/outline_solids.h"
#include "reference/plane_outline.h"
#include "shaders/relievo/constants.h"
#include "solid_samples.h"
#include "solid_scene.h"

namespace relievo::viewer {
namespace {

using reference::SolidHit;
using reference::SolidRay;

constexpr int kSize = 512;
constexpr double kTexel = 1.0 / kSize;

/// The true solid: where a ray in its metric space hits it.
using TrueSolid = std::function<std::optional<SolidHit>(const SolidRay&)>;

struct NormalErrors {
    int compared = 0;
    int atEdges = 0;
    double sum = 0.0;  // degrees
    double worst = 0.0;

    [[nodiscard]] double mean() const { return sum / std::max(compared, 1); }
};

double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0 / std::numbers::pi;
}

// Whether the solid faces elsewhere up to two texels beside a ray.
bool isAtEdge(const TrueSolid& solid, const SolidRay& ray, const SolidHit& hit) {
    const glm::dvec3 across = glm::normalize(
        glm::cross(ray.direction, std::abs(ray.direction.z) < 0.9 * glm::length(ray.direction)
                                      ? glm::dvec3(0.0, 0.0, 1.0)
                                      : glm::dvec3(1.0, 0.0, 0.0)));
    const glm::dvec3 over = glm::normalize(glm::cross(across, ray.direction));
    for (const glm::dvec3& shift : {across, -across, over, -over})
        for (const double texels : {0.5, 1.0, 2.0}) {
            SolidRay beside = ray;
            beside.origin += texels * kTexel * shift;
            const auto other = solid(beside);
            if (!other || degreesBetween(other->normal, hit.normal) > 10.0)
                return true;
        }
    return false;
}

// Rays from around the tile of a material with one part, which is [0,1]³; `middle` is what the true
// solid has at its origin.
NormalErrors measureNormals(SolidStage& stage, const solids::SolidPart& part,
                            const TrueSolid& solid, const glm::dvec3& middle) {
    materials::SolidMaterial material(stage.shapes, {{part}},
                                      materials::findSolidTechnique("solid"));
    material.boxFromWhole = glm::dmat4(1.0);
    const double aspect = part.solid.shape->aspect();
    const glm::dvec3 metric(1.0, aspect,
                            part.solid.kind == solids::SolidKind::Extrusion ? 1.0 : aspect);
    gl::Program program = solidRayProgram(material);
    std::vector<HostileSolidRay> rays = hostileSolidRays(glm::dvec3(0.0), glm::dvec3(1.0), 9000);
    std::erase_if(rays, [](const HostileSolidRay& ray) { return ray.regime != "any"; });
    NormalErrors errors;
    for (const MeasuredPixel& pixel : searchRays(material, program, rays)) {
        if (pixel.outcome != RELIEVO_OUTCOME_HIT)
            continue;
        const SolidRay ray{(glm::dvec3(pixel.origin) - middle) * metric,
                           glm::dvec3(pixel.direction) * metric, 0.0, pixel.end};
        const auto hit = solid(ray);
        const double length = glm::length(ray.direction);
        if (!hit || std::abs(hit->t - pixel.t) * length > 2.0 * kTexel || hit->startsInside)
            continue;
        if (isAtEdge(solid, ray, *hit)) {
            ++errors.atEdges;
            continue;
        }
        // Normals are covectors: that of the map's space in the metric one.
        const double off = degreesBetween(hit->normal, glm::dvec3(pixel.normal) / metric);
        ++errors.compared;
        errors.sum += off;
        errors.worst = std::max(errors.worst, off);
    }
    return errors;
}

void expectSmall(const std::string& name, const NormalErrors& errors) {
    fmt::print("{:<24} {} normals, {} at edges, mean {:.4f}°, worst {:.3f}°\n", name,
               errors.compared, errors.atEdges, errors.mean(), errors.worst);
    EXPECT_GT(errors.compared, 100) << name;
    EXPECT_LT(errors.mean(), 0.5) << name;
}

class SolidNormals : public testing::Test {
  protected:
    SolidStage stage_;
};

TEST_F(SolidNormals, OfExtrusionsAreThoseOfTheOutline) {
    for (const char* name : {"disc", "annulus", "star", "letters"}) {
        const reference::PlaneOutline outline = sampleOutline(name);
        const ShapeBaking baking{
            .width = kSize, .height = kSize, .wrap = textures::WrapMode::Clamp};
        solids::SolidPart part;
        part.solid.shape = sampleShape(name, baking);
        expectSmall(
            fmt::format("{}, basic", name),
            measureNormals(
                stage_, part, [&](const SolidRay& ray) { return hitExtrusion(outline, ray); },
                glm::dvec3(0.0)));
    }
}

TEST_F(SolidNormals, OfProfilesAreThoseOfTheOffset) {
    constexpr double kBevel = 0.06;
    constexpr double kChamfer = 0.5;
    const reference::PlaneOutline outline = sampleOutline("star");
    const reference::OffsetPiece below{kChamfer, 1.0, [](double) { return kBevel; }, 0.0};
    const reference::OffsetPiece bevel{
        0.0, kChamfer, [](double z) { return kBevel * z / kChamfer; }, kBevel / kChamfer};
    // The quarter of an ellipse begins level: steeper than this only above a hundredth of its
    // depth.
    const reference::OffsetPiece round{0.0, kChamfer,
                                       [](double z) {
                                           const double x = 1.0 - z / kChamfer;
                                           return kBevel * std::sqrt(std::max(0.0, 1.0 - x * x));
                                       },
                                       7.1 * kBevel / kChamfer};
    for (const solids::ProfileShape shape :
         {solids::ProfileShape::Bevel, solids::ProfileShape::Round}) {
        const bool isRound = shape == solids::ProfileShape::Round;
        const reference::OffsetProfile profile{isRound ? round : bevel, below};
        solids::SolidPart part;
        part.solid.shape = sampleShape(
            "star", {.width = kSize, .height = kSize, .wrap = textures::WrapMode::Clamp});
        part.solid.profile = solids::makeProfile(0.0, kBevel, kChamfer, shape);
        expectSmall(
            fmt::format("star, {}", solids::profileShapeName(shape)),
            measureNormals(
                stage_, part,
                [&](const SolidRay& ray) { return hitOffsetExtrusion(outline, profile, ray); },
                glm::dvec3(0.0)));
    }
}

TEST_F(SolidNormals, OfRevolutionsAreThoseOfTheSection) {
    for (const char* name : {"cone", "torus", "sphere", "vase"}) {
        const reference::PlaneOutline section = sampleOutline(name);
        solids::SolidPart part;
        part.solid.kind = solids::SolidKind::Revolution;
        part.solid.shape =
            sampleShape(name, {.width = kSize, .height = kSize, .wrap = textures::WrapMode::Clamp});
        expectSmall(name, measureNormals(
                              stage_, part,
                              [&](const SolidRay& ray) { return hitRevolution(section, ray); },
                              glm::dvec3(part.solid.axis, 0.0)));
    }
}

}  // namespace
}  // namespace relievo::viewer
