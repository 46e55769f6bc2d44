// The distance between four texel centres of a shape map (textures/shape_map.h): bilinear, or where there is a
// crease the larger or the smaller one of two bilinear fields, the distances to both sides of a corner.
//
//   RELIEVO_SOLID_CREASED  maps may have creases. Then their channels are what steps go by, the distance less
//                          that (and RELIEVO_SOLID_CREASE more at texels with a crease), and the code of the
//                          crease. The last bit of the first says whether the others are not 0, so that they
//                          are looked up around corners only. Of maps without creases it may say so as well,
//                          and they are 0.
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
    uvec4 bits = floatBitsToUint(steps) & 1u;
    if (bits == uvec4(0u)) return SolidCell(steps, steps, true);
    ++reliefFetchCount;
    vec4 above = reliefGatherChannel(map, corner, 1);
    vec4 creased = step(RELIEVO_SOLID_LEAST_REFLEX, above);
    vec4 distances = steps + (above - RELIEVO_SOLID_CREASE * creased);
    if (creased == vec4(0.0)) return SolidCell(distances, distances, true);
    ++reliefFetchCount;
    vec4 codes = reliefGatherChannel(map, corner, 2);
    bool isReflex = any(greaterThanEqual(abs(codes), vec4(RELIEVO_SOLID_LEAST_REFLEX)));
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

#ifdef RELIEVO_SOLID_CREASED
// In a cell with a crease the direction in which the distance grows, (u, v) being in tiles: that of the side that
// the place is on. False, without a direction: there is no crease.
bool solidCornerGradient(sampler2D map, vec2 uv, out vec2 gradient) {
    vec2 size = vec2(textureSize(map, 0));
    vec2 place = uv * size - 0.5;
    vec2 corner = (floor(place) + 1.0) / size;
    place = fract(place);
    gradient = vec2(0.0);
    ++reliefFetchCount;
    vec4 steps = reliefGather(map, corner);
    SolidCell cell = solidCell(map, corner, steps);
    if (cell.first == cell.second) return false;
    vec4 weights = vec4(1.0 - place.x, place.x, place.x, 1.0 - place.x) * vec4(place.yy, 1.0 - place.yy);
    vec4 field = solidIsFirst(cell, dot(weights, cell.first), dot(weights, cell.second)) ? cell.first : cell.second;
    vec2 along = mix(vec2(field.z, field.x) - field.w, field.yy - vec2(field.x, field.z), place.yx);
    gradient = along / max(length(along), 1e-6);
    return true;
}
#endif

// By how much distances may be above what steps go by.
float solidCreaseDepth(int part) {
#ifdef RELIEVO_SOLID_CREASED
    return solidParts[part].windowMinimum.w;
#else
    return 0.0;
#endif
}
