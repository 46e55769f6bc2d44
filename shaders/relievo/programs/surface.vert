// A surface with tangent frames that carries a relief.
#include "relievo/constants.h"

layout(location = RELIEVO_ATTRIBUTE_POSITION) in vec3 position;
layout(location = RELIEVO_ATTRIBUTE_NORMAL) in vec3 normal;
layout(location = RELIEVO_ATTRIBUTE_TANGENT) in vec3 tangent;
layout(location = RELIEVO_ATTRIBUTE_BITANGENT) in vec3 bitangent;
layout(location = RELIEVO_ATTRIBUTE_UV) in vec2 uv;

uniform mat4 viewProjection;

// The same for every program, so that a surface is where it was when it was asked for alone.
invariant gl_Position;

out vec3 surfacePosition;
out vec3 surfaceNormal;
out vec3 surfaceTangent;
out vec3 surfaceBitangent;
out vec2 surfaceUv;

void main() {
    surfacePosition = position;
    surfaceNormal = normal;
    surfaceTangent = tangent;
    surfaceBitangent = bitangent;
    surfaceUv = uv;
    gl_Position = viewProjection * vec4(position, 1.0);
}
