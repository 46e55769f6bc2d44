// Shape maps against brute force over exact outlines, in all wrap modes and formats.
#include "preprocess/shape_baker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>
#include <random>

#include "preprocess/distance_transform.h"
#include "preprocess/inside_mask.h"
#include "preprocess/plane_shape.h"
#include "preprocess/prewitt_gradient.h"
#include "preprocess/sequential_distances.h"
#include "reference/shape_check.h"
#include "tests/preprocess/random_set.h"
#include "tests/preprocess/shape_oracle.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "thread_limit.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::ShapeMap;
using textures::StorageFormat;
using textures::WrapMode;

constexpr std::array kWraps{WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp};
constexpr std::array kFormats{StorageFormat::Float, StorageFormat::Half, StorageFormat::U16,
                              StorageFormat::U8};

ShapeSource vectorSource(const Polygons& shape, int width, int height) {
    return {drawingOf(shape, width, height), width, height, ""};
}

ShapeSource bitmapSource(Plane coverage) {
    const int width = coverage.width;
    const int height = coverage.height;
    return {std::move(coverage), width, height, ""};
}

// Of distances alone: what corners make of them is measured in shape_truth_test.
ShapePlan planOf(WrapMode wrap, StorageFormat format = StorageFormat::Float) {
    ShapePlan plan;
    plan.wrap = wrap;
    plan.format = format;
    plan.hasSharpCorners = false;
    return plan;
}

glm::dvec2 centreOf(int i, int j) {
    return {i + 0.5, j + 0.5};
}

// The nearest of the shape and what the wrap mode puts around it: outside positive.
double wrappedDistance(const Polygons& shape, const glm::dvec2& place, const glm::dvec2& size,
                       WrapMode wrap) {
    double nearest = signedDistance(shape, place);
    if (wrap != WrapMode::Repeat)
        return nearest;  // shapes that do not touch the border
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            nearest = std::min(nearest, signedDistance(shape, place + glm::dvec2(i, j) * size));
    return nearest;
}

// No pair of colours of noise: smooth, with coverage between 0 and 1 at its outlines.
Plane blobs(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::array<glm::dvec4, 8> waves;
    for (glm::dvec4& wave : waves)
        wave = {std::floor(7.0 * unit(random)) - 3.0, std::floor(7.0 * unit(random)) - 3.0,
                unit(random), 0.3 + unit(random)};
    Plane coverage(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            double sum = 0.0;
            for (const glm::dvec4& wave : waves)
                sum += wave.w * std::sin(2.0 * std::numbers::pi *
                                         (wave.x * i / width + wave.y * j / height + wave.z));
            coverage.at(i, j) = static_cast<float>(std::clamp(0.5 + 4.0 * sum, 0.0, 1.0));
        }
    return coverage;
}

TEST(ShapeBaker, DistancesOfDrawingsAreExact) {
    const std::array shapes{starOf({30.3, 20.1}, 6.0, 16.0, 5, 0.3),
                            annulusOf({31.0, 21.0}, 5.5, 14.25), squareOf({33.0, 19.5}, 9.0, 0.2)};
    for (const WrapMode wrap : kWraps)
        for (const Polygons& shape : shapes) {
            const int width = 61;
            const int height = 43;
            const ShapeMap map = bakeShape(vectorSource(shape, width, height), planOf(wrap));
            EXPECT_TRUE(map.isSigned);
            EXPECT_EQ(map.wrap, wrap);
            for (int j = 0; j < height; j += 2)
                for (int i = 0; i < width; ++i) {
                    const double exact =
                        wrappedDistance(shape, centreOf(i, j), {width, height}, wrap) / width;
                    ASSERT_NEAR(map.distance.at(i, j), exact, map.slack + 1e-7);
                    // Never farther than true, but for the 2⁻²⁸ of a tile of the outline.
                    ASSERT_LE(std::abs(map.distance.at(i, j)), std::abs(exact) + 1e-8);
                    const glm::dvec2 gradient(map.gradientX.at(i, j), map.gradientY.at(i, j));
                    ASSERT_NEAR(glm::length(gradient), 1.0, 1e-6);
                    // Along it lies the outline.
                    const glm::dvec2 nearest = centreOf(i, j) - exact * width * gradient;
                    ASSERT_NEAR(wrappedDistance(shape, nearest, {width, height}, wrap), 0.0, 1e-3);
                }
        }
}

