// Relaxed cones: they are so wide that a ray may pierce the surface once inside one, so that few steps lead
// through them; binary search finds the crossing (cones: Policarpo, Oliveira 2007; cells: ours). With relaxed
// cones guaranteed on the bilinear surface that crossing is the first hit.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/cones.glsl"
#include "relievo/search/binary.glsl"
