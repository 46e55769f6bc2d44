// The parts of a solid, each with its map and by its kind.
#include "relievo/solid/extrusion.glsl"
#include "relievo/solid/revolution.glsl"

// Signed distances in texels, linear between texel centres; and their unit gradients ∂d/∂(u, ρ·v).
uniform sampler2D relievoSolidDistances0;
uniform sampler2D relievoSolidGradients0;
#if RELIEVO_SOLID_PARTS > 1
uniform sampler2D relievoSolidDistances1;
uniform sampler2D relievoSolidGradients1;
#endif
#if RELIEVO_SOLID_PARTS > 2
uniform sampler2D relievoSolidDistances2;
uniform sampler2D relievoSolidGradients2;
#endif
#if RELIEVO_SOLID_PARTS > 3
uniform sampler2D relievoSolidDistances3;
uniform sampler2D relievoSolidGradients3;
#endif

#if RELIEVO_SOLID_KIND0 == RELIEVO_SOLID_REVOLUTION
#define SOLID_CROSS0 solidCrossRevolution
#else
#define SOLID_CROSS0 solidCrossExtrusion
#endif
#if RELIEVO_SOLID_PARTS > 1
#if RELIEVO_SOLID_KIND1 == RELIEVO_SOLID_REVOLUTION
#define SOLID_CROSS1 solidCrossRevolution
#else
#define SOLID_CROSS1 solidCrossExtrusion
#endif
#endif
#if RELIEVO_SOLID_PARTS > 2
#if RELIEVO_SOLID_KIND2 == RELIEVO_SOLID_REVOLUTION
#define SOLID_CROSS2 solidCrossRevolution
#else
#define SOLID_CROSS2 solidCrossExtrusion
#endif
#endif
#if RELIEVO_SOLID_PARTS > 3
#if RELIEVO_SOLID_KIND3 == RELIEVO_SOLID_REVOLUTION
#define SOLID_CROSS3 solidCrossRevolution
#else
#define SOLID_CROSS3 solidCrossExtrusion
#endif
#endif

bool solidIsRevolution(int part) {
    if (part == 0) return RELIEVO_SOLID_KIND0 == RELIEVO_SOLID_REVOLUTION;
#if RELIEVO_SOLID_PARTS > 1
    if (part == 1) return RELIEVO_SOLID_KIND1 == RELIEVO_SOLID_REVOLUTION;
#endif
#if RELIEVO_SOLID_PARTS > 2
    if (part == 2) return RELIEVO_SOLID_KIND2 == RELIEVO_SOLID_REVOLUTION;
#endif
#if RELIEVO_SOLID_PARTS > 3
    if (part == 3) return RELIEVO_SOLID_KIND3 == RELIEVO_SOLID_REVOLUTION;
#endif
    return false;
}

// On to the next place where the ray passes the surface of a part, from the cursor's.
void solidCross(int part, SolidPath path, inout SolidCursor cursor) {
    if (part == 0) SOLID_CROSS0(relievoSolidDistances0, 0, path, cursor);
#if RELIEVO_SOLID_PARTS > 1
    if (part == 1) SOLID_CROSS1(relievoSolidDistances1, 1, path, cursor);
#endif
#if RELIEVO_SOLID_PARTS > 2
    if (part == 2) SOLID_CROSS2(relievoSolidDistances2, 2, path, cursor);
#endif
#if RELIEVO_SOLID_PARTS > 3
    if (part == 3) SOLID_CROSS3(relievoSolidDistances3, 3, path, cursor);
#endif
}

// The stored gradient of a part's distances at (u,v) of its map, of unit length or less.
vec2 solidStoredGradient(int part, vec2 uv) {
    ++reliefFetchCount;
    if (part == 0) return textureLod(relievoSolidGradients0, uv, 0.0).rg;
#if RELIEVO_SOLID_PARTS > 1
    if (part == 1) return textureLod(relievoSolidGradients1, uv, 0.0).rg;
#endif
#if RELIEVO_SOLID_PARTS > 2
    if (part == 2) return textureLod(relievoSolidGradients2, uv, 0.0).rg;
#endif
#if RELIEVO_SOLID_PARTS > 3
    if (part == 3) return textureLod(relievoSolidGradients3, uv, 0.0).rg;
#endif
    return vec2(0.0);
}

#ifdef RELIEVO_SOLID_CREASED
bool solidCornerGradientOf(int part, vec2 uv, out vec2 gradient) {
    if (part == 0) return solidCornerGradient(relievoSolidDistances0, part, uv, gradient);
#if RELIEVO_SOLID_PARTS > 1
    if (part == 1) return solidCornerGradient(relievoSolidDistances1, part, uv, gradient);
#endif
#if RELIEVO_SOLID_PARTS > 2
    if (part == 2) return solidCornerGradient(relievoSolidDistances2, part, uv, gradient);
#endif
#if RELIEVO_SOLID_PARTS > 3
    if (part == 3) return solidCornerGradient(relievoSolidDistances3, part, uv, gradient);
#endif
    gradient = vec2(0.0);
    return false;
}
#endif

// The gradient of a part's distances at (u,v) of its tiles, of unit length or less; beside a corner that of the
// side that the place is on.
vec2 solidGradientAt(int part, vec2 uv) {
#ifdef RELIEVO_SOLID_CREASED
    vec2 corner;
    if (solidCornerGradientOf(part, uv, corner)) return corner;
#endif
    vec2 gradient = solidStoredGradient(part, uv);
    if (solidIsMirrored(part) && !solidIsRevolution(part)) gradient *= 1.0 - 2.0 * mod(floor(uv), 2.0);
    return gradient;
}

// Height over width of a part's map.
float solidAspect(int part) {
    ivec2 size = ivec2(1);
    if (part == 0) size = textureSize(relievoSolidDistances0, 0);
#if RELIEVO_SOLID_PARTS > 1
    if (part == 1) size = textureSize(relievoSolidDistances1, 0);
#endif
#if RELIEVO_SOLID_PARTS > 2
    if (part == 2) size = textureSize(relievoSolidDistances2, 0);
#endif
#if RELIEVO_SOLID_PARTS > 3
    if (part == 3) size = textureSize(relievoSolidDistances3, 0);
#endif
    return float(size.y) / float(size.x);
}
