#pragma once

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// The radii of cylinder tracing (Baboud and Décoret 2006): for each texel the radius, in tile
/// widths, of a vertical cylinder in which no ray pierces the relief twice. A ray that begins above
/// any point of the texel's square, at any depth from there up, and goes down or level, does not
/// come out of the bilinear surface again before it is so far away, whatever its depth. Unlimited
/// (infinite) where no ray ever does; 0 where one may within a texel of the square.
///
/// The bound. Let f(t) be the depth of the surface along a ray's way and c ≥ 0 the depth that the
/// ray gains. It enters where f' ≤ c and comes out later where f' > c, so between the two f' grows
/// to a value above 0. Along a direction of one quadrant that happens only
///   - inside a bilinear cell whose twist D00 − D10 − D01 + D11 has the sign of the product of the
///     signs of the direction, since f'' is twice the twist times its two components, or
///   - on the border where it enters a cell across which the depths bend down, that is, have a
///     second difference above 0 at one of the border's ends,
/// and in both cases in a cell in which f' can be above 0: whose depths grow, on one of its sides,
/// the way the quadrant goes. Such cells are marked, and the radius is the distance from the
/// texel's square to the nearest marked cell of each quadrant that lies ahead in it. A slope that
/// falls away evenly, or less and less, marks nothing; the crest of a ridge does, and the part of a
/// hill that falls away more and more.
///
/// Twisted cells are marked with good reason: along one of their diagonals a ray that touches the
/// surface comes out again as soon as one likes. tolerant_radii.h overlooks such shallow dips.
///
/// So the radius is safe for all rays, but not the widest: a marked cell counts as if every ray
/// came out of it. Noise in the last bit of depths marks cells as well.
///
/// Linear time: one-sided distances along columns, then one-sided lower envelopes of parabolas
/// along rows, for each quadrant. Scratch memory: at most 16 bytes a texel (mirror).
textures::Plane buildCylinderRadii(const textures::DepthMap& map);

}  // namespace relievo::preprocess
