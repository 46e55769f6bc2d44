// What a renderer calls: include one file of techniques/ and then this one, and call traceRelief in
// the fragment shader. Uniforms are set by relievo::materials::ReliefMaterial.
#include "relievo/slopes.glsl"
#include "relievo/trace.glsl"

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

// Searches the relief on `surface` along `view` (unit length, away from the eye) for a pixel of that
// footprint.
ReliefFragment traceRelief(ReliefSurface surface, vec3 view, ReliefFootprint footprint) {
    ReliefTrace trace = reliefTrace(surface, view, footprint);
    ReliefFragment result;
    result.ray = trace.ray;
    result.hit = trace.hit;
    result.level = trace.level;
    result.position = trace.position;
    vec2 gradient = reliefGradient(trace.hit.position.xy, trace.level);
    result.normal = reliefWorldNormal(surface, gradient, reliefAspect());
    result.tileNormal = normalize(vec3(relievoDepthScale * gradient, 1.0));
    return result;
}

// The same for the fragment at hand. To be called where neighbouring pixels come by too: see
// relievo/footprint.glsl.
ReliefFragment traceRelief(ReliefSurface surface, vec3 view) {
    return traceRelief(surface, view, reliefFootprint(surface.uv, reliefAspect()));
}
