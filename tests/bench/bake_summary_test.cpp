#include "bench/bake_summary.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace relievo::bench {
namespace {

BakeMeasurement measured(const char* sample, const char* builder, int size, double nsPerTexel,
                         std::optional<double> bytes = {}) {
    BakeMeasurement m;
    m.sample = sample;
    m.builder = builder;
    m.size = size;
    m.builtTexels = std::int64_t{size} * size;
    m.seconds = nsPerTexel * 1e-9 * static_cast<double>(m.builtTexels);
    m.workingBytes = bytes;
    return m;
}

const ReportSection& sectionOf(const std::vector<ReportSection>& sections, const char* title) {
    for (const ReportSection& section : sections)
        if (section.title == title)
            return section;
    throw std::out_of_range(title);
}

const std::vector<BakeMeasurement> kMeasurements = {
    measured("noise", "cones-texel", 512, 200.0, 10.0),
    measured("noise", "cones-texel", 1024, 250.0, 9.5),
    measured("noise", "cones-squares", 512, 5000.0, 0.0),
    measured("ridge", "cones-texel", 512, 500.0, 9.0),
    measured("ridge", "cones-texel", 1024, 1000.0, 9.25),
    measured("ridge", "cones-squares", 512, 20000.0, 0.0),
};

TEST(BakeSummary, SpeedsAreRangesOverSamples) {
    EXPECT_EQ(markdownTable(sectionOf(summariseBake(kMeasurements), "Speed").table),
              "| builder | 512² | 1024² |\n"
              "|---|---|---|\n"
              "| cones-texel | 2 – 5 | 1 – 4 |\n"
              "| cones-squares | 0.05 – 0.2 | – |\n");
}

TEST(BakeSummary, GrowthIsTimePerTexelOverThatAt512) {
    EXPECT_EQ(markdownTable(sectionOf(summariseBake(kMeasurements), "Growth").table),
              "| builder | noise | ridge |\n"
              "|---|---:|---:|\n"
              "| cones-texel at 1024² | 1.25 | 2 |\n");
}

TEST(BakeSummary, BaselinesAreComparedAtTheLargestSizeOfBoth) {
    EXPECT_EQ(markdownTable(sectionOf(summariseBake(kMeasurements), "Against baselines").table),
              "| builders | noise | ridge |\n"
              "|---|---:|---:|\n"
              "| cones-texel : cones-squares, 512² | 25 | 40 |\n");
}

TEST(BakeSummary, MemoryIsTheMostOnAnySampleBesideWhatIsStated) {
    const ReportTable table = sectionOf(summariseBake(kMeasurements), "Memory").table;
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "cones-texel at 1024²");
    EXPECT_EQ(std::get<double>(table.rows[0][1]), 9.5);
    EXPECT_GT(std::get<double>(table.rows[0][2]), 9.5);
    EXPECT_EQ(std::get<std::string>(table.rows[1][0]), "cones-squares at 512²");
}

TEST(BakeSummary, WithoutMeasurementsHasNoSections) {
    EXPECT_TRUE(summariseBake({}).empty());
    EXPECT_TRUE(summariseEdits({}).empty());
    EXPECT_TRUE(summariseSearches({}).empty());
}

TEST(BakeSummary, ComparesAt1024IfItIsThere) {
    EXPECT_EQ(sizeForComparison({512, 1024, 4096}), 1024);
    EXPECT_EQ(sizeForComparison({512, 64}), 512);
}

TEST(BakeSummary, StrokesAreSharesOfANewBuild) {
    const std::vector<ReportSection> sections =
        summariseEdits({{"noise", "heap", 64, 2, 0.001, 0.002, 0.04, 300.0, 350},
                        {"noise", "undo", 64, 2, 0.003, 0.006, 0.04, 300.0, 350}});
    ASSERT_EQ(sections.size(), 2u);
    EXPECT_EQ(markdownTable(sections[0].table),
              "| sample | heap | undo | all |\n|---|---:|---:|---:|\n"
              "| noise | 0.025 | 0.075 | 0.05 |\n");
    EXPECT_EQ(markdownTable(sections[1].table),
              "| sample | heap | undo | all |\n|---|---:|---:|---:|\n"
              "| noise | 0.05 | 0.15 | 0.15 |\n");
}

TEST(BakeSummary, SearchesAreMeansOverSamples) {
    const std::vector<ReportSection> sections =
        summariseSearches({{"noise", "roof-1", 45.0, 8.0, 20, 0.0, 0.5},
                           {"wave", "roof-1", 45.0, 10.0, 20, 0.01, 0.7},
                           {"noise", "pyramid", 45.0, 14.0, 31, 0.0, {}}});
    EXPECT_EQ(markdownTable(sections.at(0).table),
              "| search | lookups at 45° | wrong % at 45° | mean ratio |\n|---|---:|---:|---:|\n"
              "| roof-1 | 9 | 0.5 | 0.6 |\n"
              "| pyramid | 14 | 0 | – |\n");
}

TEST(Markdown, DocumentsHaveTitlesTextsAndTables) {
    const ReportTable table{{{"n", "number"}}, {{std::int64_t{3}}}};
    EXPECT_EQ(markdownDocument("Report", {{"First", "Some text.", table}, {"Second", "", table}}),
              "# Report\n\n## First\n\nSome text.\n\n| number |\n|---:|\n| 3 |\n"
              "\n## Second\n\n| number |\n|---:|\n| 3 |\n");
}

}  // namespace
}  // namespace relievo::bench
