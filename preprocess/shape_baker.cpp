#include "preprocess/shape_baker.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "preprocess/boundary_distance.h"
#include "preprocess/coverage_boundary.h"
#include "preprocess/distance_transform.h"
#include "preprocess/inside_mask.h"
#include "preprocess/oriented_distances.h"
#include "preprocess/outline_creases.h"
#include "preprocess/plane_shape.h"
#include "preprocess/prewitt_gradient.h"
#include "textures/version.h"

namespace relievo::preprocess {
namespace {

using textures::Plane;
using textures::ShapeMap;

// Segments are measured in pieces of so many texels: the nearest is chosen in floats, which are off
// by what they are of the distance to the ends of a piece.
constexpr double kLongestPiece = 64.0;

constexpr std::size_t kTexelsAtOnce = 1 << 16;

// A shape on the texels of its map.
struct Sampled {
    int width;
    int height;
    std::vector<BoundarySegment> boundary;  // the inside to the right
    std::vector<std::uint8_t> inside;       // centres of texels
    const Plane* coverage;                  // of a bitmap
};

Sampled sample(const outlines::Drawing& drawing, const ShapeSource& source, const ShapePlan& plan) {
    PlaneShape shape = shapeOf(drawing, source.width, source.height, plan.wrap);
    Sampled sampled{source.width, source.height, std::move(shape.boundary),
                    insideMask(shape, source.width, source.height), nullptr};
    if (plan.isWhiteInside) {
        for (BoundarySegment& segment : sampled.boundary)
            std::swap(segment.start, segment.end);
        for (std::uint8_t& texel : sampled.inside)
            texel = static_cast<std::uint8_t>(1 - texel);
    }
    return sampled;
}

Sampled sample(const Plane& coverage, const ShapeSource& source, const ShapePlan& plan) {
    CoverageBoundary found = coverageBoundary(coverage, plan.wrap);
    return {source.width, source.height, std::move(found.segments), std::move(found.inside),
            &coverage};
}

// The greatest result of work(range of texels, greatest so far).
template <typename Work>
double greatestOver(const Plane& plane, const Work& work) {
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, plane.texels.size(), kTexelsAtOnce), 0.0, work,
        [](double a, double b) { return std::max(a, b); });
}

// makeDistancesSure for a whole map.
double makeSure(Plane& distance) {
    const auto work = [&](const tbb::blocked_range<std::size_t>& texels, double most) {
        const auto part = std::span(distance.texels).subspan(texels.begin(), texels.size());
        return std::max(most, makeDistancesSure(part, distance.width, kLongestPiece));
    };
    return greatestOver(distance, work);
}

// A step that nothing lowers, until the distance is sure: it is that.
constexpr float kNotLowered = std::numeric_limits<float>::infinity();

// The same for creases in texels, under distances that are sure already: steps are lowered.
double makeCreasesSure(ShapeMap& map) {
    const int width = map.width();
    const auto work = [&](const tbb::blocked_range<std::size_t>& texels, double most) {
        for (std::size_t t = texels.begin(); t < texels.end(); ++t) {
            map.creases.code.texels[t] /= static_cast<float>(width);
            float& step = map.creases.step.texels[t];
            if (step == kNotLowered) {
                step = map.distance.texels[t];
                continue;
            }
            const double measured = step;
            const double off = kMeasuredRelativeError * (std::abs(measured) + kLongestPiece) +
                               kMeasuredAbsoluteError;
            step = std::min(static_cast<float>((measured - 3.0 * off) / width), mostStep(map, t));
            most = std::max(most, (measured + off) / width - static_cast<double>(step));
        }
        return most;
    };
    return greatestOver(map.creases.step, work);
}

// Rounds a channel to the format. Returns the most that it changes.
double roundToFormat(Plane& plane, const char* channel, textures::StorageFormat format) {
    const std::vector<float> before = plane.texels;
    textures::storeInPlace(plane, channel, format);
    double most = 0.0;
    for (std::size_t t = 0; t < before.size(); ++t)
        most = std::max(most, std::abs(static_cast<double>(before[t]) - plane.texels[t]));
    return most;
}

// Rounds distances and creases to the format, with steps still under both.
void roundToFormat(ShapeMap& map, textures::StorageFormat format) {
    if (format == textures::StorageFormat::Float)
        return;
    const double distances = roundToFormat(map.distance, "distance", format);
    if (!map.isCreased()) {
        map.slack += distances;
        return;
    }
    roundToFormat(map.creases.code, "crease", format);
    const std::vector<float> before = map.creases.step.texels;
    for (std::size_t t = 0; t < before.size(); ++t)
        map.creases.step.texels[t] = std::min(before[t], mostStep(map, t));
    textures::storeInPlace(map.creases.step, "step", format);
    double steps = 0.0;
    for (std::size_t t = 0; t < before.size(); ++t)
        steps = std::max(steps, static_cast<double>(before[t]) - map.creases.step.texels[t]);
    map.slack += steps;
}

