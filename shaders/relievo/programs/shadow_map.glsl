// Visibility from a light that is far away, by a map of the least depths that it sees.

uniform sampler2D shadowMap;  // window depths of a parallel projection from −1 to 1 in depth
uniform mat4 shadowViewProjection;

// 1 for a point that the light reaches, 0 for one in shadow; what the map does not cover is lit.
//
// The texels have the depths of their centres. A plane is nowhere between four of them deeper than at the
// deepest of them, and so the point is in shadow only if it lies behind all four: no bias is needed for
// slopes. What is left is rounding: window depths of two programs, each a sum of four products of at most 1.
float shadowMapVisibility(vec3 position) {
    const float rounding = 16.0 / 16777216.0;
    vec3 place = 0.5 * (shadowViewProjection * vec4(position, 1.0)).xyz + 0.5;
    // The outermost texels have no neighbours, and what ends there may cover half of one.
    vec2 margin = 1.0 / vec2(textureSize(shadowMap, 0));
    if (any(lessThan(place.xy, margin)) || any(greaterThan(place.xy, 1.0 - margin))) return 1.0;
    // Behind all that the map shows: in the shadow of what is there, if anything is.
    place.z = min(place.z, 1.0);
    vec4 depths = textureGather(shadowMap, place.xy);
    float deepest = max(max(depths.x, depths.y), max(depths.z, depths.w));
    return place.z <= deepest + rounding ? 1.0 : 0.0;
}

// The widths of a texel of the map in the world.
vec2 shadowMapTexel() {
    mat3 across = transpose(mat3(shadowViewProjection));
    return 2.0 / (vec2(textureSize(shadowMap, 0)) * vec2(length(across[0]), length(across[1])));
}

// The same for a surface that curves, or that shadows itself by other means: from a place that lies off it by
// the width of a texel of the map and a half, so that the surface itself is not in its way.
float shadowMapVisibility(vec3 position, vec3 normal) {
    vec2 texel = shadowMapTexel();
    return shadowMapVisibility(position + 1.5 * max(texel.x, texel.y) * normal);
}