// Long sides, far away: what floats may be off is in the slack.
TEST(ShapeBaker, DistancesOfLargeMapsAreWithinTheirSlack) {
    const Polygons shape{{{3.1, 1000.2}, {1997.7, 900.6}, {1990.3, 950.9}, {11.9, 1100.4}}};
    const ShapeMap map = bakeShape(vectorSource(shape, 2000, 1500), planOf(WrapMode::Clamp));
    std::mt19937 random(5);
    for (int k = 0; k < 20000; ++k) {
        const int i = static_cast<int>(random() % 2000);
        const int j = static_cast<int>(random() % 1500);
        const double exact = signedDistance(shape, centreOf(i, j)) / 2000;
        ASSERT_LE(std::abs(map.distance.at(i, j)), std::abs(exact) + 1e-8) << i << " " << j;
        ASSERT_GE(std::abs(map.distance.at(i, j)), std::abs(exact) - map.slack - 1e-8);
    }
    EXPECT_LT(map.slack * 2000, 0.002);
}

TEST(ShapeBaker, OutlinesOfCoverageAreWithinAQuarterTexel) {
    struct Case {
        const char* name;
        Polygons shape;
        double besideCorners;  // what holds, in texels
        double atCorners;
    };
    const glm::dvec2 centre(255.7, 256.4);
    const std::array cases{
        Case{"disc", discOf(centre, 180.3), 0.03, 0.0},
        Case{"small disc", discOf(centre, 5.0), 0.1, 0.0},
        Case{"annulus", annulusOf(centre, 100.0, 140.0), 0.04, 0.0},
        Case{"thin annulus", annulusOf(centre, 100.0, 102.5), 0.06, 0.0},
        Case{"square", squareOf(centre, 100.3, 0.0), 0.01, 0.01},
        Case{"turned square", squareOf(centre, 100.3, 0.3), 0.01, 0.02},
        Case{"diamond", squareOf(centre, 100.3, 0.25 * std::numbers::pi), 0.01, 0.2},
        Case{"star", starOf(centre, 76.39, 200.0, 5, -0.5 * std::numbers::pi), 0.02, 0.2},
        Case{"acute star", starOf(centre, 120.0, 200.0, 24, 0.2), 0.02, 0.25},
    };
    const auto errors = [](const Case& each, const Plane& coverage) {
        const ShapeMap map = bakeShape(bitmapSource(coverage), planOf(WrapMode::Clamp));
        std::array<double, 2> worst{0.0, 0.0};
        std::mt19937 random(3);
        for (int k = 0; k < 4000; ++k) {
            // Texels along the outline, and everywhere.
            const auto& polygon = each.shape[random() % each.shape.size()];
            glm::dvec2 place = polygon[random() % polygon.size()];
            place += glm::dvec2(random() % 40, random() % 40) - 20.0;
            const int i = static_cast<int>(std::clamp(place.x, 0.0, 511.0));
            const int j = static_cast<int>(std::clamp(place.y, 0.0, 511.0));
            const double exact = signedDistance(each.shape, centreOf(i, j));
            const glm::dvec2 gradient(map.gradientX.at(i, j), map.gradientY.at(i, j));
            const glm::dvec2 nearest = centreOf(i, j) - exact * gradient;
            const bool isAtCorner =
                each.atCorners > 0.0 && cornerDistance(each.shape, nearest) < 4.0;
            double& error = worst[isAtCorner ? 1 : 0];
            error = std::max(error, std::abs(512.0 * map.distance.at(i, j) - exact));
        }
        return worst;
    };
    for (const Case& each : cases) {
        Plane coverage = exactCoverage(each.shape, 512, 512);
        for (float& value : coverage.texels)  // as an image of 8 bits has it
            value = std::nearbyint(value * 255.0f) / 255.0f;
        const auto [beside, at] = errors(each, coverage);
        EXPECT_LT(beside, each.besideCorners) << each.name;
        EXPECT_LE(at, each.atCorners) << each.name;
        // Without the grey texels a quarter does not hold.
        Plane hard = coverage;
        for (float& value : hard.texels)
            value = value >= 0.5f ? 1.0f : 0.0f;
        EXPECT_GT(errors(each, hard)[0], 0.25) << each.name;
    }
}

