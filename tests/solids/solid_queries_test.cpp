#include "solids/solid_queries.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "ray_check.h"
#include "small_shapes.h"
#include "textures/input_error.h"

namespace relievo::solids {
namespace {

using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

std::shared_ptr<const textures::ShapeMap> halfPlane(double c) {
    return shapeOf(32, 32, WrapMode::Clamp, [c](const glm::dvec2& place) { return place.x - c; });
}

// A point in the unit ball, nearer to its border than at random.
glm::dvec3 randomInBall(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const glm::dvec3 v(normal(random), normal(random), normal(random));
    return v * (std::pow(unit(random), 0.1) / glm::length(v));
}

// Counts points within the bounds of random places that are what the bounds say they are not, of
// `factor` times the bounds.
struct BoundCheck {
    int solid = 0;    // points with a bound to the solid above 0
    int outside = 0;  // to the outside
    int wrong = 0;
};

BoundCheck checkBounds(const Compound& compound, const glm::dmat4& placement, bool isDistance,
                       double factor, std::mt19937_64& random) {
    TraceOptions options;
    options.mapsAreDistances = isDistance;
    const SolidTracer tracer(compound, options);
    const SolidQueries queries(tracer, placement);
    const glm::dmat4 wholeFromWorld = glm::inverse(placement);
    std::uniform_real_distribution<double> unit(-0.6, 1.6);
    BoundCheck check;
    for (int k = 0; k < 60; ++k) {
        const glm::dvec3 point(placement *
                               glm::dvec4(unit(random), unit(random), unit(random), 1.0));
        const DistanceBounds bounds = queries.distanceBounds(point);
        EXPECT_GE(bounds.toSolid, 0.0);
        EXPECT_GE(bounds.toOutside, 0.0);
        EXPECT_EQ(std::min(bounds.toSolid, bounds.toOutside), 0.0);
        const double radius = std::max(bounds.toSolid, bounds.toOutside);
        if (radius == 0.0 || !std::isfinite(radius))
            continue;
        ++(bounds.toSolid > 0.0 ? check.solid : check.outside);
        for (int s = 0; s < 60; ++s) {
            const glm::dvec3 near = point + factor * radius * randomInBall(random);
            const bool isInside =
                plainInside(compound, glm::dvec3(wholeFromWorld * glm::dvec4(near, 1.0)));
            EXPECT_EQ(queries.inside(near), isInside);
            check.wrong += isInside == (bounds.toSolid > 0.0) ? 1 : 0;
        }
    }
    return check;
}

glm::dmat4 randomPlacement(std::mt19937_64& random, double lean) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    glm::dmat4 m = glm::rotate(glm::dmat4(1.0), 6.3 * unit(random),
                               glm::dvec3(unit(random), unit(random), 0.1));
    m = glm::scale(m, glm::dvec3(0.5) + glm::dvec3(unit(random), unit(random), unit(random)));
    m[1][0] += lean * unit(random);
    m[2][1] += lean * unit(random);
    m[3] = glm::dvec4(unit(random), unit(random), unit(random), 1.0);
    return m;
}

void add(BoundCheck& sum, const BoundCheck& one) {
    sum.solid += one.solid;
    sum.outside += one.outside;
    sum.wrong += one.wrong;
}

enum class Maps { Discs, Stars, Texels };

std::shared_ptr<const textures::ShapeMap> randomMap(Maps maps, WrapMode wrap,
                                                    std::mt19937_64& random) {
    switch (maps) {
        case Maps::Discs:
            return randomDiscs(16, 11, wrap, random);
        case Maps::Stars:
            return randomStar(32, 29, wrap, random);
        case Maps::Texels:
            break;
    }
    return randomTexels(5, 4, wrap, random);
}

BoundCheck checkAll(double factor, Maps maps) {
    std::mt19937_64 random(20291);
    const bool isDistance = maps != Maps::Texels;
    BoundCheck sum;
    for (const WrapMode wrap : kWraps)
        for (const double lean : {0.0, 0.4}) {
            for (const Profile& profile : manyProfiles()) {
                SolidPart part = extrusion(randomMap(maps, wrap, random), profile);
                part.windowMinimum = {-0.5, -0.3, 0.1};
                part.windowMaximum = {1.5, 1.2, 1.0};
                add(sum, checkBounds({{part}}, randomPlacement(random, lean), isDistance, factor,
                                     random));
            }
            for (const double extension : {0.0, 0.1, -0.03}) {
                SolidPart part = revolution(randomMap(maps, wrap, random), extension, {0.4, 0.5});
                part.windowMinimum = {-0.5, -0.3, -0.6};
                part.windowMaximum = {1.5, 1.2, 1.6};
                add(sum, checkBounds({{part}}, randomPlacement(random, lean), isDistance, factor,
                                     random));
            }
        }
    return sum;
}

TEST(DistanceBounds, HoldForDistances) {
    const BoundCheck check = checkAll(1.0, Maps::Discs);
    EXPECT_EQ(check.wrong, 0);
    EXPECT_GT(check.solid, 1000);
    EXPECT_GT(check.outside, 200);
}

TEST(DistanceBounds, HoldAroundSharpCorners) {
    const BoundCheck check = checkAll(1.0, Maps::Stars);
    EXPECT_EQ(check.wrong, 0);
    EXPECT_GT(check.solid, 1000);
    EXPECT_GT(check.outside, 100);
}

TEST(DistanceBounds, HoldForAnyMap) {
    const BoundCheck check = checkAll(1.0, Maps::Texels);
    EXPECT_EQ(check.wrong, 0);
    EXPECT_GT(check.solid, 1000);
    EXPECT_GT(check.outside, 200);
}

TEST(DistanceBounds, CheckCatchesTheGradientTakenForOne) {
    // √2 of a bound is what the distance of a texel would be if d had no slope above 1.
    EXPECT_GT(checkAll(std::sqrt(2.0), Maps::Discs).wrong, 0);
}

TEST(DistanceBounds, HoldForCompounds) {
    std::mt19937_64 random(20292);
    BoundCheck sum;
    for (int k = 0; k < 60; ++k) {
        Compound compound;
        for (int p = 0; p < 3; ++p) {
            SolidPart part = (k + p) % 3 == 0
                                 ? revolution(randomDiscs(12, 12, WrapMode::Repeat, random), 0.05)
                                 : extrusion(randomDiscs(12, 12, WrapMode::Mirror, random),
                                             makeProfile(0.05, 0.1));
            part.fromWhole = p == 0 ? glm::dmat4(1.0) : glm::inverse(randomPlacement(random, 0.2));
            part.operation = p == 0 ? BooleanOperation::Union
                                    : static_cast<BooleanOperation>((k / (p == 1 ? 1 : 3)) % 3);
            compound.parts.push_back(part);
        }
        add(sum, checkBounds(compound, randomPlacement(random, 0.2), true, 1.0, random));
    }
    EXPECT_EQ(sum.wrong, 0);
    EXPECT_GT(sum.solid, 1000);
    EXPECT_GT(sum.outside, 50);
}

TEST(DistanceBounds, AreTheDistanceInFrontOfWalls) {
    // u ≤ 1/4 + z/4 in a world where a tile is 2 wide, 2 long and 1 deep.
    const glm::dmat4 placement = glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 2.0, 1.0));
    const SolidTracer tracer({{extrusion(halfPlane(0.25), makeProfile(0.0, 0.25))}});
    const SolidQueries queries(tracer, placement);
    // In the world x ≤ 1/2 + z/2: from (x,z) it is (x − 1/2 − z/2)/√(5/4) away.
    const double distance = (1.3 - 0.5 - 0.25) / std::sqrt(1.25);
    const double bound = queries.distanceBound({1.3, 1.0, 0.5});
    EXPECT_LE(bound, distance);
    EXPECT_GE(bound, distance - 0.5 * 2.0 / 32.0);
    // Above the cap and above its edge.
    EXPECT_NEAR(queries.distanceBound({0.2, 1.0, -0.75}), 0.75, 1e-9);
    const double edge = std::hypot(0.5, 0.4);
    const double over = queries.distanceBound({0.5 + 0.5, 1.0, -0.4});
    EXPECT_LE(over, edge);
    EXPECT_GE(over, edge - 0.5 * 2.0 / 32.0);
    // Inside: to the nearest cap.
    EXPECT_NEAR(queries.distanceBounds({0.1, 1.0, 0.1}).toOutside, 0.1, 1e-9);
}

