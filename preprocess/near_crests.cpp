#include "preprocess/near_crests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "preprocess/lanes.h"
#include "preprocess/processor.h"

namespace relievo::preprocess {
namespace {

constexpr int kReach = CrestSearch::kReach;

// Bounds within this of what a chord attains are accepted.
constexpr float kAccepted = 1.12f;
constexpr int kMostPairs = 512;

}  // namespace
}  // namespace relievo::preprocess

#define RELIEVO_KERNEL "preprocess/near_crests_kernel.h"
#include "preprocess/for_each_processor.h"

namespace relievo::preprocess {

NearCrests::NearCrests(double aspect, const ChordSector& sector) : surface_{} {
    surface_.aspect = static_cast<float>(aspect);
    surface_.sector = sector;
}

void NearCrests::begin(const textures::DepthMap& map, int left, int top) {
    for (int j = 0; j < Surroundings::kSide; ++j) {
        const int row =
            textures::wrapIndex(top - Surroundings::kBorder + j, map.height(), map.wrap);
        for (int i = 0; i < Surroundings::kSide; ++i)
            surface_.depths[static_cast<std::size_t>(j * Surroundings::kSide + i)] = map.depth.at(
                textures::wrapIndex(left - Surroundings::kBorder + i, map.width(), map.wrap), row);
    }
}

void NearCrests::findCornerDepths(std::array<BlockValues, 4>& depth) const {
    RELIEVO_CALL_KERNEL(findSquareDepths, surface_, depth);
}

void NearCrests::findAttained(BlockValues& slopes) const {
    RELIEVO_CALL_KERNEL(findAttained, surface_, slopes);
}

void NearCrests::refine(int width, int height, BlockValues& slopes) {
    RELIEVO_CALL_KERNEL(refineNearCrests, surface_, open_, pairs_, width, height, slopes);
}

}  // namespace relievo::preprocess
