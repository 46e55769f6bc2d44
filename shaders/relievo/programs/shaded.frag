// A shaded relief that writes the depth of its hits.
#include "relievo/material.glsl"
#include "relievo/pixel_rays.glsl"
#include "relievo/seen_normals.glsl"
#include "relievo/shading.glsl"
#include "relievo/programs/srgb.glsl"
#include "relievo/programs/depth_output.glsl"
#include "relievo/programs/surface_input.glsl"
#ifdef RELIEVO_SHADOW_MAP
#include "relievo/programs/shadow_map.glsl"
#endif

uniform mat4 viewProjection;
uniform vec3 toLight;
#ifdef RELIEVO_SHADOW
uniform float lightRadius;  // radians
#endif

layout(location = 0) out vec4 color;

// Outside the window there is no relief, and a search that ran out has found none: what it would shade
// is not a hit.
bool isShown(ReliefHit hit) {
#ifdef RELIEVO_MARK_EXHAUSTED
    return hit.outcome != RELIEVO_OUTCOME_MISS;
#else
    return hit.outcome == RELIEVO_OUTCOME_HIT;
#endif
}

// Linear RGB of a hit, for a ray of a pixel that goes through `surface` along `view`.
vec3 shade(ReliefFragment relief, ReliefPixel pixel, ReliefSurface surface, vec3 view) {
#ifdef RELIEVO_MARK_EXHAUSTED
    if (relief.hit.outcome == RELIEVO_OUTCOME_EXHAUSTED) return vec3(1.0, 0.0, 1.0);
#endif
    ReliefAppearance appearance =
        reliefAppearance(relief.hit.position.xy, pixel.uvX, pixel.uvY, relievoDepthScale);
    vec3 light = vec3(1.0);
#ifdef RELIEVO_SHADOW
    light *= reliefVisibility(
        makeReliefLight(surface, relief.hit.position, toLight, lightRadius));
#endif
#ifdef RELIEVO_SHADOW_MAP
    light *= shadowMapVisibility(relief.position);
#endif
    ReliefNormals normals = reliefSeenNormals(surface, relief);
    return clamp(shadeRelief(appearance, normals, toLight, -view, light), 0.0, 1.0);
}

void main() {
    ReliefPixel pixel = reliefPixel(surfaceInput(), reliefAspect());
    vec3 sum = vec3(0.0);
    int hits = 0;
    float depth = reliefFarthestDepth();
    for (int ray = 0; ray < pixel.rays; ++ray) {
        ReliefSurface surface = reliefPixelSurface(pixel, ray);
        vec3 view = surfaceView(surface.position);
        ReliefFragment relief = traceRelief(surface, view, reliefRayFootprint(pixel, ray));
        if (!isShown(relief.hit)) continue;
        ++hits;
        sum += shade(relief, pixel, surface, view);
        depth = reliefNearerDepth(
            depth, reliefWindowDepth(relief.hit, relief.position, viewProjection));
    }
    // A pixel is drawn when half of it is hit, and lies where the nearest of its hits does.
    if (hits == 0 || 2 * hits < pixel.rays) discard;
    color = vec4(toSrgb(sum / float(hits)), 1.0);
    gl_FragDepth = depth;
}
