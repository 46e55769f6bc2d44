#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/bilinear_cell.h"
#include "textures/depth_map.h"

namespace relievo::reference {

/// The walk of a line over the cells of one axis. Cell k lies between texel centres k and k+1, in
/// texel coordinates x = u·size − ½. Where the map is constant along the axis (one texel, or
/// outside a clamped tile) a single cell reaches to infinity.
class AxisWalk {
  public:
    /// `texels` is where the line begins, in texel coordinates; `speed` in texels per unit of its
    /// parameter.
    AxisWalk(double texels, double speed, int size, textures::WrapMode wrap);

    /// The parameter at which the line leaves the cell along this axis. From integers every time,
    /// so that errors do not add up along the walk.
    [[nodiscard]] double exit() const noexcept;
    /// The coordinate at parameter t, relative to the first texel centre of the cell.
    [[nodiscard]] double local(double t) const noexcept {
        return (start_ - static_cast<double>(steps_)) + t * speed_;
    }
    /// On to the next cell in the direction of the line.
    void step() noexcept;
    /// On to the cell that holds the line's point at parameter t, but never back.
    void jump(double t) noexcept;

    [[nodiscard]] double speed() const noexcept { return speed_; }
    /// The number k of the cell, not wrapped.
    [[nodiscard]] std::int64_t cell() const noexcept { return cell_; }
    /// The texels on the two sides of the cell.
    [[nodiscard]] int low() const noexcept { return low_; }
    [[nodiscard]] int high() const noexcept { return high_; }

  private:
    [[nodiscard]] bool reachesToInfinity() const noexcept;

    double speed_;
    int size_;
    textures::WrapMode wrap_;
    std::int64_t cell_ = 0;
    std::int64_t steps_ = 0;  // cells walked from the first one, negative to the left
    double start_ = 0.0;      // where the line begins, relative to the first cell
    int low_ = 0;
    int high_ = 0;
};

/// The walk of the line start + t·direction, 0 ≤ t ≤ end, over the bilinear cells of a map, one
/// cell after the other (DDA on integers).
class CellWalk {
  public:
    /// `start` and `direction` in tile space (u,v,z); |start·size| under 2⁵¹ texels, so that
    /// doubles resolve them. `map` must outlive the walk.
    CellWalk(const textures::DepthMap& map, const glm::dvec3& start, const glm::dvec3& direction,
             double end);

    /// The parameters between which the line is in the current cell. exit() ≥ entry(), and the next
    /// cell's entry() is this one's exit().
    [[nodiscard]] double entry() const noexcept { return entry_; }
    [[nodiscard]] double exit() const noexcept { return exit_; }
    /// Whether the line ends in the current cell.
    [[nodiscard]] bool isLast() const noexcept { return exit_ >= end_; }
    /// On to the next cell.
    void step() noexcept;
    /// On to the cell that holds the line's point at parameter t ≥ entry(), which is where the line
    /// enters it then, but never to a cell behind the current one.
    void jump(double t) noexcept;
    /// Whether the line's point at parameter t lies beyond the current cell.
    [[nodiscard]] bool isBeyond(double t) const noexcept { return t > exit_; }

    /// Depth of the line at parameter t.
    [[nodiscard]] double z(double t) const noexcept { return z_ + t * direction_.z; }
    /// The greatest depth of the line in the current cell.
    [[nodiscard]] double deepest() const noexcept { return z(direction_.z > 0.0 ? exit_ : entry_); }
    /// The surface in the current cell.
    [[nodiscard]] BilinearCell surface() const noexcept;
    /// The line's coordinates at t in the current cell: (0,0) to (1,1) inside.
    [[nodiscard]] glm::dvec2 local(double t) const noexcept {
        return {columns_.local(t), rows_.local(t)};
    }
    /// z − D along the line in the current cell, whose surface is `cell`; its parameter s is
    /// counted from entry().
    [[nodiscard]] DepthBelowSurface below(const BilinearCell& cell) const noexcept;

    [[nodiscard]] const AxisWalk& columns() const noexcept { return columns_; }
    [[nodiscard]] const AxisWalk& rows() const noexcept { return rows_; }

  private:
    void findExit() noexcept;

    const textures::DepthMap* map_;
    AxisWalk columns_;
    AxisWalk rows_;
    glm::dvec3 direction_;  // x and y in texels
    double z_;
    double end_;
    double columnExit_ = 0.0;
    double rowExit_ = 0.0;
    double entry_ = 0.0;
    double exit_ = 0.0;
};

}  // namespace relievo::reference
