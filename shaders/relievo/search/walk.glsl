// The walk of a ray over the bilinear cells of a map.
//
// Cell (i,j) is the patch between the texel centres i and i+1, j and j+1. The walk keeps it as a pair
// of integers that only ever moves forward along the ray: to find the cell again from a point near its
// border may give the cell before, for ever. Texel coordinates count from the first cell, so that a
// ray that begins far from the map's first tile is as accurate as one that begins in it.
#include "relievo/ray.glsl"

struct ReliefWalk {
    vec2 start;     // the ray's origin in texels from the first cell, in [0,1)² but in a clamped map
    vec2 speed;     // texels per unit of t
    ivec2 first;    // the first cell, counted from the tile of the origin
    ivec2 advance;  // cells from the first to the current one
    ivec2 size;     // of the map, in texels
    bool isClamped;  // outside of its tile one cell reaches to infinity
    float t;        // where the ray enters the current cell
    float exit;     // where it leaves that cell, ≥ t
};

ivec2 reliefWalkCell(ReliefWalk walk) { return walk.first + walk.advance; }

// The t at which the walk's ray leaves the cells from `before` before cell number `cell` to `after` after it, `advance` from the
// first one, along an axis of `size` texels.
float reliefSpanExit(bool isClamped, int advance, int cell, int size, int before, int after, float start,
                     float speed) {
    bool isForward = speed > 0.0;
    if (isClamped && (isForward ? cell >= size - 1 : cell < 0)) return kReliefBoundless;
    int border = isForward ? advance + after + 1 : advance - before;
    return speed == 0.0 ? kReliefBoundless : (float(border) - start) / speed;
}

// The t at which the walk's ray leaves the cells from `before` before the current one to `after` after it,
// along each axis.
vec2 reliefSpanExits(ReliefWalk walk, ivec2 before, ivec2 after) {
    ivec2 cell = reliefWalkCell(walk);
    return vec2(reliefSpanExit(walk.isClamped, walk.advance.x, cell.x, walk.size.x, before.x, after.x,
                               walk.start.x, walk.speed.x),
                reliefSpanExit(walk.isClamped, walk.advance.y, cell.y, walk.size.y, before.y, after.y,
                               walk.start.y, walk.speed.y));
}

void reliefFindExit(inout ReliefWalk walk) {
    vec2 exits = reliefSpanExits(walk, ivec2(0), ivec2(0));
    walk.exit = max(min(exits.x, exits.y), walk.t);
}

// The walk over a map of `size` texels from the point at t = 0 of a ray in its tiles.
ReliefWalk reliefBeginWalk(vec2 origin, vec2 direction, ivec2 size, bool isClamped) {
    // An even one: a mirrored map looks the same from there.
    vec2 tile = isClamped ? vec2(0.0) : 2.0 * floor(0.5 * origin);
    vec2 texels = (origin - tile) * vec2(size);
    vec2 cell = floor(texels - 0.5);
    if (isClamped) cell = clamp(cell, vec2(-1.0), vec2(size - 1));
    // In this order the differences are exact, or of less than a texel.
    ReliefWalk walk = ReliefWalk((texels - cell) - 0.5, direction * vec2(size), ivec2(cell), ivec2(0), size,
                                 isClamped, 0.0, 0.0);
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
    if (walk.isClamped)
        walk.advance = clamp(reliefWalkCell(walk), ivec2(-1), walk.size - 1) - walk.first;
    walk.t = t;
    reliefFindExit(walk);
}

// Where textureGather takes the texels of the walk's cell: the corner that they share.
vec2 reliefWalkGather(ReliefWalk walk) { return vec2(reliefWalkCell(walk) + 1) / vec2(walk.size); }

// Where the walk's ray is in its cell, in [0,1]², at a t between where it enters and where it leaves.
vec2 reliefPlaceInCell(ReliefWalk walk, float t) {
    return clamp(walk.start + t * walk.speed - vec2(walk.advance), 0.0, 1.0);
}

// The bilinear interpolation of a cell's corners, in the order of textureGather (0,1), (1,1), (1,0), (0,0),
// along the walk's ray: x + y·s + z·s², s counted from where the ray enters the cell.
vec3 reliefAlongCell(ReliefWalk walk, vec4 corners) {
    vec2 place = reliefPlaceInCell(walk, walk.t);
    vec2 slope = vec2(corners.z, corners.x) - corners.w;
    float twist = (corners.y - corners.x) - slope.x;
    vec2 gradient = slope + twist * place.yx;
    return vec3(corners.w + slope.x * place.x + gradient.y * place.y, dot(gradient, walk.speed),
                twist * walk.speed.x * walk.speed.y);
}
