// Skipping pays: on a floor, a far wall and a hidden box `auto` takes less than a third of the
// lookups of relief mapping that is no more wrong by whichever measure.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "bench/scene_benchmark.h"
#include "relief_scene.h"

namespace relievo::viewer {
namespace {

std::vector<bench::SceneMeasurement> measure() {
    bench::SceneBenchmarkOptions options;
    options.size = 128;
    options.frame = 120;
    return bench::measureScene(options);
}

TEST(SceneCost, AutoTakesLessThanAThirdOfReliefMapping) {
    const auto context = makeTestContext();
    const std::vector<bench::SceneMeasurement> rows = measure();
    fmt::print("{}\n", bench::formatTable(bench::sceneTable(rows)));
    const auto ours = std::ranges::find_if(rows, [](const bench::SceneMeasurement& row) {
        return row.technique == "auto" && row.pixelError == 0.1 && row.skipsHidden;
    });
    ASSERT_NE(ours, rows.end());
    EXPECT_LT(ours->errors.meanShift, 0.1);
    int reliefs = 0;
    for (const bench::SceneMeasurement& relief : rows) {
        if (relief.technique != "relief")
            continue;
        ++reliefs;
        if (3 * ours->fetches < relief.fetches)
            continue;
        SCOPED_TRACE(fmt::format("{} steps", *relief.steps));
        EXPECT_GT(relief.errors.wrongObjectShare, ours->errors.wrongObjectShare);
        EXPECT_GT(relief.errors.wrongShare, ours->errors.wrongShare);
        EXPECT_GT(relief.errors.meanShift, ours->errors.meanShift);
    }
    EXPECT_GT(reliefs, 1);
}

TEST(SceneCost, HiddenObjectsCostAndChangeNothing) {
    const auto context = makeTestContext();
    const std::vector<bench::SceneMeasurement> rows = measure();
    for (std::size_t k = 0; rows[k].technique != "relief"; k += 2) {
        // Skipping changes the lookups, not the picture.
        EXPECT_LT(rows[k].fetches, rows[k + 1].fetches);
        EXPECT_EQ(rows[k].errors.meanShift, rows[k + 1].errors.meanShift);
    }
}

}  // namespace
}  // namespace relievo::viewer
