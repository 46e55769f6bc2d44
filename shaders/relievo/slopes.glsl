// Slopes of the relief, from one of three sources. Which one does not depend on the search: the text
// defines it (materials/slope_sources.h), and a program reads no other map for them.
//
// What is common to all of them is reliefGradient: ∂D/∂u, ∂D/∂v in the metric at a = 1. The depth scale
// comes in afterwards, so that shading follows it whatever the source (specification 5).
#include "relievo/maps.glsl"

#if defined(RELIEVO_SLOPES_FROM_NORMAL)
uniform sampler2D relievoNormalMap;  // nx, ny, nz at the depth scale below, linear filter
uniform float relievoNormalScale;    // a0, above 0
#elif !defined(RELIEVO_SLOPES_FROM_HEIGHT)
uniform sampler2D relievoDerivativeMap;  // ∂D/∂u, ∂D/∂v in the metric at a = 1, linear filter
#endif

// What a lookup of slopes in a level is to be multiplied by on each axis. In a mirrored tile slopes along the
// mirrored axis are reversed, and between the last texel of a tile and the same texel beyond the border, half
// a texel away each, they pass through 0. Beyond the border of a clamped map there are none: they fade out
// from the last texel to the same texel beyond.
vec2 reliefTileSense(vec2 uv, int level) {
    vec2 size = vec2(textureSize(relievoDepthMap, level));
#if defined(RELIEVO_WRAP_MIRROR)
    vec2 tile = floor(uv);
    vec2 border = min(uv - tile, 1.0 - (uv - tile)) * size;
    return (1.0 - 2.0 * mod(tile, 2.0)) * min(2.0 * border, 1.0);
#elif defined(RELIEVO_WRAP_CLAMP)
    return clamp(min(uv, 1.0 - uv) * size + 0.5, 0.0, 1.0);
#else
    return vec2(1.0);
#endif
}

// Gradient of D as filtered for a level, which may lie between two.
#if defined(RELIEVO_SLOPES_FROM_NORMAL)
// The slopes of a stored normal: (nx, ny)/nz at a0. It is rescaled by a/a0 when a comes in.
vec2 reliefGradient(vec2 uv, float level) {
    ++reliefFetchCount;
    vec3 normal = textureLod(relievoNormalMap, uv, level).rgb;
    // A relief has no vertical walls. Where nz was rounded to 0, half a step of 16 bits is left of it.
    float up = max(normal.z, 0.5 / 65535.0);
    return reliefTileSense(uv, int(level)) * normal.xy / (relievoNormalScale * up);
}
#elif defined(RELIEVO_SLOPES_FROM_HEIGHT)
float reliefDepthDifference(vec2 uv, vec2 offset, int level) {
    reliefFetchCount += 2;
    return textureLod(relievoDepthMap, uv + offset, float(level)).r -
           textureLod(relievoDepthMap, uv - offset, float(level)).r;
}

// Central differences of the depths (Blinn 1978), a texel to each side. Being linear in the depths, they
// are between the texels what a derivative map filtered linearly is: the picture is the same without the
// map. The slopes of the bilinear patch itself would need one gather only, but they jump at the borders of
// the patches, and every texel would show as a facet.
vec2 reliefDifferences(vec2 uv, int level) {
    vec2 size = vec2(textureSize(relievoDepthMap, level));
    vec2 differences = vec2(reliefDepthDifference(uv, vec2(1.0 / size.x, 0.0), level),
                            reliefDepthDifference(uv, vec2(0.0, 1.0 / size.y), level));
    return 0.5 * size * differences / vec2(1.0, reliefAspect());
}

vec2 reliefGradient(vec2 uv, float level) {
    int finer = int(level);
    vec2 gradient = reliefDifferences(uv, finer);
#ifdef RELIEVO_MIPS
    float share = level - float(finer);
    if (share > 0.0) gradient = mix(gradient, reliefDifferences(uv, finer + 1), share);
#endif
    return gradient;
}
#else
vec2 reliefGradient(vec2 uv, float level) {
    ++reliefFetchCount;
    return reliefTileSense(uv, int(level)) * textureLod(relievoDerivativeMap, uv, level).rg;
}
#endif

// That of the level that is searched.
vec2 reliefGradient(vec2 uv) { return reliefGradient(uv, float(reliefLevel)); }
