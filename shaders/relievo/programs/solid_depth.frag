// The depth of a solid's hits and nothing else, for shadow maps.
#include "relievo/programs/solid_input.glsl"

void main() {
    SolidTrace trace = solidInput();
    if (trace.hit.outcome != RELIEVO_OUTCOME_HIT) discard;
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
