// What a search returned for every pixel, with the ray that it was given, for comparison with the
// exact hit of the same ray.
#include "relievo/material.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"

uniform mat4 viewProjection;

layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;

void main() {
    ReliefFragment relief = traceRelief(surfaceInput(), surfaceView());
    hitOutput = vec4(relief.hit.position, relief.hit.t);
    workOutput = vec4(float(relief.hit.outcome), float(relief.hit.steps),
                      float(relief.hit.fetches), 1.0);
    originOutput = vec4(relief.ray.origin, relief.ray.end);
    directionOutput = vec4(relief.ray.direction, relief.ray.worldLength);
    normalOutput = vec4(relief.tileNormal, 0.0);
    gl_FragDepth = reliefWindowDepth(relief.hit, relief.position, viewProjection);
}
