// What GLSL ES 3.00 lacks of GLSL 4.50 core, for the files that searches are made of.

// Four neighbouring texels around the corner that they share, in the order of textureGather: (0,1),
// (1,1), (1,0), (0,0).
#if defined(GL_ES) && __VERSION__ < 310
vec4 reliefGather(sampler2D map, vec2 corner) {
    // At the centre of a texel every filter gives the texel itself.
    vec2 side = 0.5 / vec2(textureSize(map, 0));
    return vec4(textureLod(map, corner + vec2(-side.x, side.y), 0.0).r,
                textureLod(map, corner + side, 0.0).r,
                textureLod(map, corner + vec2(side.x, -side.y), 0.0).r,
                textureLod(map, corner - side, 0.0).r);
}
#else
vec4 reliefGather(sampler2D map, vec2 corner) { return textureGather(map, corner); }
#endif
