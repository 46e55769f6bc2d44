// A mesh without a relief.
#include "relievo/shading.glsl"
#include "relievo/programs/srgb.glsl"
#include "relievo/programs/surface_input.glsl"
#ifdef RELIEVO_SHADOW_MAP
#include "relievo/programs/shadow_map.glsl"
#endif

uniform vec3 toLight;
uniform vec3 plainColor;

layout(location = 0) out vec4 color;

void main() {
    vec3 light = vec3(1.0);
#ifdef RELIEVO_SHADOW_MAP
    light *= shadowMapVisibility(surfacePosition);
#endif
    ReliefAppearance appearance =
        reliefAppearance(surfaceUv, dFdx(surfaceUv), dFdy(surfaceUv), 1.0);
#ifdef RELIEVO_ALBEDO_MAP
    appearance.albedo *= plainColor;
#else
    appearance.albedo = plainColor;
#endif
    vec3 shaded =
        shadeRelief(appearance, normalize(surfaceNormal), toLight, -surfaceView(), light);
    color = vec4(toSrgb(clamp(shaded, 0.0, 1.0)), 1.0);
}
