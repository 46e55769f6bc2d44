// A solid searched from a surface that it is sunk into, or from the box that it is in. Include one file of
// solids/ before, and call traceSolid in the fragment shader. Uniforms are set by
// relievo::materials::SolidMaterial.
//
// With RELIEVO_SHAPE_BOX the fragments are those of the back faces of the box: of every ray that passes the
// box there is one, wherever the eye is (specification 7.4).
#include "relievo/ray.glsl"
#include "relievo/solid/compound.glsl"
#include "relievo/window_depth.glsl"

uniform vec3 relievoSolidLow;   // corners of the box in (u, v, z), or of the window of a surface
uniform vec3 relievoSolidHigh;
#ifdef RELIEVO_SHAPE_BOX
uniform mat4 relievoSolidFromWorld;
#else
uniform float relievoSolidDepth;  // a: depth of z = 1, in tile widths
uniform bool relievoSolidFloor;   // what is not hit is hit at z = 1
#endif

struct SolidTrace {
    SolidRay ray;
    SolidHit hit;
    vec3 start;     // of the ray, in world space
    vec3 position;  // of the hit
    vec3 normal;    // there, unit length, outwards
    mat3 toWhole;   // from directions of the world to those of the whole
};

// A place in the world, and the space of the whole around it.
struct SolidFrame {
    vec3 position;
    vec3 whole;    // the same place
    mat3 toWhole;
};

#ifdef RELIEVO_SHAPE_BOX
SolidFrame solidFrame(vec3 position) {
    return SolidFrame(position, (relievoSolidFromWorld * vec4(position, 1.0)).xyz,
                      mat3(relievoSolidFromWorld));
}
#else
// The tangent frame of a surface, as if it went on like that. A solid without depth is a millionth of a tile
// deep; so that the shader can square what comes of it, no tile is narrower than a billionth, as it is at the
// pole of a sphere.
SolidFrame solidFrame(ReliefSurface surface) {
    vec3 dualU, dualV;
    reliefDualBasis(surface, dualU, dualV);
    vec3 dualW = -surface.normal / (max(relievoSolidDepth, 1e-6) * max(length(surface.tangent), 1e-9));
    return SolidFrame(surface.position, vec3(surface.uv, 0.0), transpose(mat3(dualU, dualV, dualW)));
}
#endif

// What the surface at a hit faces, as ∂/∂(u, v, z) of the whole.
vec3 solidCovector(SolidHit hit) {
    vec3 covector = hit.side;
    if (hit.side == vec3(0.0)) {
        float aspect = solidAspect(hit.part);
        if (solidIsRevolution(hit.part)) {
            vec4 info = solidParts[hit.part].section;
            vec3 tile = floor(hit.place);
            vec2 across = hit.place.xy - tile.xy - info.xy;
            float depth = hit.place.z - tile.z;
            bool isTurned = solidIsTurned(hit.part, int(tile.z));
            float radius = length(across);
            vec2 gradient = solidGradientAt(hit.part, vec2(radius, isTurned ? 1.0 - depth : depth));
            if (isTurned) gradient.y = -gradient.y;
            covector = vec3(gradient.x * (radius > 0.0 ? across / radius : vec2(0.0)), aspect * gradient.y);
        } else {
            vec2 gradient = solidGradientAt(hit.part, hit.place.xy);
            float width = max(length(gradient), 1e-6);
            covector = vec3(hit.normal.x * gradient * vec2(1.0, aspect) / width,
                            -hit.normal.y);
        }
    }
    if (hit.isTurned) covector = -covector;
    return transpose(mat3(solidParts[hit.part].fromWhole)) * covector;
}

// Narrows the t between which origin + t·direction is in the box; `side` is that by which it comes in.
void solidNarrowToBox(vec3 origin, vec3 direction, inout vec2 stretch, inout vec3 side) {
    SolidPath path;
    path.origin = origin;
    path.direction = direction;
    path.enter = stretch.x;
    path.leave = stretch.y;
    path.enterNormal = side;
    path.leaveNormal = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis)
        solidNarrow(path, axis, relievoSolidLow[axis], relievoSolidHigh[axis]);
    stretch = vec2(path.enter, path.leave);
    side = path.enterNormal;
}

// Whether a pixel shows what its search has come to: a hit, and where the printed searches run out of steps
// as well (solid/printed.glsl).
bool solidIsShown(SolidTrace trace) {
#ifdef RELIEVO_SOLID_SHADES_EXHAUSTED
    if (trace.hit.outcome == RELIEVO_OUTCOME_EXHAUSTED) return true;
#endif
    return trace.hit.outcome == RELIEVO_OUTCOME_HIT;
}

