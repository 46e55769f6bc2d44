#include "preprocess/bilinear_slopes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "preprocess/lanes.h"
#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr int kReach = BilinearSlopes::kReach;

// Cells around a texel within its reach: from kReach + 1 before it to kReach after it.
constexpr int kCellBorder = kReach + 1;
constexpr int kCellSide = kBlockSize + 2 * kCellBorder;
// Chords that are not taken from the halves end less than 3 texels from the square, and so on: see
// the table in the header. Twice the radius in cells is the side of the surroundings.
constexpr int kCellsAroundHalves = 4;
constexpr int kCellsAroundQuarters = 2;
constexpr int kCellsAroundEighths = 1;
constexpr float kMarginAroundEighths = 0.25f;

// Gradients around that are steeper than the slope known by less than this are accepted: a finer
// lattice could not gain more.
constexpr float kWorthwhile = 1.02f;

// κ of the theorem for pieces of sides g and h: with texels of height `aspect`.
double correctionFor(double g, double h, double aspect) {
    return (g * g + h * h) / 4.0 * (1.0 + aspect * aspect);
}

}  // namespace
}  // namespace relievo::preprocess

#define RELIEVO_KERNEL "preprocess/bilinear_slopes_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {
namespace {

ChordTable::Rules latticeRules(int subdivisions, int farthest, double aspect) {
    const double side = 1.0 / subdivisions;
    return {.apexReach = subdivisions / 2,
            .nearest = 2,
            .farthest = farthest,
            .correction = correctionFor(side, side, aspect)};
}

void measureCells(BilinearSlopes::Lattices& lattices) {
    const std::ptrdiff_t right = lattices.halves.stepTo(2, 0);
    const std::ptrdiff_t below = lattices.halves.stepTo(0, 2);
    for (int j = -kCellBorder; j < kBlockSize + kCellBorder; ++j)
        for (int i = -kCellBorder; i < kBlockSize + kCellBorder; ++i) {
            const float* const cell = lattices.halves.texel(i, j);
            const float alongTop = cell[right] - cell[0];
            const float alongBottom = cell[right + below] - cell[below];
            const float alongLeft = (cell[below] - cell[0]) / lattices.aspect;
            const float alongRight = (cell[right + below] - cell[right]) / lattices.aspect;
            const auto place =
                static_cast<std::size_t>((j + kCellBorder) * kCellSide + i + kCellBorder);
            lattices.cells[place] =
                std::sqrt(std::max(alongTop * alongTop, alongBottom * alongBottom) +
                          std::max(alongLeft * alongLeft, alongRight * alongRight));
        }
}

}  // namespace

BilinearSlopes::Lattices::Lattices(double texelAspect)
    : aspect(static_cast<float>(texelAspect)),
      halves(2, kBlockSize, kCellBorder + 1),
      quarters(4, kBlockSize, 2),
      eighths(8, kBlockSize, 2),
      farChords(halves,
                {.apexReach = 1,
                 .nearest = 6,
                 .farthest = 2 * kReach,
                 .sampleStep = 2,
                 .aroundTexel = true,
                 .correction = correctionFor(0.5, 1.0, texelAspect)},
                texelAspect),
      // Pieces less than 3 texels apart end within 2½ + ½ + 1 of each other.
      halfChords(halves, latticeRules(2, 8, texelAspect), texelAspect),
      // Pieces less than 2 sides apart end within 3 sides, 6 of the next lattice, of each other.
      quarterChords(quarters, latticeRules(4, 6, texelAspect), texelAspect),
      eighthChords(eighths, latticeRules(8, 6, texelAspect), texelAspect),
      cells(static_cast<std::size_t>(kCellSide) * kCellSide + kLanes) {}

BilinearSlopes::BilinearSlopes(double aspect) : lattices_(aspect) {}

void BilinearSlopes::begin(const textures::DepthMap& map, int left, int top) {
    lattices_.map = &map;
    lattices_.left = left;
    lattices_.top = top;
    lattices_.halves.fill(map, left, top);
    lattices_.hasQuarters = false;
    lattices_.hasEighths = false;
    measureCells(lattices_);
}

void BilinearSlopes::findCoarse(const BlockGroups& wanted, BlockValues& slopes) const {
    RELIEVO_CALL_KERNEL(findCoarseSlopes, lattices_, wanted, slopes);
}

void BilinearSlopes::refine(const BlockGroups& wanted, BlockValues& slopes) {
    RELIEVO_CALL_KERNEL(refineSlopes, lattices_, wanted, slopes);
}

void BilinearSlopes::findCornerDepths(const BlockGroups& wanted, BlockValues& depths) const {
    RELIEVO_CALL_KERNEL(findCornerDepths, lattices_, wanted, depths);
}

}  // namespace relievo::preprocess
