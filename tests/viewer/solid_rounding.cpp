#include "solid_rounding.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "reference/shape_cell.h"
#include "shaders/relievo/constants.h"

namespace relievo::viewer {
namespace {

using solids::BooleanOperation;
using solids::Compound;
using solids::Profile;
using solids::ProfilePiece;
using solids::Solid;
using solids::SolidKind;
using solids::SolidPart;
using solids::SolidRay;

// A search of revolutions takes what is nearer than this for the surface: kSolidTouch of
// shaders/relievo/solid/revolution.glsl, before and after a place where it goes on from.
constexpr double kTouch = 2.0 * 6e-5;

double absoluteSum(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// The largest sum of what a row of the linear part, and the shift, make of coordinates of 1.
double largestRow(const glm::dmat4& m) {
    double largest = 0.0;
    for (int row = 0; row < 3; ++row)
        largest =
            std::max(largest, std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]));
    return largest;
}

double largestShift(const glm::dmat4& m) {
    return std::max({std::abs(m[3].x), std::abs(m[3].y), std::abs(m[3].z)});
}

// Texels by which neighbours differ along an axis, at most: of the distance, and of both fields of
// a crease.
double steepestStep(const textures::ShapeMap& map) {
    double steepest = 0.0;
    for (int j = 0; j < map.height(); ++j)
        for (int i = 0; i < map.width(); ++i) {
            const reference::ShapeCell cell =
                reference::shapeCell(map, i, textures::wrapIndex(i + 1, map.width(), map.wrap), j,
                                     textures::wrapIndex(j + 1, map.height(), map.wrap));
            for (const reference::BilinearCell& field : {cell.a, cell.b})
                for (const glm::dvec2& corner : {glm::dvec2(0.0), glm::dvec2(1.0)}) {
                    const glm::dvec2 slope = glm::abs(field.gradient(corner));
                    steepest = std::max({steepest, slope.x, slope.y});
                }
        }
    return steepest * map.width();
}

double steepestSlope(const Profile& profile) {
    double steepest = 0.0;
    for (const ProfilePiece& piece : profile.pieces)
        steepest = std::max(steepest, std::abs(piece.slope()));
    return steepest;
}

double largestMagnitude(const Solid& solid) {
    double largest = std::abs(solid.extension);
    if (solid.kind == SolidKind::Extrusion)
        for (const ProfilePiece& piece : solid.profile.pieces)
            largest = std::max({largest, std::abs(piece.topOffset), std::abs(piece.bottomOffset)});
    return largest;
}

// What distances are off by in the texture of a map with creases, in tile widths: those around
// corners, which near the surface are up to `nearest`, by the marks in their last bits, and codes
// by rounding.
double creaseRounding(const textures::ShapeMap& map, double nearest) {
    return map.isCreased() ? 0x1p-16 * nearest + 0x1p-20 / map.width() : 0.0;
}

// What rounding may be off in a part, `length` being the sum of what a ray's origin and its way to
// the hit have of the three coordinates of the whole.
struct PartRounding {
    double place;   // tiles, along each axis of the part's tile space
    double offset;  // tile widths, of the distance less the offset
};

// A place of the whole comes into a part's space by three products and three sums, each of which
// rounds by 2⁻²⁴ of less than the sum of all magnitudes; its change to texels, or to the distance
// from an axis, the product of t and the speed, t itself and the sum of both round by as much: less
// than eight roundings, 2⁻²¹ of the sum, in all. Places count from two tiles away at most, and
// within their cell they round by as much of a texel.
//
// On the steepest slope of the bilinear distance, √2 times the largest difference of neighbours,
// that is as much distance as the ray may seem nearer or farther; on the steepest slope of the
// profile it is as much offset. Distances and offsets themselves, which near the surface are those
// of the profile and three texels at most, take eight roundings more.
PartRounding roundingOf(const SolidPart& part, double length) {
    const textures::ShapeMap& map = *part.solid.shape;
    const double texels = std::max(map.width(), map.height());
    const double magnitude =
        largestRow(part.fromWhole) * length + largestShift(part.fromWhole) + 2.0;
    const double place = 0x1p-21 * magnitude + 0x1p-22 / texels;
    // Along v a tile is as high as the aspect says.
    const double perTile = std::numbers::sqrt2 * steepestStep(map) * std::max(1.0, map.aspect());
    const double nearest = largestMagnitude(part.solid) + 3.0 / map.width();
    double offset = perTile * place + 0x1p-21 * nearest + creaseRounding(map, nearest);
    if (part.solid.kind == SolidKind::Extrusion)
        offset += 2.0 * steepestSlope(part.solid.profile) * place;
    else
        offset += kTouch / map.width();
    return {place, offset};
}

// Steps of the profile move so that the solid grows by `depth`, and all offsets by `offset`.
Profile moved(Profile profile, double offset, double depth) {
    for (std::size_t k = 0; k + 1 < profile.pieces.size(); ++k) {
        ProfilePiece& above = profile.pieces[k];
        ProfilePiece& below = profile.pieces[k + 1];
        const double rise = below.topOffset - above.bottomOffset;
        if (std::abs(rise) < 1e-9)
            continue;
        // Those around steps are level in the tests, or as good as that.
        const double shift = rise > 0.0 ? -depth : depth;
        above.bottom += shift;
        below.top += shift;
    }
    for (ProfilePiece& piece : profile.pieces) {
        piece.topOffset += offset;
        piece.bottomOffset += offset;
    }
    return profile;
}

// Stretched along z about the middle of its depths, which are those from 0 to 1 for every
// extrusion.
glm::dmat4 stretched(const glm::dmat4& fromWhole, double lengthening) {
    glm::dmat4 stretch(1.0);
    stretch[2][2] = 1.0 - lengthening;
    stretch[3][2] = 0.5 * lengthening;
    return stretch * fromWhole;
}

// sense 1: grown, −1: shrunk.
SolidPart moved(const SolidPart& part, double length, double sense) {
    const PartRounding rounding = roundingOf(part, length);
    const double place = sense * rounding.place;
    const double offset = sense * rounding.offset;
    SolidPart result = part;
    result.windowMinimum -= place;
    result.windowMaximum += place;
    if (part.solid.kind == SolidKind::Extrusion) {
        result.fromWhole = stretched(part.fromWhole, 2.0 * place);
        result.solid.profile = moved(part.solid.profile, offset, 2.0 * place);
    } else {
        result.solid.extension += offset;
    }
    return result;
}

// Of what is taken away a shrunk solid has more.
Compound moved(const Compound& compound, double length, double sense) {
    Compound result;
    for (const SolidPart& part : compound.parts)
        result.parts.push_back(
            moved(part, length, part.operation == BooleanOperation::Difference ? -sense : sense));
    return result;
}

// Rays end where the search ended them, and not before.
solids::TraceOptions traceOptions() {
    solids::TraceOptions options;
    options.maxDistance = 8.0 * RELIEVO_MAXIMUM_REACH;
    return options;
}

}  // namespace

