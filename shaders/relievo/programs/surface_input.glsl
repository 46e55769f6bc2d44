// The fragment's side of programs/surface.vert.
#include "relievo/ray.glsl"

in vec3 surfacePosition;
in vec3 surfaceNormal;
in vec3 surfaceTangent;
in vec3 surfaceBitangent;
in vec2 surfaceUv;

uniform vec4 eye;  // the eye's position (w = 1), or the direction towards it (w = 0, orthographic)

ReliefSurface surfaceInput() {
    return ReliefSurface(surfacePosition, normalize(surfaceNormal), surfaceTangent, surfaceBitangent,
                         surfaceUv);
}

// Unit direction from the eye to a point of the surface, and to the one of the fragment.
vec3 surfaceView(vec3 position) { return normalize(position * eye.w - eye.xyz); }
vec3 surfaceView() { return surfaceView(surfacePosition); }
