#include "solids/solid_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "reference/shape_cell.h"
#include "solids/part_walk.h"
#include "textures/input_error.h"

namespace relievo::solids {
namespace {

using reference::AxisWalk;
using textures::InputError;
using textures::WrapMode;

// The last row of an inverse that somebody has computed is 0, 0, 0, 1 up to a rounding.
bool isAffine(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(m[column][row]))
                return false;
        if (!(std::abs(m[column][3] - (column < 3 ? 0.0 : 1.0)) <= 1e-9))
            return false;
    }
    return true;
}

void checkPart(const SolidPart& part, std::size_t index) {
    const auto require = [&](bool holds, const char* what) {
        if (!holds)
            throw InputError(fmt::format("part {} of the solid {}", index, what));
    };
    const Solid& solid = part.solid;
    require(solid.shape != nullptr && solid.shape->width() > 0 && solid.shape->height() > 0,
            "has no shape map, expected one of at least one texel");
    require(std::ranges::all_of(solid.shape->distance.texels,
                                [](float d) { return std::isfinite(d); }) &&
                std::isfinite(solid.shape->slack),
            "has distances that are not finite, expected numbers");
    require(solid.kind == SolidKind::Revolution || !solid.profile.pieces.empty(),
            "has a profile without pieces, expected at least one");
    require(std::isfinite(solid.extension) && std::isfinite(solid.axis.x) &&
                std::isfinite(solid.axis.y),
            "has an extension or axis that is not finite, expected numbers");
    for (int axis = 0; axis < 3; ++axis)
        require(!std::isnan(part.windowMinimum[axis]) && !std::isnan(part.windowMaximum[axis]),
                "has a window with a bound that is not a number, expected bounds");
    require(isAffine(part.fromWhole),
            "has a placement that is not affine and finite, expected a last row of 0, 0, 0, 1");
}

// A place between texel centres of a map.
struct MapPlace {
    const textures::ShapeMap& map;
    AxisWalk column;
    AxisWalk row;

    [[nodiscard]] glm::dvec2 local() const { return {column.local(0.0), row.local(0.0)}; }
    [[nodiscard]] double distance() const {
        return reference::shapeCell(map, column.low(), column.high(), row.low(), row.high())
            .distance(local());
    }
    [[nodiscard]] double step() const {
        return reference::stepCell(map, column.low(), column.high(), row.low(), row.high())
            .depth(local());
    }
};

MapPlace placeInShape(const Solid& solid, const glm::dvec3& place) {
    const textures::ShapeMap& map = *solid.shape;
    return {map,
            {place.x * map.width() - 0.5, 0.0, map.width(), map.wrap},
            {place.y * map.height() - 0.5, 0.0, map.height(), map.wrap}};
}

MapPlace placeInSection(const Solid& solid, const glm::dvec3& tile, const glm::dvec3& place) {
    const textures::ShapeMap& map = *solid.shape;
    const glm::dvec2 radial = glm::dvec2(place - tile) - solid.axis;
    const bool isUpsideDown =
        solid.shape->wrap == WrapMode::Mirror && std::fmod(tile.z, 2.0) != 0.0;
    const double z = isUpsideDown ? 1.0 - (place.z - tile.z) : place.z - tile.z;
    return {map,
            {std::hypot(radial.x, radial.y) * map.width() - 0.5, 0.0, map.width(), WrapMode::Clamp},
            {z * map.height() - 0.5, 0.0, map.height(), WrapMode::Clamp}};
}

// The parts of a compound along a ray, from event to event.
class CompoundWalk {
  public:
    CompoundWalk(const SolidTracer& tracer, const SolidRay& ray, TraceCost* cost)
        : compound_(tracer.compound()), isInside_(tracer.compound().parts.size(), 0) {
        const double speed = glm::length(ray.direction);
        originReach_ = speed > 0.0 ? glm::length(ray.origin) / speed : 0.0;
        walks_.reserve(compound_.parts.size());
        for (std::size_t k = 0; k < compound_.parts.size(); ++k) {
            walks_.emplace_back(compound_.parts[k], tracer.freeSpace(k), ray, tracer.options(),
                                cost);
            next_.push_back(walks_.back().next());
        }
    }

    struct Event {
        SolidCrossing crossing;
        std::size_t part;
    };

    // The first crossing of a part after which the whole is solid, for longer than a rounding.
    std::optional<Event> findEntry() {
        std::optional<Event> entry;
        while (const std::optional<double> t = nextPlace()) {
            if (entry && *t - entry->crossing.t > sliver(entry->crossing.t))
                return entry;
            for (std::size_t k = 0; k < walks_.size(); ++k)
                while (next_[k] && next_[k]->t == *t) {
                    const bool wasSolid = entry.has_value();
                    isInside_[k] = next_[k]->enters ? 1 : 0;
                    if (!joined(compound_, isInside_))
                        entry.reset();
                    else if (!wasSolid)
                        entry = Event{*next_[k], k};
                    next_[k] = walks_[k].next();
                }
        }
        return entry;
    }

