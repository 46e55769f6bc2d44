#pragma once

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Radii of cylinder tracing that overlook shallow dips: for each texel a radius, in tile widths,
/// such that a ray that begins above any point of the texel's square, at any depth from there up,
/// and goes down or level, does not come out of the bilinear surface again before it is so far away
/// once it was deeper than `tolerance` > 0 below it. buildCylinderRadii gives 0 wherever a cell is
/// twisted, and must: along one diagonal of it the surface falls away ever faster, and a ray that
/// touches the surface there dips in and comes out as soon as one likes, however smooth the relief.
///
/// The bound. Let a ray of depth z enter the surface D at a, be h deeper than it at b, and come out
/// at c, all within the radius R, so c − a ≤ R. The slope of z − D is h/(b − a) in the mean before
/// b and −h/(c − b) after it, and z is straight, so the slopes of D along the ray differ by h/(b −
/// a) + h/(c − b) ≥ 4h/(c − a) ≥ 4h/R. Where no two gradients within R of the square differ by more
/// than 4·tolerance/R, the ray is never deeper than the tolerance. Gradients of bilinear patches
/// lie between the differences of samples along their sides, whose extremes over windows that hold
/// the disk are taken, ever larger ones.
///
/// Unlike there a valley counts as much as a crest: the greater of both radii is one that holds.
///
/// Time: linear for each size of windows, which grow by halves up to the first that improves no
/// texel. Scratch memory: at most 80 bytes a texel (mirror).
textures::Plane buildTolerantRadii(const textures::DepthMap& map, double tolerance);

}  // namespace relievo::preprocess
