// Quadtree displacement mapping: the pyramid of least depths down to a single cell, which is taken to be as
// solid as its highest corner; then one line through the relief where the ray enters the cell under that lid
// and where it leaves it (Drobot 2010).
//
// Cheaper than techniques/pyramid.glsl by the cells that a ray enters and does not hit: here they are hits, up
// to a cell before the surface and farther beside a silhouette.
// A cell is as high as its highest corner.
#define RELIEVO_SEARCH_TOLERANCE(rise) rise
#include "relievo/search/pyramid.glsl"
#include "relievo/search/bracket.glsl"

float reliefHitInLeaf(ReliefRay ray, ReliefWalk walk, float under, float exit) {
    ReliefBracket bracket = reliefStretch(ray, under, min(exit, ray.end));
    if (bracket.above <= 0.0) return under;
    // A ray that ends in the cell, above the relief, leaves the window there.
    if (bracket.below < 0.0 && exit > ray.end) return kReliefBoundless;
    return bracket.below >= 0.0 ? reliefSecant(bracket) : bracket.inside;
}
