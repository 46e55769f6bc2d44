// Blinn–Phong shading under one directional light (Blinn 1977). Of the appearance it takes albedo and
// occlusion.
#include "relievo/shading/appearance.glsl"
#include "relievo/shading/surroundings.glsl"

vec3 reliefDiffuse(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye, vec3 lightColor) {
    vec3 ambient = appearance.occlusion * reliefSurroundings(normal, 1.0);
    return appearance.albedo * (ambient + lightColor * max(dot(normal, toLight), 0.0));
}

// A lobe of shininess s is about as wide as slopes of the variance 1/s. Variances add up, and a wider lobe is
// as much lower (Toksvig 2005).
vec3 reliefHighlight(ReliefAppearance appearance, vec3 normal, float variance, vec3 toLight, vec3 toEye,
                     vec3 lightColor) {
    const float specular = 0.12;
    const float shininess = 32.0;
    float widened = shininess / (1.0 + shininess * variance);
    float facing = max(dot(normal, normalize(toLight + toEye)), 0.0);
    float highlight = dot(normal, toLight) > 0.0 ? pow(facing, widened) : 0.0;
    return lightColor * (specular * highlight * (1.0 + widened) / (1.0 + shininess));
}
