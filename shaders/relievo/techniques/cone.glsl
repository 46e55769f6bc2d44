// Cone tracing: each texel holds the widest empty cone that stands on it, and a step leads through the cell
// that the ray is in and to where it leaves the cone behind it (cones: Dummer 2006; radius form and metric:
// specification 3.1 and E3; cells: ours).
//
// With cones guaranteed on the bilinear surface no step passes the first hit, and every hit is solved in its
// cell. Cones of texel centres may pierce curved cells: such a step is halved.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/cones.glsl"
#include "relievo/search/binary.glsl"
