// Blinn–Phong shading under one directional light (Blinn 1977).

// All directions have unit length; toLight and toEye point away from the surface. Returns linear RGB.
vec3 blinnPhong(vec3 albedo, vec3 normal, vec3 toLight, vec3 toEye, vec3 lightColor) {
    const vec3 ambient = vec3(0.16, 0.17, 0.19);
    const float specular = 0.12;
    const float shininess = 32.0;
    float diffuse = max(dot(normal, toLight), 0.0);
    vec3 halfway = normalize(toLight + toEye);
    float highlight = diffuse > 0.0 ? pow(max(dot(normal, halfway), 0.0), shininess) : 0.0;
    return albedo * (ambient + lightColor * diffuse) + lightColor * (specular * highlight);
}
