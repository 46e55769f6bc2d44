#include "materials/profile_bounds.h"

#include <algorithm>

namespace relievo::materials {
namespace {

// A piece as a ray comes by it: places along its way, offsets as it sees them.
struct Stretch {
    double start;
    double end;
    double startOffset;
    double endOffset;
};

std::vector<Stretch> stretches(const solids::Profile& profile, bool isUp, bool isInside) {
    const double sense = isInside ? -1.0 : 1.0;
    std::vector<Stretch> result;
    for (const solids::ProfilePiece& piece : profile.pieces)
        result.push_back(isUp ? Stretch{-piece.bottom, -piece.top, sense * piece.bottomOffset,
                                        sense * piece.topOffset}
                              : Stretch{piece.top, piece.bottom, sense * piece.topOffset,
                                        sense * piece.bottomOffset});
    if (isUp)
        std::ranges::reverse(result);
    return result;
}

// Offsets of one knot, computed in two ways.
constexpr double kRounding = 1e-9;

// The piece before the next step that comes nearer, or the last one.
std::size_t lastBeforeStep(const std::vector<Stretch>& way, std::size_t first) {
    std::size_t last = first;
    while (last + 1 < way.size() && way[last + 1].startOffset <= way[last].endOffset + kRounding)
        ++last;
    return last;
}

double steepestChord(const std::vector<Stretch>& way, std::size_t first, std::size_t last) {
    const Stretch& from = way[first];
    double steepest = (from.endOffset - from.startOffset) / (from.end - from.start);
    // Seen from a point that moves along a line, the slope towards another point is monotone: that
    // from the ends of the piece bounds it.
    for (std::size_t k = first + 1; k <= last; ++k) {
        const Stretch& to = way[k];
        steepest =
            std::max({steepest, (to.startOffset - from.startOffset) / (to.start - from.start),
                      (to.endOffset - from.startOffset) / (to.end - from.start),
                      (to.endOffset - from.endOffset) / (to.end - from.end)});
        if (to.start > from.end)
            steepest =
                std::max(steepest, (to.startOffset - from.endOffset) / (to.start - from.end));
    }
    return steepest;
}

}  // namespace

std::vector<ProfileBounds> profileBounds(const solids::Profile& profile) {
    const std::size_t count = profile.pieces.size();
    std::vector<ProfileBounds> bounds(count);
    for (std::size_t w = 0; w < kProfileWays; ++w) {
        const bool isUp = w % 2 == 1;
        const std::vector<Stretch> way = stretches(profile, isUp, w >= 2);
        double extreme = way.back().endOffset;
        for (std::size_t k = count; k-- > 0;) {
            const std::size_t last = lastBeforeStep(way, k);
            extreme = std::max({extreme, way[k].startOffset, way[k].endOffset});
            ProfileBounds& piece = bounds[isUp ? count - 1 - k : k];
            piece.extreme[w] = extreme;
            piece.chord[w] = steepestChord(way, k, last);
            const bool hasStep = last + 1 < count;
            piece.limit[w] =
                hasStep ? (isUp ? -way[last].end : way[last].end) : (isUp ? -1.0 : 2.0);
        }
    }
    return bounds;
}

}  // namespace relievo::materials
