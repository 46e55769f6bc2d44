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
    vec2 gradient;    // ∂D/∂u, ∂D/∂v there, in the metric at a = 1
    float level;      // of the maps that a pixel takes its shading from; it may lie between two
};

// The normal of the displaced surface, in step with the depth scale: the depth w·D (w = a·|tangent|)
// has the surface gradient w·(∂D/∂u·dualU + ∂D/∂v·dualV), and ∂D/∂v = ρ·dy because dy is measured in
// the metric. It tilts the surface normal towards where the relief gets deeper (specification 5). It is
// as long as the displaced surface is larger than the surface below it.
vec3 reliefUprightNormal(ReliefSurface surface, vec2 gradient, float aspect) {
    vec3 dualU, dualV;
    reliefDualBasis(surface, dualU, dualV);
    float worldDepth = relievoDepthScale * length(surface.tangent);
    return surface.normal + worldDepth * (gradient.x * dualU + aspect * gradient.y * dualV);
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
    result.gradient = reliefGradient(trace.hit.position.xy, trace.level);
    result.normal = normalize(reliefUprightNormal(surface, result.gradient, reliefAspect()));
    result.tileNormal = normalize(vec3(relievoDepthScale * result.gradient, 1.0));
    return result;
}

// The same for the fragment at hand. To be called where neighbouring pixels come by too: see
// relievo/footprint.glsl.
ReliefFragment traceRelief(ReliefSurface surface, vec3 view) {
    return traceRelief(surface, view, reliefFootprint(surface.uv, reliefAspect()));
}
