#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "reference/cell_walk.h"
#include "reference/shape_cell.h"
#include "solids/free_space.h"
#include "solids/line_roots.h"
#include "solids/solid.h"
#include "solids/solid_crossing.h"

namespace relievo::solids {

/// The crossings of a ray with an extrusion, in order: an exact walk over the bilinear cells of the
/// distance and the straight pieces of the profile, in each of which d − o is a quadratic of t, or
/// one up to a crease and another behind it.
/// Where `freeSpace` is given the walk jumps over what is all outside or all inside; that changes
/// its cost only.
class ExtrusionWalk {
  public:
    /// `solid`, `freeSpace` and `cost` must outlive the walk; the latter two may be null. The span
    /// is in the tile space of the solid, |start·size| under 2⁵¹ texels.
    ExtrusionWalk(const Solid& solid, const FreeSpace* freeSpace, const WalkSpan& span,
                  TraceCost* cost);

    /// The next crossing, with t from 0 at the start of the span and `outward` in tile space;
    /// nothing at the end.
    std::optional<SolidCrossing> next();

  private:
    enum class Border { Start, Cell, Piece };

    void walkOn();
    void finish() noexcept;
    void findExit() noexcept;
    void step() noexcept;
    [[nodiscard]] double freeUntil(double step) const noexcept;
    [[nodiscard]] bool jump(double step) noexcept;
    [[nodiscard]] Quadratic clearance(const reference::BilinearCell& field, double t) const;
    [[nodiscard]] bool jumpFrom(const reference::ShapeCell& cell);
    void enter(const reference::ShapeCell& cell);
    void cross(const reference::ShapeCell& cell);
    void cross(const reference::BilinearCell& field, double from, double to);
    [[nodiscard]] glm::dvec2 place(double t) const noexcept {
        return {columns_.local(t), rows_.local(t)};
    }
    void stepPiece() noexcept;
    void findPieceExit() noexcept;
    void toggle(double t, SolidFace face, const glm::dvec3& outward) noexcept;
    [[nodiscard]] SolidFace borderFace(double value) const noexcept;
    [[nodiscard]] glm::dvec3 outwardAt(SolidFace face, const reference::BilinearCell& field,
                                       double t) const;
    [[nodiscard]] glm::dvec3 flatOutward(int axis) const noexcept;
    [[nodiscard]] double z(double t) const noexcept {
        return span_.start.z + t * span_.direction.z;
    }
    [[nodiscard]] const ProfilePiece& piece() const noexcept {
        return solid_->profile.pieces[piece_];
    }

    const Solid* solid_;
    const FreeSpace* freeSpace_;
    WalkSpan span_;
    TraceCost* cost_;
    reference::AxisWalk columns_;
    reference::AxisWalk rows_;
    double texelSpeed_;
    double lowestOffset_ = 0.0;
    double highestOffset_ = 0.0;
    std::size_t piece_ = 0;
    double columnExit_ = 0.0;
    double rowExit_ = 0.0;
    double pieceExit_ = 0.0;
    double entry_ = 0.0;
    double exit_ = 0.0;
    Border border_ = Border::Start;
    bool stepAtBorder_ = false;  // the offset jumps at the border of the piece
    bool isInside_ = false;
    bool isDone_ = false;
    // Of a cell: one at its entry and at each crease, two between, one at the end.
    std::array<SolidCrossing, 10> pending_;
    std::size_t firstPending_ = 0;
    std::size_t pendingCount_ = 0;
};

}  // namespace relievo::solids
