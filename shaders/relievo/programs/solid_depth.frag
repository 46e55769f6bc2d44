// The depth of a solid's hits and nothing else, for shadow maps.
#include "relievo/programs/solid_input.glsl"

void main() {
    SolidTrace trace = solidInput();
    if (!solidIsShown(trace)) discard;
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
