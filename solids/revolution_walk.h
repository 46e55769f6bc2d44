#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "reference/cell_walk.h"
#include "reference/shape_cell.h"
#include "solids/free_space.h"
#include "solids/section_roots.h"
#include "solids/solid.h"
#include "solids/solid_crossing.h"

namespace relievo::solids {

/// The crossings of a ray with a repeated revolution, in order: from replica to replica, and in
/// each over the bilinear cells of the section, through which the ray moves on a hyperbola: inwards
/// until it is closest to the axis, then outwards. `freeSpace` as in ExtrusionWalk.
class RevolutionWalk {
  public:
    /// As ExtrusionWalk; |start| under 2⁵¹ tiles.
    RevolutionWalk(const Solid& solid, const FreeSpace* freeSpace, const WalkSpan& span,
                   TraceCost* cost);

    /// The next crossing, with t from 0 at the start of the span and `outward` in tile space;
    /// nothing at the end.
    std::optional<SolidCrossing> next();

  private:
    /// A replica's section along the ray; parameters count from where the ray enters the replica.
    struct Section {
        RadialLine line;
        glm::dvec2 start{0.0};  // from the axis, where the ray enters
        reference::AxisWalk rows{0.0, 0.0, 1, textures::WrapMode::Clamp};
        double sign = 1.0;  // −1 upside down
        int column = 0;     // of the cell: between texel centres column and column + 1
        bool goesInwards = false;
        double end = 0.0;  // where the ray leaves the replica
    };

    void walkOn();
    void enterReplica();
    void leaveReplica();
    void findExit() noexcept;
    void step() noexcept;
    [[nodiscard]] bool jump(double distance) noexcept;
    [[nodiscard]] double columnExit() const noexcept;
    [[nodiscard]] int columnOf(double radius) const noexcept;
    [[nodiscard]] SectionCell sectionCell(const reference::BilinearCell& field,
                                          double extension) const noexcept;
    [[nodiscard]] double stepHere(const reference::ShapeCell& cell) const noexcept;
    [[nodiscard]] const reference::BilinearCell& fieldBetween(const reference::ShapeCell& cell,
                                                              double from,
                                                              double to) const noexcept;
    void cross(const reference::ShapeCell& cell);
    void cross(const SectionCell& cell, double from, double to);
    void toggle(double t, SolidFace face, const glm::dvec3& outward);
    [[nodiscard]] glm::dvec3 flatOutward(int axis) const noexcept;
    [[nodiscard]] glm::dvec3 wallOutward(const SectionCell& cell, double t) const noexcept;
    void toggleAtBorder(const SectionCell& cell);

    const Solid* solid_;
    const FreeSpace* freeSpace_;
    WalkSpan span_;
    TraceCost* cost_;
    reference::AxisWalk tiles_[3];
    Section section_;
    double replicaEntry_ = 0.0;
    int borderAxis_ = -1;  // of the replica's border that has just been crossed
    bool isAtStart_ = true;
    double entry_ = 0.0;  // both from the replica's entry
    double exit_ = 0.0;
    double turn_ = 0.0;  // where the ray is closest to the axis
    bool isInside_ = false;
    bool isDone_ = false;
    std::vector<double> creases_;
    std::vector<double> places_;
    std::vector<SolidCrossing> pending_;
    std::size_t firstPending_ = 0;
};

}  // namespace relievo::solids
