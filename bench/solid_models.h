#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "solids/solid.h"
#include "textures/depth_map.h"
#include "textures/shape_map.h"

namespace relievo::bench {

/// Solids to be measured: "basic", "extended", "bevel", "chamfer", "chamfer-large" (a bevel that
/// reaches far, as in figure 4.8 of the thesis), "round", "revolution", and with ten replicas in u
/// and in v "revolution-10" and "revolution-10-off", whose axes are not in the middle: there the
/// next replica may be nearer than the one that a place is in.
std::span<const std::string_view> solidModelNames();

/// Shapes that they are made of: of extrusions "star", "annulus" and "comb" (thin bars), repeated
/// without end; of revolutions the sections "torus" and "vase".
std::span<const std::string_view> solidShapeNames();

/// Whether the shape is one for that solid. Both must be of the names above.
bool fitsSolid(std::string_view shape, std::string_view solid);

/// The map of a shape, size² texels, with sharp corners (textures::ShapeCreases) or without.
/// `shape` must be one of the names above.
std::shared_ptr<const textures::ShapeMap> makeSolidShape(std::string_view shape, int size,
                                                         bool hasSharpCorners);

/// A solid of one part. Extrusions have no window but their depths from 0 to 1; revolutions are in
/// the box [0, replicas]²×[0,1].
solids::SolidPart makeSolidModel(std::string_view solid,
                                 std::shared_ptr<const textures::ShapeMap> shape);

/// An extrusion whose profile nowhere narrows downwards as a relief: at each texel the depth at
/// which the solid begins, 1 where it is nowhere. Between texels it is another solid: upright walls
/// become slopes of a texel.
textures::DepthMap reliefOf(const solids::Solid& extrusion);

}  // namespace relievo::bench
