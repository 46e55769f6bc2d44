// Where a ray passes the surface of a revolution d(|R|, z) = e (specification 7.3), d bilinear in the section:
// the sphere as large as the distance is free of it, and within a cell the ray goes on to where a parabola
// that lies below the distance along it comes down to the surface. That is never behind the surface, and
// twice as many digits are right each time. Every replica is a solid of its own: no step leaves its tile.
//
// Error: rounding of floats. Cost: one lookup a cell, at a crease one more where the ray may pass the surface;
// and one a leap that was too long.
#include "relievo/solid/cell.glsl"
#include "relievo/solid/leap.glsl"
#include "relievo/solid/section.glsl"

// Texels: what floats make of distances from the axis of a thousand texels. Nearer is on the surface.
const float kSolidTouch = 6e-5;
const int kSolidParabolas = 48;
const float kSolidLastDigit = 1.2e-7;  // of 1, as floats have it

// Where textureGather takes the texels of the section's cell. Beyond the border the last texels go on: the
// sampler clamps.
vec2 solidSectionGather(SolidSection section) { return vec2(section.cell + 1) / vec2(section.size); }

// A bilinear field of a cell, less the extension, in the sense of the ray.
struct SolidCellField {
    vec4 terms;  // corner, slope across, slope down, twist
};

SolidCellField solidCellField(vec4 corners, float extension, float sense) {
    vec2 slope = vec2(corners.z, corners.x) - corners.w;
    return SolidCellField(sense * vec4(corners.w - extension, slope, (corners.y - corners.x) - slope.x));
}

float solidFieldAt(SolidCellField field, SolidSection section, float t) {
    vec2 place = solidPlaceInSection(section, t);
    return field.terms.x + field.terms.y * place.x + (field.terms.z + field.terms.w * place.x) * place.y;
}

// Along the ray at t: the slope of the field, a bound of its bend up to `end` on the same side of the turn,
// and a bound of its slope there.
vec3 solidFieldSlopes(SolidCellField field, SolidSection section, float t, float end) {
    vec2 place = solidPlaceInSection(section, t);
    float square = section.across * section.across;
    float radius = max(solidRadius(section, t), 1e-6);
    float least = max(min(radius, solidRadius(section, end)), 1e-6);
    float widening = square * (t - section.turn) / radius;
    float hollow = section.nearest / least;
    float bend = square * hollow * hollow / least;
    float across = max(abs(field.terms.y), abs(field.terms.y + field.terms.w));
    float down = max(abs(field.terms.z), abs(field.terms.z + field.terms.w));
    float slope = (field.terms.y + field.terms.w * place.y) * widening +
                  (field.terms.z + field.terms.w * place.x) * section.down;
    return vec3(slope, 2.0 * abs(field.terms.w * section.down) * section.across + across * bend,
                across * section.across + down * abs(section.down));
}

// How far the field is from 0 for certain, at a place where it has that value and slopes.
float solidFreeOfField(float value, vec3 slopes) {
    float parabola = sqrt(slopes.x * slopes.x + 2.0 * slopes.y * value) - slopes.x;
    return max(2.0 * value / max(parabola, 1e-30), value / max(slopes.z, 1e-30));
}

// From a place on the surface to where the field can first say on which side the ray is: the top of the
// parabola below it when it rises, and no less than what the field can change by unnoticed.
float solidLeaveSurface(vec3 slopes) {
    float rise = slopes.x > 0.0 ? slopes.x / max(slopes.y, 1e-30) : 0.0;
    return max(rise, max(sqrt(kSolidTouch / max(slopes.y, 1e-30)), kSolidTouch / max(slopes.z, 1e-30)));
}

// What the ray has for certain up to `stretch`, where the field has that value: from a place on the surface
// as far as it takes to leave it.
float solidFieldWay(SolidCellField field, SolidSection section, float t, float stretch, float value,
                    bool isLeaving) {
    vec3 slopes = solidFieldSlopes(field, section, t, stretch);
    return isLeaving ? solidLeaveSurface(slopes) : solidFreeOfField(max(value, 0.0), slopes);
}

// The distance in a cell, in the sense of the ray: the larger or smaller one of two fields.
struct SolidSectionCell {
    SolidCellField first;
#ifdef RELIEVO_SOLID_CREASED
    SolidCellField second;
    bool isLarger;
#endif
};

SolidSectionCell solidSectionCell(SolidCell cell, float extension, float sense) {
#ifdef RELIEVO_SOLID_CREASED
    return SolidSectionCell(solidCellField(cell.first, extension, sense),
                            solidCellField(cell.second, extension, sense), cell.isLarger == (sense > 0.0));
#else
    return SolidSectionCell(solidCellField(cell.first, extension, sense));
#endif
}