double unlimited(const Sampled& shape) {
    return kUnlimitedDiagonals * std::hypot(1.0, static_cast<double>(shape.height) / shape.width);
}

// Without an outline.
ShapeMap levelMap(const Sampled& shape, const ShapePlan& plan) {
    const bool isInside = shape.inside.front() != 0;
    const auto far = static_cast<float>(unlimited(shape));
    const float distance = !isInside ? far : (plan.isSigned ? -far : 0.0f);
    return {Plane(shape.width, shape.height, distance), Plane(shape.width, shape.height),
            Plane(shape.width, shape.height),
            Plane(shape.width, shape.height, isInside ? 1.0f : 0.0f)};
}

void setUnsigned(const Sampled& shape, const ShapePlan& plan, ShapeMap& map) {
    const SquaredDistances squares =
        distancesTo(shape.inside, shape.width, shape.height, plan.wrap);
    map.distance = Plane(shape.width, shape.height);
    if (std::ranges::find(shape.inside, 1) == shape.inside.end()) {
        std::ranges::fill(map.distance.texels, static_cast<float>(unlimited(shape)));
        return;
    }
    const auto work = [&](const tbb::blocked_range<std::size_t>& range, double most) {
        for (std::size_t t = range.begin(); t < range.end(); ++t) {
            const double texels = std::sqrt(static_cast<double>(squares.texels[t]));
            const float stored = towardsZero(texels, shape.width);
            map.distance.texels[t] = stored;
            most = std::max(most, texels / shape.width - static_cast<double>(stored));
        }
        return most;
    };
    map.slack = greatestOver(map.distance, work);
}

// How much of a texel is inside a straight outline at `distance` (texels, > 0 outside) from its
// centre, with this unit normal.
float halfPlaneCoverage(float distance, float normalX, float normalY) {
    const float long_ = std::max(std::abs(normalX), std::abs(normalY));
    const float short_ = std::min(std::abs(normalX), std::abs(normalY));
    const float reach = 0.5f * (long_ + short_);
    const float within = std::abs(distance);
    float outside = 0.0f;  // of the half of the texel that the centre is in
    if (within < 0.5f * (long_ - short_))
        outside = 0.5f - within / long_;
    else if (within < reach)
        outside = (reach - within) * (reach - within) / (2.0f * long_ * short_);
    return distance > 0.0f ? outside : 1.0f - outside;
}

// Coverage of some rows, where distances are still those to the outline.
void cover(const Sampled& shape, const BoundaryDistances& distances, std::size_t first,
           std::span<float> covered) {
    if (shape.coverage != nullptr) {
        std::ranges::copy(std::span(shape.coverage->texels).subspan(first, covered.size()),
                          covered.begin());
        return;
    }
    for (std::size_t k = 0; k < covered.size(); ++k) {
        const std::size_t t = first + k;
        const float distance = distances.distance.texels[t];
        covered[k] = halfPlaneCoverage(shape.inside[t] != 0 ? -distance : distance,
                                       distances.awayX.texels[t], distances.awayY.texels[t]);
    }
}

// Sharpens the corners of distances in texels.
void crease(const Sampled& shape, const ShapePlan& plan, ShapeMap& map) {
    CreasedDistances found =
        creaseCorners(shape.boundary, std::move(map.distance), plan.wrap,
                      shape.coverage != nullptr ? kCornerOfBitmap : kCornerOfDrawing);
    map.distance = std::move(found.distance);
    if (found.sharpCorners == 0)
        return;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, found.step.texels.size(), kTexelsAtOnce),
        [&](const tbb::blocked_range<std::size_t>& texels) {
            for (std::size_t t = texels.begin(); t < texels.end(); ++t)
                if (found.step.texels[t] == map.distance.texels[t] && found.code.texels[t] == 0.0f)
                    found.step.texels[t] = kNotLowered;
        });
    map.creases = {std::move(found.code), std::move(found.step)};
}

Plane binaryShape(const Sampled& shape) {
    Plane result(shape.width, shape.height);
    std::ranges::copy(shape.inside, result.texels.begin());
    return result;
}

std::vector<BoundarySegment> inPieces(const std::vector<BoundarySegment>& segments) {
    std::vector<BoundarySegment> pieces;
    pieces.reserve(segments.size());
    for (const auto& [start, end] : segments) {
        const int count =
            1 + static_cast<int>(std::floor(glm::distance(start, end) / kLongestPiece));
        glm::dvec2 last = start;
        for (int k = 1; k < count; ++k) {
            const glm::dvec2 next = glm::mix(start, end, static_cast<double>(k) / count);
            pieces.push_back({last, next});
            last = next;
        }
        pieces.push_back({last, end});
    }
    return pieces;
}

