// A relief searched from a point of the surface that carries it, and the window depth of what is found:
// all that a program without shading needs. Include one file of techniques/ before.
#include "relievo/footprint.glsl"
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"
#include "relievo/window_depth.glsl"

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

// For gl_FragDepth, under the layout of programs/depth_output.glsl: the window depth of a hit, no nearer
// than the fragment, in spite of rounding. A miss is as far away as can be, so that it hides nothing.
float reliefWindowDepth(ReliefHit hit, vec3 position, mat4 viewProjection) {
    float depth = reliefToWindowDepth(viewProjection * vec4(position, 1.0));
    bool isMiss = hit.outcome == RELIEVO_OUTCOME_MISS;
    return isMiss ? reliefFarthestDepth() : reliefFartherDepth(depth, gl_FragCoord.z);
}
