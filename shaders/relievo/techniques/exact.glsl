// The first hit with the bilinear surface itself, by roof cones (specification 3.6; ours).
//
// Error: float rounding. Cost: a lookup for every cone, a second one in every cell that is solved.
#include "relievo/search/roofs.glsl"

ReliefHit searchRelief(ReliefRay ray) { return reliefSearchRoofs(ray); }
