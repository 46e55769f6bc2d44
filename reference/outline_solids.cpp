#include "reference/outline_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace relievo::reference {
namespace {

glm::dvec2 horizontal(const glm::dvec3& vector) {
    return {vector.x, vector.y};
}

/// (s, z): the place of a point in the section.
glm::dvec2 sectionPlace(const glm::dvec3& position) {
    return {glm::length(horizontal(position)), position.z};
}

// What a normal in the section is in space.
glm::dvec3 revolved(const glm::dvec2& normal, const glm::dvec3& position) {
    const double radius = glm::length(horizontal(position));
    const glm::dvec2 out = radius > 0.0 ? horizontal(position) / radius : glm::dvec2(1.0, 0.0);
    return {normal.x * out, normal.y};
}

SolidHit startOf(const SolidRay& ray, double t) {
    return {t, ray.at(t), glm::dvec3(0.0), true};
}

struct Stretch {
    double from;
    double to;
    [[nodiscard]] bool isEmpty() const { return !(from <= to); }
};

// Where the ray is at depths from low to high.
Stretch between(const SolidRay& ray, double low, double high, Stretch stretch) {
    if (ray.direction.z == 0.0) {
        const bool isBetween = low <= ray.origin.z && ray.origin.z <= high;
        return isBetween ? stretch : Stretch{1.0, 0.0};
    }
    const double a = (low - ray.origin.z) / ray.direction.z;
    const double b = (high - ray.origin.z) / ray.direction.z;
    return {std::max(stretch.from, std::min(a, b)), std::min(stretch.to, std::max(a, b))};
}

// The parts of cones and the rings that segments of a section make, met by a ray.
class RevolvedSegments {
  public:
    RevolvedSegments(const SolidRay& ray, double from)
        : ray_(ray),
          from_(from),
          last_(ray.to),
          origin_(horizontal(ray.origin)),
          direction_(horizontal(ray.direction)),
          square_(glm::dot(direction_, direction_)),
          half_(glm::dot(origin_, direction_)) {}

    // Whether the ray may meet something with (s,z) in the node's box before the first hit.
    [[nodiscard]] bool mayMeet(const PlaneOutline::Node& node) const {
        const Stretch part =
            between(ray_, node.low.y - kSlack, node.high.y + kSlack, {from_, last_});
        if (part.isEmpty())
            return false;
        const double nearest =
            square_ > 0.0 ? std::clamp(-half_ / square_, part.from, part.to) : part.from;
        const double farthest = std::max(radius(part.from), radius(part.to));
        return radius(nearest) <= node.high.x + kSlack && farthest >= node.low.x - kSlack;
    }

    void meet(const PlaneOutline::Segment& segment) {
        const glm::dvec2 along = segment.end - segment.start;
        const double length = glm::length(along);
        if (!(length > 0.0))
            return;
        const glm::dvec2 normal = glm::dvec2(along.y, -along.x) / length;
        // The line is normal.x·s + normal.y·z = level. On the ray normal.x·s is a + b·t, so its
        // square is normal.x²·|R|².
        const double a = glm::dot(normal, segment.start) - normal.y * ray_.origin.z;
        const double b = -normal.y * ray_.direction.z;
        if (std::abs(normal.x) < kLevel) {
            if (b != 0.0)
                tryAt(-a / b, segment, along, normal);
            return;
        }
        const double share = normal.x * normal.x;
        for (const double t : roots(share * square_ - b * b, share * half_ - a * b,
                                    share * glm::dot(origin_, origin_) - a * a))
            if (normal.x * (a + b * t) >= 0.0)  // not the cone's other half, of negative s
                tryAt(t, segment, along, normal);
    }

    [[nodiscard]] std::optional<SolidHit> first() const { return first_; }

  private:
    static constexpr double kSlack = 1e-12;
    static constexpr double kLevel = 1e-12;

    [[nodiscard]] double radius(double t) const { return glm::length(origin_ + t * direction_); }

    // Of a·t² + 2·b·t + c; none where they are not real.
    static std::array<double, 2> roots(double a, double b, double c) {
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        const double square = b * b - a * c;
        if (!(square >= 0.0))
            return {kNone, kNone};
        const double q = -(b + std::copysign(std::sqrt(square), b));
        return {a != 0.0 ? q / a : kNone, q != 0.0 ? c / q : kNone};
    }

    void tryAt(double t, const PlaneOutline::Segment& segment, const glm::dvec2& along,
               glm::dvec2 normal) {
        if (!(t >= from_ && t <= last_))
            return;
        const glm::dvec3 position = ray_.at(t);
        const double share =
            glm::dot(sectionPlace(position) - segment.start, along) / glm::dot(along, along);
        const double slack = kSlack / glm::length(along);
        if (!(share >= -slack && share <= 1.0 + slack))
            return;
        glm::dvec3 out = revolved(normal, position);
        if (glm::dot(out, ray_.direction) > 0.0)
            out = -out;
        last_ = t;
        first_ = SolidHit{t, position, out, false};
    }

