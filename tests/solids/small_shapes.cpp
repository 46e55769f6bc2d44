#include "small_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "preprocess/shape_baker.h"
#include "textures/bilinear.h"

namespace relievo::solids {
namespace {

using textures::ShapeMap;
using textures::WrapMode;

// Tiles whose copies can be nearest to a place in the tile.
int copiesAround(WrapMode wrap) {
    return wrap == WrapMode::Clamp ? 0 : 2;
}

double copyOf(double x, int tile, double size, WrapMode wrap) {
    const bool isMirrored = wrap == WrapMode::Mirror && tile % 2 != 0;
    return tile * size + (isMirrored ? size - x : x);
}

}  // namespace

std::shared_ptr<const ShapeMap> shapeOf(int width, int height, WrapMode wrap,
                                        const std::function<double(const glm::dvec2&)>& distance) {
    auto shape = std::make_shared<ShapeMap>();
    shape->wrap = wrap;
    shape->distance = textures::Plane(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            shape->distance.at(i, j) =
                static_cast<float>(distance((glm::dvec2(i, j) + 0.5) / double(width)));
    return shape;
}

std::shared_ptr<const ShapeMap> discShape(int width, int height, WrapMode wrap,
                                          const std::vector<Disc>& discs) {
    const double aspect = static_cast<double>(height) / width;
    return shapeOf(width, height, wrap, [&](const glm::dvec2& place) {
        double nearest = std::numeric_limits<double>::max();
        const int copies = copiesAround(wrap);
        for (const Disc& disc : discs)
            for (int y = -copies; y <= copies; ++y)
                for (int x = -copies; x <= copies; ++x) {
                    const glm::dvec2 centre(copyOf(disc.centre.x, x, 1.0, wrap),
                                            copyOf(disc.centre.y, y, aspect, wrap));
                    nearest = std::min(nearest, glm::distance(place, centre) - disc.radius);
                }
        return nearest;
    });
}

std::shared_ptr<const ShapeMap> randomDiscs(int width, int height, WrapMode wrap,
                                            std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double aspect = static_cast<double>(height) / width;
    std::vector<Disc> discs;
    for (int k = 0; k < 3; ++k)
        discs.push_back({{unit(random), aspect * unit(random)},
                         (0.02 + 0.2 * unit(random)) * std::min(1.0, aspect)});
    return discShape(width, height, wrap, discs);
}

std::shared_ptr<const ShapeMap> randomTexels(int width, int height, WrapMode wrap,
                                             std::mt19937_64& random) {
    std::uniform_real_distribution<double> value(-0.5, 0.5);
    return shapeOf(width, height, wrap, [&](const glm::dvec2&) { return value(random); });
}

SolidPart extrusion(std::shared_ptr<const textures::ShapeMap> shape, Profile profile) {
    SolidPart part;
    part.solid = {std::move(shape), SolidKind::Extrusion, std::move(profile), 0.0, glm::dvec2(0.5)};
    return part;
}

SolidPart revolution(std::shared_ptr<const textures::ShapeMap> shape, double extension,
                     glm::dvec2 axis) {
    SolidPart part;
    part.solid = {std::move(shape), SolidKind::Revolution, makeProfile(0.0), extension, axis};
    return part;
}

std::shared_ptr<const ShapeMap> randomStar(int width, int height, WrapMode wrap,
                                           std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const double aspect = static_cast<double>(height) / width;
    const glm::dvec2 centre(unit(random), aspect * unit(random));
    const double radius = (0.3 + 0.2 * unit(random)) * std::min(1.0, aspect);
    const double turn = 6.3 * unit(random);
    outlines::Contour contour;
    for (int k = 0; k < 10; ++k) {
        const double angle = turn + std::numbers::pi * k / 5.0;
        contour.push_back(centre + (k % 2 == 0 ? radius : 0.45 * radius) *
                                       glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    preprocess::ShapeSource source;
    source.content = outlines::Drawing{{{{contour}, outlines::FillRule::NonZero}}, aspect};
    source.width = width;
    source.height = height;
    preprocess::ShapePlan plan;
    plan.wrap = wrap;
    return std::make_shared<ShapeMap>(preprocess::bakeShape(source, plan));
}

std::shared_ptr<const ShapeMap> randomCreases(int width, int height, WrapMode wrap,
                                              std::mt19937_64& random) {
    std::uniform_real_distribution<double> value(-0.5, 0.5);
    auto shape = std::make_shared<ShapeMap>(*randomTexels(width, height, wrap, random));
    shape->creases = {textures::Plane(width, height), textures::Plane(width, height)};
    const bool isReflex = value(random) < 0.0;
    for (std::size_t t = 0; t < shape->distance.texels.size(); ++t) {
        const auto code = static_cast<float>(value(random));
        shape->creases.code.texels[t] =
            isReflex
                ? code + std::copysign(static_cast<float>(textures::kReflexTexels / width), code)
                : code;
        shape->creases.step.texels[t] = textures::mostStep(*shape, t);
    }
    return shape;
}

namespace {

// The texels around a place, and how far it is between them.
struct Around {
    std::array<std::size_t, 4> texels;
    glm::dvec2 part;
};

Around around(const ShapeMap& map, double u, double v, WrapMode wrap) {
    const double x = u * map.width() - 0.5;
    const double y = v * map.height() - 0.5;
    Around result{{}, {x - std::floor(x), y - std::floor(y)}};
    for (int k = 0; k < 4; ++k)
        result.texels[static_cast<std::size_t>(k)] =
            map.distance.index(textures::wrapIndex(static_cast<std::int64_t>(std::floor(x)) + k % 2,
                                                   map.width(), wrap),
                               textures::wrapIndex(static_cast<std::int64_t>(std::floor(y)) + k / 2,
                                                   map.height(), wrap));
    return result;
}

// Of the two sides of the crease there, if there is one.
double creasedDistance(const ShapeMap& map, double u, double v, WrapMode wrap) {
    const Around here = around(map, u, v, wrap);
    bool isReflex = false;
    for (const std::size_t t : here.texels)
        isReflex = isReflex || map.isReflex(t);
    double a = 0.0;
    double b = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double weight = (k % 2 == 0 ? 1.0 - here.part.x : here.part.x) *
                              (k < 2 ? 1.0 - here.part.y : here.part.y);
        const double code = map.creases.code.texels[here.texels[k]];
        const double distance = map.distance.texels[here.texels[k]];
        const double over = std::max(
            0.0, std::abs(code) - (isReflex ? textures::kReflexTexels / map.width() : 0.0));
        const double other = isReflex ? distance + over : distance - over;
        a += weight * (code < 0.0 ? distance : other);
        b += weight * (code < 0.0 ? other : distance);
    }
    return isReflex ? std::min(a, b) : std::max(a, b);
}

double mapDistance(const ShapeMap& map, double u, double v, WrapMode wrap) {
    return map.isCreased() ? creasedDistance(map, u, v, wrap)
                           : textures::sampleBilinear(map.distance, u, v, wrap);
}

}  // namespace

double plainDistance(const Solid& solid, const glm::dvec3& place) {
    const ShapeMap& map = *solid.shape;
    if (solid.kind == SolidKind::Extrusion)
        return mapDistance(map, place.x, place.y, map.wrap);
    const glm::dvec3 tile(std::floor(place.x), std::floor(place.y), std::floor(place.z));
    const glm::dvec3 within = place - tile;
    const bool isOdd = std::llround(tile.z) % 2 != 0;
    const double z = map.wrap == WrapMode::Mirror && isOdd ? 1.0 - within.z : within.z;
    return mapDistance(map, glm::distance(glm::dvec2(within), solid.axis), z, WrapMode::Clamp);
}

double plainClearance(const Solid& solid, const glm::dvec3& place) {
    return plainDistance(solid, place) - (solid.kind == SolidKind::Extrusion
                                              ? offsetAt(solid.profile, place.z)
                                              : solid.extension);
}

bool plainInside(const SolidPart& part, const glm::dvec3& point) {
    const glm::dvec3 place(part.fromWhole * glm::dvec4(point, 1.0));
    for (int axis = 0; axis < 3; ++axis)
        if (place[axis] < part.windowMinimum[axis] || place[axis] > part.windowMaximum[axis])
            return false;
    return plainClearance(part.solid, place) <= 0.0;
}

bool plainInside(const Compound& compound, const glm::dvec3& point) {
    bool whole = false;
    for (const SolidPart& part : compound.parts) {
        const bool isInside = plainInside(part, point);
        if (part.operation == BooleanOperation::Union)
            whole = whole || isInside;
        else
            whole = whole && isInside == (part.operation == BooleanOperation::Intersection);
    }
    return whole;
}

std::vector<Profile> manyProfiles() {
    const std::array<glm::dvec2, 6> steps{
        {{0.1, 0.02}, {0.3, 0.1}, {0.3, -0.05}, {0.6, -0.05}, {0.6, 0.15}, {0.9, 0.0}}};
    return {makeProfile(0.0),
            makeProfile(0.05),
            makeProfile(-0.02),
            makeProfile(0.0, 0.3),
            makeProfile(0.1, -0.25),
            makeProfile(0.0, 0.1, 0.3),
            makeProfile(0.02, 0.15, 0.5, ProfileShape::Round),
            makeProfile(0.0, 0.2, 0.8, ProfileShape::Cove),
            makeProfile(0.0, 0.2, 1.0, ProfileShape::Ogee),
            profileThrough(steps)};
}

}  // namespace relievo::solids
