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

// Everything to the left of u = c.
std::shared_ptr<const textures::ShapeMap> halfPlane(double c, int width = 8, int height = 8) {
    return shapeOf(width, height, WrapMode::Clamp,
                   [c](const glm::dvec2& place) { return place.x - c; });
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

TEST(Revolution, OfALineIsACylinder) {
    // d = |R| − 1/4: exact outside the first half texel around the axis.
    const SolidTracer tracer({{revolution(halfPlane(0.25, 16, 8))}});
    std::mt19937_64 random(20271);
    int hits = 0;
    for (int k = 0; k < 2000; ++k) {
        const SolidRay ray = randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random);
        const glm::dvec2 from = glm::dvec2(ray.origin) - 0.5;
        const glm::dvec2 along(ray.direction);
        if (glm::length(from) < 0.25 + 1e-9 || glm::length(along) < 1e-9)
            continue;
        const double a = glm::dot(along, along);
        const double b = glm::dot(from, along);
        const double discriminant = b * b - a * (glm::dot(from, from) - 0.0625);
        if (std::abs(discriminant) < 1e-9 * a)
            continue;
        const double t = discriminant > 0.0 ? (-b - std::sqrt(discriminant)) / a : -1.0;
        const double z = ray.origin.z + t * ray.direction.z;
        const auto hit = tracer.firstHit(ray);
        if (t < 0.0) {
            EXPECT_FALSE(hit);
        } else if (z > 1e-9 && z < 1.0 - 1e-9) {
            ASSERT_TRUE(hit);
            EXPECT_NEAR(hit->t, t, 1e-12 * (1.0 + t));
            const glm::dvec2 radial = (from + t * along) / 0.25;
            EXPECT_NEAR(glm::distance(hit->outward, glm::dvec3(radial, 0.0)), 0.0, 1e-6);
            ++hits;
        }
    }
    EXPECT_GT(hits, 300);
}

TEST(Revolution, OfASlantIsACone) {
    // d = ½·(|R| − 1/8 − z/4), of a section of 16 × 16 texels; rays that hit away from its rim.
    const auto shape = shapeOf(16, 16, WrapMode::Clamp, [](const glm::dvec2& place) {
        return 0.5 * (place.x - 0.125 - 0.25 * place.y);
    });
    TraceOptions options;
    options.mapsAreDistances = false;
    const SolidTracer tracer({{revolution(shape)}}, options);
    std::mt19937_64 random(20272);
    int hits = 0;
    for (int k = 0; k < 2000; ++k) {
        const SolidRay ray = randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random);
        // |F + t·V|² = (p + t·q)², p + t·q ≥ 0
        const glm::dvec2 f = glm::dvec2(ray.origin) - 0.5;
        const glm::dvec2 v(ray.direction);
        const double p = 0.125 + 0.25 * ray.origin.z;
        const double q = 0.25 * ray.direction.z;
        const double a = glm::dot(v, v) - q * q;
        const double b = glm::dot(f, v) - p * q;
        const double c = glm::dot(f, f) - p * p;
        const double discriminant = b * b - a * c;
        if (c < 1e-9 || discriminant < 1e-6 * std::abs(a) || std::abs(a) < 1e-12 || p <= 0.0)
            continue;
        const double t = (-b - std::sqrt(discriminant)) / a;
        const double z = ray.origin.z + t * ray.direction.z;
        const glm::dvec3 place = ray.origin + t * ray.direction;
        if (a < 0.0 || t < 0.0 || z < 0.04 || z > 0.96 ||
            glm::distance(glm::dvec2(place), glm::dvec2(0.5)) > 0.45)
            continue;
        const auto hit = tracer.firstHit(ray);
        if (hit && hit->face == SolidFace::Cap)
            continue;  // it has come in through the top or bottom
        ASSERT_TRUE(hit) << k;
        if (hit->position.z < 0.04 || hit->position.z > 0.96)
            continue;  // the section is clamped there: a cylinder
        EXPECT_NEAR(hit->t, t, 1e-11 * (1.0 + t)) << k;
        ++hits;
    }
    EXPECT_GT(hits, 200);
}

