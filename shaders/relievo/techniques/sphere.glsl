// Sphere tracing in a distance volume: each step is as long as the nearest point of the relief is far
// (Donnelly 2005). The volume's values hold for whole voxels, so that no step passes the surface; beside
// it they are 0, and least steps and binary search take over.
#include "relievo/search/two_phases.glsl"
#include "relievo/search/skip.glsl"
#include "relievo/search/binary.glsl"

uniform sampler2DArray relievoVolumeMap;  // tile widths, a layer for each slice of depth
uniform float relievoVolumeScale;         // a of the relief for which it was made

float reliefFreeLength(ReliefRay ray, vec3 point) {
    ++reliefFetchCount;
    float slices = float(textureSize(relievoVolumeMap, 0).z);
    float slice = clamp(floor(point.z * slices), 0.0, slices - 1.0);
    float distance = textureLod(relievoVolumeMap, vec3(point.xy, slice), float(reliefLevel)).r;
    // A flatter relief is nearer by no more than it is flatter; reliefDepthLength is a in t.
    float scale = min(1.0, ray.depthScale / relievoVolumeScale);
    return ray.depthScale > 0.0 ? distance * scale * reliefDepthLength(ray) / ray.depthScale
                                : RELIEVO_MAXIMUM_REACH;
}
