// Shadows by visibility ellipses (Heidrich, Daubert, Kautz, Seidel 2000): for each texel an ellipse in the
// unit disc of directions, projected onto the reference surface, in which the light must lie to be seen.
//
// Error: what a texel sees is taken for an ellipse; between texels the ellipses' centres and second moments
// are interpolated; the border of the ellipse is taken to be straight before the light. Cost: two lookups.
#include "relievo/light.glsl"

// Layer 0: centre; layer 1: the squares of the half axes as a matrix (xx, xy, yy).
uniform sampler2DArray relievoEllipseMap;
uniform float relievoEllipseScale;  // depth scale for which it was made

#ifdef RELIEVO_WRAP_MIRROR
// Between a texel and its mirror image what points along that axis passes through 0.
vec2 reliefMirrorSigns(vec2 uv) {
    vec2 tile = floor(uv);
    vec2 border = min(uv - tile, 1.0 - (uv - tile)) * vec2(textureSize(relievoEllipseMap, 0).xy);
    return (1.0 - 2.0 * mod(tile, 2.0)) * min(2.0 * border, 1.0);
}
#else
vec2 reliefMirrorSigns(vec2 uv) { return vec2(1.0); }
#endif

// A direction of tile space in the unit disc of the map. Slopes of depth per tile width stay what they are
// at its scale, so that the same texels are in the way.
vec2 reliefInDisc(vec3 direction) {
    vec3 scaled = vec3(direction.x, reliefAspect() * direction.y, relievoEllipseScale * direction.z);
    return scaled.xy / max(length(scaled), 1e-30);
}

float reliefVisibility(ReliefLight light) {
    if (light.direction.z >= 0.0) return 0.0;
    reliefFetchCount += 2;
    vec2 signs = reliefMirrorSigns(light.point.xy);
    vec2 centre = signs * textureLod(relievoEllipseMap, vec3(light.point.xy, 0.0), 0.0).rg;
    vec3 squares = textureLod(relievoEllipseMap, vec3(light.point.xy, 1.0), 0.0).rgb;
    squares.y *= signs.x * signs.y;

    // The ellipse is where outside = d·adj(squares)·d − det(squares) is below 0.
    vec2 d = reliefInDisc(light.direction) - centre;
    vec2 normal = vec2(squares.z * d.x - squares.y * d.y, squares.x * d.y - squares.y * d.x);
    float outside = dot(d, normal) - (squares.x * squares.z - squares.y * squares.y);
    // What that changes by from the centre of the light to its edges, across the border.
    vec2 lift = reliefInDisc(light.direction + light.lift) - reliefInDisc(light.direction);
    vec2 side = reliefInDisc(light.direction + light.side) - reliefInDisc(light.direction);
    float change = 2.0 * length(vec2(dot(normal, lift), dot(normal, side)));
    if (change <= 0.0) return outside <= 0.0 ? 1.0 : 0.0;
    return reliefDiscBeyond(outside / change);
}
