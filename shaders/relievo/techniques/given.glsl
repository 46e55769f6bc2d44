// No search: the hits were found elsewhere (by the double-precision reference on the CPU) and lie in a
// texture of the frame's size. It shows the exact picture through the same shading as every technique.
#include "relievo/search/result.glsl"

uniform sampler2D relievoGivenHits;  // (u, v, z), t; t < 0 where the ray misses

ReliefHit searchRelief(ReliefRay ray) {
    vec4 given = texelFetch(relievoGivenHits, ivec2(gl_FragCoord.xy), 0);
    return ReliefHit(given.xyz, given.w, given.w < 0.0 ? RELIEVO_OUTCOME_MISS : RELIEVO_OUTCOME_HIT,
                     0, 0);
}
