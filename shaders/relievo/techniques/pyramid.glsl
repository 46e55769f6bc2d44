// The first hit with the bilinear surface itself, by a pyramid of least depths (Oh, Ki, Lee 2006; Tevs,
// Ihrke, Seidel 2008): for maps without roof cones.
//
// A node of the pyramid is a square of cells and the least depth in it. A ray that leaves the node before
// it is as deep goes on in the next node, a level up; otherwise it comes down to that depth, and a level
// down. In a single cell the quadratic is solved, so that the hit is computed and not approached.
//
// Error: float rounding. Cost: a lookup for every node, a second one in every cell that is solved; about
// twice those of techniques/exact.glsl.
// It stays in the first MIP level: the levels of its texture are sizes of nodes.
#define RELIEVO_BASE_LEVEL
#include "relievo/search/cells.glsl"

uniform sampler2D relievoPyramidMap;  // level k: nodes of 2ᵏ × 2ᵏ cells
uniform int relievoPyramidSteps;

// The node of a level that holds a cell, along one axis, and how many of its cells lie before that one
// and after it, the way cells are counted.
struct ReliefNodeSpan {
    int node;
    int before;
    int after;
};

// Level cells between a tile and what lies beyond it, in clamped and mirrored maps, are nodes of their own.
ReliefNodeSpan reliefNodeSpan(int cell, int size, int level) {
    int texel = cell;
    bool isReversed = false;
#if defined(RELIEVO_WRAP_CLAMP)
    if (cell < 0) return ReliefNodeSpan(0, 0, 0);
#elif defined(RELIEVO_WRAP_MIRROR)
    texel = reliefModulo(cell, 2 * size);
    if (texel == 2 * size - 1) return ReliefNodeSpan(0, 0, 0);
    isReversed = texel >= size;
    if (isReversed) texel = 2 * size - 2 - texel;
#else
    texel = reliefModulo(cell, size);
#endif
    int node = texel >> level;
    int first = node << level;
    int last = min(first + (1 << level), size) - 1;
    return isReversed ? ReliefNodeSpan(node, last - texel, texel - first)
                      : ReliefNodeSpan(node, texel - first, last - texel);
}

// On to what follows at t, in any case out of the current cell.
void reliefLeave(inout ReliefWalk walk, float t) {
    if (t > walk.exit) {
        reliefJumpWalk(walk, t);
    } else {
        reliefStepWalk(walk);
    }
}

ReliefHit searchRelief(ReliefRay ray) {
    ivec2 size = reliefMapSize();
    // The sizes of the pyramid are powers of two.
    vec2 nodes = vec2(textureSize(relievoPyramidMap, 0));
    int top = int(round(log2(max(nodes.x, nodes.y))));
    int level = top;
    ReliefWalk walk = reliefBeginWalk(ray);
    for (int steps = 1; steps <= relievoPyramidSteps; ++steps) {
        ++reliefFetchCount;
        ivec2 cell = reliefWalkCell(walk);
        ReliefNodeSpan across = reliefNodeSpan(cell.x, size.x, level);
        ReliefNodeSpan down = reliefNodeSpan(cell.y, size.y, level);
        float least = texelFetch(relievoPyramidMap, ivec2(across.node, down.node), level).r;
        vec2 exits = reliefSpanExits(walk, ivec2(across.before, down.before),
                                     ivec2(across.after, down.after));
        float exit = max(min(exits.x, exits.y), walk.t);

        float z = ray.origin.z + walk.t * ray.direction.z;
        float under = z >= least ? walk.t
                      : ray.direction.z > 0.0 ? walk.t + (least - z) / ray.direction.z
                                              : kReliefNever;
        if (min(under, exit) >= ray.end) return reliefAtEnd(ray, steps);
        if (under > exit) {
            reliefLeave(walk, exit);
            level = min(level + 1, top);
        } else if (level > 0) {
            if (under > walk.t) reliefJumpWalk(walk, under);
            --level;
        } else {
            float hit = reliefHitInCell(ray, walk);
            if (hit <= ray.end) return reliefResult(ray, hit, RELIEVO_OUTCOME_HIT, steps);
            if (walk.exit >= ray.end) return reliefAtEnd(ray, steps);
            reliefStepWalk(walk);
            level = min(1, top);
        }
    }
    return reliefResult(ray, walk.t, RELIEVO_OUTCOME_EXHAUSTED, relievoPyramidSteps);
}
