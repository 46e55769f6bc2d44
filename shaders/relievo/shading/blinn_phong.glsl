// Blinn–Phong shading under one directional light (Blinn 1977). Of the appearance it takes albedo and
// occlusion.
#include "relievo/shading/appearance.glsl"
#include "relievo/shading/surroundings.glsl"

// All directions have unit length; toLight and toEye point away from the surface. lightColor is what a white
// diffuse surface shows that faces the light; without occluders of its own. Returns linear RGB.
vec3 shadeRelief(ReliefAppearance appearance, vec3 normal, vec3 toLight, vec3 toEye,
                 vec3 lightColor) {
    const float specular = 0.12;
    const float shininess = 32.0;
    float diffuse = max(dot(normal, toLight), 0.0);
    vec3 halfway = normalize(toLight + toEye);
    float highlight = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), shininess) : 0.0;
    vec3 ambient = appearance.occlusion * reliefSurroundings(normal, 1.0);
    return appearance.albedo * (ambient + lightColor * diffuse) +
           lightColor * (specular * highlight);
}
