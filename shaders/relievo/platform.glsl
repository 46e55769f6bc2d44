// What GLSL ES 3.00 lacks of GLSL 4.50 core, for the files that searches are made of.
#include "relievo/level.glsl"

// The four texels of the searched level around the corner that they share, one by one.
vec4 reliefFetchFour(sampler2D map, vec2 corner) {
    // At the centre of a texel every filter gives the texel itself.
    vec2 side = 0.5 / vec2(textureSize(map, reliefLevel));
    float level = float(reliefLevel);
    return vec4(textureLod(map, corner + vec2(-side.x, side.y), level).r,
                textureLod(map, corner + side, level).r,
                textureLod(map, corner + vec2(side.x, -side.y), level).r,
                textureLod(map, corner - side, level).r);
}

// The same in the order of textureGather: (0,1), (1,1), (1,0), (0,0). textureGather itself, where it
// is had, knows the first level only.
vec4 reliefGather(sampler2D map, vec2 corner) {
#if defined(GL_ES) && __VERSION__ < 310
    return reliefFetchFour(map, corner);
#else
    if (reliefLevel > 0) return reliefFetchFour(map, corner);
    return textureGather(map, corner);
#endif
}
