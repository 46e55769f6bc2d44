// What a surface is made of: the usual texture set, with the meanings of glTF 2.0. A map that the text does
// not define is neither declared nor read; a number stands for it. Uniforms are set by
// relievo::materials::SurfaceTextures.

struct ReliefAppearance {
    vec3 albedo;      // linear RGB: the diffuse colour, or what a metal reflects straight on
    float roughness;  // perceptual: its square is the width of the lobe
    float metalness;  // 0 a dielectric, 1 a metal
    float occlusion;  // the share of the light from all around that arrives
};

#ifdef RELIEVO_ALBEDO_MAP
uniform sampler2D relievoAlbedoMap;  // sRGB
#endif
#ifdef RELIEVO_ORM_MAP
uniform sampler2D relievoOrmMap;  // occlusion, roughness, metalness
#endif
#ifdef RELIEVO_OCCLUSION_MAP
uniform sampler2D relievoOcclusionMap;
#endif
#ifdef RELIEVO_OCCLUSION_BAKED
uniform float relievoOcclusionScale;  // the depth scale that the occlusion is for, above 0
#endif
#ifdef RELIEVO_ROUGHNESS_MAP
uniform sampler2D relievoRoughnessMap;
#elif !defined(RELIEVO_ORM_MAP)
uniform float relievoRoughness;
#endif
#ifdef RELIEVO_METALNESS_MAP
uniform sampler2D relievoMetalnessMap;
#elif !defined(RELIEVO_ORM_MAP)
uniform float relievoMetalness;
#endif

// The occlusion that was built for one depth scale, at another one: that of a horizon which is as high all
// around, cos²α = 1/(1 + tan²α), and the tangent grows with the scale. `ratio` is a/a0.
float reliefRescaledOcclusion(float occlusion, float ratio) {
    // Where 8 bits say 0, half a step of them is left: without depth the light arrives there too.
    float share = max(occlusion, 0.5 / 255.0);
    return share / (share + ratio * ratio * (1.0 - share));
}

// The appearance at a hit. uvX and uvY are the derivatives of the surface's own uv across the screen: those
// of the hit's uv jump where the relief hides itself, and would read the smallest level there.
ReliefAppearance reliefAppearance(vec2 uv, vec2 uvX, vec2 uvY, float depthScale) {
    ReliefAppearance result = ReliefAppearance(vec3(0.6), 0.5, 0.0, 1.0);
#ifdef RELIEVO_ALBEDO_MAP
    result.albedo = textureGrad(relievoAlbedoMap, uv, uvX, uvY).rgb;
#endif
#ifdef RELIEVO_ORM_MAP
    vec3 orm = textureGrad(relievoOrmMap, uv, uvX, uvY).rgb;
    result.occlusion = orm.r;
    result.roughness = orm.g;
    result.metalness = orm.b;
#else
#ifdef RELIEVO_OCCLUSION_MAP
    result.occlusion = textureGrad(relievoOcclusionMap, uv, uvX, uvY).r;
#endif
#ifdef RELIEVO_ROUGHNESS_MAP
    result.roughness = textureGrad(relievoRoughnessMap, uv, uvX, uvY).r;
#else
    result.roughness = relievoRoughness;
#endif
#ifdef RELIEVO_METALNESS_MAP
    result.metalness = textureGrad(relievoMetalnessMap, uv, uvX, uvY).r;
#else
    result.metalness = relievoMetalness;
#endif
#endif
#ifdef RELIEVO_OCCLUSION_BAKED
    result.occlusion = reliefRescaledOcclusion(result.occlusion, depthScale / relievoOcclusionScale);
#endif
    return result;
}
