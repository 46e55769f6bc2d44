#include "solids/solid_tracer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ray_check.h"
#include "small_shapes.h"
#include "textures/input_error.h"

namespace relievo::solids {
namespace {

using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

SolidPart extrusion(std::shared_ptr<const textures::ShapeMap> shape, Profile profile) {
    SolidPart part;
    part.solid = {std::move(shape), SolidKind::Extrusion, std::move(profile), 0.0, glm::dvec2(0.5)};
    return part;
}

SolidPart revolution(std::shared_ptr<const textures::ShapeMap> shape, double extension = 0.0,
                     glm::dvec2 axis = glm::dvec2(0.5)) {
    SolidPart part;
    part.solid = {std::move(shape), SolidKind::Revolution, makeProfile(0.0), extension, axis};
    return part;
}

// Everything to the left of u = c.
std::shared_ptr<const textures::ShapeMap> halfPlane(double c, int width = 8, int height = 8) {
    return shapeOf(width, height, WrapMode::Clamp,
                   [c](const glm::dvec2& place) { return place.x - c; });
}

// What goes wrong in `rays` random rays through a part and its window, without and with jumps;
// prints the first.
int countWrong(const SolidPart& part, int rays, int samples, bool isDistance,
               std::mt19937_64& random) {
    TraceOptions plain;
    plain.jumps = false;
    TraceOptions jumping;
    jumping.mapsAreDistances = isDistance;
    const SolidTracer walker({{part}}, plain);
    const SolidTracer jumper({{part}}, jumping);
    int wrong = 0;
    for (int k = 0; k < rays; ++k) {
        const SolidRay ray = randomRay(part.windowMinimum, part.windowMaximum, random);
        const double end = lastPlace(ray, part.windowMinimum, part.windowMaximum);
        const auto walked = walker.crossings(0, ray);
        const auto jumped = jumper.crossings(0, ray);
        auto found = disagreement(part, walked, ray, end, samples);
        if (!found)
            found = disagreement(part, jumped, ray, end, samples);
        if (found && wrong++ == 0)
            ADD_FAILURE() << *found << "\norigin " << ray.origin.x << ' ' << ray.origin.y << ' '
                          << ray.origin.z << " direction " << ray.direction.x << ' '
                          << ray.direction.y << ' ' << ray.direction.z;
    }
    return wrong;
}

TEST(Extrusion, OfAHalfPlaneIsExact) {
    // Bilinear interpolation of a plane is that plane between the outermost texel centres.
    const SolidTracer basic({{extrusion(halfPlane(0.375), makeProfile(0.0))}});
    const SolidRay ray{{0.9, 0.5, 0.5}, {-2.0, 0.0, 0.0}};
    const auto hit = basic.firstHit(ray);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (0.9 - 0.375) / 2.0, 1e-15);
    EXPECT_EQ(hit->face, SolidFace::Wall);
    EXPECT_NEAR(hit->outward.x, 1.0, 1e-6);
    EXPECT_NEAR(hit->outward.y, 0.0, 1e-6);
    EXPECT_EQ(hit->outward.z, 0.0);

    // u − 3/8 ≤ z/4: a slope, met from above at u = 3/8 + z/4 where u = 1/2: z = 1/2.
    const SolidTracer bevel({{extrusion(halfPlane(0.375), makeProfile(0.0, 0.25))}});
    const auto top = bevel.firstHit({{0.5, 0.5, -1.0}, {0.0, 0.0, 3.0}});
    ASSERT_TRUE(top);
    EXPECT_NEAR(top->position.z, 0.5, 1e-15);
    EXPECT_NEAR(top->outward.z, -0.25, 1e-15);
}

TEST(Extrusion, HasCapsWhereTheRayEntersTheWindow) {
    const SolidTracer tracer({{extrusion(halfPlane(0.375), makeProfile(0.0))}});
    const auto top = tracer.firstHit({{0.2, 0.3, -2.0}, {0.0, 0.0, 1.0}});
    ASSERT_TRUE(top);
    EXPECT_EQ(top->t, 2.0);
    EXPECT_EQ(top->face, SolidFace::Cap);
    EXPECT_EQ(top->outward, glm::dvec3(0.0, 0.0, -1.0));
    EXPECT_FALSE(top->startsInside);
    const auto bottom = tracer.firstHit({{0.2, 0.3, 2.0}, {0.0, 0.0, -1.0}});
    ASSERT_TRUE(bottom);
    EXPECT_EQ(bottom->t, 1.0);
    EXPECT_EQ(bottom->outward, glm::dvec3(0.0, 0.0, 1.0));
    const auto all = tracer.crossings(0, {{-1.0, 0.5, 0.5}, {1.0, 0.0, 0.0}});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].t, 1.0);
    EXPECT_EQ(all[0].outward, glm::dvec3(-1.0, 0.0, 0.0));
    EXPECT_NEAR(all[1].t, 1.375, 1e-15);
    EXPECT_EQ(all[1].face, SolidFace::Wall);
}

