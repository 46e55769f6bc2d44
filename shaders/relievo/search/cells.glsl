// The walk of a ray over the bilinear cells of the map, and the first hit in one of them.
//
// Cell (i,j) is the patch between the texel centres i and i+1, j and j+1. The walk keeps it as a pair
// of integers that only ever moves forward along the ray: to find the cell again from a point near its
// border may give the cell before, for ever. Texel coordinates count from the first cell, so that a
// ray that begins far from the map's first tile is as accurate as one that begins in it.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"
#include "relievo/search/result.glsl"

struct ReliefWalk {
    vec2 start;     // the ray's origin in texels from the first cell, in [0,1)² but in a clamped map
    vec2 speed;     // texels per unit of t
    ivec2 first;    // the first cell, counted from the tile of the origin
    ivec2 advance;  // cells from the first to the current one
    float t;        // where the ray enters the current cell
    float exit;     // where it leaves that cell, ≥ t
};

ivec2 reliefWalkCell(ReliefWalk walk) { return walk.first + walk.advance; }

// The t at which the walk's ray leaves the cells from `before` before cell number `cell` to `after` after it, `advance` from the
// first one, along an axis of `size` texels.
float reliefSpanExit(int advance, int cell, int size, int before, int after, float start,
                     float speed) {
    bool isForward = speed > 0.0;
#ifdef RELIEVO_WRAP_CLAMP
    // Outside a clamped tile one cell reaches to infinity.
    if (isForward ? cell >= size - 1 : cell < 0) return kReliefBoundless;
#endif
    int border = isForward ? advance + after + 1 : advance - before;
    return speed == 0.0 ? kReliefBoundless : (float(border) - start) / speed;
}

// The t at which the walk's ray leaves the cells from `before` before the current one to `after` after it,
// along each axis.
vec2 reliefSpanExits(ReliefWalk walk, ivec2 before, ivec2 after) {
    ivec2 size = reliefMapSize();
    ivec2 cell = reliefWalkCell(walk);
    return vec2(reliefSpanExit(walk.advance.x, cell.x, size.x, before.x, after.x, walk.start.x,
                               walk.speed.x),
                reliefSpanExit(walk.advance.y, cell.y, size.y, before.y, after.y, walk.start.y,
                               walk.speed.y));
}

void reliefFindExit(inout ReliefWalk walk) {
    vec2 exits = reliefSpanExits(walk, ivec2(0), ivec2(0));
    walk.exit = max(min(exits.x, exits.y), walk.t);
}

ReliefWalk reliefBeginWalk(ReliefRay ray) {
    vec2 size = vec2(reliefMapSize());
#ifdef RELIEVO_WRAP_CLAMP
    vec2 tile = vec2(0.0);
#else
    // An even one: a mirrored map looks the same from there.
    vec2 tile = 2.0 * floor(0.5 * ray.origin.xy);
#endif
    vec2 texels = (ray.origin.xy - tile) * size;
    vec2 cell = floor(texels - 0.5);
#ifdef RELIEVO_WRAP_CLAMP
    cell = clamp(cell, vec2(-1.0), size - 1.0);
#endif
    // In this order the differences are exact, or of less than a texel.
    ReliefWalk walk = ReliefWalk((texels - cell) - 0.5, ray.direction.xy * size, ivec2(cell), ivec2(0), 0.0,
                                 0.0);
    reliefFindExit(walk);
    return walk;
}

// On to the next cell.
void reliefStepWalk(inout ReliefWalk walk) {
    vec2 exits = reliefSpanExits(walk, ivec2(0), ivec2(0));
    walk.t = walk.exit;
    ivec2 along = ivec2(sign(walk.speed));
    walk.advance += exits.x <= exits.y ? ivec2(along.x, 0) : ivec2(0, along.y);
    reliefFindExit(walk);
}

// How far the walk is along one axis at `target` cells from the first: never back.
int reliefAdvance(int advance, int target, float speed) {
    if (speed == 0.0) return advance;
    return speed > 0.0 ? max(advance, target) : min(advance, target);
}

