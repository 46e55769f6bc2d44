// Window depths of points in clip space: those of glDepthRange (gl_DepthRange), of a clip volume from −1 to
// 1 in depth, or from 0 to 1 with RELIEVO_CLIP_ZERO_TO_ONE (glClipControl). With RELIEVO_DEPTH_REVERSED what
// is farther has the lesser window depth, by the projection or by glDepthRange.

// Window depth of a point in clip space.
float reliefToWindowDepth(vec4 clip) {
#ifdef RELIEVO_CLIP_ZERO_TO_ONE
    return gl_DepthRange.diff * clamp(clip.z / clip.w, 0.0, 1.0) + gl_DepthRange.near;
#else
    float device = clamp(clip.z / clip.w, -1.0, 1.0);
    return 0.5 * (gl_DepthRange.diff * device + gl_DepthRange.near + gl_DepthRange.far);
#endif
}

// The window depth of what is as far away as can be, and the nearer and the farther one of two.
#ifdef RELIEVO_DEPTH_REVERSED
float reliefFarthestDepth() { return min(gl_DepthRange.near, gl_DepthRange.far); }
float reliefNearerDepth(float a, float b) { return max(a, b); }
float reliefFartherDepth(float a, float b) { return min(a, b); }
#else
float reliefFarthestDepth() { return max(gl_DepthRange.near, gl_DepthRange.far); }
float reliefNearerDepth(float a, float b) { return min(a, b); }
float reliefFartherDepth(float a, float b) { return max(a, b); }
#endif

// The t at which position + t·view, seen from `eye` (w = 0: a direction), passes the near plane.
float reliefNearPlane(vec3 position, vec3 view, vec4 eye, mat4 viewProjection) {
    float behind = eye.w > 0.0 ? -length(position - eye.xyz) : -1e30;
    vec4 place = viewProjection * vec4(position, 1.0);
    vec4 along = viewProjection * vec4(view, 0.0);
#ifdef RELIEVO_CLIP_ZERO_TO_ONE
    vec2 start = vec2(place.z, place.z - place.w);
    vec2 speed = vec2(along.z, along.z - along.w);
#else
    vec2 start = vec2(place.z + place.w, place.z - place.w);
    vec2 speed = vec2(along.z + along.w, along.z - along.w);
#endif
    // Of the two planes the nearer one in front of the eye; the far one may be infinitely far.
    float nearest = 1e30;
    for (int k = 0; k < 2; ++k) {
        float t = speed[k] != 0.0 ? -start[k] / speed[k] : 1e30;
        if (t > behind) nearest = min(nearest, t);
    }
    return nearest < 1e30 ? nearest : behind;
}
