// Shadows by a horizon map (Max 1988): each texel holds how steeply the relief rises before it in several
// directions. What stands above that, of the light, is seen; hard under a light that is a point.
//
// Error: the horizon is that of texel centres and of the azimuths in the map, and is interpolated between
// both; before the light it is taken to be level. Cost: two lookups, four beside the border of a mirrored
// tile.
#include "relievo/light.glsl"

uniform sampler2DArray relievoHorizonMap;  // greatest slopes, in depth per tile width; layer k of n is for
                                           // the azimuth 2πk/n from +u towards +v in the metric

// The slope of the horizon before texels around uv, along `direction` in the metric.
float reliefHorizonAlong(vec2 uv, vec2 direction) {
    float layers = float(textureSize(relievoHorizonMap, 0).z);
    float turn = any(notEqual(direction, vec2(0.0))) ? atan(direction.y, direction.x) / 6.28318531 : 0.0;
    float place = fract(turn) * layers;
    float before = floor(place);
    reliefFetchCount += 2;
    float low = textureLod(relievoHorizonMap, vec3(uv, mod(before, layers)), 0.0).r;
    float high = textureLod(relievoHorizonMap, vec3(uv, mod(before + 1.0, layers)), 0.0).r;
    return mix(low, high, place - before);
}

#ifdef RELIEVO_WRAP_MIRROR
// A mirrored tile sees the light of the mirrored direction. Within half a texel of a border the filter
// gives the same texel from both sides, which see it in different directions: `share` of the far one.
void reliefMirrorAxis(float coordinate, float size, inout float direction, out float share) {
    float tile = floor(coordinate);
    float border = min(coordinate - tile, 1.0 - (coordinate - tile)) * size;
    if (mod(tile, 2.0) > 0.5) direction = -direction;
    share = max(0.5 - border, 0.0);
}

float reliefHorizon(vec2 uv, vec2 direction) {
    vec2 size = vec2(textureSize(relievoHorizonMap, 0).xy);
    float acrossU, acrossV;
    reliefMirrorAxis(uv.x, size.x, direction.x, acrossU);
    reliefMirrorAxis(uv.y, size.y, direction.y, acrossV);
    float horizon = reliefHorizonAlong(uv, direction);
    // In the corner of a tile, where both meet, the nearer border counts.
    if (acrossU > acrossV)
        return mix(horizon, reliefHorizonAlong(uv, vec2(-direction.x, direction.y)), acrossU);
    if (acrossV > 0.0)
        return mix(horizon, reliefHorizonAlong(uv, vec2(direction.x, -direction.y)), acrossV);
    return horizon;
}
#else
float reliefHorizon(vec2 uv, vec2 direction) { return reliefHorizonAlong(uv, direction); }
#endif

float reliefVisibility(ReliefLight light) {
    vec2 metric = vec2(1.0, reliefAspect());
    vec2 across = metric * light.direction.xy;
    // The edge of a light that stands straight above is lower before where its lift comes from.
    if (dot(across, across) < 1e-12) across = -metric * light.lift.xy;
    float distance = length(across);
    vec2 ahead = distance > 0.0 ? across / distance : vec2(0.0);
    float horizon = reliefHorizon(light.point.xy, ahead);
    // How far the light is above the horizon: at its centre, and what the edge has more of that.
    float centre = -light.direction.z - horizon * dot(metric * light.direction.xy, ahead);
    float edge = -light.lift.z - horizon * dot(metric * light.lift.xy, ahead);
    if (edge <= 0.0) return centre > 0.0 ? 1.0 : 0.0;
    return reliefDiscBeyond(-centre / edge);
}