// On to the cell of the ray's point at t, never back.
void reliefJumpWalk(inout ReliefWalk walk, float t) {
    ivec2 target = ivec2(floor(walk.start + t * walk.speed));
    walk.advance = ivec2(reliefAdvance(walk.advance.x, target.x, walk.speed.x),
                         reliefAdvance(walk.advance.y, target.y, walk.speed.y));
#ifdef RELIEVO_WRAP_CLAMP
    ivec2 last = reliefMapSize() - 1;
    walk.advance = clamp(reliefWalkCell(walk), ivec2(-1), last) - walk.first;
#endif
    walk.t = t;
    reliefFindExit(walk);
}

// cell mod period, in [0, period).
int reliefModulo(int cell, int period) {
    int place = cell - period * int(floor(float(cell) / float(period)));
    // The quotient may be rounded up or down to the next integer.
    return place < 0 ? place + period : (place >= period ? place - period : place);
}

// The depths at the corners of the walk's cell, in the order of textureGather: (0,1), (1,1), (1,0), (0,0).
vec4 reliefWalkCorners(ReliefWalk walk) {
    ++reliefFetchCount;
    return reliefGather(relievoDepthMap, vec2(reliefWalkCell(walk) + 1) / vec2(reliefMapSize()));
}

// How much the depth differs between the corners of a cell, at most.
float reliefRise(vec4 corners) {
    vec2 least = min(corners.xy, corners.zw);
    vec2 most = max(corners.xy, corners.zw);
    return max(most.x, most.y) - min(least.x, least.y);
}

// Where the walk's ray is in its cell, in [0,1]², at a t between where it enters and where it leaves.
vec2 reliefPlaceInCell(ReliefWalk walk, float t) {
    return clamp(walk.start + t * walk.speed - vec2(walk.advance), 0.0, 1.0);
}

// The surface along a ray in the walk's cell, whose corners are given: z − D is x + y·s + z·s², s counted
// from where the ray enters the cell.
vec3 reliefProfile(ReliefRay ray, ReliefWalk walk, vec4 corners) {
    vec2 place = reliefPlaceInCell(walk, walk.t);
    vec2 slope = vec2(corners.z, corners.x) - corners.w;
    float twist = (corners.y - corners.x) - slope.x;

    vec2 gradient = slope + twist * place.yx;
    float depth = corners.w + slope.x * place.x + gradient.y * place.y;
    return vec3(ray.origin.z + walk.t * ray.direction.z - depth,
                ray.direction.z - dot(gradient, walk.speed), -twist * walk.speed.x * walk.speed.y);
}

// The t at which the ray with this profile, above the surface where it enters the walk's cell, first
// meets the surface there; kReliefBoundless when it leaves the cell above it, or up to a rounding below.
// A ray that enters below the surface, which rounding may cause, meets it at once.
float reliefFirstMeeting(vec3 profile, ReliefWalk walk) {
    if (profile.x >= 0.0) return walk.t;
    float discriminant = profile.y * profile.y - 4.0 * profile.z * profile.x;
    if (discriminant < 0.0) return kReliefBoundless;
    // The first positive root in the form in which nothing cancels.
    float root = sqrt(discriminant);
    float numerator = profile.y >= 0.0 ? -2.0 * profile.x : root - profile.y;
    float denominator = profile.y >= 0.0 ? profile.y + root : 2.0 * profile.z;
    float s = denominator > 0.0 ? numerator / denominator : kReliefBoundless;
    return walk.t + s <= walk.exit ? walk.t + s : kReliefBoundless;
}

// The same from the map.
float reliefHitInCell(ReliefRay ray, ReliefWalk walk) {
    return reliefFirstMeeting(reliefProfile(ray, walk, reliefWalkCorners(walk)), walk);
}

// All that is left of a ray is free.
ReliefHit reliefAtEnd(ReliefRay ray, int steps) {
    return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, steps);
}
