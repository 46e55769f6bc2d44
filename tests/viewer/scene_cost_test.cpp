// Skipping pays: on a floor, a far wall and a hidden box `auto` takes less than a third of the
// lookups of relief mapping that is no more wrong.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "bench/scene_benchmark.h"
#include "relief_scene.h"

namespace relievo::viewer {
namespace {

TEST(SceneCost, AutoTakesLessThanAThirdOfReliefMapping) {
    const auto context = makeTestContext();
    bench::SceneBenchmarkOptions options;
    options.size = 128;
    options.frame = 120;
    const std::vector<bench::SceneMeasurement> rows = bench::measureScene(options);
    fmt::print("{}\n", bench::formatTable(bench::sceneTable(rows)));
    const bench::SceneMeasurement& ours = rows.front();
    const bench::SceneMeasurement& relief = rows.back();
    ASSERT_EQ(ours.technique, "auto");
    ASSERT_EQ(relief.technique, "relief");
    EXPECT_TRUE(ours.skipsHidden);
    EXPECT_LT(3 * ours.fetches, relief.fetches);
    // With half of the steps it would be more wrong, so that the comparison is no unfair one.
    EXPECT_LT(ours.errors.wrongShare, 0.002);
    EXPECT_LT(ours.errors.meanShift, 0.5);
    for (std::size_t k = 0; k + 1 < rows.size(); k += 2) {
        // Skipping changes the lookups, not the picture.
        EXPECT_LT(rows[k].fetches, rows[k + 1].fetches);
        EXPECT_EQ(rows[k].errors.meanShift, rows[k + 1].errors.meanShift);
    }
}

}  // namespace
}  // namespace relievo::viewer
