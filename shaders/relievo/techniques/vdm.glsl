// View-dependent displacement mapping: how deep a ray hits the relief is looked up by its azimuth and
// elevation, and by where it enters the tile (Wang, Wang, Tong, Lin, Hu, Guo, Shum 2003), over a plane base. The
// table is a sum of products as there: factors of a texel and an azimuth, weights of an elevation.
//
// Between texels, azimuths and elevations it is interpolated, and so it is off where neighbouring rays hit
// different things; below the lowest elevation it stays as it is there. No loop over the ray: the time does
// not depend on the relief.
#include "relievo/search/result.glsl"

uniform sampler2DArray relievoDisplacementMap;  // four factors a texel; the layers of an azimuth together
uniform sampler2D relievoDisplacementWeights;   // four weights a texel, a row for each elevation
uniform float relievoDisplacementScale;         // a of the relief for which it was made

// The normalised depth of the hit of a ray that enters the relief at uv. `way` is the horizontal part of its
// direction in the metric, `elevation` its angle with the surface at the table's scale, in units of 90°.
float reliefDisplacement(vec2 uv, vec2 way, float elevation) {
    ivec2 weights = textureSize(relievoDisplacementWeights, 0);
    float azimuths = float(textureSize(relievoDisplacementMap, 0).z / weights.x);
    const float turn = 6.283185307;
    float azimuth = fract(way == vec2(0.0) ? 0.0 : atan(way.y, way.x) / turn) * azimuths;
    float first = floor(azimuth);
    // fract may be rounded up to 1.
    vec2 layers = mod(vec2(first, first + 1.0), azimuths) * float(weights.x);
    // The rows are those of the elevations 1/n, 2/n … 1.
    float row = elevation - 0.5 / float(weights.y);
    float depth = 0.0;
    for (int group = 0; group < weights.x; ++group) {
        reliefFetchCount += 3;
        vec2 place = vec2((float(group) + 0.5) / float(weights.x), row);
        vec4 low = textureLod(relievoDisplacementMap, vec3(uv, layers.x + float(group)), float(reliefLevel));
        vec4 high = textureLod(relievoDisplacementMap, vec3(uv, layers.y + float(group)), float(reliefLevel));
        depth += dot(textureLod(relievoDisplacementWeights, place, 0.0),
                     mix(low, high, azimuth - first));
    }
    return clamp(depth, 0.0, 1.0);
}

ReliefHit searchRelief(ReliefRay ray) {
    if (ray.direction.z <= 0.0) return reliefResult(ray, ray.end, RELIEVO_OUTCOME_MISS, 1);
    // A ray that begins below the surface is looked up where it would have entered.
    float entry = max(-ray.origin.z / ray.direction.z, -RELIEVO_MAXIMUM_REACH);
    vec2 uv = reliefPoint(ray, entry).xy;
    vec2 way = vec2(ray.direction.x, reliefAspect() * ray.direction.y);
#ifdef RELIEVO_WRAP_MIRROR
    way *= 1.0 - 2.0 * mod(floor(uv), 2.0);
#endif
    const float rightAngle = 1.570796327;
    float elevation = atan(relievoDisplacementScale * ray.direction.z, ray.speed) / rightAngle;
    float t = entry + reliefDisplacement(uv, way, elevation) / ray.direction.z;
    return reliefHitWithin(ray, t, 1);
}
