// Revolutions as they were printed (Halli 2009, algorithm 4.5): steps by the distance to the section of the
// replica that the ray is in. They do not end at its border.
//
// Error: a step can lead into the solid of the next replica, or through it. Where the steps run out, after a
// few replicas, the search ends in front of the surface. Cost: one lookup a step.
#include "relievo/solid/printed.glsl"

// How far the section is from the ray at t, 0 inside.
float solidPrintedSectionDistance(SolidPath path, float t) {
    vec4 info = solidParts[0].section;
    ivec3 tile = solidTileAt(0, path, t);
    vec3 place = solidPoint(path, t) - vec3(tile);
    float depth = solidIsTurned(0, tile.z) ? 1.0 - place.z : place.z;
    vec2 section = vec2(length(place.xy - info.xy), depth);
    ivec2 size = textureSize(relievoSolidDistances0, 0);
    // As long as in the map's own metric: a radius counts its widths.
    return max(solidLinearLookup(relievoSolidDistances0, section * vec2(size)) - info.z, 0.0);
}

SolidHit searchSolid(SolidRay ray) {
    SolidPath path = solidPath(ray, 0);
    ivec2 size = textureSize(relievoSolidDistances0, 0);
    float speed = max(length(path.direction * vec3(size.xx, size.y)), 1e-20);
    float t = path.enter;
    for (int k = 0; k < relievoSolidSteps && t <= path.leave; ++k) {
        ++solidSteps;
        float distance = solidPrintedSectionDistance(path, t);
        if (distance <= 0.0) break;
        t += distance / speed;
    }
    float rest = solidPrintedSectionDistance(path, t);
    --reliefFetchCount;
    return solidPrintedHit(ray, path, t, rest, vec2(1.0, 0.0));
}
