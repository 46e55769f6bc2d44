#include "reference/bilinear_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

#include "reference/bilinear_cell.h"

namespace relievo::reference {

namespace {

using textures::DepthMap;
using textures::WrapMode;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthestTexel = 0x1p51;

/// The part of a ray inside the box window × [0,1]: the parameters of its ends and the point where
/// it begins.
struct ClippedRay {
    double begin = 0.0;
    double end = kInfinity;
    glm::dvec3 start{0.0};
    bool endsOnFloor = false;  ///< leaves through z = 1, where everything is solid
};

bool isFinite(const TileRay& ray) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(ray.origin[axis]) || !std::isfinite(ray.direction[axis]))
            return false;
    return true;
}

std::optional<ClippedRay> clip(const TileRay& ray, const TileWindow& window) {
    const glm::dvec3 low(window.minimum, 0.0);
    const glm::dvec3 high(window.maximum, 1.0);
    ClippedRay clipped;
    glm::dvec3 entry(-kInfinity);
    double floorExit = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double origin = ray.origin[axis];
        const double direction = ray.direction[axis];
        if (direction == 0.0) {
            if (origin < low[axis] || origin > high[axis])
                return std::nullopt;
            continue;
        }
        const bool forward = direction > 0.0;
        entry[axis] = ((forward ? low : high)[axis] - origin) / direction;
        const double exit = ((forward ? high : low)[axis] - origin) / direction;
        clipped.begin = std::max(clipped.begin, entry[axis]);
        clipped.end = std::min(clipped.end, exit);
        if (axis == 2 && forward)
            floorExit = exit;
    }
    if (clipped.begin > clipped.end)
        return std::nullopt;
    clipped.endsOnFloor = clipped.end == floorExit && floorExit < kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        // On the side through which the ray comes in the coordinate is the bound itself: computed,
        // it could lie a rounding below a surface that touches z = 0.
        const bool entersHere = entry[axis] == clipped.begin;
        clipped.start[axis] = entersHere ? (ray.direction[axis] > 0.0 ? low : high)[axis]
                                         : ray.origin[axis] + clipped.begin * ray.direction[axis];
    }
    return clipped;
}

/// The walk of a ray over the cells of one axis. Cell k lies between texel centres k and k+1, in
/// texel coordinates x = u·size − ½. Where the map is constant along the axis (one texel, or
/// outside a clamped tile) a single cell reaches to infinity.
class AxisWalk {
  public:
    AxisWalk(double texels, double speed, int size, WrapMode wrap)
        : speed_(speed), size_(size), wrap_(wrap) {
        cell_ = static_cast<std::int64_t>(std::floor(texels));
        if (wrap == WrapMode::Clamp)
            cell_ = std::clamp<std::int64_t>(cell_, -1, size - 1);
        start_ = texels - static_cast<double>(cell_);
        low_ = textures::wrapIndex(cell_, size_, wrap_);
        high_ = textures::wrapIndex(cell_ + 1, size_, wrap_);
    }

    /// The parameter at which the ray leaves the cell along this axis. From integers every time, so
    /// that errors do not add up along the walk.
    [[nodiscard]] double exit() const noexcept {
        if (speed_ == 0.0 || reachesToInfinity())
            return kInfinity;
        const auto border = static_cast<double>(speed_ > 0.0 ? steps_ + 1 : steps_);
        return (border - start_) / speed_;
    }
    /// The coordinate at parameter t, relative to the first texel centre of the cell.
    [[nodiscard]] double local(double t) const noexcept {
        return (start_ - static_cast<double>(steps_)) + t * speed_;
    }
    void step() noexcept {
        if (speed_ > 0.0) {
            ++cell_, ++steps_;
            low_ = high_;
            high_ = textures::wrapIndex(cell_ + 1, size_, wrap_);
        } else {
            --cell_, --steps_;
            high_ = low_;
            low_ = textures::wrapIndex(cell_, size_, wrap_);
        }
    }
    [[nodiscard]] double speed() const noexcept { return speed_; }
    /// The texels on the two sides of the cell.
    [[nodiscard]] int low() const noexcept { return low_; }
    [[nodiscard]] int high() const noexcept { return high_; }

  private:
    [[nodiscard]] bool reachesToInfinity() const noexcept {
        if (size_ == 1)
            return true;
        return wrap_ == WrapMode::Clamp && (speed_ > 0.0 ? cell_ >= size_ - 1 : cell_ <= -1);
    }

    double speed_;  ///< texels per unit of the ray's parameter
    int size_;
    WrapMode wrap_;
    std::int64_t cell_ = 0;
    std::int64_t steps_ = 0;  ///< cells walked from the first one, negative to the left
    double start_ = 0.0;      ///< where the ray begins, relative to the first cell
    int low_ = 0;
    int high_ = 0;
};

