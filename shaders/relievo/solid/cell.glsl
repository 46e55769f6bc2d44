// The distance between four texel centres of a shape map (textures/shape_map.h): bilinear, or where there is a
// crease the larger or the smaller one of two bilinear fields, the distances to both sides of a corner.
//
//   RELIEVO_SOLID_CREASED  maps may have creases. Then their channels are what steps go by, the distance less
//                          that (and RELIEVO_SOLID_CREASE more at texels with a crease), and the code of the
//                          crease. Of maps without creases the last two are 0.
#include "relievo/fetches.glsl"
#include "relievo/platform.glsl"
#include "relievo/solid/block.glsl"

// Corners are in the order of textureGather.
struct SolidCell {
    vec4 first;
    vec4 second;
    bool isLarger;  // the larger one of both is the distance
};

// The cell around `corner`, in which steps go by `steps`.
SolidCell solidCell(sampler2D map, vec2 corner, vec4 steps) {
#ifdef RELIEVO_SOLID_CREASED
    ++reliefFetchCount;
    vec4 above = reliefGatherChannel(map, corner, 1);
    vec4 creased = step(RELIEVO_SOLID_CREASE, above);
    vec4 distances = steps + (above - RELIEVO_SOLID_CREASE * creased);
    if (creased == vec4(0.0)) return SolidCell(distances, distances, true);
    ++reliefFetchCount;
    vec4 codes = reliefGatherChannel(map, corner, 2);
    bool isReflex = any(greaterThanEqual(abs(codes), vec4(RELIEVO_SOLID_CREASE)));
    vec4 apart = max(abs(codes) - (isReflex ? RELIEVO_SOLID_CREASE : 0.0), 0.0);
    vec4 other = distances + (isReflex ? apart : -apart);
    return SolidCell(mix(distances, other, vec4(greaterThan(codes, vec4(0.0)))),
                     mix(distances, other, vec4(lessThan(codes, vec4(0.0)))), !isReflex);
#else
    return SolidCell(steps, steps, true);
#endif
}

// Which of two numbers is the distance.
bool solidIsFirst(SolidCell cell, float first, float second) { return (first > second) == cell.isLarger; }

// By how much distances may be above what steps go by.
float solidCreaseDepth(int part) {
#ifdef RELIEVO_SOLID_CREASED
    return solidParts[part].windowMinimum.w;
#else
    return 0.0;
#endif
}