  private:
    // Faces of two parts that coincide are apart by a rounding if their matrices differ.
    [[nodiscard]] double sliver(double t) const { return 0x1p-44 * (originReach_ + t); }

    [[nodiscard]] std::optional<double> nextPlace() const {
        std::optional<double> nearest;
        for (const std::optional<SolidCrossing>& crossing : next_)
            if (crossing && (!nearest || crossing->t < *nearest))
                nearest = crossing->t;
        return nearest;
    }

    const Compound& compound_;
    double originReach_ = 0.0;  // in the parameter of the ray
    std::vector<PartWalk> walks_;
    std::vector<std::optional<SolidCrossing>> next_;
    std::vector<char> isInside_;
};

}  // namespace

bool joined(const Compound& compound, const std::vector<char>& isInside) noexcept {
    bool whole = false;
    for (std::size_t k = 0; k < compound.parts.size(); ++k) {
        const bool part = isInside[k] != 0;
        switch (compound.parts[k].operation) {
            case BooleanOperation::Union:
                whole = whole || part;
                break;
            case BooleanOperation::Intersection:
                whole = whole && part;
                break;
            case BooleanOperation::Difference:
                whole = whole && !part;
                break;
        }
    }
    return whole;
}

double sectionDistance(const Solid& solid, const glm::dvec3& tile, const glm::dvec3& place) {
    return placeInSection(solid, tile, place).distance();
}

double sectionStep(const Solid& solid, const glm::dvec3& tile, const glm::dvec3& place) {
    return placeInSection(solid, tile, place).step();
}

double distanceAt(const Solid& solid, const glm::dvec3& place) {
    if (solid.kind == SolidKind::Revolution)
        return sectionDistance(solid, glm::floor(place), place);
    return placeInShape(solid, place).distance();
}

double stepAt(const Solid& extrusion, const glm::dvec3& place) {
    return placeInShape(extrusion, place).step();
}

bool contains(const Solid& solid, const glm::dvec3& place) {
    if (solid.kind == SolidKind::Revolution)
        return distanceAt(solid, place) <= solid.extension;
    return place.z >= 0.0 && place.z <= 1.0 &&
           distanceAt(solid, place) <= offsetAt(solid.profile, place.z);
}

SolidTracer::SolidTracer(Compound compound, const TraceOptions& options)
    : compound_(std::move(compound)), options_(options) {
    for (std::size_t k = 0; k < compound_.parts.size(); ++k) {
        checkPart(compound_.parts[k], k);
        const Solid& solid = compound_.parts[k].solid;
        freeSpaces_.emplace_back(
            *solid.shape, solid.kind == SolidKind::Revolution ? WrapMode::Clamp : solid.shape->wrap,
            options.mapsAreDistances);
    }
}

std::optional<SolidHit> SolidTracer::firstHit(const SolidRay& ray, TraceCost* cost) const {
    CompoundWalk walk(*this, ray, cost);
    const auto entry = walk.findEntry();
    if (!entry)
        return std::nullopt;
    SolidHit hit;
    hit.t = entry->crossing.t;
    hit.position = ray.origin + hit.t * ray.direction;
    hit.part = entry->part;
    hit.place = glm::dvec3(compound_.parts[hit.part].fromWhole * glm::dvec4(hit.position, 1.0));
    hit.face = entry->crossing.face;
    hit.outward = entry->crossing.enters ? entry->crossing.outward : -entry->crossing.outward;
    hit.startsInside = hit.face == SolidFace::Origin;
    return hit;
}

std::vector<SolidCrossing> SolidTracer::crossings(std::size_t index, const SolidRay& ray,
                                                  std::size_t most, TraceCost* cost) const {
    std::vector<SolidCrossing> all;
    PartWalk walk(compound_.parts.at(index), freeSpaces_.at(index), ray, options_, cost);
    while (all.size() < most) {
        const std::optional<SolidCrossing> crossing = walk.next();
        if (!crossing)
            break;
        all.push_back(*crossing);
    }
    return all;
}

bool SolidTracer::contains(std::size_t index, const glm::dvec3& point) const {
    const SolidPart& part = compound_.parts.at(index);
    const glm::dvec3 place(part.fromWhole * glm::dvec4(point, 1.0));
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(place[axis]) < 0x1p51) || place[axis] < part.windowMinimum[axis] ||
            place[axis] > part.windowMaximum[axis])
            return false;
    if (part.solid.kind == SolidKind::Extrusion)
        return solids::contains(part.solid, place);
    glm::dvec3 tile = glm::floor(place);
    for (int axis = 0; axis < 3; ++axis)
        if (tile[axis] == part.windowMaximum[axis] && part.windowMinimum[axis] < tile[axis])
            tile[axis] -= 1.0;
    return sectionDistance(part.solid, tile, place) <= part.solid.extension;
}

bool SolidTracer::contains(const glm::dvec3& point) const {
    std::vector<char> isInside;
    for (std::size_t k = 0; k < compound_.parts.size(); ++k)
        isInside.push_back(contains(k, point) ? 1 : 0);
    return joined(compound_, isInside);
}

}  // namespace relievo::solids
