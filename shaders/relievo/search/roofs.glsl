// Roof cones (specification 3.6; ours): where a ray first meets the bilinear surface.
//
// Each cell of the map has a roof, the least depth of the cells around it (of those ahead of the ray,
// with a layer for each sector of directions), and the widest empty cone that stands on it. Above the
// roof the ray goes on to where it leaves the cone, or to where it comes down to the roof or leaves the
// block of cells, whichever is later. Below the roof the cell is solved: one gather and a quadratic.
// No step can pass a hit, and what is found is not approached but computed.
#include "relievo/search/cells.glsl"
#include "relievo/search/sector.glsl"

uniform sampler2DArray relievoRoofMap;  // roof and ratio of cell (i,j) at texel (i,j), a layer a sector
uniform int relievoRoofBlock;           // cells around, or ahead of, a cell whose roof it has
uniform int relievoExactSteps;

#ifdef RELIEVO_WRAP_MIRROR
// Where a mirrored map has cell number `cell` along an axis of `size` texels, and the direction in
// which that texel sees the ray: cells of mirrored copies lie between the same two texels in reverse,
// and the level cell before the first texel shares that texel's entry for rays into the tile.
int reliefMirroredCell(int cell, int size, inout float direction) {
    int place = reliefModulo(cell, 2 * size);
    if (place < size) return place;
    if (place == 2 * size - 1) {
        direction = abs(direction);
        return 0;
    }
    direction = -direction;
    return 2 * size - 2 - place;
}
#endif

// Roof and ratio for the walk's cell and the ray's direction.
vec2 reliefRoofCone(ReliefWalk walk) {
    ++reliefFetchCount;
    ivec3 size = textureSize(relievoRoofMap, reliefLevel);
    ivec2 cell = reliefWalkCell(walk);
#ifdef RELIEVO_WRAP_MIRROR
    vec2 direction = walk.speed;
    ivec2 texel = ivec2(reliefMirroredCell(cell.x, size.x, direction.x),
                        reliefMirroredCell(cell.y, size.y, direction.y));
    int layer = reliefSector(direction, size.z);
    return texelFetch(relievoRoofMap, ivec3(texel, layer), reliefLevel).rg;
#else
    vec2 uv = (vec2(cell) + 0.5) / vec2(size.xy);
    int layer = reliefSector(walk.speed, size.z);
    return textureLod(relievoRoofMap, vec3(uv, layer), float(reliefLevel)).rg;
#endif
}

// The t up to which nothing can stop the ray, which enters the walk's cell at depth z above the roof.
float reliefFreeUntil(ReliefRay ray, ReliefWalk walk, float z, float roof, float ratio) {
    float gap = roof - z;
    float closing = ray.speed + ratio * ray.direction.z;
    // A ray that rises as steeply as the cone never leaves it, one that does not come down never
    // reaches the roof.
    float cone = closing > 0.0 ? walk.t + ratio * gap / closing : kReliefBoundless;
    float under = ray.direction.z > 0.0 ? walk.t + gap / ray.direction.z : kReliefBoundless;
    vec2 block = reliefSpanExits(walk, ivec2(relievoRoofBlock), ivec2(relievoRoofBlock));
    return max(cone, min(under, min(block.x, block.y)));
}

// The first hit of the ray, a miss at its end, or the cell in which the steps ran out.
ReliefHit reliefSearchRoofs(ReliefRay ray) {
    ReliefWalk walk = reliefBeginWalk(ray);
    int steps = 0;
    while (steps < relievoExactSteps) {
        ++steps;
        vec2 cone = reliefRoofCone(walk);
        float z = ray.origin.z + walk.t * ray.direction.z;
        if (z < cone.x) {
            float free = reliefFreeUntil(ray, walk, z, cone.x, cone.y);
            if (free >= ray.end) return reliefAtEnd(ray, steps);
            if (free > walk.exit) {
                reliefJumpWalk(walk, free);
                continue;
            }
        }
        float hit = reliefHitInCell(ray, walk);
        if (hit <= ray.end) return reliefResult(ray, hit, RELIEVO_OUTCOME_HIT, steps);
        if (walk.exit >= ray.end) return reliefAtEnd(ray, steps);
        reliefStepWalk(walk);
    }
    return reliefResult(ray, walk.t, RELIEVO_OUTCOME_EXHAUSTED, steps);
}
