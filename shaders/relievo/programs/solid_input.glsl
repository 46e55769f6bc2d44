// A fragment's search of a solid, from the surface that it is sunk into or from the box that it is in.
#include "relievo/solid_trace.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"

uniform mat4 viewProjection;

SolidTrace solidInput() {
#ifdef RELIEVO_SHAPE_BOX
    return traceSolid(surfacePosition, surfaceView(), eye, viewProjection);
#else
    return traceSolid(surfaceInput(), surfaceView());
#endif
}
