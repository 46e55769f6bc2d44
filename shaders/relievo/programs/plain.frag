// A mesh without a relief, shaded with Blinn–Phong.
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
    vec3 shaded = shadeRelief(ReliefAppearance(plainColor, 0.5, 0.0, 1.0), normalize(surfaceNormal),
                              toLight, -surfaceView(), light);
    color = vec4(toSrgb(clamp(shaded, 0.0, 1.0)), 1.0);
}
