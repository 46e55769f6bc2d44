#pragma once

#include <vector>

#include "preprocess/apex_block.h"
#include "preprocess/chord_table.h"
#include "preprocess/sample_lattice.h"
#include "textures/depth_map.h"

namespace relievo::preprocess {

/// Upper bounds on the steepness of all chords of the bilinear surface that rise from anywhere in
/// the square of a texel: what a cone must be narrower than to be safe for every apex there.
///
/// From samples to surfaces. Let x lie in a piece with corners x_k and y in a piece with corners
/// y_l, both pieces of one bilinear cell, of sides g and h, and let all chords between corners obey
/// D(x_k) − D(y_l) ≤ s·√(|x_k − y_l|² − κ) with κ = (g² + h²)/2. Then D(x) − D(y) ≤ s·|x − y|.
/// Proof: with the bilinear weights as probabilities x and y are the means of independent random
/// corners X and Y, D(x) − D(y) is the mean of D(X) − D(Y), so at most s times the mean of
/// √(|X−Y|² − κ), which by concavity is at most √(mean |X−Y|² − κ); the mean is |x−y|² plus the
/// variances of X and Y, at most g²/2 and h²/2. So chords between the points of a lattice bound all
/// chords, if those of pieces that are near each other are taken from a finer lattice:
///
///   pieces at least 3 texels apart           apexes every ½ texel, samples
///   nearer, at least 2 half texels apart     every ½ texel
///   nearer, at least 2 quarters apart        every ¼ texel
///   nearer, at least 2 eighths apart         every ⅛ texel
///   nearer                                   the steepest gradient around: no chord is steeper
///                                            than the steepest point below it
///
/// The gradients bound the other rows as well, over larger surroundings, and are exact on slopes;
/// a finer lattice is used only for texels where the two differ.
class BilinearSlopes {
  public:
    /// Chords to samples up to so many texels away, along both axes, from a texel's centre are
    /// known by this class.
    static constexpr int kReach = 8;

    /// `aspect`: the height of a texel over its width.
    explicit BilinearSlopes(double aspect);

    /// Goes to the block of `map` (which must stay) whose first texel is (left,top).
    void begin(const textures::DepthMap& map, int left, int top);

    /// For every texel of the wanted groups: a bound on the chords to pieces at least 3 texels
    /// apart within kReach, and at least the steepest gradient inside the square. Depth per texel
    /// width.
    void findCoarse(const BlockGroups& wanted, BlockValues& slopes) const;
    /// From slopes that are at least the coarse ones to a bound on all chords within kReach.
    void refine(const BlockGroups& wanted, BlockValues& slopes);
    /// For the corners of the squares, the one at (i−½, j−½) in the place of texel (i,j): the depth
    /// there of bilinear patches that are nowhere above the surface in the four squares around, so
    /// that a chord which starts in a square is no steeper than those from its corners.
    void findCornerDepths(const BlockGroups& wanted, BlockValues& depths) const;

    /// What the work is done on: the surface around the block and the chords to try there.
    struct Lattices {
        float aspect;
        SampleLattice halves;
        SampleLattice quarters;
        SampleLattice eighths;
        ChordTable farChords;
        ChordTable halfChords;
        ChordTable quarterChords;
        ChordTable eighthChords;
        std::vector<float> cells;  ///< the steepest gradient in each cell, with a border
        const textures::DepthMap* map = nullptr;
        int left = 0;
        int top = 0;
        bool hasQuarters = false;
        bool hasEighths = false;
        explicit Lattices(double texelAspect);
    };

  private:
    Lattices lattices_;
};

}  // namespace relievo::preprocess
