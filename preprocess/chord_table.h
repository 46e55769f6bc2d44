#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "preprocess/sample_lattice.h"

namespace relievo::preprocess {

/// The short chords that start in the square of a texel: all from certain apexes to certain samples
/// of a lattice. The steepest of a fixed neighbourhood is found faster by trying all of it, for
/// sixteen texels at once and without a branch, than by any search.
class ChordTable {
  public:
    /// Which chords: both ends are lattice points.
    struct Rules {
        int apexReach = 0;         ///< apexes: up to so many subdivisions from the texel's centre
        int nearest = 1;           ///< samples at least so many subdivisions away along some axis
        int farthest = 1;          ///< and at most so many along both
        int sampleStep = 1;        ///< samples are every so many subdivisions, centres included
        bool aroundTexel = false;  ///< `farthest` counts from the texel's centre, not from the apex
        double correction = 0.0;   ///< taken off squared lengths, in squared texel widths
    };
    /// `aspect`: the height of a texel over its width.
    ChordTable(const SampleLattice& lattice, const Rules& rules, double aspect);

    /// A lattice point, in subdivisions from the texel's centre.
    struct Point {
        int x;
        int y;
    };
    /// The square of the length, in texel widths, that a chord counts with, next to 0 if it is not
    /// above 0; nothing where it does not count.
    using SquaredLength = std::function<std::optional<double>(Point apex, Point sample)>;
    /// Chords that no such rules describe. Apexes and samples up to so many subdivisions from the
    /// texel's centre are asked for.
    ChordTable(const SampleLattice& lattice, int apexReach, int sampleReach,
               const SquaredLength& squaredLength);

    struct Apex {
        std::ptrdiff_t step;  ///< from the centre of the texel
        int rings;
    };
    /// Samples at one distance from an apex.
    struct Ring {
        float perLength;
        int samples;
    };
    [[nodiscard]] const std::vector<Apex>& apexes() const noexcept { return apexes_; }
    /// Those of the first apex, of the second …
    [[nodiscard]] const std::vector<Ring>& rings() const noexcept { return rings_; }
    /// Steps from the centre of the texel to those of the first ring, of the second …
    [[nodiscard]] const std::vector<std::ptrdiff_t>& samples() const noexcept { return samples_; }

  private:
    std::vector<Apex> apexes_;
    std::vector<Ring> rings_;
    std::vector<std::ptrdiff_t> samples_;
};

}  // namespace relievo::preprocess