// Rows and columns of texels that are full or empty have their outline between them, corners too.
TEST(ShapeBaker, HardBitmaps) {
    Plane mask(24, 20);
    for (int j = 6; j < 13; ++j)
        for (int i = 4; i < 15; ++i)
            mask.at(i, j) = 1.0f;
    const Polygons box{{{4.0, 6.0}, {15.0, 6.0}, {15.0, 13.0}, {4.0, 13.0}}};
    for (const WrapMode wrap : kWraps) {
        const ShapeMap map = bakeShape(bitmapSource(mask), planOf(wrap));
        for (int j = 0; j < 20; ++j)
            for (int i = 0; i < 24; ++i)
                ASSERT_NEAR(24.0 * map.distance.at(i, j),
                            wrappedDistance(box, centreOf(i, j), {24, 20}, wrap), 1e-4);
    }
}

// A repeated or mirrored tile is a part of a plane: that of nine tiles, all written out.
TEST(ShapeBaker, WrappedBitmapsAreCropsOfTheirMosaic) {
    const int width = 40;
    const int height = 28;
    for (unsigned seed = 0; seed < 4; ++seed)
        for (const WrapMode wrap : {WrapMode::Repeat, WrapMode::Mirror}) {
            const Plane tile = blobs(width, height, seed);
            Plane mosaic(3 * width, 3 * height);
            for (int j = 0; j < 3 * height; ++j)
                for (int i = 0; i < 3 * width; ++i)
                    mosaic.at(i, j) = tile.at(textures::wrapIndex(i - width, width, wrap),
                                              textures::wrapIndex(j - height, height, wrap));
            const ShapeMap map = bakeShape(bitmapSource(tile), planOf(wrap));
            const ShapeMap whole = bakeShape(bitmapSource(mosaic), planOf(WrapMode::Clamp));
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i) {
                    // Simplified from other starts: a hundredth of a texel on either side.
                    ASSERT_NEAR(map.distance.at(i, j) * width,
                                3.0 * whole.distance.at(i + width, j + height) * width, 0.021)
                        << seed << " " << textures::wrapModeName(wrap) << " " << i << " " << j;
                }
        }
}

// What is cut off by the border of a clamped tile goes straight on to it.
TEST(ShapeBaker, OutlinesThatLeaveAClampedTile) {
    const Polygons square = squareOf({20.3, 29.1}, 12.0, 0.4);
    const ShapeMap map =
        bakeShape(bitmapSource(exactCoverage(square, 40, 32)), planOf(WrapMode::Clamp));
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 40; ++i) {
            const double exact = signedDistance(square, centreOf(i, j));
            if (std::abs(exact) < 32.0 - centreOf(i, j).y) {  // to what is left of the square
                EXPECT_NEAR(40.0 * map.distance.at(i, j), exact, 0.1) << i << " " << j;
            }
        }
}

// Coverage of exactly a half puts several points of an outline into one texel centre, and outlines
// leave the tile from there. None of them is lost: distances of neighbours differ by the texel
// between them, and by less than another one where corners are put back.
TEST(ShapeBaker, OutlinesThroughTexelCentresOfAClampedTile) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Plane coverage = blobs(41, 23, seed);
        for (float& value : coverage.texels)
            value = std::nearbyint(2.0f * value) / 2.0f;
        const ShapeMap map = bakeShape(bitmapSource(coverage), planOf(WrapMode::Clamp));
        for (int j = 0; j < 23; ++j)
            for (int i = 0; i + 1 < 41; ++i)
                ASSERT_NEAR(41.0 * map.distance.at(i, j), 41.0 * map.distance.at(i + 1, j), 2.0)
                    << seed << " " << i << " " << j;
    }
}

