// A relief on the walls and caps of a solid: where a ray has hit the solid, the relief is searched from there,
// as from any surface. Include one file of techniques/ before; techniques/normal.glsl makes it a bump map.
//
// Error: as of the technique, for a solid that goes on as it is at the hit: the relief ends where the solid
// bends away.
#include "relievo/material.glsl"
#include "relievo/solid_material.glsl"

struct SolidRelief {
    bool isFound;   // else the solid is bare there
    vec3 position;  // of the hit, in world space
    vec3 normal;
    vec2 uv;        // of its picture
};

SolidRelief solidRelief(SolidTrace trace, SolidSurface solid, vec3 view) {
    SolidRelief result = SolidRelief(false, trace.position, trace.normal, solid.uv);
    // What of the gradients lies in the surface. Its dual basis are the tangents.
    vec3 gradientU = solid.gradientU - dot(solid.gradientU, trace.normal) * trace.normal;
    vec3 gradientV = solid.gradientV - dot(solid.gradientV, trace.normal) * trace.normal;
    ReliefSurface surface =
        ReliefSurface(trace.position, trace.normal, gradientU, gradientV, solid.uv);
    float area = length(cross(gradientU, gradientV));
    // Where the picture is drawn out to a line there is no place on it.
    if (area < 1e-3 * length(solid.gradientU) * length(solid.gradientV) || dot(trace.normal, view) > -1e-3)
        return result;
    vec3 tangent, bitangent;
    reliefDualBasis(surface, tangent, bitangent);
    surface.tangent = tangent;
    surface.bitangent = bitangent;
    ReliefFragment relief =
        traceRelief(surface, view, reliefFootprint(solid.uvX, solid.uvY, reliefAspect()));
    if (relief.hit.outcome != RELIEVO_OUTCOME_HIT) return result;
    return SolidRelief(true, relief.position, relief.normal, relief.hit.position.xy);
}
