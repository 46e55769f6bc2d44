// The way of a ray through a pyramid of least depths. A node of the pyramid is a square of cells and the
// least depth in it. A ray that leaves the node before it is as deep goes on in the next node, a level up;
// otherwise it comes down to that depth, and a level down. What it
// meets in a single cell is for the file that includes this one to say.
//
// It stays in the first MIP level: the levels of its texture are sizes of nodes.
#define RELIEVO_BASE_LEVEL
#include "relievo/search/cells.glsl"

uniform sampler2D relievoPyramidMap;  // level k: nodes of 2ᵏ × 2ᵏ cells
uniform int relievoPyramidSteps;

// The t at which the ray hits the relief within the walk's cell, in which it is no higher than the highest
// corner from `under` to `exit`; kReliefBoundless when it does not.
float reliefHitInLeaf(ReliefRay ray, ReliefWalk walk, float under, float exit);

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

// The t from which the ray, in the walk's cell, is as deep as its node of a level, and that at which it
// leaves the node; both are not before walk.t.
struct ReliefNode {
    float under;
    float exit;
};

ReliefNode reliefNode(ReliefRay ray, ReliefWalk walk, int level) {
    ++reliefFetchCount;
    ivec2 size = reliefMapSize();
    ivec2 cell = reliefWalkCell(walk);
    ReliefNodeSpan across = reliefNodeSpan(cell.x, size.x, level);
    ReliefNodeSpan down = reliefNodeSpan(cell.y, size.y, level);
    float least = texelFetch(relievoPyramidMap, ivec2(across.node, down.node), level).r;
    vec2 exits = reliefSpanExits(walk, ivec2(across.before, down.before),
                                 ivec2(across.after, down.after));
    float z = ray.origin.z + walk.t * ray.direction.z;
    float under = z >= least              ? walk.t
                  : ray.direction.z > 0.0 ? walk.t + (least - z) / ray.direction.z
                                          : kReliefBoundless;
    return ReliefNode(under, max(min(exits.x, exits.y), walk.t));
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
    // The sizes of the pyramid are powers of two.
    vec2 nodes = vec2(textureSize(relievoPyramidMap, 0));
    int top = int(round(log2(max(nodes.x, nodes.y))));
    int level = top;
    ReliefWalk walk = reliefBeginWalk(ray);
    for (int steps = 1; steps <= relievoPyramidSteps; ++steps) {
        ReliefNode node = reliefNode(ray, walk, level);
        bool isEntered = node.under <= node.exit;
        if (isEntered && level > 0 && node.under < ray.end) {
            if (node.under > walk.t) reliefJumpWalk(walk, node.under);
            --level;
            continue;
        }
        if (isEntered) {
            float hit = reliefHitInLeaf(ray, walk, node.under, node.exit);
            if (hit <= ray.end) return reliefResult(ray, hit, RELIEVO_OUTCOME_HIT, steps);
        }
        if (node.exit >= ray.end) return reliefAtEnd(ray, steps);
        reliefLeave(walk, node.exit);
        level = min(level + 1, top);
    }
    return reliefResult(ray, walk.t, RELIEVO_OUTCOME_EXHAUSTED, relievoPyramidSteps);
}