BilinearCell cellAt(const DepthMap& map, const AxisWalk& columns, const AxisWalk& rows) {
    return {map.depth.at(columns.low(), rows.low()), map.depth.at(columns.high(), rows.low()),
            map.depth.at(columns.low(), rows.high()), map.depth.at(columns.high(), rows.high())};
}

/// A ray over the texels, with its parameter counted from where it enters the window.
struct CellWalk {
    AxisWalk columns;
    AxisWalk rows;
    double z = 0.0;  ///< depth at parameter 0
    double zSpeed = 0.0;
    double end = kInfinity;
    bool endsOnFloor = false;
};

struct Crossing {
    double t = 0.0;
    bool startsInside = false;
};

std::optional<Crossing> walkToSurface(const DepthMap& map, CellWalk walk) {
    const glm::dvec3 direction(walk.columns.speed(), walk.rows.speed(), walk.zSpeed);
    double entry = 0.0;
    for (bool first = true;; first = false) {
        const double columnExit = walk.columns.exit();
        const double rowExit = walk.rows.exit();
        // Two borders met at once may swap by a rounding; the parameter must not go back for it.
        const double exit = std::max(entry, std::min({columnExit, rowExit, walk.end}));
        const double zEntry = walk.z + entry * walk.zSpeed;
        const double deepest = walk.zSpeed > 0.0 ? walk.z + exit * walk.zSpeed : zEntry;
        const BilinearCell cell = cellAt(map, walk.columns, walk.rows);
        const bool last = exit >= walk.end;
        if (deepest >= cell.minimum) {
            const glm::dvec3 from(walk.columns.local(entry), walk.rows.local(entry), zEntry);
            const DepthBelowSurface below = depthBelowSurface(cell, from, direction);
            if (const auto s = firstCrossing(below); s && entry + *s <= exit)
                return Crossing{entry + *s, first && below.constant > 0.0};
        }
        if (last)  // no depth exceeds 1, so only rounding can bring a ray to the floor unhurt
            return walk.endsOnFloor ? std::optional(Crossing{exit, false}) : std::nullopt;
        (columnExit <= rowExit ? walk.columns : walk.rows).step();
        entry = exit;
    }
}

}  // namespace

std::optional<TileHit> traceBilinear(const DepthMap& map, const TileRay& ray,
                                     const TileWindow& window, double maxDistance) {
    assert(map.width() > 0 && map.height() > 0);
    assert(maxDistance >= 0.0 && std::isfinite(maxDistance));
    if (!isFinite(ray))
        return std::nullopt;
    const std::optional<ClippedRay> clipped = clip(ray, window);
    if (!clipped)
        return std::nullopt;
    const glm::dvec2 size(map.width(), map.height());
    const glm::dvec2 texels = glm::dvec2(clipped->start) * size - 0.5;
    if (!(std::max(std::abs(texels.x), std::abs(texels.y)) < kFarthestTexel))
        return std::nullopt;

    // A power of two brings any length of direction to about 1 without rounding, so that the
    // squares below neither overflow nor vanish.
    const double longest =
        std::max({std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
    const int exponent = longest > 0.0 ? std::ilogb(longest) : 0;
    const glm::dvec3 direction(std::scalbn(ray.direction.x, -exponent),
                               std::scalbn(ray.direction.y, -exponent),
                               std::scalbn(ray.direction.z, -exponent));
    const double reach = std::scalbn(clipped->end - clipped->begin, exponent);
    const double tilesPerUnit = std::hypot(direction.x, map.aspect() * direction.y);
    const double limit = tilesPerUnit > 0.0 ? maxDistance / tilesPerUnit : kInfinity;
    const CellWalk walk{
        AxisWalk(texels.x, direction.x * size.x, map.width(), map.wrap),
        AxisWalk(texels.y, direction.y * size.y, map.height(), map.wrap),
        clipped->start.z,
        direction.z,
        std::min(reach, limit),
        clipped->endsOnFloor && reach <= limit,
    };
    const std::optional<Crossing> crossing = walkToSurface(map, walk);
    if (!crossing)
        return std::nullopt;
    return TileHit{clipped->begin + std::scalbn(crossing->t, -exponent),
                   clipped->start + crossing->t * direction, crossing->startsInside};
}

glm::dvec3 bilinearNormal(const DepthMap& map, double u, double v, double depthScale) {
    assert(map.width() > 0 && map.height() > 0);
    const AxisWalk columns(u * map.width() - 0.5, 0.0, map.width(), map.wrap);
    const AxisWalk rows(v * map.height() - 0.5, 0.0, map.height(), map.wrap);
    const glm::dvec2 perTexel =
        cellAt(map, columns, rows).gradient({columns.local(0.0), rows.local(0.0)});
    // Texels are square and width⁻¹ tile widths wide, so one factor serves both directions.
    const glm::dvec2 slope = depthScale * map.width() * perTexel;
    return glm::normalize(glm::dvec3(slope, 1.0));
}

}  // namespace relievo::reference