ShapeMap measureOutline(const Sampled& shape, const ShapePlan& plan,
                        const std::function<void(std::size_t)>& advance) {
    ShapeMap map;
    BoundaryTree tree;
    tbb::parallel_invoke([&] { tree = buildBoundaryTree(inPieces(shape.boundary)); },
                         [&] { map.shape = Plane(shape.width, shape.height); });
    std::vector<double> farther(static_cast<std::size_t>(shape.height), 0.0);  // of rows
    // While rows are in the caches.
    const auto finish = [&](BoundaryDistances& distances, int first, int end) {
        const auto start = distances.distance.index(0, first);
        const auto count =
            static_cast<std::size_t>(end - first) * static_cast<std::size_t>(shape.width);
        const auto rowsOf = [&](auto& values) { return std::span(values).subspan(start, count); };
        const OrientedTexels texels{rowsOf(shape.inside), rowsOf(distances.distance.texels),
                                    rowsOf(distances.awayX.texels), rowsOf(distances.awayY.texels),
                                    rowsOf(map.shape.texels)};
        cover(shape, distances, start, texels.shape);
        orientTexels(texels);
        if (plan.isSigned && !plan.hasCreases())
            farther[static_cast<std::size_t>(first)] =
                makeDistancesSure(texels.distance, shape.width, kLongestPiece);
        if (advance)
            advance(count);
    };
    BoundaryDistances found = measureBoundaryDistances(tree, shape.width, shape.height, finish);
    map.distance = std::move(found.distance);
    map.gradientX = std::move(found.awayX);
    map.gradientY = std::move(found.awayY);
    if (!plan.isSigned) {
        setUnsigned(shape, plan, map);
    } else if (plan.hasCreases()) {  // of distances that are not rounded yet
        crease(shape, plan, map);
        map.slack = makeSure(map.distance);
        if (map.isCreased())
            map.slack += makeCreasesSure(map);
    } else {
        map.slack = std::ranges::max(farther);
    }
    return map;
}

ShapeMap measure(const Sampled& shape, const ShapePlan& plan,
                 const std::function<void(std::size_t)>& advance) {
    if (shape.boundary.empty())
        return levelMap(shape, plan);
    if (!plan.isSigned && plan.gradient != 0) {  // the form of the thesis has no outline
        ShapeMap map;
        map.shape = binaryShape(shape);
        setUnsigned(shape, plan, map);
        if (advance)
            advance(map.shape.texels.size());
        return map;
    }
    return measureOutline(shape, plan, advance);
}

std::string gradientName(const ShapePlan& plan) {
    return plan.gradient == 0 ? "exact" : fmt::format("{}", plan.gradient);
}

}  // namespace

ShapeMap bakeShape(const ShapeSource& source, const ShapePlan& plan,
                   const std::function<void(std::size_t)>& advance) {
    const Sampled shape = std::visit(
        [&](const auto& content) { return sample(content, source, plan); }, source.content);
    ShapeMap map = measure(shape, plan, advance);
    map.wrap = plan.wrap;
    map.isSigned = plan.isSigned;
    roundToFormat(map, plan.format);
    if (plan.gradient != 0)
        prewittGradient(map.distance, map.wrap, plan.gradient, map.gradientX, map.gradientY);
    return map;
}

ShapeMap bakeShapeFile(const std::string& name, const ShapePlan& plan) {
    return bakeShape(readShapeSource(name, plan), plan);
}

std::string optionWords(const ShapePlan& plan) {
    return fmt::format("shape inside={} gradient={} signed={:d} corners={} format={}",
                       plan.isWhiteInside ? "white" : "black", gradientName(plan), plan.isSigned,
                       plan.hasCreases() ? "sharp" : "round",
                       textures::storageFormatName(plan.format));
}

textures::MapSet shapeFileOf(const ShapeMap& shape, const ShapePlan& plan,
                             const std::string& source) {
    textures::MapSet maps = textures::mapSetOf(shape);
    maps.source = source;
    maps.version = textures::kVersion;
    maps.attributes["relievo:options"] = optionWords(plan);
    maps.attributes["relievo:gradient"] = gradientName(plan);
    float greatest = 0.0f;
    for (const float distance : shape.distance.texels)
        greatest = std::max(greatest, std::abs(distance));
    if (greatest > 0.0f)
        maps.attributes["relievo:tau"] = fmt::format("{}", 1.0 / static_cast<double>(greatest));
    return maps;
}

}  // namespace relievo::preprocess
