// Parallax mapping with slope information: the shift is shortened where the relief is steep, which is where a
// long one would be most wrong (Premecz 2006; thesis 2.1.4).
#include "relievo/search/result.glsl"
#include "relievo/search/slope.glsl"

ReliefHit searchRelief(ReliefRay ray) {
    return reliefResult(ray, reliefSlopeStep(ray, 0.0), RELIEVO_OUTCOME_HIT, 1);
}
