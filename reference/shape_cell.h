#pragma once

#include <array>
#include <glm/vec2.hpp>

#include "reference/bilinear_cell.h"
#include "textures/shape_map.h"

namespace relievo::reference {

/// The distance of a shape map between four neighbouring texel centres: of two bilinear fields the
/// larger or the smaller one (textures::ShapeCreases), which without a crease are one.
struct ShapeCell {
    enum class Join { Same, Larger, Smaller };

    BilinearCell a;
    BilinearCell b;
    Join join = Join::Same;

    [[nodiscard]] bool isCreased() const noexcept { return join != Join::Same; }
    /// The field that is the distance at p, in local texel coordinates as those of BilinearCell.
    [[nodiscard]] const BilinearCell& at(const glm::dvec2& p) const noexcept;
    [[nodiscard]] double distance(const glm::dvec2& p) const noexcept { return at(p).depth(p); }
    /// a − b: 0 on the crease.
    [[nodiscard]] BilinearCell difference() const noexcept;
};

/// From the distances of the centres and their codes, in the order of BilinearCell; both in units
/// of which a texel is `texel` wide.
ShapeCell shapeCell(const std::array<double, 4>& distances, const std::array<double, 4>& codes,
                    double texel) noexcept;

/// Between the columns `left` and `right` and the rows `top` and `bottom` of a map.
ShapeCell shapeCell(const textures::ShapeMap& map, int left, int right, int top,
                    int bottom) noexcept;

/// What steps go by there.
BilinearCell stepCell(const textures::ShapeMap& map, int left, int right, int top,
                      int bottom) noexcept;

}  // namespace relievo::reference
