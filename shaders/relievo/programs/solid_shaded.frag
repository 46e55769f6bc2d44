// A shaded solid that writes the depth of its hits.
#include "relievo/programs/solid_input.glsl"
#include "relievo/programs/srgb.glsl"
#include "relievo/shading.glsl"
#include "relievo/solid_material.glsl"
#ifdef RELIEVO_SOLID_RELIEF
#include "relievo/solid_relief.glsl"
#endif
#ifdef RELIEVO_SHADOW_MAP
#include "relievo/programs/shadow_map.glsl"
#endif

uniform vec3 toLight;

layout(location = 0) out vec4 color;

// `normal` is that of the solid, or of the relief on it.
vec3 shade(SolidTrace trace, SolidSurface surface, vec3 normal, vec3 view) {
    ReliefAppearance appearance = reliefAppearance(surface.uv, surface.uvX, surface.uvY, 1.0);
#ifdef RELIEVO_ALBEDO_MAP
    appearance.albedo *= surface.color;
#else
    appearance.albedo = surface.color;
#endif
    vec3 light = vec3(1.0);
#ifdef RELIEVO_SOLID_SHADOW
    if (!solidIsLit(trace, toLight)) light = vec3(0.0);
#endif
#ifdef RELIEVO_SHADOW_MAP
    light *= shadowMapVisibility(trace.position, trace.normal);
#endif
    return clamp(shadeRelief(appearance, normal, toLight, -view, light), 0.0, 1.0);
}

void main() {
    vec3 view = surfaceView();
    vec3 placeX = dFdx(surfacePosition);
    vec3 placeY = dFdy(surfacePosition);
    vec3 turnX = dFdx(view);
    vec3 turnY = dFdy(view);
    SolidTrace trace = solidInput();
#ifdef RELIEVO_MARK_EXHAUSTED
    if (trace.hit.outcome == RELIEVO_OUTCOME_EXHAUSTED) {
        color = vec4(1.0, 0.0, 1.0, 1.0);
        gl_FragDepth = gl_FragCoord.z;
        return;
    }
#endif
    if (!solidIsShown(trace)) discard;
    // From the fragment's place back to the beginning of the ray.
    float back = dot(trace.start - surfacePosition, view);
    SolidSurface surface =
        solidSurface(trace, view, placeX + back * turnX, placeY + back * turnY, turnX, turnY);
#ifdef RELIEVO_SOLID_RELIEF
    // To shadows and to the depth test it is its wall, which a shadow map has in it: what lies behind a wall
    // would be in its shadow, and things behind the solid would show through near its edges.
    SolidRelief relief = solidRelief(trace, surface, view);
    vec3 normal = relief.normal;
    surface.uv = relief.uv;
    reliefSelectLevel(0);
#else
    vec3 normal = trace.normal;
#endif
    color = vec4(toSrgb(shade(trace, surface, normal, view)), 1.0);
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
