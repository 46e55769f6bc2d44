// What GLSL ES 3.00 lacks of GLSL 4.50 core, for the files that searches are made of.
#include "relievo/level.glsl"

// A channel of the four texels of the searched level around the corner that they share, one by one.
vec4 reliefFetchFour(sampler2D map, vec2 corner, int channel) {
    // At the centre of a texel every filter gives the texel itself.
    vec2 side = 0.5 / vec2(textureSize(map, reliefLevel));
    float level = float(reliefLevel);
    return vec4(textureLod(map, corner + vec2(-side.x, side.y), level)[channel],
                textureLod(map, corner + side, level)[channel],
                textureLod(map, corner + vec2(side.x, -side.y), level)[channel],
                textureLod(map, corner - side, level)[channel]);
}

// The same in the order of textureGather: (0,1), (1,1), (1,0), (0,0). textureGather itself, where it
// is had, knows the first level only, and channels that are constants.
vec4 reliefGatherChannel(sampler2D map, vec2 corner, int channel) {
#if defined(GL_ES) && __VERSION__ < 310
    return reliefFetchFour(map, corner, channel);
#else
    if (reliefLevel > 0) return reliefFetchFour(map, corner, channel);
    if (channel == 1) return textureGather(map, corner, 1);
    if (channel == 2) return textureGather(map, corner, 2);
    return textureGather(map, corner);
#endif
}

vec4 reliefGather(sampler2D map, vec2 corner) { return reliefGatherChannel(map, corner, 0); }
