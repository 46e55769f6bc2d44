// What a renderer calls: include one file of techniques/ and then this one, and call traceRelief in
// the fragment shader. Uniforms are set by relievo::materials::ReliefMaterial.
#include "relievo/footprint.glsl"
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

uniform float relievoDepthScale;  // a: depth of D = 1, in tile widths
uniform vec4 relievoWindow;       // minimum u, v and maximum u, v of the relief

struct ReliefFragment {
    ReliefRay ray;
    ReliefHit hit;
    vec3 position;    // of the hit, in world space
    vec3 normal;      // of the relief there, in world space, unit length
    vec3 tileNormal;  // the same in the tile's metric, z up
    float level;      // of the maps that a pixel takes its shading from; it may lie between two
};

// The normal of the displaced surface, in step with the depth scale: the depth w·D (w = a·|tangent|)
// has the surface gradient w·(∂D/∂u·dualU + ∂D/∂v·dualV), and ∂D/∂v = ρ·dy because dy is measured in
// the metric. It tilts the surface normal towards where the relief gets deeper (specification 5).
vec3 reliefWorldNormal(ReliefSurface surface, vec2 gradient, float aspect) {
    vec3 dualU, dualV;
    reliefDualBasis(surface, dualU, dualV);
    float worldDepth = relievoDepthScale * length(surface.tangent);
    return normalize(surface.normal +
                     worldDepth * (gradient.x * dualU + aspect * gradient.y * dualV));
}

bool reliefInWindow(vec2 uv) {
    return all(greaterThanEqual(uv, relievoWindow.xy)) && all(lessThanEqual(uv, relievoWindow.zw));
}

// Searches the relief on `surface` along `view` (unit length, away from the eye). To be called where
// neighbouring pixels come by too, when the maps have MIP levels: see relievo/footprint.glsl.
ReliefFragment traceRelief(ReliefSurface surface, vec3 view) {
    ReliefFragment result;
    float aspect = reliefAspect();
    ReliefFootprint footprint = reliefFootprint(surface.uv, aspect);
    result.level = reliefLevelFor(footprint);
    reliefSelectLevel(int(result.level + 0.5));
    result.ray = makeReliefRay(surface, view, relievoDepthScale, relievoWindow, aspect);
    result.ray.pixelsPerDepth = reliefPixelsPerDepth(footprint, relievoDepthScale);
    result.hit = searchRelief(result.ray);
    if (!reliefInWindow(result.hit.position.xy)) result.hit.outcome = RELIEVO_OUTCOME_MISS;
    vec2 gradient = reliefGradient(result.hit.position.xy, result.level);
    result.position = surface.position + (result.hit.t * result.ray.worldLength) * view;
    result.normal = reliefWorldNormal(surface, gradient, aspect);
    result.tileNormal = normalize(vec3(relievoDepthScale * gradient, 1.0));
    return result;
}

// Window depth of a hit, for gl_FragDepth under layout(depth_greater). A miss is as far away as can
// be, so that it hides nothing.
float reliefWindowDepth(ReliefFragment relief, mat4 viewProjection) {
    if (relief.hit.outcome == RELIEVO_OUTCOME_MISS) return gl_DepthRange.far;
    vec4 clip = viewProjection * vec4(relief.position, 1.0);
    float device = clamp(clip.z / clip.w, -1.0, 1.0);
    float depth = 0.5 * (gl_DepthRange.diff * device + gl_DepthRange.near + gl_DepthRange.far);
    return max(depth, gl_FragCoord.z);
}