TEST(DistanceBounds, OfNothingAndEverything) {
    const auto empty = shapeOf(4, 4, WrapMode::Repeat, [](const glm::dvec2&) { return 1e4; });
    const SolidTracer nothing({{extrusion(empty, makeProfile(0.0))}});
    EXPECT_GT(SolidQueries(nothing, glm::dmat4(1.0)).distanceBound({0.5, 0.5, 0.5}), 1e3);
    const SolidTracer noParts(Compound{});
    const SolidQueries none(noParts, glm::dmat4(1.0));
    EXPECT_EQ(none.distanceBound({0.5, 0.5, 0.5}), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(none.sweepSphere(glm::dvec3(0.0), glm::dvec3(1.0), 0.1, 1e-3));
    EXPECT_FALSE(none.rayHit({}));
    EXPECT_EQ(SolidQueries(nothing, glm::dmat4(1.0)).distanceBound({NAN, 0.5, 0.5}), 0.0);
    EXPECT_GE(SolidQueries(nothing, glm::dmat4(1.0)).distanceBound({1e300, 0.5, 0.5}), 0.0);
    EXPECT_THROW(SolidQueries(nothing, glm::dmat4(0.0)), textures::InputError);
    EXPECT_THROW(SolidQueries(nothing, glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.0, 1.0))),
                 textures::InputError);
}

