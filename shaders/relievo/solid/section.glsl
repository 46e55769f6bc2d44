// A ray as the section of a revolution sees it: its distance from the axis, a hyperbola, beside its depth,
// over the bilinear cells of the section. In texels; x is counted from the first texel's centre, which lies
// half a texel from the axis.
//
// As in search/walk.glsl the cell is a pair of integers that moves along the ray; x first falls to where the
// ray comes nearest to the axis and then grows.
#include "relievo/solid/path.glsl"

struct SolidSection {
    float nearest;  // to the axis that the ray's line comes
    float turn;     // t where it does
    float across;   // texels across the axis per unit of t, ≥ 0
    float start;    // rows at t = 0, from the first texel's centre
    float down;     // rows per unit of t
    ivec2 size;
    ivec2 cell;     // from −1 on
    float t;        // where the ray enters the cell
    float exit;     // where it leaves it, ≥ t
};

float solidRadius(SolidSection section, float t) {
    return length(vec2(section.nearest, section.across * (t - section.turn)));
}

// Where the ray is in its cell.
vec2 solidPlaceInSection(SolidSection section, float t) {
    vec2 place = vec2(solidRadius(section, t) - 0.5, section.start + t * section.down) - vec2(section.cell);
    // One cell reaches to infinity beyond the last centres, and is the same all over.
    return clamp(place, 0.0, 1.0);
}

// t at which the ray is `radius` from the axis, before or after the turn; kReliefBoundless: never.
float solidRadiusTime(SolidSection section, float radius, bool isBefore) {
    float square = (radius - section.nearest) * (radius + section.nearest);
    if (square < 0.0 || section.across == 0.0) return kReliefBoundless;
    float way = sqrt(square) / section.across;
    return section.turn + (isBefore ? -way : way);
}

// t at which the ray leaves the cell along each axis.
vec2 solidSectionExits(SolidSection section) {
    vec2 exits = vec2(kReliefBoundless);
    bool isFalling = section.t < section.turn;
    float inner = float(section.cell.x) + 0.5;
    if (isFalling && section.cell.x >= 0 && inner > section.nearest) {
        exits.x = solidRadiusTime(section, inner, true);
    } else if (section.cell.x < section.size.x - 1) {
        exits.x = solidRadiusTime(section, inner + 1.0, false);
    }
    if (section.down > 0.0 && section.cell.y < section.size.y - 1)
        exits.y = (float(section.cell.y + 1) - section.start) / section.down;
    if (section.down < 0.0 && section.cell.y >= 0)
        exits.y = (float(section.cell.y) - section.start) / section.down;
    return exits;
}

void solidFindSectionExit(inout SolidSection section) {
    vec2 exits = solidSectionExits(section);
    section.exit = max(min(exits.x, exits.y), section.t);
}

// On to the cell of the ray's point at t, never back.
void solidJumpSection(inout SolidSection section, float t) {
    vec2 place = vec2(solidRadius(section, t) - 0.5, section.start + t * section.down);
    ivec2 target = ivec2(clamp(floor(place), vec2(-1.0), vec2(section.size - 1)));
    if (t < section.turn) target.x = min(target.x, section.cell.x);
    if (section.t >= section.turn) target.x = max(target.x, section.cell.x);
    target.y = section.down > 0.0 ? max(target.y, section.cell.y) : min(target.y, section.cell.y);
    section.cell = target;
    section.t = t;
    solidFindSectionExit(section);
}

// On to the next cell.
void solidStepSection(inout SolidSection section) {
    vec2 exits = solidSectionExits(section);
    bool isFalling = section.t < section.turn && float(section.cell.x) + 0.5 > section.nearest;
    section.t = section.exit;
    if (exits.x <= exits.y) {
        section.cell.x += isFalling ? -1 : 1;
    } else {
        section.cell.y += section.down > 0.0 ? 1 : -1;
    }
    solidFindSectionExit(section);
}

// The section at t of a ray in tile space, whose replica is `tile`; isTurned: upside down.
SolidSection solidBeginSection(SolidPath path, vec2 axis, ivec3 tile, bool isTurned, ivec2 size, float t) {
    float width = float(size.x);
    vec2 origin = (path.origin.xy - vec2(tile.xy) - axis) * width;
    vec2 direction = path.direction.xy * width;
    SolidSection section;
    section.size = size;
    section.across = length(direction);
    vec2 along = section.across > 0.0 ? direction / section.across : vec2(1.0, 0.0);
    section.nearest = section.across > 0.0 ? abs(origin.x * along.y - origin.y * along.x) : length(origin);
    section.turn = section.across > 0.0 ? -dot(origin, along) / section.across : 0.0;
    float height = float(size.y);
    float depth = path.origin.z - float(tile.z);
    section.start = height * (isTurned ? 1.0 - depth : depth) - 0.5;
    section.down = height * (isTurned ? -path.direction.z : path.direction.z);
    vec2 place = vec2(solidRadius(section, t) - 0.5, section.start + t * section.down);
    section.cell = ivec2(clamp(floor(place), vec2(-1.0), vec2(size - 1)));
    section.t = t;
    solidFindSectionExit(section);
    return section;
}
