// Metallic-roughness shading under one directional light: a microfacet surface over a diffuse body.
//
// - Facets: Trowbridge and Reitz 1975, as "GGX" by Walter, Marschner, Li, Torrance 2007; the width of the
//   lobe is the square of the roughness (Burley 2012, glTF 2.0).
// - Masking and shadowing: Smith's, correlated by height (Heitz 2014).
// - Fresnel: Schlick 1994.
// - Body: what the surface lets in and out again, (1 − F)(1 − F) over its mean (Shirley, Smits, Hu, Lafortune
//   1997). It takes no more than the facets leave: a smooth white surface reflects exactly what arrives.
//   Weights of the kind 1 − F(v·h) would give back up to twice as much at grazing angles.
#include "relievo/shading/appearance.glsl"
#include "relievo/shading/surroundings.glsl"

// What a dielectric reflects straight on: an index of refraction of 1.5.
const float kReliefDielectric = 0.04;
// No lobe is narrower than the sun, whose angular radius this is. A light without size would not show in a
// mirror at all.
const float kReliefLeastWidth = 0.00465;

float reliefLobeWidth(float roughness) { return max(roughness * roughness, kReliefLeastWidth); }

vec3 reliefSchlick(vec3 straightOn, float cosine) {
    float rest = 1.0 - clamp(cosine, 0.0, 1.0);
    float square = rest * rest;
    return straightOn + (1.0 - straightOn) * (square * square * rest);
}

// The share of the light from a direction that a dielectric lets in.
float reliefTransmission(float cosine) {
    return 1.0 - reliefSchlick(vec3(kReliefDielectric), cosine).x;
}

// The density of facets that face `halfway`, times π. 1 − cos² is taken from the cross product: the
// difference would have no digits left where the lobe is narrow.
float reliefFacets(vec3 normal, vec3 halfway, float width) {
    float cosine = dot(normal, halfway);
    vec3 across = cross(normal, halfway);
    float spread = dot(across, across) + width * width * cosine * cosine;
    return width * width / (spread * spread);
}

// The share of facets that both directions see, over four times both cosines. cosineLight is above 0,
// cosineEye at least 0.
float reliefSeenFacets(float cosineLight, float cosineEye, float width) {
    float square = width * width;
    float light = cosineEye * sqrt(cosineLight * cosineLight * (1.0 - square) + square);
    float eye = cosineLight * sqrt(cosineEye * cosineEye * (1.0 - square) + square);
    return 0.5 / (light + eye);
}

// A filtered normal may turn away from a direction that sees the surface: it is taken to be as far on the
// near side of it. Returns the direction that does so.
vec3 reliefTowards(vec3 direction, vec3 normal) {
    return direction - 2.0 * min(dot(direction, normal), 0.0) * normal;
}

// What is seen of a light that a white diffuse surface facing it shows as 1, π times the reflectance for the
// two directions times the cosine towards the light: by facets.
vec3 reliefFacetReflection(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye) {
    float cosineLight = dot(normal, toLight);
    if (cosineLight <= 0.0) return vec3(0.0);
    vec3 eye = reliefTowards(toEye, normal);
    float width = reliefLobeWidth(appearance.roughness);
    vec3 halfway = normalize(toLight + eye);
    vec3 straightOn = mix(vec3(kReliefDielectric), appearance.albedo, appearance.metalness);
    return reliefSchlick(straightOn, dot(toLight, halfway)) *
           (cosineLight * reliefFacets(normal, halfway, width) *
            reliefSeenFacets(cosineLight, dot(normal, eye), width));
}

// The same by the body.
vec3 reliefBodyReflection(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye) {
    float cosineLight = dot(normal, toLight);
    if (cosineLight <= 0.0) return vec3(0.0);
    float cosineEye = dot(normal, reliefTowards(toEye, normal));
    // Schlick's F is straightOn + (1 − straightOn)/21 on average.
    const float letIn = (1.0 - kReliefDielectric) * (20.0 / 21.0);
    float body = (1.0 - appearance.metalness) * reliefTransmission(cosineLight) *
                 reliefTransmission(cosineEye) / letIn;
    return cosineLight * body * appearance.albedo;
}

// What is seen of the light from all around, by facets. They show it around the mirrored direction, with a
// Fresnel term that grows less at grazing angles the rougher they are (Lagarde 2011).
vec3 reliefFacetAmbient(ReliefAppearance appearance, vec3 normal, vec3 toEye) {
    vec3 eye = reliefTowards(toEye, normal);
    vec3 straightOn = mix(vec3(kReliefDielectric), appearance.albedo, appearance.metalness);
    vec3 grazing = max(vec3(1.0 - appearance.roughness), straightOn);
    float rest = (reliefSchlick(vec3(0.0), dot(normal, eye))).x;
    return appearance.occlusion * (straightOn + (grazing - straightOn) * rest) *
           reliefSurroundings(reflect(-eye, normal), reliefLobeWidth(appearance.roughness));
}

// The same by the body, which sees it as a diffuse surface does.
vec3 reliefBodyAmbient(ReliefAppearance appearance, vec3 normal, vec3 toEye) {
    float cosineEye = dot(normal, reliefTowards(toEye, normal));
    return appearance.occlusion * (1.0 - appearance.metalness) * reliefTransmission(cosineEye) *
           appearance.albedo * reliefSurroundings(normal, 1.0);
}

vec3 reliefDiffuse(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye, vec3 lightColor) {
    return lightColor * reliefBodyReflection(appearance, normal, toLight, toEye) +
           reliefBodyAmbient(appearance, normal, toEye);
}

// The lobe is about that of slopes with half the square of its width as variance. Variances add up.
vec3 reliefHighlight(ReliefAppearance appearance, vec3 normal, float variance, vec3 toLight, vec3 toEye,
                     vec3 lightColor) {
    float roughness = appearance.roughness;
    float width = sqrt(roughness * roughness * roughness * roughness + 2.0 * variance);
    appearance.roughness = sqrt(min(width, 1.0));
    return lightColor * reliefFacetReflection(appearance, normal, toLight, toEye) +
           reliefFacetAmbient(appearance, normal, toEye);
}
