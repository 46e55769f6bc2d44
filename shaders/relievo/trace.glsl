// A relief searched from a point of the surface that carries it, and the window depth of what is found:
// all that a program without shading needs. Include one file of techniques/ before.
//
// Window depths are those of glDepthRange (gl_DepthRange), of a clip volume from −1 to 1 in depth, or
// from 0 to 1 with RELIEVO_CLIP_ZERO_TO_ONE (glClipControl). With RELIEVO_DEPTH_REVERSED what is farther
// has the lesser window depth, by the projection or by glDepthRange.
#include "relievo/footprint.glsl"
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

uniform float relievoDepthScale;  // a: depth of D = 1, in tile widths
uniform vec4 relievoWindow;       // minimum u, v and maximum u, v of the relief

struct ReliefTrace {
    ReliefRay ray;
    ReliefHit hit;
    vec3 position;  // of the hit, in world space
    float level;    // of the maps that a pixel is made of; it may lie between two
};

bool reliefInWindow(vec2 uv) {
    return all(greaterThanEqual(uv, relievoWindow.xy)) && all(lessThanEqual(uv, relievoWindow.zw));
}

// Searches the relief on `surface` along `view` (unit length, away from the eye) for a pixel of that
// footprint.
ReliefTrace reliefTrace(ReliefSurface surface, vec3 view, ReliefFootprint footprint) {
    ReliefTrace result;
    float aspect = reliefAspect();
    result.level = reliefLevelFor(footprint);
    reliefSelectLevel(int(result.level + footprint.rounding));
    result.ray = makeReliefRay(surface, view, relievoDepthScale, relievoWindow, aspect);
    result.ray.pixelsPerDepth = reliefPixelsPerDepth(footprint, relievoDepthScale);
    result.hit = searchRelief(result.ray);
    if (!reliefInWindow(result.hit.position.xy)) result.hit.outcome = RELIEVO_OUTCOME_MISS;
    result.position = surface.position + (result.hit.t * result.ray.worldLength) * view;
    return result;
}

// The same for the fragment at hand. To be called where neighbouring pixels come by too: see
// relievo/footprint.glsl.
ReliefTrace reliefTrace(ReliefSurface surface, vec3 view) {
    return reliefTrace(surface, view, reliefFootprint(surface.uv, reliefAspect()));
}

// Window depth of a point in clip space.
float reliefToWindowDepth(vec4 clip) {
#ifdef RELIEVO_CLIP_ZERO_TO_ONE
    return gl_DepthRange.diff * clamp(clip.z / clip.w, 0.0, 1.0) + gl_DepthRange.near;
#else
    float device = clamp(clip.z / clip.w, -1.0, 1.0);
    return 0.5 * (gl_DepthRange.diff * device + gl_DepthRange.near + gl_DepthRange.far);
#endif
}

// The window depth of what is as far away as can be, and the nearer one of two.
#ifdef RELIEVO_DEPTH_REVERSED
float reliefFarthestDepth() { return min(gl_DepthRange.near, gl_DepthRange.far); }
float reliefNearerDepth(float a, float b) { return max(a, b); }
#else
float reliefFarthestDepth() { return max(gl_DepthRange.near, gl_DepthRange.far); }
float reliefNearerDepth(float a, float b) { return min(a, b); }
#endif

// For gl_FragDepth, under the layout of programs/depth_output.glsl: the window depth of a hit, no nearer
// than the fragment, in spite of rounding. A miss is as far away as can be, so that it hides nothing.
float reliefWindowDepth(ReliefHit hit, vec3 position, mat4 viewProjection) {
    float depth = reliefToWindowDepth(viewProjection * vec4(position, 1.0));
    bool isMiss = hit.outcome == RELIEVO_OUTCOME_MISS;
#ifdef RELIEVO_DEPTH_REVERSED
    return isMiss ? reliefFarthestDepth() : min(depth, gl_FragCoord.z);
#else
    return isMiss ? reliefFarthestDepth() : max(depth, gl_FragCoord.z);
#endif
}
