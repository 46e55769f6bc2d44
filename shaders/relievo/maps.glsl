// Access to the maps of a relief. Every lookup of a search goes through here and is counted.
#include "relievo/fetches.glsl"
#include "relievo/platform.glsl"

uniform sampler2D relievoDepthMap;  // D, linear filter, wrap mode of the map

// Texels of the level that is searched.
ivec2 reliefMapSize() { return textureSize(relievoDepthMap, reliefLevel); }

// ρ, the height of a tile over its width. Texels are square in the first level; in the levels of odd
// sizes, which cover the same tile, they need not be.
float reliefAspect() {
    ivec2 size = textureSize(relievoDepthMap, 0);
    return float(size.y) / float(size.x);
}

// Height over width of a texel of the level that is searched.
float reliefTexelAspect() {
    if (reliefLevel == 0) return 1.0;
    vec2 size = vec2(reliefMapSize());
    return reliefAspect() * size.x / size.y;
}

float reliefDepth(vec2 uv) {
    ++reliefFetchCount;
    return textureLod(relievoDepthMap, uv, float(reliefLevel)).r;
}

// The bilinear cell that holds a point: the patch between four texel centres.
struct ReliefCell {
    vec2 gather;    // uv of the corner that its four texels share: where textureGather takes them all,
                    // whatever the precision of the texture unit
    vec2 fraction;  // position between the four centres, in [0,1)²
};

ReliefCell reliefCell(vec2 uv) {
    vec2 size = vec2(reliefMapSize());
    vec2 position = uv * size - 0.5;
    vec2 corner = floor(position);
    return ReliefCell((corner + 1.0) / size, position - corner);
}

// Depths at the corners of a cell, in the order of textureGather: (0,1), (1,1), (1,0), (0,0).
vec4 reliefCornerDepths(ReliefCell cell) {
    ++reliefFetchCount;
    return reliefGather(relievoDepthMap, cell.gather);
}

// The bilinear interpolation of four corners, in the order of textureGather, in full precision.
float reliefInterpolate(ReliefCell cell, vec4 corners) {
    vec2 column = mix(corners.wx, corners.zy, cell.fraction.x);
    return mix(column.x, column.y, cell.fraction.y);
}