TEST(ShapeBaker, UnsignedDistancesAreThoseOfTheTransform) {
    const Polygons star = starOf({30.3, 20.1}, 6.0, 16.0, 5, 0.3);
    for (const WrapMode wrap : kWraps) {
        ShapePlan plan = planOf(wrap);
        plan.isSigned = false;
        const ShapeSource source = vectorSource(star, 61, 43);
        const ShapeMap map = bakeShape(source, plan);
        const std::vector<std::uint8_t> mask =
            insideMask(shapeOf(drawingOf(star, 61, 43), 61, 43, wrap), 61, 43);
        const SquaredDistances squares = distancesTo(mask, 61, 43, wrap);
        for (std::size_t t = 0; t < mask.size(); ++t) {
            const double exact = std::sqrt(static_cast<double>(squares.texels[t])) / 61;
            EXPECT_LE(map.distance.texels[t], exact);
            EXPECT_GE(map.distance.texels[t], exact - map.slack);
            EXPECT_EQ(map.shape.texels[t] >= 0.5f, mask[t] != 0);
        }
        EXPECT_FALSE(map.isSigned);
        EXPECT_LT(map.slack, 1e-7);
    }
}

TEST(ShapeBaker, GradientsPointOutwardsEverywhereAndOnTheOutline) {
    // Its sides run through texel centres.
    const Polygons box{{{8.5, 8.5}, {24.5, 8.5}, {24.5, 20.5}, {8.5, 20.5}}};
    for (const bool isWhiteInside : {false, true}) {
        ShapePlan plan = planOf(WrapMode::Clamp);
        plan.isWhiteInside = isWhiteInside;
        const ShapeMap map = bakeShape(vectorSource(box, 32, 32), plan);
        const double sign = isWhiteInside ? -1.0 : 1.0;
        for (int j = 0; j < 32; ++j)
            for (int i = 0; i < 32; ++i) {
                const glm::dvec2 gradient(map.gradientX.at(i, j), map.gradientY.at(i, j));
                ASSERT_NEAR(glm::length(gradient), 1.0, 1e-6) << i << " " << j;
                if (j > 12 && j < 16 && i < 12) {
                    EXPECT_NEAR(gradient.x, -sign, 1e-6) << i << " " << j;
                }
                if (j > 18 && i > 14 && i < 18) {
                    EXPECT_NEAR(gradient.y, sign, 1e-6) << i << " " << j;
                }
            }
        EXPECT_EQ(map.distance.at(8, 14), 0.0f);
        EXPECT_EQ(map.distance.at(2, 14) < 0.0f, isWhiteInside);
    }
}

TEST(ShapeBaker, PrewittGradientsComeCloseToExactOnes) {
    const Polygons disc = discOf({64.2, 63.7}, 30.0);
    for (const int size : {3, 5, 7, 9})
        for (const WrapMode wrap : kWraps) {
            ShapePlan plan = planOf(wrap);
            plan.gradient = size;
            const ShapeMap map = bakeShape(vectorSource(disc, 128, 128), plan);
            for (int j = 34; j < 94; ++j)
                for (int i = 90; i < 100; ++i) {
                    const glm::dvec2 away = glm::normalize(centreOf(i, j) - glm::dvec2(64.2, 63.7));
                    const glm::dvec2 gradient(map.gradientX.at(i, j), map.gradientY.at(i, j));
                    EXPECT_NEAR(glm::length(gradient), 1.0, 1e-6);
                    EXPECT_GT(glm::dot(away, gradient), 0.99);
                }
        }
    // Level distances have no direction: none is made up.
    ShapePlan plan = planOf(WrapMode::Clamp);
    plan.gradient = 9;
    plan.isSigned = false;
    const ShapeMap map = bakeShape(vectorSource(disc, 128, 128), plan);
    EXPECT_EQ(map.gradientX.at(64, 64), 0.0f);
    EXPECT_EQ(map.gradientY.at(64, 64), 0.0f);
}

