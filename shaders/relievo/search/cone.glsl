// The cone on the surface that a texel holds, the widest one that stands there (specification 3.1 and E3),
// and the way out of it.
//
// Cones with a guarantee on the bilinear surface (RELIEVO_CONE_BILINEAR) hold for every apex in their
// texel's square: the nearest one is taken. Cones of texel centres hold there only: between them the
// narrowest cone of the cell's four corners is taken. The nearest one alone would be far too wide
// beside a cliff, and so would be any mean of them; what is left is the curvature of the cell.
//
// Cones with that guarantee may differ for RELIEVO_CONE_SECTORS sectors of directions: what lies behind a
// ray does not limit its step.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"
#include "relievo/search/sector.glsl"

// Ratio, or radius = ratio·D; a layer a sector.
#ifdef RELIEVO_CONE_SECTORS
uniform sampler2DArray relievoConeMap;
#else
uniform sampler2D relievoConeMap;
#endif
uniform int relievoConeSteps;

#ifdef RELIEVO_CONE_SECTORS
// The sector of a ray in the tile that holds a point: mirrored tiles see it mirrored.
int reliefConeSector(ReliefRay ray, vec2 uv) {
    vec2 direction = ray.direction.xy * vec2(reliefMapSize());
#ifdef RELIEVO_WRAP_MIRROR
    direction *= 1.0 - 2.0 * mod(floor(uv), 2.0);
#endif
    return reliefSector(direction, RELIEVO_CONE_SECTORS);
}
#endif

// The ratio of the cone at a point of the surface: `nearest` is in the square of its texel, `corner` where
// the four texels of its cell meet, whose depths are given.
float reliefConeRatio(ReliefRay ray, vec2 nearest, vec2 corner, vec4 depths) {
    ++reliefFetchCount;
#if defined(RELIEVO_CONE_SECTORS)
    vec3 place = vec3(nearest, reliefConeSector(ray, nearest));
    return textureLod(relievoConeMap, place, float(reliefLevel)).r;
#elif defined(RELIEVO_CONE_BILINEAR)
    return textureLod(relievoConeMap, nearest, float(reliefLevel)).r;
#else
    vec4 cones = reliefGather(relievoConeMap, corner);
#ifdef RELIEVO_CONE_RADIUS
    // A corner of depth 0 is a highest point: it has no cone, and the radius says nothing.
    const float unlimited = 1e30;
    cones = mix(vec4(unlimited), cones / max(depths, vec4(1e-30)), greaterThan(depths, vec4(0.0)));
#endif
    return min(min(cones.x, cones.y), min(cones.z, cones.w));
#endif
}

// The length of the step from a point `gap` above the surface to the side of the cone on it: t with
// speed·t = ratio·(gap − dz·t). A ray that rises as steeply as the cone never leaves it.
float reliefConeStep(ReliefRay ray, float ratio, float gap) {
    float closing = ray.speed + ratio * ray.direction.z;
    return closing > 0.0 ? ratio * gap / closing : ray.end;
}
