// Normal mapping: no search, the relief only shades (Blinn 1978; Peercy, Airey, Cabral 1997).
#include "relievo/search/result.glsl"

ReliefHit searchRelief(ReliefRay ray) {
    return reliefResult(ray, 0.0, RELIEVO_OUTCOME_HIT, 0);
}