SolidRay rayOf(const MeasuredPixel& pixel) {
    return {glm::dvec3(pixel.origin), glm::dvec3(pixel.direction), pixel.end};
}

SolidRounding::SolidRounding(const Compound& compound) : exact_(compound, traceOptions()) {}

const SolidRounding::Bounds& SolidRounding::boundsFor(const SolidRay& ray, double t) const {
    const double length = absoluteSum(ray.origin) + t * absoluteSum(ray.direction);
    const auto level = static_cast<std::size_t>(
        std::clamp(std::ceil(std::log2(std::max(length, 1.0))), 0.0, kLevels - 1.0));
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Bounds>& bounds = bounds_[level];
    if (!bounds) {
        const double most = std::exp2(static_cast<double>(level));
        bounds = std::make_unique<Bounds>(
            Bounds{solids::SolidTracer(moved(exact_.compound(), most, -1.0), traceOptions()),
                   solids::SolidTracer(moved(exact_.compound(), most, 1.0), traceOptions())});
    }
    return *bounds;
}

// A ray in the plane between two replicas, or along a border of the window, may be on either side
// of it: it is tried a rounding to both sides along the axes that it does not move along.
bool SolidRounding::isExplained(const MeasuredPixel& pixel, const SolidRay& ray,
                                double slack) const {
    if (isBetweenBounds(pixel, ray, slack))
        return true;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            if (ray.direction[axis] != 0.0)
                continue;
            SolidRay beside = ray;
            beside.origin[axis] += side * 0x1p-22 * (1.0 + std::abs(ray.origin[axis]));
            if (isBetweenBounds(pixel, beside, slack))
                return true;
        }
    return false;
}

bool SolidRounding::isBetweenBounds(const MeasuredPixel& pixel, const SolidRay& ray,
                                    double slack) const {
    const Bounds& bounds = boundsFor(ray, pixel.t);
    SolidRay before = ray;
    before.end = pixel.t - slack;
    if (bounds.shrunk.firstHit(before))
        return false;
    if (pixel.outcome == RELIEVO_OUTCOME_MISS)
        return true;
    SolidRay around = ray;
    const double begin = std::max(0.0, pixel.t - slack);
    around.origin += begin * ray.direction;
    around.end = pixel.t + slack - begin;
    return bounds.grown.firstHit(around).has_value();
}

SolidVerdict SolidRounding::judge(const MeasuredPixel& pixel) const {
    SolidVerdict verdict;
    if (pixel.outcome == RELIEVO_OUTCOME_EXHAUSTED)
        return verdict;
    const SolidRay ray = rayOf(pixel);
    const auto hit = exact_.firstHit(ray);
    const bool isHit = pixel.outcome == RELIEVO_OUTCOME_HIT;
    // t is a quotient of a difference, and a sum of two of them.
    const double t = pixel.t;
    const double slack = 0x1p-21 * t + std::numeric_limits<float>::min();
    if (isHit == hit.has_value()) {
        const double off = isHit ? std::abs(t - hit->t) : 0.0;
        const double width = isHit ? exact_.compound().parts[hit->part].solid.shape->width() : 1.0;
        verdict.isRight = off <= slack || isExplained(pixel, ray, slack);
        verdict.isTangent = off * glm::length(ray.direction) * width > 1.0;
        if (isHit && !verdict.isTangent)
            verdict.deviation = off * std::abs(glm::dot(hit->outward, ray.direction)) * width;
        return verdict;
    }
    verdict.isTangent = true;
    verdict.isRight = isExplained(pixel, ray, slack);
    return verdict;
}

}  // namespace relievo::viewer
