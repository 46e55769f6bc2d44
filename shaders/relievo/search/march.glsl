// Linear search: equal steps along the ray until one lies in the solid.
#include "relievo/maps.glsl"
#include "relievo/ray.glsl"

// Looks at t = end·i/count for i = 1 … count. True when a sample lies in the solid: `inside` is its t
// and `outside` that of the sample before. Features between two samples are missed.
bool reliefMarch(ReliefRay ray, int count, out float outside, out float inside, inout int steps) {
    outside = 0.0;
    inside = 0.0;
    for (int i = 1; i <= count; ++i) {
        ++steps;
        inside = ray.end * (float(i) / float(count));
        vec3 point = reliefPoint(ray, inside);
        if (point.z >= reliefDepth(point.xy)) return true;
        outside = inside;
    }
    return false;
}
