// The distance between four texel centres of a shape map (textures/shape_map.h): bilinear, or where there is a
// crease the larger or the smaller one of two bilinear fields, the distances to both sides of a corner.
//
//   RELIEVO_SOLID_CREASED  maps may have creases. Around corners the first channel then has in the last bits of
//                          the distance how far below it what steps go by is, and whether the texel has a crease,
//                          whose code is in the second channel: that is looked up at creases only.
#include "relievo/fetches.glsl"
#include "relievo/platform.glsl"
#include "relievo/solid/block.glsl"

// By how much distances may be above what steps go by.
float solidCreaseDepth(int part) {
#ifdef RELIEVO_SOLID_CREASED
    return solidParts[part].windowMinimum.w;
#else
    return 0.0;
#endif
}

// What one lookup says of a cell. Corners are in the order of textureGather.
struct SolidSamples {
    vec4 distances;
    vec4 steps;  // what steps go by: no more than the distances
    bool isCreased;
};

SolidSamples solidLookUp(sampler2D map, int part, vec2 corner) {
    ++reliefFetchCount;
    vec4 texels = reliefGather(map, corner);
#ifdef RELIEVO_SOLID_CREASED
    uvec4 bits = floatBitsToUint(texels);
    uvec4 marks = bits & RELIEVO_SOLID_MARK_BITS * (bits & RELIEVO_SOLID_MARK_LOWERED);
    vec4 distances = uintBitsToFloat(bits ^ marks);
    vec4 share = vec4(marks / RELIEVO_SOLID_MARK_UNIT) / float(RELIEVO_SOLID_MARK_DEEPEST);
    return SolidSamples(distances, distances - solidCreaseDepth(part) * share,
                        any(notEqual(marks & RELIEVO_SOLID_MARK_CREASED, uvec4(0u))));
#else
    return SolidSamples(texels, texels, false);
#endif
}

struct SolidCell {
    vec4 first;
    vec4 second;
    bool isLarger;  // the larger one of both is the distance
};

// The cell around `corner`, of which that is known.
SolidCell solidCell(sampler2D map, vec2 corner, SolidSamples samples) {
    vec4 distances = samples.distances;
#ifdef RELIEVO_SOLID_CREASED
    if (samples.isCreased) {
        ++reliefFetchCount;
        vec4 codes = reliefGatherChannel(map, corner, 1);
        bool isReflex = any(greaterThanEqual(abs(codes), vec4(RELIEVO_SOLID_LEAST_REFLEX)));
        vec4 apart = max(abs(codes) - (isReflex ? RELIEVO_SOLID_CREASE : 0.0), 0.0);
        vec4 other = distances + (isReflex ? apart : -apart);
        return SolidCell(mix(distances, other, vec4(greaterThan(codes, vec4(0.0)))),
                         mix(distances, other, vec4(lessThan(codes, vec4(0.0)))), !isReflex);
    }
#endif
    return SolidCell(distances, distances, true);
}

// Which of two numbers is the distance.
bool solidIsFirst(SolidCell cell, float first, float second) { return (first > second) == cell.isLarger; }

#ifdef RELIEVO_SOLID_CREASED
// In a cell with a crease the direction in which the distance grows, (u, v) being in tiles: that of the side that
// the place is on. False, without a direction: there is no crease.
bool solidCornerGradient(sampler2D map, int part, vec2 uv, out vec2 gradient) {
    vec2 size = vec2(textureSize(map, 0));
    vec2 place = uv * size - 0.5;
    vec2 corner = (floor(place) + 1.0) / size;
    place = fract(place);
    gradient = vec2(0.0);
    SolidCell cell = solidCell(map, corner, solidLookUp(map, part, corner));
    if (cell.first == cell.second) return false;
    vec4 weights = vec4(1.0 - place.x, place.x, place.x, 1.0 - place.x) * vec4(place.yy, 1.0 - place.yy);
    vec4 field = solidIsFirst(cell, dot(weights, cell.first), dot(weights, cell.second)) ? cell.first : cell.second;
    vec2 along = mix(vec2(field.z, field.x) - field.w, field.yy - vec2(field.x, field.z), place.yx);
    gradient = along / max(length(along), 1e-6);
    return true;
}
#endif