// Searches along `view` (unit length) from `nearest` in front of the frame's place (a t, negative before it).
SolidTrace traceSolid(SolidFrame frame, vec3 view, float nearest) {
    SolidTrace result;
    vec3 direction = frame.toWhole * view;
    vec2 stretch = vec2(nearest, kReliefBoundless);
    vec3 side = vec3(0.0);
    solidNarrowToBox(frame.whole, direction, stretch, side);
    float across = length(direction.xy);
    if (across > 0.0) stretch.y = min(stretch.y, stretch.x + RELIEVO_MAXIMUM_REACH / across);
    result.toWhole = frame.toWhole;
    result.start = frame.position + stretch.x * view;
    result.ray = SolidRay(frame.whole + stretch.x * direction, direction, stretch.y - stretch.x);
    if (result.ray.end < 0.0) {
        result.hit = solidMiss(result.ray, 0.0, RELIEVO_OUTCOME_MISS);
    } else {
        result.hit = searchSolid(result.ray);
    }
#ifndef RELIEVO_SHAPE_BOX
    bool isBottom = result.ray.end >= 0.0 && result.hit.outcome == RELIEVO_OUTCOME_MISS &&
                    direction.z > 0.0 && result.hit.position.z >= 1.0 - 1e-5;
    if (relievoSolidFloor && isBottom) {
        result.hit.outcome = RELIEVO_OUTCOME_HIT;
        result.hit.part = 0;
        result.hit.place = result.hit.position;
        result.hit.side = vec3(0.0, 0.0, -1.0);
    }
    side = vec3(0.0, 0.0, -1.0);
#endif
    result.position = result.start + result.hit.t * view;
    result.normal = -view;
    if (solidIsShown(result)) {
        // Solid from the start: the side of the box or the surface; the eye is in it where there is none.
        vec3 covector = result.hit.t <= 0.0 ? side : solidCovector(result.hit);
        vec3 normal = covector * frame.toWhole;
        if (dot(normal, normal) > 0.0) result.normal = normalize(normal);
    }
    return result;
}

#ifdef RELIEVO_SHAPE_BOX
SolidTrace traceSolid(vec3 position, vec3 view, vec4 eye, mat4 viewProjection) {
    return traceSolid(solidFrame(position), view, reliefNearPlane(position, view, eye, viewProjection));
}
#else
SolidTrace traceSolid(ReliefSurface surface, vec3 view) { return traceSolid(solidFrame(surface), view, 0.0); }
#endif

// For gl_FragDepth, under the layout of programs/depth_output.glsl: the window depth of a hit, on the side of
// the fragment's that the layout promises, in spite of rounding. A miss hides nothing.
float solidWindowDepth(SolidTrace trace, mat4 viewProjection) {
    float depth = reliefToWindowDepth(viewProjection * vec4(trace.position, 1.0));
    bool isMiss = trace.hit.outcome == RELIEVO_OUTCOME_MISS;
#ifdef RELIEVO_SHAPE_BOX
    return isMiss ? gl_FragCoord.z : reliefNearerDepth(depth, gl_FragCoord.z);
#else
    return isMiss ? reliefFarthestDepth() : reliefFartherDepth(depth, gl_FragCoord.z);
#endif
}

// Whether light from `toLight` (unit length, in world space) gets to a hit past the solid itself.
bool solidIsLit(SolidTrace trace, vec3 toLight) {
    if (dot(trace.normal, toLight) <= 0.0) return false;
    SolidPart info = solidParts[max(trace.hit.part, 0)];
    // A hundredth of a texel off the surface, so that the ray does not begin in it; and by as much as stored
    // distances are rounded, which makes stairs of it.
    mat3 toPart = mat3(info.fromWhole) * trace.toWhole;
    vec3 off = toPart * trace.normal;
    float lift = (0.01 + info.section.w) * info.windowMaximum.w / max(length(off), 1e-30);
    SolidRay ray;
    ray.origin = trace.hit.position + trace.toWhole * (lift * trace.normal);
    ray.direction = trace.toWhole * toLight;
    vec2 stretch = vec2(0.0, kReliefBoundless);
    vec3 side = vec3(0.0);
    solidNarrowToBox(ray.origin, ray.direction, stretch, side);
    ray.end = stretch.y;
    if (stretch.x > 0.0 || ray.end <= 0.0) return true;
    solidSteps = 0;
    solidIsExhausted = false;
    return searchSolid(ray).outcome != RELIEVO_OUTCOME_HIT;
}
