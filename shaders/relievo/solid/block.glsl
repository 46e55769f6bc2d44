// What a solid is made of, as relievo::materials::SolidMaterial hands it over: parts in boxes of their own
// tile spaces, joined one after the other. Every number is a uniform, so that a solid can be edited while it
// is shown; only how many parts there are and of which kinds is in the text:
//
//   RELIEVO_SOLID_PARTS  1 to RELIEVO_SOLID_MOST_PARTS
//   RELIEVO_SOLID_KIND0 …  RELIEVO_SOLID_EXTRUSION or RELIEVO_SOLID_REVOLUTION
//
// Tile space of a part: (u,v) in tiles of its shape, z its normalised depth. Lengths are in texels of the
// map, which are square.
#include "relievo/constants.h"

// A straight piece of a profile. The last three hold a number for each way of a ray, see solidWay.
struct SolidPiece {
    vec4 line;      // its depths at the top and at the bottom, the offset at the top, and its slope
    vec4 normals;   // (outline's direction, upwards) at the top and at the bottom
    vec4 chords;    // the steepest way in which the profile comes nearer, up to the limit below
    vec4 extremes;  // the nearest that it comes anywhere on that way
    vec4 limits;    // the depth of the next level step, where the chords end
};

struct SolidPart {
    mat4 fromWhole;      // from the space of the whole
    vec4 windowMinimum;  // nothing of the part is outside; w: most by which distances are above steps
    vec4 windowMaximum;  // w: width of a texel in tiles
    vec4 section;        // u and v of the axis; extension; what rounding has taken of stored distances
    ivec4 ways;          // pieces; wrap mode; operation; how it is textured
    vec4 color;          // linear RGB
};

layout(std140) uniform RelievoSolid {
    SolidPart solidParts[RELIEVO_SOLID_PARTS];
    SolidPiece solidPieces[RELIEVO_SOLID_PARTS * RELIEVO_SOLID_MOST_PIECES];
};

uniform int relievoSolidSteps;  // cells that a search may look at before it gives up

int solidSteps = 0;
bool solidIsExhausted = false;  // a search has given up

bool solidIsClamped(int part) { return solidParts[part].ways.y == RELIEVO_SOLID_CLAMP; }
bool solidIsMirrored(int part) { return solidParts[part].ways.y == RELIEVO_SOLID_MIRROR; }