TEST(Nearest, IsWithinItsToleranceOfPlanes) {
    const SolidTracer tracer({{extrusion(halfPlane(0.25), makeProfile(0.0, 0.25))}});
    const SolidQueries queries(tracer, glm::scale(glm::dmat4(1.0), glm::dvec3(2.0, 2.0, 1.0)));
    const double tolerance = 1e-3;
    const auto wall = queries.nearest({0.9, 1.0, 0.5}, tolerance, 1.0);
    ASSERT_TRUE(wall.isFound);
    EXPECT_TRUE(wall.isCertain);
    const double distance = (0.9 - 0.5 - 0.25) / std::sqrt(1.25);
    EXPECT_LE(wall.distance, distance);
    EXPECT_GE(wall.distance, distance - 2.0 * tolerance);
    const auto corner = queries.nearest({-0.1, -0.1, -0.1}, tolerance, 1.0);
    ASSERT_TRUE(corner.isFound);
    EXPECT_NEAR(corner.distance, std::sqrt(0.03), 2.0 * tolerance);
    EXPECT_LE(glm::distance(corner.position, glm::dvec3(0.0)), 0.03);
    EXPECT_FALSE(queries.nearest({1.9, 1.0, 0.5}, tolerance, 0.1).isFound);
    EXPECT_EQ(queries.nearest({1.9, 1.0, 0.5}, tolerance, 0.1).distance, 0.1);
    EXPECT_EQ(queries.nearest({0.1, 1.0, 0.5}, tolerance, 0.1).distance, 0.0);
}

TEST(Sweep, OfAHalfSpaceIsExactWithinTheTolerance) {
    const SolidTracer tracer({{extrusion(halfPlane(0.25), makeProfile(0.0))}});
    const SolidQueries queries(tracer, glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
    for (const double radius : {0.0, 0.01, 0.3}) {
        const double tolerance = radius > 0.1 ? 2e-3 : 1e-4;
        const auto contact =
            queries.sweepSphere({1.6, 1.0, 1.0}, {0.1, 1.1, 0.9}, radius, tolerance);
        ASSERT_TRUE(contact);
        const double t = (1.6 - 0.5 - radius) / 1.5;
        EXPECT_LE(contact->t, t + 1e-9);
        EXPECT_GE(contact->t, t - 1.01 * tolerance / 1.5) << radius;
        EXPECT_TRUE(contact->isCertain);
        EXPECT_FALSE(contact->startsInContact);
        if (radius > 0.0) {
            EXPECT_GT(contact->normal.x, 0.98);
        }
    }
    EXPECT_FALSE(queries.sweepSphere({1.6, 1.0, 1.0}, {1.0, 1.1, 0.9}, 0.4, 1e-4));
    const auto inside = queries.sweepSphere({0.2, 1.0, 1.0}, {1.0, 1.1, 0.9}, 0.1, 1e-4);
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->startsInContact);
    EXPECT_FALSE(queries.sweepSphere({NAN, 1.0, 1.0}, {1.0, 1.1, 0.9}, 0.1, 1e-4));
    EXPECT_FALSE(queries.sweepSphere({1.6, 1.0, 1.0}, {0.1, 1.1, 0.9}, -1.0, 1e-4));
    EXPECT_FALSE(queries.sweepSphere({1.6, 1.0, 1.0}, {0.1, 1.1, 0.9}, 0.1, 0.0));
}

