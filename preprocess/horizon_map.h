#pragma once

#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// Azimuth `index` of `count`, in radians from +u towards +v in the metric: 2π·index/count.
double azimuthOf(int index, int count);

/// The horizon of a relief in one direction (Max 1988): for each texel the greatest slope
/// (D(x) − D(y)) / |x − y| under which it sees the surface, from its centre x to any y along the
/// azimuth, in depth per tile width and at least 0. At depth scale a light is blocked that comes
/// from this azimuth at an elevation of tangent a·horizon or less.
///
/// In amortised constant time a texel (Timonen and Westerholm 2010): the map is swept along
/// parallel lines a texel apart, from far to near, with a stack that holds the convex hull of what
/// lies ahead. The hull is that of the surface along the line, piece by piece between the borders
/// of its cells, where it is a parabola, by the control points of the parabolas: no horizon is
/// below that of the surface, and where the surface is straight, as along the axes, it is the true
/// one.
///
/// Lines along the axes, and along the diagonals of square texels, pass through texel centres. Of
/// other azimuths a texel takes the values of the lines on its two sides, interpolated at its
/// centre. What is farther than one period of the tile, counted along the axis that is nearer to
/// the azimuth, is not seen; along the axes, and the diagonals of square maps, all is. Light at a
/// tangent above a tile's depth per width is never blocked from there.
///
/// Linear time for a given ratio of sides; clamped maps take longer the more it differs from 1.
/// Scratch memory: at most 8 bytes a texel and some rows.
textures::Plane buildHorizon(const textures::DepthMap& map, double azimuth);

}  // namespace relievo::preprocess
