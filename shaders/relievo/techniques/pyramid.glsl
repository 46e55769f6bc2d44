// The first hit with the bilinear surface itself, by a pyramid of least depths (Oh, Ki, Lee 2006; Tevs,
// Ihrke, Seidel 2008): for maps without roof cones. In a single cell the quadratic is solved, so that the hit
// is computed and not approached.
//
// Error: float rounding. Cost: a lookup for every node, a second one in every cell that is solved; about
// twice those of techniques/exact.glsl.
#include "relievo/search/pyramid.glsl"

float reliefHitInLeaf(ReliefRay ray, ReliefWalk walk, float under, float exit) {
    return reliefHitInCell(ray, walk);
}
