// Hard shadows by a search along the light ray, with the technique that found the hit (Policarpo, Oliveira,
// Comba 2005). The light is taken for a point.
//
// Error: that of the technique on light rays; with techniques/exact.glsl the rounding of floats.
#include "relievo/search/light_ray.glsl"

float reliefVisibility(ReliefLight light) {
    return reliefIsLit(light.point.xy, light.direction) ? 1.0 : 0.0;
}
