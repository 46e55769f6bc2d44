// The search for a bevelled extrusion as it was printed (Halli 2009, algorithm 4.3): steps by the distance to
// the extended shape, which lies behind the bevel, until one ends inside of the bevel, then halvings.
#include "relievo/solid/printed.glsl"

uniform int relievoBinarySteps;

struct SolidBevel {
    float extension;  // e, texels
    float slope;      // b, texels per unit of depth
    float depth;      // c: where the first piece of the profile ends
};

SolidBevel solidPrintedBevel() {
    vec4 line = solidPieces[0].line;
    return SolidBevel(line.z, line.w, line.y);
}

float solidPrintedDepth(SolidPath path, float t) { return path.origin.z + t * path.direction.z; }

// From t on to the bevel, which is taken to go on below the profile.
void solidStepToBevel(SolidPath path, SolidBevel bevel, inout float t) {
    float speed = solidPrintedSpeed(path);
    float way = 0.0;
    for (int k = 0; k < relievoSolidSteps; ++k) {
        ++solidSteps;
        float distance = solidPrintedDistance(path, bevel.extension, t);
        if (distance - bevel.slope * solidPrintedDepth(path, t) <= 0.0) break;
        if (t > path.leave) return;
        way = distance / speed;
        t += way;
    }
    for (int k = 0; k < relievoBinarySteps && way > 0.0; ++k) {
        ++solidSteps;
        way *= 0.5;
        float distance = solidPrintedDistance(path, bevel.extension, t);
        t += distance - bevel.slope * solidPrintedDepth(path, t) > 0.0 ? way : -way;
    }
}

// How far the bevel is from the ray at t; below 0 inside.
float solidPrintedBevelRest(SolidPath path, SolidBevel bevel, float t) {
    return solidPrintedRest(path, bevel.extension, t) - bevel.slope * solidPrintedDepth(path, t);
}