TEST(ShapeBaker, EmptyFullAndOneTexel) {
    const double far = 4.0 * std::hypot(1.0, 20.0 / 24.0);
    for (const WrapMode wrap : kWraps)
        for (const bool isSigned : {true, false}) {
            ShapePlan plan = planOf(wrap);
            plan.isSigned = isSigned;
            const ShapeMap empty = bakeShape(bitmapSource(Plane(24, 20, 0.0f)), plan);
            EXPECT_NEAR(empty.distance.at(3, 4), far, 1e-6);
            EXPECT_EQ(empty.gradientX.at(3, 4), 0.0f);
            const ShapeMap none = bakeShape(vectorSource({}, 24, 20), plan);
            EXPECT_EQ(none.distance.texels, empty.distance.texels);
            const ShapeMap full = bakeShape(bitmapSource(Plane(24, 20, 1.0f)), plan);
            EXPECT_NEAR(full.distance.at(3, 4), isSigned ? -far : 0.0, 1e-6);
            EXPECT_EQ(full.shape.at(3, 4), 1.0f);
            Plane mask(24, 20);
            mask.at(7, 5) = 1.0f;
            const ShapeMap one = bakeShape(bitmapSource(mask), plan);
            EXPECT_EQ(one.distance.at(7, 5) < 0.0f, isSigned);
            EXPECT_NEAR(24.0 * one.distance.at(7, 5), isSigned ? -0.36 : 0.0, 0.15);
            EXPECT_NEAR(24.0 * one.distance.at(10, 5), isSigned ? 2.5 : 3.0, 1e-4);
            for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {2, 2}}) {
                const ShapeMap small = bakeShape(bitmapSource(blobs(width, height, 3)), plan);
                EXPECT_TRUE(std::ranges::all_of(small.distance.texels,
                                                [](float d) { return std::isfinite(d); }));
            }
        }
}

// What a search is promised, and that the check sees it broken.
TEST(ShapeBaker, NoStepEntersTheSolid) {
    const Polygons star = starOf({30.3, 20.1}, 6.0, 16.0, 5, 0.3);
    reference::ShapeCheckOptions options;
    options.rays = 10000;
    for (const WrapMode wrap : kWraps)
        for (const StorageFormat format : kFormats)
            for (const auto& [isSigned, hasSharpCorners] :
                 {std::pair{true, true}, {true, false}, {false, false}}) {
                ShapePlan plan = planOf(wrap, format);
                plan.isSigned = isSigned;
                plan.hasSharpCorners = hasSharpCorners;
                const std::array sources{vectorSource(star, 61, 43),
                                         bitmapSource(exactCoverage(star, 61, 43)),
                                         bitmapSource(blobs(61, 43, 2))};
                for (const ShapeSource& source : sources) {
                    ShapeMap map = bakeShape(source, plan);
                    const reference::ShapeReport report = reference::checkShape(map, options);
                    EXPECT_EQ(report.violations, 0u);
                    EXPECT_EQ(report.contradictions, 0u);
                    for (float& distance : map.distance.texels)
                        distance *= 1.1f;
                    for (float& step : map.creases.step.texels)
                        step *= 1.1f;
                    EXPECT_GT(reference::checkShape(map, options).violations, 0u);
                }
            }
}

// Some texels of the four-point method are too far, by a few hundredths: one of thousands.
TEST(ShapeBaker, OverestimatesOfSequentialDistancesAreFound) {
    constexpr int kSize = 64;
    const auto violationsOf = [](const SquaredDistances& squares) {
        ShapeMap map;
        map.distance = Plane(kSize, kSize);
        map.shape = Plane(kSize, kSize);
        for (std::size_t t = 0; t < squares.texels.size(); ++t) {
            map.distance.texels[t] =
                static_cast<float>(std::sqrt(static_cast<double>(squares.texels[t])) / kSize);
            map.shape.texels[t] = squares.texels[t] == 0 ? 1.0f : 0.0f;
        }
        map.wrap = WrapMode::Clamp;
        map.isSigned = false;
        map.slack = 1e-7;
        prewittGradient(map.distance, map.wrap, 5, map.gradientX, map.gradientY);
        reference::ShapeCheckOptions options;
        options.rays = 200000;
        return reference::checkShape(map, options).violations;
    };
    std::uint64_t found = 0;
    int wrongMaps = 0;
    for (unsigned seed = 1; wrongMaps < 4; ++seed) {
        const std::vector<std::uint8_t> mask = randomSet(kSize, kSize, 100, seed);
        const SquaredDistances wrong = sequentialDistances(mask, kSize, kSize, WrapMode::Clamp);
        const SquaredDistances right = distancesTo(mask, kSize, kSize, WrapMode::Clamp);
        if (compareDistances(wrong, right).tooLarge == 0)
            continue;
        ++wrongMaps;
        found += violationsOf(wrong);
        EXPECT_EQ(violationsOf(right), 0u);
    }
    EXPECT_GT(found, 0u);
}

