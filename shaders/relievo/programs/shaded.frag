// A shaded relief that writes the depth of its hits.
#include "relievo/material.glsl"
#include "relievo/shading.glsl"
#include "relievo/programs/srgb.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"

uniform mat4 viewProjection;
uniform vec3 toLight;
#ifdef RELIEVO_SHADOW
uniform float lightRadius;  // radians
#endif

layout(location = 0) out vec4 color;

void main() {
    vec2 uvX = dFdx(surfaceUv);
    vec2 uvY = dFdy(surfaceUv);
    vec3 view = surfaceView();
    ReliefFragment relief = traceRelief(surfaceInput(), view);
    // Outside the window there is no relief, and a search that ran out has found none: what it would
    // shade is not a hit.
    if (relief.hit.outcome == RELIEVO_OUTCOME_MISS) discard;
#ifndef RELIEVO_MARK_EXHAUSTED
    if (relief.hit.outcome == RELIEVO_OUTCOME_EXHAUSTED) discard;
#endif

    ReliefAppearance appearance =
        reliefAppearance(relief.hit.position.xy, uvX, uvY, relievoDepthScale);
    vec3 light = vec3(1.0);
#ifdef RELIEVO_SHADOW
    light *= reliefVisibility(
        makeReliefLight(surfaceInput(), relief.hit.position, toLight, lightRadius));
#endif
    vec3 shaded = shadeRelief(appearance, relief.normal, toLight, -view, light);
#ifdef RELIEVO_MARK_EXHAUSTED
    if (relief.hit.outcome == RELIEVO_OUTCOME_EXHAUSTED) shaded = vec3(1.0, 0.0, 1.0);
#endif
    color = vec4(toSrgb(clamp(shaded, 0.0, 1.0)), 1.0);
    gl_FragDepth = reliefWindowDepth(relief.hit, relief.position, viewProjection);
}
