#include "small_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

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

double plainDistance(const Solid& solid, const glm::dvec3& place) {
    const ShapeMap& map = *solid.shape;
    if (solid.kind == SolidKind::Extrusion)
        return textures::sampleBilinear(map.distance, place.x, place.y, map.wrap);
    const glm::dvec3 tile(std::floor(place.x), std::floor(place.y), std::floor(place.z));
    const glm::dvec3 within = place - tile;
    const bool isOdd = std::llround(tile.z) % 2 != 0;
    const double z = map.wrap == WrapMode::Mirror && isOdd ? 1.0 - within.z : within.z;
    return textures::sampleBilinear(map.distance, glm::distance(glm::dvec2(within), solid.axis), z,
                                    WrapMode::Clamp);
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
