// Distances to boundaries against brute force over all segments, and against shapes in closed form.
#include "preprocess/boundary_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "preprocess/processor.h"
#include "thread_limit.h"

namespace relievo::preprocess {
namespace {

double distanceTo(const BoundarySegment& segment, const glm::dvec2& place) {
    const glm::dvec2 along = segment.end - segment.start;
    const double square = glm::dot(along, along);
    const double share =
        square > 0.0 ? std::clamp(glm::dot(place - segment.start, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(place, segment.start + share * along);
}

double nearestDistance(const std::vector<BoundarySegment>& segments, const glm::dvec2& place) {
    double nearest = HUGE_VAL;
    for (const BoundarySegment& segment : segments)
        nearest = std::min(nearest, distanceTo(segment, place));
    return nearest;
}

std::vector<BoundarySegment> circle(const glm::dvec2& centre, double radius, int count) {
    std::vector<BoundarySegment> segments;
    const auto at = [&](int k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        return centre + radius * glm::dvec2(std::cos(angle), std::sin(angle));
    };
    for (int k = 0; k < count; ++k)
        segments.push_back({at(k), at(k + 1)});
    return segments;
}

// Short and long segments, points, and many that share a point.
std::vector<BoundarySegment> randomSegments(unsigned seed, double size) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-0.5 * size, 1.5 * size);
    std::uniform_real_distribution<double> step(-3.0, 3.0);
    std::vector<BoundarySegment> segments;
    for (int k = 0; k < 200; ++k) {
        const glm::dvec2 start(place(random), place(random));
        const glm::dvec2 end = k % 20 == 0   ? glm::dvec2(place(random), place(random))
                               : k % 20 == 1 ? start
                                             : start + glm::dvec2(step(random), step(random));
        segments.push_back({start, end});
    }
    return segments;
}

void expectExact(const std::vector<BoundarySegment>& segments, int width, int height) {
    const BoundaryDistances found =
        measureBoundaryDistances(buildBoundaryTree(segments), width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const glm::dvec2 place(i + 0.5, j + 0.5);
            const double exact = nearestDistance(segments, place);
            ASSERT_NEAR(found.distance.at(i, j), exact, 1e-6 + 0x1p-22 * exact) << i << ", " << j;
            const glm::dvec2 away(found.awayX.at(i, j), found.awayY.at(i, j));
            if (exact == 0.0)
                continue;
            EXPECT_NEAR(glm::length(away), 1.0, 1e-6);
            // Back along it there is the boundary.
            EXPECT_NEAR(nearestDistance(segments, place - exact * away), 0.0, 1e-5 * (1.0 + exact));
        }
}

TEST(BoundaryDistance, IsThatOfTheNearestSegment) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        expectExact(randomSegments(seed, 48.0), 48, 48);
    }
    expectExact(randomSegments(9, 30.0), 37, 5);
    expectExact(randomSegments(10, 8.0), 1, 1);
    expectExact(circle({20.0, 21.0}, 15.0, 300), 41, 43);
    expectExact({{{3.0, 3.0}, {3.0, 3.0}}}, 7, 9);
}

// Many short segments: lists are long, and what is left out of them must never be the nearest, near
// or far, beside an outline or in the middle of it.
TEST(BoundaryDistance, OfRaggedOutlines) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> offset(-2.0, 2.0);
    std::vector<BoundarySegment> ragged;
    for (const double radius : {4.0, 20.0, 40.0}) {
        const std::size_t first = ragged.size();
        for (const BoundarySegment& segment :
             circle({50.3, 40.8}, radius, static_cast<int>(8.0 * radius)))
            ragged.push_back(segment);
        for (std::size_t k = first; k < ragged.size(); ++k) {
            ragged[k].end += glm::dvec2(offset(random), offset(random));
            ragged[k + 1 < ragged.size() ? k + 1 : first].start = ragged[k].end;
        }
    }
    expectExact(ragged, 101, 83);
    expectExact(circle({150.5, 150.5}, 140.0, 2500), 67, 45);  // seen from outside and inside
    expectExact(circle({33.5, 22.5}, 200.0, 3000), 67, 45);    // all as far from its middle
}

TEST(BoundaryDistance, FarFromTheMap) {
    expectExact(circle({5000.0, -7000.0}, 300.0, 2000), 16, 16);
}

TEST(BoundaryDistance, WithoutABoundaryIsEndless) {
    const BoundaryDistances found = measureBoundaryDistances(buildBoundaryTree({}), 5, 3);
    for (const float distance : found.distance.texels)
        EXPECT_EQ(distance, std::numeric_limits<float>::infinity());
    for (const float away : found.awayX.texels)
        EXPECT_EQ(away, 0.0f);
}

TEST(BoundaryDistance, DoesNotDependOnThreadsOrProcessor) {
    const BoundaryTree tree = buildBoundaryTree(randomSegments(3, 64.0));
    const auto measure = [&] { return measureBoundaryDistances(tree, 64, 64); };
    const BoundaryDistances all = measure();
    for (const Processor processor : {Processor::Baseline, Processor::Avx2, Processor::Avx512}) {
        const ProcessorLimit limit(processor);
        const BoundaryDistances one = onThreads(1, measure);
        EXPECT_EQ(all.distance.texels, one.distance.texels);
        EXPECT_EQ(all.awayX.texels, one.awayX.texels);
        EXPECT_EQ(all.awayY.texels, one.awayY.texels);
    }
}

}  // namespace
}  // namespace relievo::preprocess