TEST(Solids, BeginningInsideIsSaid) {
    const SolidTracer tracer({{extrusion(halfPlane(0.375), makeProfile(0.0))}});
    const auto inside = tracer.firstHit({{0.2, 0.5, 0.5}, {1.0, 0.0, 0.0}});
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->startsInside);
    EXPECT_EQ(inside->t, 0.0);
    EXPECT_EQ(inside->face, SolidFace::Origin);
    EXPECT_EQ(inside->outward, glm::dvec3(0.0));
    // On the surface: inwards it hits there, outwards it does not.
    const auto inwards = tracer.firstHit({{0.375, 0.5, 0.5}, {-1.0, 0.0, 0.0}});
    ASSERT_TRUE(inwards);
    EXPECT_EQ(inwards->t, 0.0);
    EXPECT_FALSE(inwards->startsInside);
    EXPECT_EQ(inwards->face, SolidFace::Wall);
    EXPECT_FALSE(tracer.firstHit({{0.375, 0.5, 0.5}, {1.0, 0.0, 0.0}}));
    // On the border of the window, likewise.
    const auto border = tracer.firstHit({{0.2, 0.5, 0.0}, {0.0, 0.0, 1.0}});
    ASSERT_TRUE(border);
    EXPECT_EQ(border->face, SolidFace::Cap);
    EXPECT_FALSE(border->startsInside);
    EXPECT_FALSE(tracer.firstHit({{0.2, 0.5, 0.0}, {0.0, 0.0, -1.0}}));
}

TEST(Solids, EndsAreKept) {
    const SolidTracer tracer({{extrusion(halfPlane(0.375), makeProfile(0.0))}});
    EXPECT_FALSE(tracer.firstHit({{0.875, 0.5, 0.5}, {-1.0, 0.0, 0.0}, 0.4999}));
    EXPECT_TRUE(tracer.firstHit({{0.875, 0.5, 0.5}, {-1.0, 0.0, 0.0}, 0.5001}));
    EXPECT_FALSE(tracer.firstHit({{0.875, 0.5, 0.5}, {-1.0, 0.0, 0.0}, 0.0}));
    EXPECT_TRUE(tracer.firstHit({{0.2, 0.5, 0.5}, {-1.0, 0.0, 0.0}, 0.0}));
    EXPECT_FALSE(tracer.firstHit({{0.2, 0.5, 0.5}, {-1.0, 0.0, 0.0}, -1.0}));
    EXPECT_FALSE(tracer.firstHit({{0.2, 0.5, 0.5}, {-1.0, 0.0, 0.0}, NAN}));
    const auto all = tracer.crossings(0, {{0.875, 0.5, 0.5}, {-1.0, 0.0, 0.0}, 0.6});
    ASSERT_EQ(all.size(), 1u);  // it ends inside
    EXPECT_TRUE(all[0].enters);
}

TEST(Solids, AbsurdRaysNeitherHangNorGiveNaN) {
    std::mt19937_64 random(20273);
    const std::array<double, 14> values{0.0, -0.0, 1e-320, 1e-300, 1e-16, 0.5,       1.0,
                                        1e5, 1e16, 1e300,  -1e-9,  -1e7,  kInfinity, NAN};
    std::vector<SolidTracer> tracers;
    for (const WrapMode wrap : kWraps)
        for (const int size : {1, 7}) {
            SolidPart a =
                extrusion(randomDiscs(size, 2 * size, wrap, random), makeProfile(0.0, 0.2));
            SolidPart b = revolution(randomDiscs(size, 2 * size, wrap, random));
            for (SolidPart* part : {&a, &b}) {
                tracers.emplace_back(Compound{{*part}});
                part->windowMinimum = glm::dvec3(-kInfinity);
                part->windowMaximum = glm::dvec3(kInfinity);
                tracers.emplace_back(Compound{{*part}});
            }
        }
    std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
    for (int k = 0; k < 2000; ++k) {
        SolidRay ray;
        for (int axis = 0; axis < 3; ++axis) {
            ray.origin[axis] = values[pick(random)];
            ray.direction[axis] = values[pick(random)];
        }
        for (const SolidTracer& tracer : tracers)
            if (const auto hit = tracer.firstHit(ray)) {
                EXPECT_TRUE(std::isfinite(hit->t)) << k;
                EXPECT_TRUE(std::isfinite(glm::dot(hit->position, glm::dvec3(1.0)))) << k;
                EXPECT_TRUE(std::isfinite(glm::dot(hit->outward, glm::dvec3(1.0)))) << k;
            }
    }
}

