// What a pixel covers of a surface, and the MIP level of a relief that belongs to it.
#include "relievo/level.glsl"
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

// The ellipse that a pixel covers, in tile widths in the metric. Across the view it is as wide as the
// pixel itself, along the view it is longer the more the view grazes the surface.
struct ReliefFootprint {
    float longest;
    float shortest;  // the size of a pixel at the surface, whatever the angle
    float rounding;  // what is added to the level of the pixel before it is rounded down; ½: the nearest
};

// The singular values of ∂(u, ρ·v)/∂(x, y) on the screen, for the derivatives of uv along x and along y.
ReliefFootprint reliefFootprint(vec2 uvX, vec2 uvY, float aspect) {
    vec2 across = uvX * vec2(1.0, aspect);
    vec2 down = uvY * vec2(1.0, aspect);
    float squares = dot(across, across) + dot(down, down);
    float area = abs(across.x * down.y - across.y * down.x);
    float difference = sqrt(max((squares - 2.0 * area) * (squares + 2.0 * area), 0.0));
    float longest = sqrt(0.5 * (squares + difference));
    return ReliefFootprint(longest, longest > 0.0 ? area / longest : 0.0, 0.5);
}

// The same of the fragment at hand. To be called where neighbouring pixels come by too (outside of branches
// that they may not take): it compares their uv.
ReliefFootprint reliefFootprint(vec2 uv, float aspect) { return reliefFootprint(dFdx(uv), dFdy(uv), aspect); }

// The unit direction on the screen, in pixels, in which the footprint is longest; any where it is round.
vec2 reliefLongestDirection(vec2 uv, float aspect) {
    vec2 across = dFdx(uv) * vec2(1.0, aspect);
    vec2 down = dFdy(uv) * vec2(1.0, aspect);
    // The major axis of JᵀJ turns by half the angle of (difference, 2·off-diagonal).
    float angle = 0.5 * atan(2.0 * dot(across, down), dot(across, across) - dot(down, down));
    return vec2(cos(angle), sin(angle));
}

// How many pixels a depth of 1 is long where it is seen from the side.
float reliefPixelsPerDepth(ReliefFootprint footprint, float depthScale) {
    return min(depthScale / max(footprint.shortest, 1e-30), kReliefBoundless);
}

#ifdef RELIEVO_MIPS
uniform vec2 relievoLevels;  // the first and the last level that may be used

// The level whose texels are between a quarter of a pixel and half of one across the view, from the middle of
// that range: a search takes the nearest level, shading may mix two. With the rays that a pixel takes
// (relievo/pixel_rays.glsl) larger texels would be no steadier, and what stands up in them hides less of what
// is behind it. Nor must the level follow the footprint along the view, where a grazing one is longer.
float reliefLevelFor(ReliefFootprint footprint) {
    float texels = footprint.shortest * float(textureSize(relievoDepthMap, 0).x);
    return clamp(log2(max(texels, 1e-30)) - 1.5, relievoLevels.x, relievoLevels.y);
}
#else
float reliefLevelFor(ReliefFootprint footprint) { return 0.0; }
#endif
