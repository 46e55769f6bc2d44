// The depth of a relief's hits and nothing else, for shadow maps.
#include "relievo/trace.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"

uniform mat4 viewProjection;

void main() {
    ReliefTrace trace = reliefTrace(surfaceInput(), surfaceView());
    if (trace.hit.outcome != RELIEVO_OUTCOME_HIT) discard;
    gl_FragDepth = reliefWindowDepth(trace.hit, trace.position, viewProjection);
}
