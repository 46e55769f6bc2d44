// Soft shadows by the highest blocker (Tatarchuk 2006; specification 6), in slices of the light that
// stand side by side: how high the relief stands before each is found by searches along light rays between
// the lower and the upper edge of the slice, by halves. What stands above that is seen, and nothing below.
//
// Error: over its width a slice finds the relief as high as before its middle; the last half is a share of
// 2⁻ⁿ⁻¹ of its height. Cost: one or two searches a slice outside of penumbras, up to n more inside.
#include "relievo/search/light_ray.glsl"

uniform int relievoShadowSlices;    // all of one width
uniform int relievoShadowHalvings;  // n

float reliefVisibility(ReliefLight light) {
    bool isPoint = light.lift == vec3(0.0) && light.side == vec3(0.0);
    float width = 2.0 / float(relievoShadowSlices);
    float share = 0.0;
    bool isLit = true;  // what the last search found
    int slice = 0;
    int searches = 0;     // in this slice
    float hidden = -1.0;  // heights, of that of the slice
    float seen = 1.0;
    // One loop for all searches: each place that calls one is as much program as the technique.
    for (int left = relievoShadowSlices * (relievoShadowHalvings + 2); left > 0; --left) {
        float low = float(slice) * width - 1.0;
        float middle = low + 0.5 * width;
        float inner = max(abs(middle) - 0.5 * width, 0.0);
        float top = sqrt(1.0 - inner * inner);
        // The edge that is likely to settle the slice comes first: that of a slice like the one before.
        float height = searches >= 2 ? 0.5 * (hidden + seen) : isLit ? hidden : seen;
        isLit = reliefIsLit(light.point.xy,
                            light.direction + top * height * light.lift + middle * light.side);
        if (isPoint) return isLit ? 1.0 : 0.0;
        if (isLit) {
            seen = height;
        } else {
            hidden = height;
        }
        ++searches;
        if (hidden < seen && searches < relievoShadowHalvings + 2) continue;
        share += reliefSliceBeyond(low, low + width, 0.5 * top * (hidden + seen));
        if (++slice == relievoShadowSlices) break;
        searches = 0;
        hidden = -1.0;
        seen = 1.0;
    }
    return share;
}
