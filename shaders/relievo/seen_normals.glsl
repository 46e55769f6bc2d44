// The slopes that a MIP level has averaged away, and the normals that stand for them in shading.
//
// Beside the slopes of its own a level has the second moments of those it was made of. What the moments are
// more than the products of its slopes is the covariance of what was lost (Olano, Baker, LEAN mapping, 2010).
// Four slopes have the mean and the covariance of all; each counts by as much of it as is seen (Dupuy et al.,
// LEADR mapping, 2013), which is what hides the far sides of bumps from an eye that looks along the surface.
//
// A pixel of the first level has nothing of this to look up.
#include "relievo/material.glsl"
#include "relievo/shading/normals.glsl"

#ifdef RELIEVO_MIPS
// Means of dx², dx·dy and dy², slopes as in reliefGradient. Its first level belongs to the relief's second.
uniform sampler2D relievoMomentMap;

// As filtered for a level of the relief, 1 or more. They continue beyond the tile as slopes do
// (reliefTileSense).
vec3 reliefSlopeMoments(vec2 uv, float level) {
    ++reliefFetchCount;
    vec3 moments = textureLod(relievoMomentMap, uv, level - 1.0).rgb;
    vec2 sense = reliefTileSense(uv, int(level));
#if defined(RELIEVO_WRAP_MIRROR)
    moments.y *= sense.x * sense.y;
#elif defined(RELIEVO_WRAP_CLAMP)
    moments *= vec3(sense.x * sense.x, sense.x * sense.y, sense.y * sense.y);
#endif
    return moments;
}

// The covariance xx, xy, yy of what a level has lost. It fades in from the first level, which has lost
// nothing, to the second.
vec3 reliefLostSlopes(vec2 uv, float level) {
    float coarse = max(level, 1.0);
    vec2 own = reliefGradient(uv, coarse);
    vec3 lost = reliefSlopeMoments(uv, coarse) - vec3(own.x * own.x, own.x * own.y, own.y * own.y);
    // Filters and rounding may leave what is no covariance.
    lost.xz = max(lost.xz, 0.0);
    float bound = sqrt(lost.x * lost.z);
    lost.y = clamp(lost.y, -bound, bound);
    return min(level, 1.0) * lost;
}

// The columns of the square root of a covariance, which is symmetric too: unlike its axes the root goes along
// with the covariance without jumps.
mat2 reliefSquareRoot(vec3 covariance) {
    float root = sqrt(max(covariance.x * covariance.z - covariance.y * covariance.y, 0.0));
    float norm = inversesqrt(max(covariance.x + covariance.z + 2.0 * root, 1e-30));
    return norm * mat2(covariance.x + root, covariance.y, covariance.y, covariance.z + root);
}
#endif

// The normals that a pixel sees around a hit of traceRelief on `surface`.
ReliefNormals reliefSeenNormals(ReliefSurface surface, ReliefFragment relief) {
    float aspect = reliefAspect();
    ReliefNormals normals;
    normals.upright = reliefUprightNormal(surface, relief.gradient, aspect);
    normals.first = vec3(0.0);
    normals.second = vec3(0.0);
    normals.count = 1;
#ifdef RELIEVO_MIPS
    if (relief.level > 0.0) {
        // Each of four has a quarter of the covariance: a pair along a column lies √2 to both sides.
        mat2 columns =
            sqrt(2.0) * reliefSquareRoot(reliefLostSlopes(relief.hit.position.xy, relief.level));
        normals.first = reliefUprightNormal(surface, columns[0], aspect) - surface.normal;
        normals.second = reliefUprightNormal(surface, columns[1], aspect) - surface.normal;
        normals.count = 4;
    }
#endif
    return normals;
}
