// What a search returned for every pixel, with the ray that it was given, for comparison with the
// exact hit of the same ray; and likewise for the light there.
#include "relievo/light.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"

uniform mat4 viewProjection;
uniform vec3 toLight;
uniform float lightRadius;

layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;
layout(location = RELIEVO_OUTPUT_LIGHT) out vec4 lightOutput;
layout(location = RELIEVO_OUTPUT_LIFT) out vec4 liftOutput;
layout(location = RELIEVO_OUTPUT_SIDE) out vec4 sideOutput;

void measureLight(ReliefHit hit) {
    ReliefLight light = makeReliefLight(surfaceInput(), hit.position, toLight, lightRadius);
    float share = 1.0;
    int before = reliefFetchCount;
#ifdef RELIEVO_SHADOW
    if (hit.outcome == RELIEVO_OUTCOME_HIT) share = reliefVisibility(light);
#endif
    lightOutput = vec4(light.direction, share);
    liftOutput = vec4(light.lift, float(reliefFetchCount - before));
    sideOutput = vec4(light.side, 0.0);
}

void main() {
    ReliefFragment relief = traceRelief(surfaceInput(), surfaceView());
    measureLight(relief.hit);
    hitOutput = vec4(relief.hit.position, relief.hit.t);
    workOutput = vec4(float(relief.hit.outcome), float(relief.hit.steps),
                      float(relief.hit.fetches), 1.0);
    originOutput = vec4(relief.ray.origin, relief.ray.end);
    directionOutput = vec4(relief.ray.direction, relief.ray.worldLength);
    normalOutput = vec4(relief.tileNormal, 0.0);
    gl_FragDepth = reliefWindowDepth(relief.hit, relief.position, viewProjection);
}
