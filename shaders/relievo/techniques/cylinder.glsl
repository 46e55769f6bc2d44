// Cylinder tracing: within the radius of a texel's cylinder a ray pierces the relief at most once, so it may
// go that far, and binary search finds the crossing (Baboud, Décoret 2006). The radii of the map hold on
// the bilinear surface, but for dips more shallow than its tolerance.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/skip.glsl"
#include "relievo/search/binary.glsl"

uniform sampler2D relievoCylinderMap;  // radius in tile widths

float reliefFreeLength(ReliefRay ray, vec3 point) {
    ++reliefFetchCount;
    float radius = textureLod(relievoCylinderMap, point.xy, float(reliefLevel)).r;
    return ray.speed > 0.0 ? radius / ray.speed : RELIEVO_MAXIMUM_REACH;
}