    const SolidRay& ray_;
    double from_;
    double last_;
    glm::dvec2 origin_;
    glm::dvec2 direction_;
    double square_;
    double half_;
    std::optional<SolidHit> first_;
};

// Steps along [from, to] by what `distance` allows at `speed`, to where it is at most the
// tolerance. The number of t, or nothing.
template <class Distance>
std::optional<double> sphereTrace(const Distance& distance, double speed, Stretch stretch) {
    double t = stretch.from;
    while (t <= stretch.to) {
        const double free = distance(t);
        if (free <= kOffsetTolerance)
            return t;
        if (!(speed > 0.0))
            return std::nullopt;
        const double next = t + free / speed;
        // A step that rounding swallows: the ray is as near as doubles can tell.
        t = next > t ? next : std::nextafter(t, std::numeric_limits<double>::infinity());
    }
    return std::nullopt;
}

// Of a level end of the solid which the ray comes upon; a level ray runs along one of the caps.
glm::dvec3 capNormal(const SolidRay& ray) {
    const bool isFromAbove = ray.direction.z != 0.0 ? ray.direction.z > 0.0 : ray.origin.z < 0.5;
    return {0.0, 0.0, isFromAbove ? -1.0 : 1.0};
}

// Not on a cap: a ray that begins there hits it at once, as those of mapped surfaces do.
bool startsBetweenCaps(const SolidRay& ray) {
    const double z = ray.at(ray.from).z;
    return z > 0.0 && z < 1.0;
}

// The pieces of a profile in the order in which the ray comes to them.
std::vector<const OffsetPiece*> inOrder(const OffsetProfile& profile, const SolidRay& ray) {
    std::vector<const OffsetPiece*> pieces;
    for (const OffsetPiece& piece : profile)
        pieces.push_back(&piece);
    if (ray.direction.z < 0.0)
        std::reverse(pieces.begin(), pieces.end());
    return pieces;
}

glm::dvec3 sheetNormal(const PlaneOutline& outline, const OffsetPiece& piece,
                       const glm::dvec3& position) {
    const double step = 1e-7 * (piece.bottom - piece.top);
    const double above = std::max(piece.top, position.z - step);
    const double below = std::min(piece.bottom, position.z + step);
    const double slope = (piece.offset(below) - piece.offset(above)) / (below - above);
    return glm::normalize(glm::dvec3(outline.nearest(horizontal(position)).direction, -slope));
}

}  // namespace

std::optional<SolidHit> hitExtrusion(const PlaneOutline& outline, const SolidRay& ray) {
    const Stretch part = between(ray, 0.0, 1.0, {ray.from, ray.to});
    if (part.isEmpty())
        return std::nullopt;
    if (outline.isInside(horizontal(ray.at(part.from)))) {
        if (startsBetweenCaps(ray))
            return startOf(ray, part.from);
        return SolidHit{part.from, ray.at(part.from), capNormal(ray), false};
    }
    const std::optional<OutlineCrossing> wall = outline.firstCrossing(
        horizontal(ray.origin), horizontal(ray.direction), part.from, part.to);
    if (!wall)
        return std::nullopt;
    return SolidHit{wall->t, ray.at(wall->t), glm::dvec3(wall->normal, 0.0), false};
}

std::optional<SolidHit> hitRevolution(const PlaneOutline& section, const SolidRay& ray) {
    if (section.isInside(sectionPlace(ray.at(ray.from))))
        return startOf(ray, ray.from);
    RevolvedSegments surfaces(ray, ray.from);
    section.visitSegments([&](const PlaneOutline::Node& node) { return surfaces.mayMeet(node); },
                          [&](const PlaneOutline::Segment& segment) { surfaces.meet(segment); });
    return surfaces.first();
}

std::optional<SolidHit> hitOffsetExtrusion(const PlaneOutline& outline,
                                           const OffsetProfile& profile, const SolidRay& ray) {
    for (const OffsetPiece* const piece : inOrder(profile, ray)) {
        const Stretch part = between(ray, piece->top, piece->bottom, {ray.from, ray.to});
        if (part.isEmpty())
            continue;
        const auto distance = [&](double t) {
            const glm::dvec3 position = ray.at(t);
            return outline.distance(horizontal(position)) -
                   piece->offset(std::clamp(position.z, piece->top, piece->bottom));
        };
        const double speed =
            glm::length(horizontal(ray.direction)) + piece->steepest * std::abs(ray.direction.z);
        const std::optional<double> t = sphereTrace(distance, speed, part);
        if (t && *t == ray.from && startsBetweenCaps(ray))
            return startOf(ray, *t);
        if (t) {
            const glm::dvec3 position = ray.at(*t);
            // At once where a piece begins: its level end, a cap or the tread of a step.
            const glm::dvec3 normal =
                *t == part.from ? capNormal(ray) : sheetNormal(outline, *piece, position);
            return SolidHit{*t, position, normal, false};
        }
    }
    return std::nullopt;
}

std::optional<SolidHit> hitOffsetRevolution(const PlaneOutline& section, double extension,
                                            const SolidRay& ray) {
    const auto distance = [&](double t) {
        return section.distance(sectionPlace(ray.at(t))) - extension;
    };
    const std::optional<double> t =
        sphereTrace(distance, glm::length(ray.direction), {ray.from, ray.to});
    if (!t)
        return std::nullopt;
    if (*t == ray.from)
        return startOf(ray, *t);
    const glm::dvec3 position = ray.at(*t);
    return SolidHit{*t, position,
                    revolved(section.nearest(sectionPlace(position)).direction, position), false};
}

}  // namespace relievo::reference
