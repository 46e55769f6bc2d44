#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "preprocess/apex_block.h"
#include "preprocess/crest_search.h"
#include "textures/depth_map.h"

namespace relievo::preprocess {

/// Bounds on the chords from the square of a texel to the cells around it (those that
/// crest_search.h leaves out) along which rays may come out of the relief.
///
/// A pair of pieces, X in the square and Y in a cell, is bounded as crest_search.h does and, where
/// their cells touch, by gradients: the slope of the chord from x to y is the mean of −∇D·e over
/// it, e its direction, and F > 0 there means ∇D(y)·e > 0, so that the slope is at most
///
///   max over a = −∇D(p), p in the rectangle around X and Y, and b = ∇D(y), y in Y, of
///   max { a·e : |e| = 1, b·e ≥ 0 } = |a| where a·b ≥ 0, else |a × b| / |b|,
///
/// which vanishes on planes. Gradients of bilinear pieces are boxes, and corners of boxes suffice.
/// Pairs are halved until their bounds are nearly attained by a chord.
class NearCrests {
  public:
    /// Chords in the directions of `sector` alone count.
    explicit NearCrests(double aspect, const ChordSector& sector = {});

    /// Goes to the block of `map` whose first texel is (left,top).
    void begin(const textures::DepthMap& map, int left, int top);

    /// Depths nowhere above the surface at the corners of all squares, as CrestBlock wants them.
    void findCornerDepths(std::array<BlockValues, 4>& depth) const;

    /// For every texel a slope that some chord to these cells has along which a ray comes out.
    void findAttained(BlockValues& slopes) const;

    /// The bounds, and at least `slopes`, for width × height texels of the block.
    void refine(int width, int height, BlockValues& slopes);

    /// Pairs bounded so far: the work.
    [[nodiscard]] std::uint64_t pairs() const noexcept { return pairs_; }

    /// Texels are divided into so many parts along an axis.
    static constexpr int kParts = 8;
    /// A square part of a bilinear cell. Lengths in parts of a texel; places from the first texel
    /// of the surroundings.
    struct Piece {
        std::uint16_t x;
        std::uint16_t y;
        std::uint16_t side;  ///< a power of 2, at most kParts
    };
    /// Sixteen bytes: sixteen pairs are four registers.
    struct Pair {
        Piece from;
        Piece to;
        std::uint32_t texel;  ///< of those that are searched together
    };
    /// Pairs that wait.
    struct OpenPairs {
        std::vector<Pair> pairs;
        std::vector<float> bounds;  ///< squared
        std::vector<Pair> halves;
    };
    /// The surface around a block.
    struct Surroundings {
        static constexpr int kBorder = CrestSearch::kReach + 2;
        static constexpr int kSide = kBlockSize + 2 * kBorder;
        std::array<float, static_cast<std::size_t>(kSide) * kSide + kLanes> depths;
        float aspect;
        ChordSector sector;
        [[nodiscard]] const float* texel(int i, int j) const noexcept {
            return depths.data() + (j + kBorder) * kSide + i + kBorder;
        }
    };

  private:
    Surroundings surface_;
    OpenPairs open_;
    std::uint64_t pairs_ = 0;
};

}  // namespace relievo::preprocess
