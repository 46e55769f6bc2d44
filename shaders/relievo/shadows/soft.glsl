// Soft shadows by the highest blocker (Policarpo, Oliveira 2005; specification 6): how high the relief
// stands before the light, above the azimuth of its centre, is found by searches along light rays between
// its lower and its upper edge, by halves. What stands above that is seen.
//
// Error: the relief is taken to be as high over the whole width of the light as it is before its centre,
// and what is before its upper edge to reach down to the horizon; the last half is a share of 2⁻ⁿ⁻¹ of the
// light's height. Cost: two searches outside of penumbras, n more inside.
#include "relievo/search/light_ray.glsl"

uniform int relievoShadowHalvings;  // n

float reliefVisibility(ReliefLight light) {
    float hidden = -1.0;
    float seen = 1.0;
    // One loop for all searches: each place that calls one is as much program as the technique.
    for (int search = 0; search < relievoShadowHalvings + 2; ++search) {
        float height = search == 0 ? seen : search == 1 ? hidden : 0.5 * (hidden + seen);
        bool isLit = reliefIsLit(light.point.xy, light.direction + height * light.lift);
        if (search == 0 && !isLit) return 0.0;
        if (search == 1 && isLit) return 1.0;
        if (isLit) {
            seen = height;
        } else {
            hidden = height;
        }
    }
    return reliefDiscBeyond(0.5 * (hidden + seen));
}
