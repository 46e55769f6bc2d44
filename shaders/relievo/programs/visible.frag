// What each pixel of a frame shows, instead of its colour, and the lookups of all searches of the frame
// together: those of fragments that are hidden later, too, which no sum over the pixels would have.
#include "relievo/programs/surface_input.glsl"
#ifndef RELIEVO_PLAIN
// Of reliefs and of solids: a file is included where it comes first, which must be in neither branch alone.
#include "relievo/window_depth.glsl"
#include "relievo/programs/depth_output.glsl"
#endif
#if defined(RELIEVO_SOLID)
#include "relievo/programs/solid_input.glsl"
#elif !defined(RELIEVO_PLAIN)
#include "relievo/trace.glsl"
#endif
#ifdef RELIEVO_SHADOW_MAP
#include "relievo/programs/shadow_map.glsl"
#endif

uniform int objectNumber;

layout(location = RELIEVO_VISIBLE_POINT) out vec4 pointOutput;
layout(location = RELIEVO_VISIBLE_LIGHT) out vec4 lightOutput;

void show(vec3 position) {
    pointOutput = vec4(position, float(objectNumber + 1));
#ifdef RELIEVO_SHADOW_MAP
    lightOutput = vec4(shadowMapVisibility(position));
#else
    lightOutput = vec4(1.0);
#endif
}

#ifdef RELIEVO_PLAIN
void main() { show(surfacePosition); }
#else
layout(std430, binding = RELIEVO_BUFFER_LOOKUPS) buffer Lookups {
    uint lookupsLow;
    uint lookupsHigh;
};

void countLookups(uint count) {
    uint before = atomicAdd(lookupsLow, count);
    if (before + count < before) atomicAdd(lookupsHigh, 1u);
}

#ifdef RELIEVO_SOLID
void main() {
    SolidTrace trace = solidInput();
    countLookups(uint(trace.hit.fetches));
    if (trace.hit.outcome != RELIEVO_OUTCOME_HIT) discard;
    show(trace.position);
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
#else
uniform mat4 viewProjection;

void main() {
    ReliefTrace trace = reliefTrace(surfaceInput(), surfaceView());
    countLookups(uint(trace.hit.fetches));
    if (trace.hit.outcome != RELIEVO_OUTCOME_HIT) discard;
    show(trace.position);
    gl_FragDepth = reliefWindowDepth(trace.hit, trace.position, viewProjection);
}
#endif
#endif
