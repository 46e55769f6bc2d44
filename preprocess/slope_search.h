#pragma once

#include <array>
#include <climits>
#include <cstdint>
#include <span>
#include <vector>

#include "preprocess/lanes.h"
#include "preprocess/relief_tree.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {

/// The work of a slope search. It depends on the map alone, not on threads or the machine.
struct SlopeSearchStatistics {
    std::uint64_t packets = 0;  ///< searches of neighbouring apexes at once
    std::uint64_t nodes = 0;    ///< nodes whose bound was computed for a packet
    std::uint64_t samples = 0;  ///< samples whose slope was computed for a packet
    SlopeSearchStatistics& operator+=(const SlopeSearchStatistics& other) noexcept;
};

/// The directions of the chords that count, those on the border of a sector included.
struct ChordSector {
    enum class Half { Both, Shallow, Steep };
    float signX = 0.0f;      ///< ±1: towards greater or smaller columns; 0: both
    float signY = 0.0f;      ///< the same for rows
    Half half = Half::Both;  ///< of a quadrant: |dx| ≥ |dy| or |dx| ≤ |dy| in the metric
    float slack = 0.0f;      ///< how far past its border a half goes, along an axis

    [[nodiscard]] bool isAll() const noexcept { return signX == 0.0f; }
    /// For apexes that are cells, with chords between any point of the cell and any point of a cell
    /// with the sample at a corner: whether a sample counts that is (fromX,fromY) texel widths from
    /// the middle of a cell of the given half sides.
    [[nodiscard]] bool counts(double fromX, double fromY, double halfSide,
                              double halfHeight) const noexcept;
};

/// Sector `number` of 1, 4 or 8: all directions, or the quadrant (dx<0) + 2·(dy<0), of eight the
/// half that is steep + 4.
ChordSector chordSector(int number, int sectors) noexcept;

/// The rules of one kind of search. Lengths in texel widths.
struct SlopeSearchRules {
    /// Samples no farther than this from an apex in both axes are left out: a window is searched
    /// faster by chord_table.h.
    float window = 0.0f;
    /// Taken off every squared distance: what the interpolation between samples may add to a slope
    /// (bilinear_slopes.h says why).
    float correction = 0.0f;
    /// Apexes are squares (cells) of this half side; 0 for points.
    float halfSide = 0.0f;
    /// Slopes are rounded up to floats with so many bits after the first: a search gives up what
    /// cannot reach the next number, and what it finds does not depend on its order.
    int bits = 20;
    ChordSector sector = {};
};

/// A copy of the tile that is searched: where its first sample lies, and which axes are mirrored.
struct TileCopy {
    int i = 0;
    int j = 0;
    bool flipsX = false;
    bool flipsY = false;
};

/// Where a search looks.
struct SlopeSearchSpace {
    const ReliefTree& tree;
    textures::WrapMode wrap;
    float aspect;  ///< the height of a texel over its width
    std::vector<TileCopy> copies;
};

/// A node on the stack of a search.
struct SlopeSearchNode {
    int level;
    int i;
    int j;
    int copy;     ///< index of its copy of the tile
    float bound;  ///< no chord into it is steeper, squared, for the packet as a whole
};

/// A sample, by column and row in the plane of all copies of the tile.
struct SamplePlace {
    static constexpr int kNone = INT_MIN;
    int i = kNone;
    int j = kNone;
    [[nodiscard]] bool exists() const noexcept { return i != kNone; }
    bool operator==(const SamplePlace&) const = default;
};

/// Apexes are searched in packets of so many columns and rows: neighbours open nearly the same
/// nodes.
inline constexpr int kPacketSize = 8;
inline constexpr std::size_t kPacketApexes = static_cast<std::size_t>(kPacketSize) * kPacketSize;
/// A packet is worked on in quarters of sixteen apexes: quarter q is in its left or right half
/// (q % 2) and in the upper or lower one (q / 2).
inline constexpr int kQuarters = 4;
inline constexpr int kQuarterSize = kPacketSize / 2;
static_assert(kQuarterSize * kQuarterSize == kLanes);

/// Neighbouring apexes: columns and rows in texels (fractions allowed), and in the order of
/// packetIndex (packet_search.h) their depths and the slopes up to which nothing is of interest.
struct alignas(64) SlopePacket {
    std::array<float, kPacketSize> column;
    std::array<float, kPacketSize> row;
    std::array<float, kPacketApexes> depth;
    std::array<float, kPacketApexes> known;
};

/// The slopes, and where the chords end (kNone where no slope is above the known one).
struct alignas(64) PacketSlopes {
    std::array<float, kPacketApexes> slope;
    std::array<SamplePlace, kPacketApexes> place;
};

/// Searches the steepest chords that rise from apexes to the samples of a map:
///
///   s(a) = max over samples y outside the window with D(y) < D(a) of (D(a) − D(y)) / √(|a−y|² − κ)
///
/// with κ the correction, in depth per texel width. Depth-first through a quadtree of least depths
/// and lower planes (relief_tree.h), the most promising child first; a node is given up when no
/// chord into it can be steeper than those that all apexes of the packet have already.
///
/// Under repeat the eight copies of the tile around it are searched as well. Under mirror and clamp
/// the tile itself suffices: a chord to another copy crosses the border of the tile, and with the
/// part behind the border folded back it is a chord to the same depth in the tile, no longer. That
/// changes its direction: in a sector the copies ahead are searched under mirror as well, and a
/// clamped map, whose border texels go on for ever, is searched in whole quadrants.
class SlopeSearch {
  public:
    /// `aspect`: the height of a texel over its width. The tree must outlive the search.
    SlopeSearch(const ReliefTree& tree, textures::WrapMode wrap, double aspect,
                const SlopeSearchRules& rules);

    /// The slopes of a packet: rounded up as the rules say, and at least `known` rounded down.
    /// `seeds` are tried first: where the chords of neighbours end is often steep here too.
    void find(const SlopePacket& packet, std::span<const SamplePlace> seeds, PacketSlopes& found);

    [[nodiscard]] const SlopeSearchStatistics& statistics() const noexcept { return statistics_; }

  private:
    SlopeSearchSpace space_;
    SlopeSearchRules rules_;
    std::vector<SlopeSearchNode> stack_;
    SlopeSearchStatistics statistics_;
};

}  // namespace relievo::preprocess
