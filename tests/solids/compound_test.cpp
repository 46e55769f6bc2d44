#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "ray_check.h"
#include "small_shapes.h"
#include "solids/solid_tracer.h"

namespace relievo::solids {
namespace {

using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};

SolidPart fullBox(BooleanOperation operation, glm::dvec3 low, glm::dvec3 high) {
    SolidPart part = extrusion(
        shapeOf(1, 1, WrapMode::Clamp, [](const glm::dvec2&) { return -1.0; }), makeProfile(0.0));
    part.windowMinimum = low;
    part.windowMaximum = high;
    part.operation = operation;
    return part;
}

// A placement whose space holds the part's tile somewhere around [0,1]³.
glm::dmat4 randomPlacement(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    glm::dmat4 m(1.0);
    m = glm::translate(m, glm::dvec3(0.5));
    m = glm::rotate(m, 6.3 * unit(random), glm::dvec3(unit(random), unit(random), 0.1));
    m = glm::scale(m, glm::dvec3(0.5) + glm::dvec3(unit(random), unit(random), unit(random)));
    m[1][0] += 0.3 * unit(random);  // shear
    return glm::translate(m, -glm::dvec3(unit(random), unit(random), unit(random)));
}

Compound randomCompound(std::mt19937_64& random) {
    std::uniform_int_distribution<int> pick(0, 2);
    Compound compound;
    const int parts = 2 + pick(random);
    const std::vector<Profile> profiles = manyProfiles();
    for (int k = 0; k < parts; ++k) {
        const auto shape =
            randomDiscs(12, 9, kWraps[static_cast<std::size_t>(pick(random))], random);
        SolidPart part =
            pick(random) == 0
                ? revolution(shape, 0.02)
                : extrusion(shape, profiles[static_cast<std::size_t>(3 * pick(random) + k)]);
        part.fromWhole =
            k == 1 && pick(random) == 0 ? compound.parts[0].fromWhole : randomPlacement(random);
        if (k > 0)
            part.operation = static_cast<BooleanOperation>(pick(random));
        compound.parts.push_back(part);
    }
    return compound;
}

bool isAnyTie(const Compound& compound, const glm::dvec3& point) {
    for (const SolidPart& part : compound.parts)
        if (isTie(part, glm::dvec3(part.fromWhole * glm::dvec4(point, 1.0))))
            return true;
    return false;
}

TEST(Compound, FirstHitsAreWhereTheWholeBegins) {
    std::mt19937_64 random(20281);
    int hits = 0;
    int wrong = 0;
    int facing = 0;
    for (int c = 0; c < 200; ++c) {
        const Compound compound = randomCompound(random);
        const SolidTracer tracer(compound);
        for (int k = 0; k < 100; ++k) {
            const SolidRay ray = randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random);
            const double speed = glm::length(ray.direction);
            const double last = 4.0 / std::max(1e-3, speed);
            const auto hit = tracer.firstHit(ray);
            const double free = hit ? hit->t - 1e-8 / speed : last;
            // Between any two crossings nothing changes.
            std::vector<double> places{0.0, free};
            for (std::size_t p = 0; p < compound.parts.size(); ++p)
                for (const SolidCrossing& crossing : tracer.crossings(p, ray))
                    if (crossing.t < free)
                        places.push_back(crossing.t);
            std::sort(places.begin(), places.end());
            for (std::size_t p = places.size(); p-- > 1;)
                places.push_back(0.5 * (places[p - 1] + places[p]));
            for (int s = 0; s < 50; ++s)
                places.push_back(free * (s + 0.5) / 50.0);
            for (const double t : places) {
                const glm::dvec3 point = ray.origin + t * ray.direction;
                if (t >= 0.0 && t <= free && plainInside(compound, point) &&
                    !isAnyTie(compound, point) && !(hit && hit->startsInside))
                    ++wrong;
            }
            if (!hit)
                continue;
            ++hits;
            const glm::dvec3 after = ray.origin + (hit->t + 1e-8 / speed) * ray.direction;
            if (!plainInside(compound, after) && !isAnyTie(compound, after)) {
                // Or it leaves again at once.
                std::size_t soon = 0;
                for (std::size_t p = 0; p < compound.parts.size(); ++p)
                    for (const SolidCrossing& crossing : tracer.crossings(p, ray))
                        soon += std::abs(crossing.t - hit->t) < 1e-8 / speed ? 1 : 0;
                wrong += soon < 2 ? 1 : 0;
            }
            EXPECT_EQ(tracer.contains(after), plainInside(compound, after));
            if (!hit->startsInside)
                facing += glm::dot(hit->outward, ray.direction) <= 0.0 ? 0 : 1;
        }
    }
    EXPECT_GT(hits, 3000);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(facing, 0);
}

