// Leaps of a search beyond what it knows to be free, made good from where they end: over-relaxed sphere tracing
// (Keinert et al. 2014, Enhanced sphere tracing). What is free around a place is free backwards as well: where
// that reaches what was free before, nothing has been missed. Where it does not, the search goes on from there
// as if it had not leapt, and a lookup is lost.
//
// How far to leap is guessed from a plane in place of the surface ahead, as by Bálint and Valasek (2018,
// Accelerating sphere tracing). The guess decides on the cost alone.
#include "relievo/ray.glsl"

struct SolidLeap {
    float clear;   // t up to which all is free; what is farther has to be made good
    vec2 island;   // from and to, farther on: free as well, as a leap has shown that was too long
    bool wasLost;  // the last leap was too long
};

// Widths of a map: what is farther away is seldom the surface that the guess is made of.
const float kSolidLongestLeap = 1.0 / 16.0;
// Texels a texel that the surface may come nearer by than the plane.
const float kSolidBend = 0.02;
// Texels: of smaller radii the gap is not what the guess takes it for.
const float kSolidNearest = 0.70710678;

SolidLeap solidBeginLeaps(float t) { return SolidLeap(t, vec2(kReliefBoundless, 0.0), false); }

// Two stretches without a gap between them overlap by what floats make of t at least.
const float kSolidOverlap = 1.0 + 2.4e-7;

// Whether all is free up to t, where the search has come to: it is from `back` before t on to `ahead` after it.
bool solidHasLanded(inout SolidLeap leap, float t, float back, float ahead) {
    if (!(t > leap.clear) || kSolidOverlap * t - back <= leap.clear) return true;
    leap.wasLost = true;
    if (back > 0.0) leap.island = vec2(t - back, t + ahead);
    return false;
}

// How far all is free that is so up to `clear`, with what leaps have shown.
float solidClearOfIsland(inout SolidLeap leap, float clear) {
    if (clear < leap.island.x) return clear;
    leap.island.x = kReliefBoundless;
    return max(clear, leap.island.y);
}

// What a leap is guessed from: a plane in place of the surface ahead, per texel of the ray's way.
struct SolidOutlook {
    float gap;      // texels that the distance is above the offset
    float radius;   // texels of the way that are free
    float nearing;  // how much the distance falls
    float rising;   // how much the offset grows
};

// How many texels on a place may be whose free way reaches back to the radius r.
//
// L texels on the gap is g − (nearing + rising)·L, and by (specification 7.2) b texels are free backwards with
// √(b² + ½) = gap + rising·b, as r is with √(r² + ½) = g − rising·r. So b = L − r has
// (L − r)² + ½ = (A − nearing·L)², A = √(r² + ½). An offset that grows by a texel and more gives all the way
// back as long as there is a gap.
float solidLeapReach(SolidOutlook outlook) {
    float nearing = min(outlook.nearing + kSolidBend, 1.0);
    float closing = nearing + outlook.rising;
    float reach = closing > 0.0 ? (outlook.gap - kSolidNearest) / closing : kReliefBoundless;
    if (outlook.rising >= 1.0) return reach;
    float radius = outlook.radius;
    float back = radius - nearing * sqrt(radius * radius + 0.5);
    return min(reach, 2.0 * back / max(1.0 - nearing * nearing, 1e-3));
}

// From `leap.clear` to the t at which to look next, before `end`. `width`: the map's texels.
float solidLeap(inout SolidLeap leap, SolidOutlook outlook, float speed, float width, float end) {
    bool isRefused = leap.wasLost || !(outlook.radius > kSolidNearest);
    leap.wasLost = false;
    if (isRefused) return leap.clear;
    float texels = min(solidLeapReach(outlook) - outlook.radius, kSolidLongestLeap * width);
    return leap.clear + max(min(texels / speed, 0.5 * (end - leap.clear)), 0.0);
}