TEST(Extrusion, StepsOfTheProfileAreSurfaces) {
    const std::array<glm::dvec2, 2> knots{{{0.5, 0.0}, {0.5, 0.25}}};
    const SolidTracer tracer({{extrusion(halfPlane(0.375), profileThrough(knots))}});
    const auto ledge = tracer.firstHit({{0.5, 0.5, 0.0}, {0.0, 0.0, 1.0}});
    ASSERT_TRUE(ledge);
    EXPECT_EQ(ledge->t, 0.5);
    EXPECT_EQ(ledge->face, SolidFace::Step);
    EXPECT_EQ(ledge->outward, glm::dvec3(0.0, 0.0, -1.0));
    const auto up = tracer.crossings(0, {{0.5, 0.5, 2.0}, {0.0, 0.0, -1.0}});
    ASSERT_EQ(up.size(), 2u);
    EXPECT_EQ(up[0].t, 1.0);
    EXPECT_EQ(up[1].t, 1.5);
    EXPECT_EQ(up[1].face, SolidFace::Step);
    EXPECT_EQ(up[1].outward, glm::dvec3(0.0, 0.0, -1.0));
}

TEST(Extrusion, AgreesWithItsImplicitFunction) {
    std::mt19937_64 random(20261);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const Profile& profile : manyProfiles())
            for (const auto& [width, height] : {std::pair(16, 16), {13, 7}, {5, 11}}) {
                SolidPart part = extrusion(randomDiscs(width, height, wrap, random), profile);
                part.windowMinimum = {-1.3, -0.4, 0.0};
                part.windowMaximum = {1.7, 1.2, 0.9};
                wrong += countWrong(part, 500, 100, true, random);
            }
    EXPECT_EQ(wrong, 0);
}

TEST(Extrusion, OfMapsThatAreNoDistancesAgreesToo) {
    std::mt19937_64 random(20262);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const Profile& profile : manyProfiles())
            for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {6, 1}, {4, 4}, {7, 3}}) {
                SolidPart part = extrusion(randomTexels(width, height, wrap, random), profile);
                part.windowMinimum = {-1.3, -0.4, 0.0};
                part.windowMaximum = {1.7, 1.2, 1.0};
                wrong += countWrong(part, 200, 100, false, random);
            }
    EXPECT_EQ(wrong, 0);
}

TEST(Revolution, AgreesWithItsImplicitFunction) {
    std::mt19937_64 random(20263);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const double extension : {0.0, 0.06, -0.03})
            for (const glm::dvec2 axis : {glm::dvec2(0.5), glm::dvec2(0.3, 0.8)})
                for (const auto& [width, height] : {std::pair(16, 16), {13, 7}, {5, 11}}) {
                    SolidPart part = revolution(randomDiscs(width, height, WrapMode::Clamp, random),
                                                extension, axis);
                    auto shape = std::make_shared<textures::ShapeMap>(*part.solid.shape);
                    shape->wrap = wrap;
                    part.solid.shape = shape;
                    part.windowMinimum = {-1.3, -0.4, -0.7};
                    part.windowMaximum = {1.7, 1.2, 2.2};
                    wrong += countWrong(part, 300, 100, true, random);
                }
    EXPECT_EQ(wrong, 0);
}

TEST(Revolution, OfMapsThatAreNoDistancesAgreesToo) {
    std::mt19937_64 random(20264);
    int wrong = 0;
    for (const WrapMode wrap : kWraps)
        for (const auto& [width, height] : {std::pair(1, 1), {1, 5}, {6, 1}, {4, 4}, {7, 3}}) {
            SolidPart part = revolution(randomTexels(width, height, wrap, random));
            part.windowMinimum = {-1.3, -0.4, -0.7};
            part.windowMaximum = {1.7, 1.2, 2.2};
            wrong += countWrong(part, 1000, 100, false, random);
        }
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace relievo::solids
