// First phase by cells and cones (ours). The four texels that give the depth at a point give the whole
// bilinear cell that it is in. So each step first solves the cell: a hit there is computed, not approached.
// Otherwise the ray leaves the cell, and goes on to the side of the cone that stands where it left.
//
// For the lookups of search/cone_steps.glsl no step is less than a cell, however narrow the cone, and where
// the relief is steep, and cones are, nothing converges slowly.
#include "relievo/search/bracket.glsl"
#include "relievo/search/cells.glsl"
#include "relievo/search/cone.glsl"

// The t at which a ray that leaves the walk's cell `gap` above the surface leaves the cone there.
float reliefConeExit(ReliefRay ray, ReliefWalk walk, vec4 corners, float gap) {
    vec2 size = vec2(reliefMapSize());
    vec2 cell = vec2(reliefWalkCell(walk));
    vec2 texel = cell + step(0.5, reliefPlaceInCell(walk, walk.exit));
    float ratio = reliefConeRatio(ray, (texel + 0.5) / size, (cell + 1.0) / size, corners);
    return walk.exit + reliefConeStep(ray, ratio, gap);
}

// Until the hit is in a cell, where the bracket is empty, or a point is in the solid: then the ray came
// there within the cone of the last cell.
int reliefFind(ReliefRay ray, out ReliefBracket bracket, inout int steps) {
    ReliefWalk walk = reliefBeginWalk(ray);
    bracket = ReliefBracket(0.0, 0.0, 0.0, 0.0);
    while (steps < relievoConeSteps) {
        ++steps;
        vec4 corners = reliefWalkCorners(walk);
        vec3 profile = reliefProfile(ray, walk, corners);
        bracket.inside = walk.t;
        bracket.below = profile.x;
        if (profile.x >= 0.0) return RELIEVO_OUTCOME_HIT;
        float hit = reliefFirstMeeting(profile, walk);
        if (min(hit, walk.exit) >= ray.end || hit < kReliefBoundless) {
            bracket.inside = min(hit, ray.end);
            bracket.outside = bracket.inside;
            return hit <= ray.end ? RELIEVO_OUTCOME_HIT : RELIEVO_OUTCOME_MISS;
        }
        bracket.outside = walk.exit;
        float across = walk.exit - walk.t;
        bracket.above = max(-(profile.x + across * (profile.y + across * profile.z)), 0.0);
        float free = min(reliefConeExit(ray, walk, corners, bracket.above), ray.end);
        reliefStepWalk(walk);
        if (free > walk.exit) reliefJumpWalk(walk, free);
    }
    bracket.inside = walk.t;
    return RELIEVO_OUTCOME_EXHAUSTED;
}