// The field that is the distance at t, and there its value.
SolidCellField solidShownField(SolidSectionCell cell, SolidSection section, float t, out float value) {
    value = solidFieldAt(cell.first, section, t);
#ifdef RELIEVO_SOLID_CREASED
    float second = solidFieldAt(cell.second, section, t);
    if ((value > second) != cell.isLarger) {
        value = second;
        return cell.second;
    }
#endif
    return cell.first;
}

// The same of the distance, of which `shown` is the field that it is. The smaller one of two may soon be the other one.
float solidSectionWay(SolidSectionCell cell, SolidCellField shown, SolidSection section, float t, float stretch,
                      float value, bool isLeaving) {
#ifdef RELIEVO_SOLID_CREASED
    if (!cell.isLarger) {
        float first = solidFieldAt(cell.first, section, t);
        float second = solidFieldAt(cell.second, section, t);
        return min(solidFieldWay(cell.first, section, t, stretch, first, isLeaving && first <= kSolidTouch),
                   solidFieldWay(cell.second, section, t, stretch, second, isLeaving && second <= kSolidTouch));
    }
#endif
    return solidFieldWay(shown, section, t, stretch, value, isLeaving);
}

// The first t from `from` on to `end` at which the distance comes down to 0; kReliefBoundless: none. False: it
// has not come so far, and `from` is where it has come. Up to the turn and from there on the bounds are
// different ones.
bool solidSectionRoot(SolidSectionCell cell, SolidSection section, float end, bool isOnSurface, bool isInside,
                      inout float from, out float root) {
    root = kReliefBoundless;
    // Inside of a map without signs the field is 0 all over: there only what is behind the surface is passed.
    float touch = isOnSurface || isInside ? 0.0 : kSolidTouch;
    for (int k = 0; k < kSolidParabolas; ++k) {
        float stretch = from < section.turn ? min(section.turn, end) : end;
        float value;
        SolidCellField shown = solidShownField(cell, section, from, value);
        bool isLevel =
            isInside && value == 0.0 && solidFieldSlopes(shown, section, from, stretch).x >= 0.0;
        bool isLeaving = isOnSurface || isLevel;
        float way = solidSectionWay(cell, shown, section, from, stretch, value, isLeaving);
        if (!isLeaving) {
            if (value > 2.0 * kSolidTouch) touch = kSolidTouch;
            // Where t has no more digits the rest of the way is its last one. That the sum of both is one of
            // them is not asked: compilers take that for a question of `way` being 0.
            if (value <= touch || way <= kSolidLastDigit * from) {
                root = from;
                return true;
            }
        }
        isOnSurface = false;
        from = min(from + way, stretch);
        if (from >= end) return true;
    }
    return false;
}

// solidSectionRoot for the distance of the section's cell, of which `samples` is known. What steps keep clear
// of from outside the distance does as well.
bool solidMeetSection(sampler2D map, SolidSection section, SolidSamples samples, float extension, float end,
                      SolidCursor cursor, bool isOnSurface, out float from, out float root) {
    float sense = cursor.isInside ? -1.0 : 1.0;
#ifdef RELIEVO_SOLID_CREASED
    if (samples.isCreased && !cursor.isInside && !isOnSurface) {
        from = section.t;
        SolidCell steps = SolidCell(samples.steps, samples.steps, true);
        bool isSettled = solidSectionRoot(solidSectionCell(steps, extension, sense), section, end, false, false,
                                          from, root);
        if (isSettled && root >= kReliefBoundless) return true;
    }
#endif
    from = section.t;
    SolidCell cell = solidCell(map, solidSectionGather(section), samples);
    return solidSectionRoot(solidSectionCell(cell, extension, sense), section, end, isOnSurface, cursor.isInside,
                            from, root);
}

// Whether the surface has been passed where the ray enters the section's cell: `gap` is sure of the distance
// less the extension, in the sense of the ray.
bool solidHasPassed(sampler2D map, int part, SolidSection section, SolidSamples samples, float gap,
                    bool isInside) {
    if (!solidIsPassed(gap, isInside)) return false;
    if (solidIsPassed(gap + solidCreaseDepth(part), isInside)) return true;
    SolidCell cell = solidCell(map, solidSectionGather(section), samples);
    float value;
    solidShownField(solidSectionCell(cell, solidParts[part].section.z, isInside ? -1.0 : 1.0), section,
                     section.t, value);
    return solidIsPassed(value, isInside);
}

bool solidIsTurned(int part, int tile) { return solidIsMirrored(part) && (tile & 1) != 0; }

// t at which the ray leaves a replica, and along which axis.
float solidTileExit(SolidPath path, ivec3 tile, out int axis) {
    float exit = kReliefBoundless;
    axis = 2;
    for (int k = 0; k < 3; ++k) {
        float direction = path.direction[k];
        if (direction == 0.0) continue;
        float border = float(tile[k] + (direction > 0.0 ? 1 : 0));
        float leave = (border - path.origin[k]) / direction;
        if (leave < exit) {
            exit = leave;
            axis = k;
        }
    }
    return exit;
}