TEST(Sweep, PassesNothingThin) {
    // A wall of a twentieth of a texel.
    const auto thin = shapeOf(64, 64, WrapMode::Clamp, [](const glm::dvec2& place) {
        return std::abs(place.x - 32.5 / 64.0) - 0.05 / 64.0;
    });
    const SolidTracer tracer({{extrusion(thin, makeProfile(0.0))}});
    const SolidQueries queries(tracer, glm::dmat4(1.0));
    const auto contact = queries.sweepSphere({-100.0, 0.5, 0.5}, {100.0, 0.6, 0.4}, 1e-3, 1e-5);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->centre.x, 32.5 / 64.0 - 0.05 / 64.0 - 1e-3, 2e-5);
}

TEST(Sweep, StopsWhereABallMeetsTheSolid) {
    std::mt19937_64 random(20293);
    std::uniform_real_distribution<double> unit(-0.5, 1.5);
    int contacts = 0;
    int uncertain = 0;
    int near = 0;
    for (int k = 0; k < 60; ++k) {
        SolidPart first = k % 2 == 0 ? revolution(randomDiscs(24, 24, WrapMode::Clamp, random))
                                     : extrusion(randomDiscs(24, 24, WrapMode::Repeat, random),
                                                 makeProfile(0.0, 0.1, 0.4));
        SolidPart second =
            extrusion(randomDiscs(16, 16, WrapMode::Repeat, random), makeProfile(0.0));
        second.fromWhole = glm::inverse(randomPlacement(random, 0.0));
        second.operation = k % 3 == 0 ? BooleanOperation::Union : BooleanOperation::Difference;
        const Compound compound{{first, second}};
        const SolidTracer tracer(compound);
        const SolidQueries queries(tracer, glm::dmat4(1.0));
        for (int s = 0; s < 4; ++s) {
            const glm::dvec3 a(unit(random), unit(random), unit(random));
            const glm::dvec3 b(unit(random), unit(random), unit(random));
            const double radius = 0.02 + 0.05 * s;
            const double tolerance = 1e-3;
            const auto contact = queries.sweepSphere(a, b, radius, tolerance);
            const double free = contact ? contact->t : 1.0;
            for (int sample = 0; sample < 2000 && !(contact && contact->startsInContact);
                 ++sample) {
                const double t = free * (unit(random) + 0.5) / 2.0;
                const glm::dvec3 place = a + t * (b - a) + radius * randomInBall(random);
                EXPECT_FALSE(plainInside(compound, place)) << k << ' ' << s;
            }
            if (!contact)
                continue;
            ++contacts;
            uncertain += contact->isCertain ? 0 : 1;
            if (!contact->isCertain)
                continue;
            EXPECT_LE(glm::distance(contact->centre, contact->position),
                      radius + tolerance * (1.0 + 1e-9));
            EXPECT_LE(queries.distanceBound(contact->position), 0.5 * tolerance);
            bool isNear = plainInside(compound, contact->position);
            for (int sample = 0; sample < 1000 && !isNear; ++sample)
                isNear = plainInside(compound,
                                     contact->position + 3.0 * tolerance * randomInBall(random));
            near += isNear ? 1 : 0;
        }
    }
    EXPECT_GT(contacts, 100);
    EXPECT_EQ(uncertain, 0);
    EXPECT_EQ(near, contacts);
}

TEST(RayHit, IsTheTracersInTheWorld) {
    std::mt19937_64 random(20294);
    const SolidTracer tracer(
        {{extrusion(randomDiscs(16, 16, WrapMode::Repeat, random), makeProfile(0.0, 0.1))}});
    int hits = 0;
    for (int k = 0; k < 300; ++k) {
        const glm::dmat4 placement = randomPlacement(random, 0.3);
        const SolidQueries queries(tracer, placement);
        const SolidRay ray = randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random);
        const SolidRay inWorld{glm::dvec3(placement * glm::dvec4(ray.origin, 1.0)),
                               glm::dmat3(placement) * ray.direction, ray.end};
        const auto expected = tracer.firstHit(ray);
        const auto hit = queries.rayHit(inWorld);
        if (!hit || !expected || expected->startsInside)
            continue;
        ++hits;
        EXPECT_NEAR(hit->t, expected->t, 1e-6 * (1.0 + expected->t));
        EXPECT_NEAR(glm::length(hit->normal), 1.0, 1e-12);
        EXPECT_LE(glm::dot(hit->normal, inWorld.direction), 1e-9);
        // At right angles to what is at right angles to the covector.
        const glm::dvec3 tangent = glm::cross(expected->outward, glm::dvec3(0.3, 0.5, 0.8));
        if (glm::distance(hit->hit.outward, expected->outward) < 1e-6) {
            EXPECT_NEAR(glm::dot(hit->normal, glm::dmat3(placement) * tangent), 0.0, 1e-5);
        }
    }
    EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace relievo::solids
