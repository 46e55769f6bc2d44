#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "preprocess/apex_block.h"
#include "preprocess/crest_tree.h"
#include "preprocess/lanes.h"
#include "preprocess/slope_search.h"
#include "textures/depth_map.h"
#include "textures/plane.h"

namespace relievo::preprocess {

/// What chords of a crest search start from and end at.
enum class CrestLeaves {
    Texels,  ///< from texel centres to texel centres
    Cells,   ///< from anywhere in a texel's square to anywhere in a cell of the bilinear surface
};

/// The apexes of a block of texels.
struct CrestBlock {
    int left = 0;  ///< the first texel
    int top = 0;
    int width = kBlockSize;  ///< texels that are wanted, from the first on
    int height = kBlockSize;
    /// Depths nowhere above the surface at the corners of each square, in the order of ReliefQuad;
    /// of the centre, four times, where chords start there.
    std::array<BlockValues, 4> depth;
    BlockValues known;  ///< slopes up to which nothing is of interest
};

/// Searches the steepest chords along which rays may come out of the relief: bounds on
///
///   s(t) = max over x of texel t and y with D(y) < D(x), F(x,y) > 0 of (D(x) − D(y)) / |x − y|
///
/// in depth per texel width, F(x,y) = ∇D(y)·(y − x) with the gradient of the cell after y.
///
/// Between texel centres the maximum itself is found. From a square X to a cell Y, with corners x_k
/// and y_l, a bound is found: as F > 0, D(x) − D(y) is less than D(x) − D(y) + λ·F(x,y) for every
/// λ ≥ 0, which is affine in x and bilinear in y but for D(x), so that by the theorem of
/// bilinear_slopes.h chords between corners bound it. λ = 0, 1 and ∞ are tried for each pair:
/// chords of the surface, chords from the surface to the planes that touch it at y, and whether F
/// is positive at all.
///
/// Copies of the tile: under repeat those within kTiles tile widths are searched; nothing beyond
/// could be steeper than the whole depth of the relief over that distance, and at least so steep a
/// slope is found. Under mirror likewise, the odd ones with everything reflected. Under clamp the
/// tile suffices: a chord to a point outside is a chord to the point of the border beside it, of
/// the same depth and gradient, no longer. A map of one row or column is the same everywhere along
/// the other axis, where the same argument holds.
class CrestSearch {
  public:
    /// Copies as far as this are searched.
    static constexpr int kTiles = 4;
    /// Cells that begin up to so many texels after a texel's centre, or end so many before it, are
    /// left out along both axes: near_crests.h.
    static constexpr int kReach = 2;

    /// `depths`: withBorder(map). All must outlive the search. Chords in the directions of
    /// `sector` alone count; those to a cell that is there in part may count as a whole.
    CrestSearch(const textures::DepthMap& map, const textures::Plane& depths, const CrestTree& tree,
                CrestLeaves leaves, const ChordSector& sector = {});

    /// The slopes of a block, rounded up to few bits (so that no order of search changes them), and
    /// at least `known` rounded up. Values beyond width and height are undefined.
    void find(const CrestBlock& block, BlockValues& slopes);

    [[nodiscard]] const SlopeSearchStatistics& statistics() const noexcept { return statistics_; }

    /// Neighbouring texels: columns and rows, and in the order of packetIndex (packet_search.h) the
    /// depths of the corners and known slopes.
    struct alignas(64) Packet {
        std::array<float, kPacketSize> column;
        std::array<float, kPacketSize> row;
        std::array<std::array<float, kPacketApexes>, 4> depth;
        std::array<float, kPacketApexes> known;
    };
    /// A leaf in a copy of the tile, given by the first column and row of the copy, as seen with
    /// reflected axes (bit 0: x, bit 1: y).
    struct Place {
        int i = -1;  ///< −1: none
        int j = 0;
        int copyI = 0;
        int copyJ = 0;
        int reflection = 0;
        [[nodiscard]] bool exists() const noexcept { return i >= 0; }
        bool operator==(const Place&) const = default;
    };
    struct alignas(64) Found {
        std::array<float, kPacketApexes> slope;
        std::array<Place, kPacketApexes> place;
    };
    struct Node {
        int level;
        Place place;
        float bound;  ///< no chord into it is steeper, squared, for the packet as a whole
    };
    /// What the search is done on.
    struct Scene {
        const textures::Plane* depths;
        const CrestTree* tree;
        float aspect;
        textures::WrapMode wrap;
        int width;  ///< of the tile, in texels
        int height;
        int copiesX;  ///< to each side
        int copiesY;
        ChordSector sector;
    };

  private:
    Scene scene_;
    CrestLeaves leaves_;
    float reach_;  ///< texel widths to the nearest copy that is not searched
    std::vector<Node> stack_;
    SlopeSearchStatistics statistics_;
};

}  // namespace relievo::preprocess