// The replica that the ray is in at t; on a border the one that it goes into.
ivec3 solidTileAt(int part, SolidPath path, float t) {
    vec3 point = solidPoint(path, t);
    vec3 tile = mix(floor(point), ceil(point) - 1.0, lessThan(path.direction, vec3(0.0)));
    vec3 low = floor(solidParts[part].windowMinimum.xyz);
    vec3 high = max(ceil(solidParts[part].windowMaximum.xyz) - 1.0, low);
    return ivec3(clamp(clamp(tile, low, high), -1e6, 1e6));
}

SolidSection solidSectionOf(int part, SolidPath path, ivec3 tile, ivec2 size, float t) {
    return solidBeginSection(path, solidParts[part].section.xy, tile, solidIsTurned(part, tile.z), size, t);
}

// On to t where that is beyond the section's cell.
void solidReachSection(inout SolidSection section, float t) {
    if (t > section.exit) solidJumpSection(section, t);
}

// On to the next place where the ray passes the surface, from the cursor's.
void solidCrossRevolution(sampler2D map, int part, SolidPath path, inout SolidCursor cursor) {
    ivec2 size = textureSize(map, 0);
    vec4 info = solidParts[part].section;
    float sense = cursor.isInside ? -1.0 : 1.0;
    float speed = length(path.direction * vec3(size.xx, size.y));
    SolidSection section = solidSectionOf(part, path, cursor.tile, size, cursor.t);
    int axis;
    float tileExit = min(solidTileExit(path, cursor.tile, axis), path.leave);
    vec3 side = path.enterNormal;
    bool isFresh = true;  // at the start, or behind the border of a replica
    bool isOnSurface = cursor.isOnSurface;
    SolidLeap leap = solidBeginLeaps(section.t);
    SolidSection back = section;  // from where to go on after a leap that was too long
    while (solidSteps < relievoSolidSteps) {
        ++solidSteps;
        SolidSamples samples = solidLookUp(map, part, solidSectionGather(section));
        bool isBeyondCorners = !cursor.isInside && info.z >= RELIEVO_SOLID_CORNERS_END;
        SolidCellField sure = solidCellField(isBeyondCorners ? samples.distances : samples.steps, info.z, sense);
        if (cursor.isInside) sure.terms.x -= solidCreaseDepth(part);
        float exit = max(min(section.exit, tileExit), section.t);
        float clear = section.t;
        if (!isOnSurface) {
            float value = solidFieldAt(sure, section, section.t);
            if (isFresh && solidHasPassed(map, part, section, samples, value, cursor.isInside)) {
                // What is solid where a ray comes in shows the side that it came in by.
                cursor.t = section.t;
                cursor.side = side;
                return;
            }
            float around = kSolidShort * solidFree(value - info.w, 0.0, speed);
            if (!solidHasLanded(leap, section.t, around, around)) {
                section = back;
                solidReachSection(section, leap.clear);
                continue;
            }
            clear += around;
        }
        if (clear <= exit) {
            float root;
            float from;
            bool isSettled =
                solidMeetSection(map, section, samples, info.z, exit, cursor, isOnSurface, from, root);
            if (root < kReliefBoundless) {
                cursor.t = root;
                cursor.side = vec3(0.0);
                cursor.normal = vec2(1.0, 0.0);
                cursor.isOnSurface = true;
                return;
            }
            if (!isSettled) {
                section.t = leap.clear = from;
                isFresh = isOnSurface = false;
                continue;
            }
        }
        float gap = solidFieldAt(sure, section, exit);
        float free = kSolidShort * solidFree(gap - info.w, 0.0, speed);
        clear = solidClearOfIsland(leap, max(clear, exit + free));
        isFresh = false;
        isOnSurface = isOnSurface && exit <= cursor.t;  // a cell of no length does not lead off it
        if (clear < tileExit) {
            // The step alone is sure to leave the cell.
            float slope = solidFieldSlopes(sure, section, exit, exit).x;
            solidStepSection(section);
            back = section;
            leap.clear = max(clear, section.t);
            SolidOutlook outlook = SolidOutlook(gap, isOnSurface ? 0.0 : free * speed, -slope / speed, 0.0);
            solidReachSection(section, solidLeap(leap, outlook, speed, float(size.x), tileExit));
            continue;
        }
        cursor.isOnSurface = false;
        if (tileExit >= path.leave) {
            cursor.t = cursor.isInside ? path.leave : kReliefBoundless;
            cursor.side = path.leaveNormal;
            return;
        }
        float ahead = sign(path.direction[axis]);
        cursor.tile[axis] += int(ahead);
        side = vec3(0.0);
        side[axis] = -sense * ahead;
        section = solidSectionOf(part, path, cursor.tile, size, tileExit);
        tileExit = max(min(solidTileExit(path, cursor.tile, axis), path.leave), section.t);
        isFresh = true;
        leap = solidBeginLeaps(section.t);
    }
    cursor.t = min(section.t, leap.clear);
    solidIsExhausted = true;
}
