// The texture set and the shading model that the text asks for. A file of relievo/shading/ defines
//
//   vec3 reliefDiffuse(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye, vec3 lightColor);
//   vec3 reliefHighlight(ReliefAppearance appearance, vec3 normal, float variance, vec3 toLight, vec3 toEye,
//                        vec3 lightColor);
//
// what is seen of one directional light and of the light from all around, in linear RGB: what has been inside
// the body, and what the surface mirrors, whose slopes vary by `variance` along each axis around those of the
// normal. Directions have unit length; toLight and toEye point away from the surface. lightColor is what a
// white diffuse surface shows that faces the light.
//
// What the models share comes first: a file counts as included also where a branch leaves it out.
#include "relievo/shading/appearance.glsl"
#include "relievo/shading/normals.glsl"
#include "relievo/shading/surroundings.glsl"
#ifdef RELIEVO_MICROFACET
#include "relievo/shading/microfacet.glsl"
#else
#include "relievo/shading/blinn_phong.glsl"
#endif

vec3 shadeRelief(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye, vec3 lightColor) {
    return reliefDiffuse(appearance, normal, toLight, toEye, lightColor) +
           reliefHighlight(appearance, normal, 0.0, toLight, toEye, lightColor);
}

// The same of several normals: the body is seen under each; the lobe, which may be narrow, around their mean,
// as wide as they differ. A facet over an area of the surface shows the eye that area times the product of its
// long normal with the direction; where none faces the eye, all count alike.
vec3 shadeRelief(ReliefAppearance appearance, ReliefNormals normals, vec3 toLight, vec3 toEye,
                 vec3 lightColor) {
#ifndef RELIEVO_MIPS
    // Without levels there is one, and no loop.
    return shadeRelief(appearance, normalize(normals.upright), toLight, toEye, lightColor);
#else
    vec3 sum = vec3(0.0);
    vec3 mean = vec3(0.0);
    float seen = 0.0;
    for (int k = 0; k < normals.count; ++k) {
        vec3 facet = reliefFacetNormal(normals, k);
        vec3 normal = normalize(facet);
        float share = max(dot(facet, toEye), 1e-6);
        sum += share * reliefDiffuse(appearance, normal, toLight, toEye, lightColor);
        mean += share * normal;
        seen += share;
    }
    // Normals all around have no mean; their lobe is so wide that nothing of it shows.
    float meanLength = max(length(mean), 1e-6 * seen);
    float variance = normals.count > 1 ? reliefNormalVariance(meanLength / seen) : 0.0;
    return sum / seen +
           reliefHighlight(appearance, mean / meanLength, variance, toLight, toEye, lightColor);
#endif
}
