// What the search of a solid returned for every pixel, with the ray that it was given, in the space of the
// whole; the normal is that of the world.
#include "relievo/programs/solid_input.glsl"

layout(location = RELIEVO_OUTPUT_HIT) out vec4 hitOutput;
layout(location = RELIEVO_OUTPUT_WORK) out vec4 workOutput;
layout(location = RELIEVO_OUTPUT_ORIGIN) out vec4 originOutput;
layout(location = RELIEVO_OUTPUT_DIRECTION) out vec4 directionOutput;
layout(location = RELIEVO_OUTPUT_NORMAL) out vec4 normalOutput;
layout(location = RELIEVO_OUTPUT_LIGHT) out vec4 lightOutput;

uniform vec3 toLight;

void main() {
    SolidTrace trace = solidInput();
    hitOutput = vec4(trace.hit.position, trace.hit.t);
    workOutput = vec4(float(trace.hit.outcome), float(trace.hit.steps), float(trace.hit.fetches), 1.0);
    originOutput = vec4(trace.ray.origin, trace.ray.end);
    directionOutput = vec4(trace.ray.direction, 1.0);
    normalOutput = vec4(trace.normal, float(trace.hit.part));
    float share = 1.0;
    if (trace.hit.outcome == RELIEVO_OUTCOME_HIT && !solidIsLit(trace, toLight)) share = 0.0;
    lightOutput = vec4(trace.toWhole * toLight, share);
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