TEST(Compound, CutFacesPointIntoWhatIsTakenAway) {
    const SolidTracer tracer(
        {{fullBox(BooleanOperation::Union, glm::dvec3(0.0), glm::dvec3(1.0)),
          fullBox(BooleanOperation::Difference, {0.25, 0.25, -1.0}, {0.75, 0.75, 2.0})}});
    const SolidRay ray{{0.5, 0.5, 0.5}, {1.0, 0.0, 0.0}};
    const auto hit = tracer.firstHit(ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 0.25);
    EXPECT_EQ(hit->part, 1u);
    EXPECT_EQ(hit->face, SolidFace::Cap);
    EXPECT_EQ(hit->outward, glm::dvec3(-1.0, 0.0, 0.0));
    EXPECT_FALSE(hit->startsInside);
    EXPECT_FALSE(tracer.contains(glm::dvec3(0.5)));
    EXPECT_TRUE(tracer.contains({0.2, 0.5, 0.5}));
}

TEST(Compound, FacesThatCoincideLeaveNothingBetweenThem) {
    const SolidTracer halves(
        {{fullBox(BooleanOperation::Union, glm::dvec3(0.0), glm::dvec3(1.0)),
          fullBox(BooleanOperation::Difference, glm::dvec3(0.0), {0.5, 1.0, 1.0})}});
    const auto hit = halves.firstHit({{-1.0, 0.3, 0.7}, {1.0, 0.0, 0.0}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 1.5);
    const SolidTracer nothing(
        {{fullBox(BooleanOperation::Union, glm::dvec3(0.0), glm::dvec3(1.0)),
          fullBox(BooleanOperation::Difference, glm::dvec3(0.0), glm::dvec3(1.0))}});
    std::mt19937_64 random(20282);
    for (int k = 0; k < 1000; ++k)
        EXPECT_FALSE(nothing.firstHit(randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random)));
}

TEST(Compound, FacesThatCoincideUpToARoundingLeaveNothingEither) {
    // A wall of a third, and a hole of its own scale through it, flush with both of its faces.
    SolidPart wall = fullBox(BooleanOperation::Union, glm::dvec3(0.0), glm::dvec3(1.0));
    wall.fromWhole =
        glm::affineInverse(glm::translate(glm::dmat4(1.0), glm::dvec3(0.1)) *
                           glm::scale(glm::dmat4(1.0), glm::dvec3(3.0, 3.0, 1.0 / 3.0)));
    SolidPart hole = fullBox(BooleanOperation::Difference, glm::dvec3(0.0),
                             glm::dvec3(1.0, 1.0, 1.0 / 3.0 / 0.7));
    hole.fromWhole = glm::scale(glm::dmat4(1.0), glm::dvec3(0.7, 0.7, 1.0 / 0.7)) *
                     glm::translate(glm::dmat4(1.0), glm::dvec3(-0.3, -0.3, -0.1));
    const SolidTracer tracer({{wall, hole}});
    const SolidTracer walls({{wall}});
    std::mt19937_64 random(20284);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    int apart = 0;
    for (int k = 0; k < 2000; ++k) {
        const glm::dvec3 through(0.4 + 0.8 * unit(random), 0.4 + 0.8 * unit(random), 0.25);
        const glm::dvec3 direction(0.2 * unit(random), 0.2 * unit(random), k % 2 == 0 ? 1.0 : -1.0);
        const SolidRay ray{through - 3.0 * unit(random) * direction - 0.5 * direction, direction};
        EXPECT_FALSE(tracer.firstHit(ray));
        const auto a = tracer.crossings(0, ray);
        const auto b = tracer.crossings(1, ray);
        ASSERT_EQ(a.size(), 2u);
        ASSERT_EQ(b.size(), 2u);
        apart += a[0].t != b[0].t ? 1 : 0;
    }
    EXPECT_GT(apart, 100);
}

TEST(Compound, OutwardIsTheGradientInTheWhole) {
    std::mt19937_64 random(20283);
    int checked = 0;
    for (int k = 0; k < 3000; ++k) {
        SolidPart part = k % 2 == 0 ? extrusion(randomDiscs(9, 7, WrapMode::Mirror, random),
                                                makeProfile(0.0, 0.2))
                                    : revolution(randomDiscs(9, 7, WrapMode::Mirror, random));
        part.fromWhole = randomPlacement(random);
        part.windowMinimum.z = k % 2 == 0 ? 0.0 : -2.0;
        const SolidTracer tracer({{part}});
        const auto hit = tracer.firstHit(randomRay(glm::dvec3(0.0), glm::dvec3(1.0), random));
        if (!hit || hit->face != SolidFace::Wall)
            continue;
        const auto clearance = [&](const glm::dvec3& point) {
            return plainClearance(part.solid, glm::dvec3(part.fromWhole * glm::dvec4(point, 1.0)));
        };
        glm::dvec3 gradient;
        glm::dvec3 coarse;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 shift(0.0);
            shift[axis] = 1e-6;
            gradient[axis] =
                (clearance(hit->position + shift) - clearance(hit->position - shift)) / 2e-6;
            shift[axis] = 2e-6;
            coarse[axis] =
                (clearance(hit->position + shift) - clearance(hit->position - shift)) / 4e-6;
        }
        if (glm::distance(gradient, coarse) > 1e-7)
            continue;  // at the border of two cells
        EXPECT_NEAR(glm::distance(hit->outward, gradient), 0.0, 1e-6);
        ++checked;
    }
    EXPECT_GT(checked, 500);
}

}  // namespace
}  // namespace relievo::solids