TEST(ShapeBaker, FilesBringBackWhatWasBaked) {
    const Polygons star = starOf({30.3, 20.1}, 6.0, 16.0, 5, 0.3);
    for (const StorageFormat format : kFormats)
        for (const bool isSigned : {true, false}) {
            ShapePlan plan = planOf(WrapMode::Mirror, format);
            plan.isSigned = isSigned;
            plan.hasSharpCorners = true;
            const ShapeMap map = bakeShape(vectorSource(star, 61, 43), plan);
            EXPECT_EQ(map.isCreased(), plan.hasCreases());
            const textures::MapSet maps = shapeFileOf(map, plan, "hash");
            EXPECT_EQ(maps.attributes.at("relievo:gradient"), "exact");
            EXPECT_NEAR(std::stod(maps.attributes.at("relievo:tau")) *
                            std::abs(*std::ranges::max_element(
                                map.distance.texels, {}, [](float d) { return std::abs(d); })),
                        1.0, 1e-6);
            const ShapeMap again = textures::shapeMapOf(maps);
            // The file's own rounding changes no distance any more.
            EXPECT_EQ(textures::storedValues(again.distance, "distance", format).texels,
                      map.distance.texels);
            if (map.isCreased()) {
                EXPECT_EQ(textures::storedValues(again.creases.code, "crease", format).texels,
                          map.creases.code.texels);
                EXPECT_EQ(textures::storedValues(again.creases.step, "step", format).texels,
                          map.creases.step.texels);
            }
            EXPECT_EQ(again.slack, map.slack);
            EXPECT_EQ(again.isSigned, isSigned);
        }
}

TEST(ShapeBaker, DoesNotDependOnThreads) {
    const ShapeSource source = bitmapSource(blobs(123, 77, 1));
    ShapePlan plan = planOf(WrapMode::Repeat);
    plan.hasSharpCorners = true;
    const auto bake = [&] { return bakeShape(source, plan); };
    const ShapeMap all = bake();
    const ShapeMap one = onThreads(1, bake);
    EXPECT_EQ(all.distance.texels, one.distance.texels);
    EXPECT_EQ(all.gradientX.texels, one.gradientX.texels);
    EXPECT_EQ(all.shape.texels, one.shape.texels);
    EXPECT_EQ(all.slack, one.slack);
}

TEST(ShapeBaker, ShapesAreUnited) {
    outlines::Drawing drawing = drawingOf(squareOf({12.0, 12.0}, 6.0, 0.0), 32, 32);
    drawing.shapes.push_back(drawingOf(squareOf({18.0, 12.0}, 6.0, 0.0), 32, 32).shapes.front());
    const ShapeMap map = bakeShape({drawing, 32, 32, ""}, planOf(WrapMode::Clamp));
    const Polygons both{{{6.0, 6.0}, {24.0, 6.0}, {24.0, 18.0}, {6.0, 18.0}}};
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
            ASSERT_NEAR(32.0 * map.distance.at(i, j), signedDistance(both, centreOf(i, j)), 1e-4);
}

TEST(ShapeBaker, RefusesPlacesThatMakeNoSense) {
    for (const double place : {1e12, HUGE_VAL, std::nan("")}) {
        const Polygons odd{{{1.0, 1.0}, {place, 2.0}, {3.0, 7.0}}};
        EXPECT_THROW(bakeShape(vectorSource(odd, 16, 16), {}), textures::InputError);
    }
}

}  // namespace
}  // namespace relievo::preprocess