TEST(Solids, EmptyAndFullShapesAreNothingAndTheWindow) {
    for (const WrapMode wrap : kWraps) {
        const auto empty = shapeOf(4, 4, wrap, [](const glm::dvec2&) { return 10.0; });
        const auto full = shapeOf(4, 4, wrap, [](const glm::dvec2&) { return -10.0; });
        const SolidRay ray{{0.5, 0.5, -1.0}, {0.01, 0.02, 1.0}};
        for (const bool jumps : {false, true}) {
            TraceOptions options;
            options.jumps = jumps;
            EXPECT_FALSE(
                SolidTracer({{extrusion(empty, makeProfile(0.0))}}, options).firstHit(ray));
            EXPECT_FALSE(SolidTracer({{revolution(empty)}}, options).firstHit(ray));
            for (const SolidPart& part : {extrusion(full, makeProfile(0.0)), revolution(full)}) {
                const auto all = SolidTracer({{part}}, options).crossings(0, ray);
                ASSERT_EQ(all.size(), 2u);
                EXPECT_EQ(all[0].t, 1.0);
                EXPECT_EQ(all[1].t, 2.0);
                EXPECT_EQ(all[0].face, SolidFace::Cap);
            }
        }
    }
    EXPECT_FALSE(SolidTracer(Compound{}).firstHit({}));
}

TEST(Solids, SenselessPartsAreRefused) {
    const SolidPart good = extrusion(halfPlane(0.5), makeProfile(0.0));
    const auto refused = [&](const auto& spoil) {
        SolidPart part = good;
        spoil(part);
        EXPECT_THROW(SolidTracer({{part}}), textures::InputError);
    };
    refused([](SolidPart& part) { part.solid.shape = nullptr; });
    refused([](SolidPart& part) { part.solid.shape = std::make_shared<textures::ShapeMap>(); });
    refused([](SolidPart& part) { part.solid.profile.pieces.clear(); });
    refused([](SolidPart& part) { part.solid.extension = NAN; });
    refused([](SolidPart& part) { part.windowMaximum.y = NAN; });
    refused([](SolidPart& part) { part.fromWhole[2][3] = 0.5; });
    refused([](SolidPart& part) { part.fromWhole[1][0] = kInfinity; });
    refused([](SolidPart& part) {
        part.solid.shape =
            shapeOf(2, 2, WrapMode::Repeat, [](const glm::dvec2&) { return double(NAN); });
    });
}

TEST(Solids, JumpsSaveMostCells) {
    const std::vector<Disc> discs{{{0.5, 0.5}, 0.1}};
    SolidPart part = extrusion(discShape(512, 512, WrapMode::Repeat, discs), makeProfile(0.0));
    part.windowMaximum = {8.0, 8.0, 1.0};
    const SolidRay ray{{0.0, 0.1, 0.0}, {8.0, 0.02, 1.0}};
    TraceCost walked;
    TraceCost jumped;
    TraceOptions plain;
    plain.jumps = false;
    EXPECT_FALSE(SolidTracer({{part}}, plain).firstHit(ray, &walked));
    EXPECT_FALSE(SolidTracer({{part}}).firstHit(ray, &jumped));
    EXPECT_GE(walked.cells, 8 * 512);
    EXPECT_EQ(walked.jumps, 0);
    EXPECT_LT(jumped.cells + jumped.jumps, 64);
}

// The thesis' step by d itself, halved back where it has gone in: it passes what a bevel adds.
double steppedByDistance(const SolidPart& part, const SolidRay& ray, double end) {
    const double speed = std::hypot(ray.direction.x, part.solid.shape->aspect() * ray.direction.y);
    double t = 0.0;
    for (int k = 0; k < 10000 && t < end; ++k) {
        const glm::dvec3 place = ray.origin + t * ray.direction;
        if (plainClearance(part.solid, place) <= 1e-9)
            return t;
        t += std::max(1e-6, plainDistance(part.solid, place)) / speed;
    }
    return kInfinity;
}

TEST(Solids, ComparisonCatchesStepsByTheDistanceAlone) {
    std::mt19937_64 random(20274);
    const SolidPart part =
        extrusion(randomDiscs(32, 32, WrapMode::Repeat, random), makeProfile(0.0, 0.3));
    int passed = 0;
    int hits = 0;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 2000; ++k) {
        const double angle = 6.283185307179586 * unit(random);
        const SolidRay ray{{unit(random), unit(random), 1e-12},
                           {std::cos(angle), std::sin(angle), unit(random)}};
        const double end = lastPlace(ray, glm::dvec3(0.0), glm::dvec3(1.0));
        const auto hit = SolidTracer({{part}}).firstHit(ray);
        if (!hit || hit->startsInside)
            continue;
        ++hits;
        passed += steppedByDistance(part, ray, end) > hit->t + 1e-3 ? 1 : 0;
    }
    EXPECT_GT(hits, 300);
    EXPECT_GT(passed, hits / 10);
}

}  // namespace
}  // namespace relievo::solids
