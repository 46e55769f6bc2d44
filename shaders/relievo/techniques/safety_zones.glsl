// Dilation and erosion: each texel holds the least and the greatest depth around it, and above the least one
// a ray may go to the border of that zone, or down to that depth (Kolb, Rezk-Salama 2005). Between the two
// depths least steps are taken, and binary search within the one that pierced the surface.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/skip.glsl"
#include "relievo/search/binary.glsl"

uniform sampler2D relievoExtremaMap;  // least and greatest depth within the reach, along both axes
uniform int relievoReach;             // texels

float reliefFreeLength(ReliefRay ray, vec3 point) {
    ++reliefFetchCount;
    float least = textureLod(relievoExtremaMap, point.xy, float(reliefLevel)).r;
    if (point.z >= least) return 0.0;
    float under = ray.direction.z > 0.0 ? (least - point.z) / ray.direction.z
                                        : RELIEVO_MAXIMUM_REACH;
    vec2 size = vec2(reliefMapSize());
    vec2 texel = floor(point.xy * size) + 0.5;
    vec2 low = (texel - float(relievoReach)) / size;
    vec2 high = (texel + float(relievoReach)) / size;
    float across = reliefAxisExit(point.x, ray.direction.x, low.x, high.x);
    float down = reliefAxisExit(point.y, ray.direction.y, low.y, high.y);
    return min(under, min(across, down));
}
