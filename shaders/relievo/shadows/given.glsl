// No search: the shares of the light were found elsewhere (by the double-precision reference on the CPU)
// and lie in a texture of the frame's size.
#include "relievo/light.glsl"

uniform sampler2D relievoGivenVisibility;  // 0 to 1

float reliefVisibility(ReliefLight light) {
    return texelFetch(relievoGivenVisibility, ivec2(gl_FragCoord.xy), 0).r;
}
