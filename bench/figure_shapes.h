#pragma once

#include <memory>
#include <string_view>

#include "outlines/outline.h"
#include "textures/shape_map.h"

namespace relievo::bench {

/// A plane shape of the figures of solids. Of sections the left border is the axis. Extruded are
/// `arrow`, `gear`, `star`, `heart`, `flower`, `column`, `ring`, `meander` and `lattice` (the last
/// two go on from tile to tile) and the letters `ampersand` and `R`; revolved are `pawn`, `goblet`,
/// `vase`, `baluster`, `bell`, `top`, `bowl`, `torus` and `ball`. It must be one of these.
outlines::Drawing figureDrawing(std::string_view name);

/// The shape map of it, so many texels wide, with sharp corners or without.
std::shared_ptr<const textures::ShapeMap> figureShape(
    std::string_view name, int width, textures::WrapMode wrap = textures::WrapMode::Clamp,
    bool hasSharpCorners = true);

}  // namespace relievo::bench
