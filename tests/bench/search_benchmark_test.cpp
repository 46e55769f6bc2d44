#include "bench/search_benchmark.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <stdexcept>

namespace relievo::bench {
namespace {

SearchBenchmarkOptions smallOptions() {
    SearchBenchmarkOptions options;
    options.samples = {"noise", "blocks"};
    for (const SearchKind& kind : searchKinds())
        options.searches.emplace_back(kind.name);
    options.elevations = {45, 5};
    options.size = 48;
    options.rays = 300;
    return options;
}

const SearchMeasurement& rowOf(const std::vector<SearchMeasurement>& rows, std::string_view sample,
                               std::string_view search, double elevation) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const SearchMeasurement& row) {
        return row.sample == sample && row.search == search && row.elevation == elevation;
    });
    if (found == rows.end())
        throw std::out_of_range("no such row");
    return *found;
}

TEST(SearchBenchmark, ExactSearchesAreNeverWrongAndLinearOnesAtGrazingAngles) {
    const auto rows = measureSearches(smallOptions());
    ASSERT_EQ(rows.size(), 2 * searchKinds().size() * 2);
    for (const char* sample : {"noise", "blocks"})
        for (const double elevation : {45.0, 5.0}) {
            const SearchMeasurement& pyramid = rowOf(rows, sample, "pyramid", elevation);
            EXPECT_EQ(pyramid.wrongShare, 0.0);
            EXPECT_FALSE(pyramid.meanRatio);
            for (const char* exact :
                 {"cones-bilinear-cell", "roof-1", "roof-4", "roof-8", "roof-1-far", "roof-4-far",
                  "roof-8-far", "relaxed-bilinear-cell"})
                EXPECT_EQ(rowOf(rows, sample, exact, elevation).wrongShare, 0.0) << exact;
            const SearchMeasurement& relief = rowOf(rows, sample, "relief", elevation);
            EXPECT_GE(relief.meanLookups, 6.0);
            EXPECT_LE(relief.mostLookups, 37);
            EXPECT_GT(*rowOf(rows, sample, "cones-texel", elevation).meanRatio, 0.0);
        }
    EXPECT_GT(rowOf(rows, "noise", "pyramid", 5).meanLookups,
              rowOf(rows, "noise", "pyramid", 45).meanLookups);
    EXPECT_GT(rowOf(rows, "blocks", "relief", 5).wrongShare, 0.01);
    // Cones of texel centres let rays pass the corners of blocks.
    EXPECT_GT(rowOf(rows, "blocks", "cones-texel", 5).wrongShare, 0.01);
}

TEST(SearchBenchmark, CountsRepeatForAnyNumberOfThreadsAndChangeWithTheSeed) {
    SearchBenchmarkOptions options = smallOptions();
    options.samples = {"noise"};
    const auto lookups = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<double> means;
        for (const SearchMeasurement& row : measureSearches(options))
            means.push_back(row.meanLookups);
        return means;
    };
    const auto one = lookups(1);
    EXPECT_EQ(lookups(3), one);
    options.seed = 2;
    EXPECT_NE(lookups(1), one);
}

TEST(SearchBenchmark, TableAndPlotHaveEveryMeasurement) {
    const std::vector<SearchMeasurement> rows = {{"noise", "pyramid", 45.0, 14.5, 31, 0.0, {}},
                                                 {"noise", "pyramid", 5.0, 38.5, 139, 0.02, 0.25}};
    EXPECT_EQ(formatTable(searchTable(rows)),
              "sample  search   elevation  lookups  most  wrong %  mean ratio\n"
              "noise   pyramid         45     14.5    31        0           -\n"
              "noise   pyramid          5     38.5   139        2        0.25");
    const Plot plot = searchPlot(rows);
    ASSERT_EQ(plot.panels.size(), 1u);
    ASSERT_EQ(plot.panels[0].series.size(), 1u);
    EXPECT_EQ(plot.panels[0].series[0].points.size(), 2u);
}

TEST(SearchBenchmark, UnknownSearchIsRefused) {
    SearchBenchmarkOptions options = smallOptions();
    options.searches = {"magic"};
    EXPECT_THROW(measureSearches(options), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::bench
