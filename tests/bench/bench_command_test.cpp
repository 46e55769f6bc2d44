// relievo-bench as a process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/scoped_path.h"
#include "tests/commands/process.h"
#include "textures/picture_file.h"

namespace relievo::tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

ProcessResult bench(const Words& words, const ProcessOptions& options = {}) {
    return runProcess(Words{std::getenv("RELIEVO_BENCH")} + words, options);
}

/// The lines of a table, each split at runs of two or more spaces.
std::vector<Words> parseTable(const std::string& text) {
    std::vector<Words> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        Words cells;
        for (std::size_t at = line.find_first_not_of(' '); at != std::string::npos;) {
            const std::size_t end = line.find("  ", at);
            cells.push_back(line.substr(at, end - at));
            at = end == std::string::npos ? end : line.find_first_not_of(' ', end);
        }
        lines.push_back(cells);
    }
    return lines;
}

const Words kSmallInput{"bake", "--samples", "noise,wave", "--sizes", "8,13", "--repeat", "1"};
const Words kSmallBake =
    kSmallInput + Words{"--builders", "derivatives,distances-4sed,cones-texel,cones-squares"};

const Words kSmallRender{
    "render",       "--samples", "wave",    "--techniques", "normal,relief,cone",
    "--elevations", "90,30",     "--steps", "4,64",         "--size",
    "16",           "--frame",   "19",      "--repeat",     "1"};

TEST(BenchBake, TableHasARowAMeasurement) {
    const ProcessResult result = bench(kSmallBake);
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    const std::vector<Words> table = parseTable(result.output);
    ASSERT_EQ(table.size(), 1u + 2 * 2 * 4);
    EXPECT_EQ(table[0], (Words{"sample", "builder", "size", "ms", "ns/texel", "Mtexel/s", "texels",
                               "bytes/texel", "nodes/texel", "samples/texel", "mean ratio",
                               "wrong texels", "greatest error"}));
    std::set<Words> distinct;
    for (std::size_t row = 1; row < table.size(); ++row) {
        ASSERT_EQ(table[row].size(), 13u);
        distinct.insert({table[row][0], table[row][1], table[row][2]});
        EXPECT_GT(std::stod(table[row][3]), 0.0);
        // Only the search has work to count, only cones have ratios, only 4SED has errors.
        EXPECT_EQ(table[row][8] != "-", table[row][1] == "cones-texel");
        EXPECT_EQ(table[row][9] != "-", table[row][1] == "cones-texel");
        EXPECT_EQ(table[row][10] != "-", table[row][1].starts_with("cones-"));
        EXPECT_EQ(table[row][11] != "-", table[row][1] == "distances-4sed");
    }
    EXPECT_EQ(distinct.size(), table.size() - 1);
}

TEST(BenchBake, WritesJsonAndPlot) {
    const ScratchFolder folder;
    const ProcessResult result = bench(
        kSmallBake + Words{"--json", folder.file("bake.json"), "--plot", folder.file("bake.svg")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    const auto report = nlohmann::json::parse(readBytes(folder.file("bake.json")));
    EXPECT_EQ(report.at("benchmark"), "bake");
    EXPECT_EQ(report.at("repeat"), 1);
    EXPECT_GE(report.at("threads"), 1);
    ASSERT_EQ(report.at("rows").size(), 16u);
    for (const auto& row : report.at("rows")) {
        const double perTexel = row.at("nanosecondsPerTexel");
        const double size = row.at("size");
        EXPECT_GT(perTexel, 0.0);
        EXPECT_NEAR(perTexel * size * size, row.at("milliseconds").get<double>() * 1e6, 1e-3);
        EXPECT_EQ(row.at("nodesPerTexel").is_number(), row.at("builder") == "cones-texel");
    }
    const std::string svg = readBytes(folder.file("bake.svg"));
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("cones-squares"));
    EXPECT_EQ(folder.list(), (Words{"bake.json", "bake.svg"}));
}

TEST(BenchBake, MeansAreTheSameForSearchesThatAreExact) {
    Words means[2];
    for (const Words& row : parseTable(bench(kSmallBake).output))
        if (row[1].starts_with("cones-"))
            means[row[1] == "cones-texel" ? 0 : 1].push_back(row.at(10));
    EXPECT_EQ(means[0].size(), 4u);
    EXPECT_EQ(means[0], means[1]);
}

TEST(BenchBake, LeavesOutWhatTakesLongWithANoteUnlessAskedFor) {
    const Words words{"bake",     "--samples", "ridge",      "--sizes",          "2,65",
                      "--repeat", "1",         "--builders", "relaxed-policarpo"};
    const ProcessResult result = bench(words);
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_EQ(parseTable(result.output).size(), 1u + 1);
    EXPECT_THAT(result.errors, HasSubstr("relaxed-policarpo is left out at 65x65"));
    const ProcessResult all = bench(words + Words{"--no-limits"});
    EXPECT_EQ(parseTable(all.output).size(), 1u + 2);
    EXPECT_EQ(all.errors, "");
}

TEST(BenchBake, SaysWhenOnlySomeTexelsAreBuilt) {
    const ProcessResult result = bench({"bake", "--samples", "noise", "--sizes", "64,130",
                                        "--repeat", "1", "--builders", "cones-squares"});
    const std::vector<Words> table = parseTable(result.output);
    EXPECT_EQ(table.at(1).at(6), "4096");
    EXPECT_EQ(table.at(2).at(6), "1936") << "every third texel of every third row";
}

TEST(BenchBake, StrokesAndRaysAreReportedAsWell) {
    const ScratchFolder folder;
    const ProcessResult result =
        bench(kSmallBake + Words{"--sizes", "40", "--strokes", "2", "--rays", "10", "--json",
                                 folder.file("bake.json"), "--markdown", folder.file("bake.md")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    const auto report = nlohmann::json::parse(readBytes(folder.file("bake.json")));
    ASSERT_EQ(report.at("strokes").size(), 2u * 3u) << "heap, dent and undo on each relief";
    EXPECT_EQ(report.at("strokes").at(0).at("size"), 40);
    std::set<std::string> searches;
    for (const auto& row : report.at("searches"))
        searches.insert(row.at("search"));
    EXPECT_TRUE(searches.contains("roof-1"));
    EXPECT_TRUE(searches.contains("relaxed-bilinear-cell"));
    const std::string markdown = readBytes(folder.file("bake.md"));
    for (const char* title : {"# relievo-bench bake", "## Speed\n", "## Memory", "## Mean ratios",
                              "## Strokes of a brush", "## Lookups to the hit"})
        EXPECT_THAT(markdown, HasSubstr(title));
}

TEST(BenchBake, WorkDoesNotDependOnThreads) {
    const auto nodes = [](const char* threads) {
        const ProcessResult result =
            bench(kSmallInput + Words{"--builders", "cones-texel", "--threads", threads});
        Words column;
        for (const Words& row : parseTable(result.output))
            column.push_back(row.at(8));
        return column;
    };
    EXPECT_EQ(nodes("1").size(), 5u);
    EXPECT_EQ(nodes("1"), nodes("2"));
}

TEST(BenchRender, MoreStepsHaveFewerErrors) {
    const ScratchFolder folder;
    const ProcessResult result = bench(
        kSmallRender + Words{"--json", folder.file("render.json"), "--plot",
                             folder.file("render.svg"), "--markdown", folder.file("render.md")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    const std::vector<Words> table = parseTable(result.output);
    ASSERT_EQ(table.size(), 1u + 2 * (1 + 2 + 2));
    const auto report = nlohmann::json::parse(readBytes(folder.file("render.json")));
    EXPECT_EQ(report.at("benchmark"), "render");
    EXPECT_NE(report.at("renderer"), "");
    const auto& rows = report.at("rows");
    ASSERT_EQ(rows.size(), table.size() - 1);
    for (const auto& row : rows)
        EXPECT_GT(row.at("milliseconds"), 0.0);
    // The row at 30° of a technique and budget.
    const auto find = [&](const std::string& technique, const nlohmann::json& budget) {
        for (const auto& row : rows)
            if (row.at("technique") == technique && row.at("elevation") == 30.0 &&
                row.at("stepBudget") == budget)
                return row;
        throw std::runtime_error("no row for " + technique);
    };
    EXPECT_EQ(find("normal", nullptr).at("meanSteps"), 0.0);
    EXPECT_GT(find("normal", nullptr).at("wrongPercent"), 50.0);
    EXPECT_GT(find("relief", 4).at("meanDistanceTexels"),
              find("relief", 64).at("meanDistanceTexels"));
    EXPECT_EQ(find("relief", 64).at("wrongPercent"), 0.0);
    EXPECT_GT(find("cone", 4).at("unconvergedPercent"), find("cone", 64).at("unconvergedPercent"));
    EXPECT_EQ(find("cone", 64).at("wrongPercent"), 0.0);
    EXPECT_GT(find("cone", 64).at("meanFetches"), find("cone", 4).at("meanFetches"));
    EXPECT_GT(find("normal", nullptr).at("picturePercent"), 0.3);
    EXPECT_LT(find("cone", 64).at("picturePercent"), 0.1);
    EXPECT_THAT(readBytes(folder.file("render.svg")),
                AllOf(HasSubstr("wrong first hits"), HasSubstr(", 30")));
    EXPECT_THAT(readBytes(folder.file("render.md")),
                AllOf(HasSubstr("## Wrong first hits"), HasSubstr("| relief 64 |")));
}

// A budget that a technique cannot have is not measured, and no reason to stop.
TEST(BenchRender, BudgetsGoAsFarAsTheTechniqueDoes) {
    const ProcessResult result =
        bench({"render", "--samples", "wave", "--techniques", "binary,relief", "--elevations", "45",
               "--steps", "8,64", "--size", "16", "--frame", "19", "--repeat", "1"});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_EQ(parseTable(result.output).size(), 1u + 1 + 2);
}

// Differences of depths take four lookups and give the picture of the derivatives, which are
// filtered differences of depths; normals are theirs up to what 128² texels resolve.
TEST(BenchRender, NormalsComeFromWhereTheyAreAskedFor) {
    const auto normalErrors = [](const std::string& source) {
        const ScratchFolder folder;
        const ProcessResult result =
            bench(kSmallRender + Words{"--techniques", "cone", "--steps", "64", "--normals", source,
                                       "--json", folder.file("render.json")});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        const auto report = nlohmann::json::parse(readBytes(folder.file("render.json")));
        EXPECT_EQ(report.at("normals"), source);
        return report.at("rows").at(0).at("meanNormalDegrees").get<double>();
    };
    const double derivative = normalErrors("derivative");
    EXPECT_NEAR(normalErrors("height"), derivative, 1e-3);
    // Interpolated normals are not quite those of interpolated slopes, and no others either.
    EXPECT_NEAR(normalErrors("normal"), derivative, 0.5);
    EXPECT_NE(normalErrors("normal"), derivative);
}

TEST(BenchRender, BackEndsAgreeOnAllButTime) {
    const auto withoutTimes = [](const char* backend) {
        const ProcessResult result = bench(kSmallRender + Words{"--backend", backend});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        std::vector<Words> table = parseTable(result.output);
        for (Words& row : table)
            row.at(4) = "";
        return table;
    };
    const std::vector<Words> osmesa = withoutTimes("osmesa");
    EXPECT_EQ(osmesa.size(), 11u);
    EXPECT_EQ(osmesa, withoutTimes("egl"));
}

const Words kSmallShadow{"shadow",
                         "--samples",
                         "pillars",
                         "--methods",
                         "none,search,soft,horizon",
                         "--elevations",
                         "30",
                         "--light-sizes",
                         "0,20",
                         "--budgets",
                         "1,6,100",
                         "--size",
                         "32",
                         "--frame",
                         "29",
                         "--light-rays",
                         "64",
                         "--repeat",
                         "1"};

TEST(BenchShadow, MoreSlicesOfTheLightHaveFewerErrors) {
    const ScratchFolder folder;
    const ProcessResult result = bench(
        kSmallShadow + Words{"--json", folder.file("shadow.json"), "--plot",
                             folder.file("shadow.svg"), "--markdown", folder.file("shadow.md")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    const auto report = nlohmann::json::parse(readBytes(folder.file("shadow.json")));
    EXPECT_EQ(report.at("benchmark"), "shadow");
    EXPECT_EQ(report.at("technique"), "exact");
    const auto& rows = report.at("rows");
    // The third budget is more than the method can take.
    ASSERT_EQ(rows.size(), 2u * (1 + 1 + 2 + 1));
    EXPECT_EQ(parseTable(result.output).size(), 1 + rows.size());
    for (const auto& row : rows)
        EXPECT_GT(row.at("milliseconds"), 0.0);
    const auto find = [&](const std::string& method, double size, const nlohmann::json& budget) {
        for (const auto& row : rows)
            if (row.at("method") == method && row.at("lightSize") == size &&
                row.at("budget") == budget)
                return row;
        throw std::runtime_error("no row for " + method);
    };
    EXPECT_EQ(find("none", 0.0, nullptr).at("meanFetches"), 0.0);
    EXPECT_GT(find("none", 0.0, nullptr).at("wrongPercent"), 5.0);
    EXPECT_EQ(find("horizon", 0.0, nullptr).at("meanFetches"), 2.0);
    EXPECT_EQ(find("search", 0.0, nullptr).at("wrongPercent"), 0.0);
    EXPECT_GT(find("search", 20.0, nullptr).at("wrongPercent"), 5.0);
    EXPECT_LT(find("soft", 20.0, 6).at("wrongPercent"), find("soft", 20.0, 1).at("wrongPercent"));
    EXPECT_GT(find("soft", 20.0, 6).at("meanFetches"), find("soft", 20.0, 1).at("meanFetches"));
    EXPECT_THAT(readBytes(folder.file("shadow.svg")), HasSubstr("light from 30"));
    EXPECT_THAT(readBytes(folder.file("shadow.md")),
                AllOf(HasSubstr("## Wrong pixels on the worst relief"), HasSubstr("| soft 6 |"),
                      HasSubstr("30°, 20° across")));
}

TEST(BenchSheet, HasAPictureForEveryTechniqueAndTheExactOne) {
    const ScratchFolder folder;
    const auto sizeOf = [&](const char* columns) {
        const ProcessResult result = bench(
            {"sheet", "--sample", "wave", "--techniques", "relief,exact", "--size", "32", "--width",
             "64", "--height", "48", "--columns", columns, "-o", folder.file("sheet.png")});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        const auto planes = textures::readPicture(folder.file("sheet.png"));
        return std::pair(planes.at(0).width, planes.at(0).height);
    };
    const auto [width, height] = sizeOf("3");
    EXPECT_GE(width, 3 * 64);
    const auto [narrow, tall] = sizeOf("1");
    EXPECT_LT(narrow, 2 * 64);
    EXPECT_GE(tall, 3 * 48);
}

TEST(BenchSheet, ShowsShadowsAndShadingToo) {
    const ScratchFolder folder;
    const auto sheet = [&](const Words& words) {
        const ProcessResult result =
            bench(Words{"sheet", "--sample", "blocks", "--size", "32", "--width", "96", "--height",
                        "64", "-o", folder.file("sheet.png")} +
                  words);
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        return readBytes(folder.file("sheet.png"));
    };
    const std::string shadows = sheet({"--of", "shadows", "--elevation", "40", "--columns", "3"});
    const auto planes = textures::readPicture(folder.file("sheet.png"));
    EXPECT_GE(planes.at(0).width, 3 * 96);
    EXPECT_GE(planes.at(0).height, 2 * 64);
    EXPECT_NE(sheet({"--of", "shading"}), shadows);
    EXPECT_GE(textures::readPicture(folder.file("sheet.png")).at(0).height, 3 * 64);
}

TEST(BenchSheet, ShowsFiguresOfSolids) {
    const ScratchFolder folder;
    const auto sizeOf = [&](const char* figures) {
        const ProcessResult result =
            bench({"sheet", "--of", "solids", "--figures", figures, "--size", "32", "--width", "24",
                   "--height", "16", "-o", folder.file("sheet.png")});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        const auto planes = textures::readPicture(folder.file("sheet.png"));
        return std::pair(planes.at(0).width, planes.at(0).height);
    };
    const auto [width, height] = sizeOf("maps");
    EXPECT_GE(width, 5 * 24);
    EXPECT_GE(height, 2 * 16);
    const auto [allWidth, allHeight] = sizeOf("all");
    EXPECT_EQ(allWidth, width);
    EXPECT_GE(allHeight, 12 * 16);
}

TEST(BenchSearch, WritesJsonAndPlot) {
    const ScratchFolder folder;
    const ProcessResult result = bench(
        {"search", "--samples", "noise", "--searches", "relief,pyramid", "--size", "16", "--rays",
         "50", "--json", folder.file("search.json"), "--plot", folder.file("search.svg")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_EQ(parseTable(result.output).size(), 1u + 2 * 4);
    const auto report = nlohmann::json::parse(readBytes(folder.file("search.json")));
    EXPECT_EQ(report.at("benchmark"), "search");
    EXPECT_EQ(report.at("rays"), 50);
    ASSERT_EQ(report.at("rows").size(), 8u);
    EXPECT_TRUE(report.at("rows").at(0).at("meanRatio").is_null());
    EXPECT_THAT(readBytes(folder.file("search.svg")), HasSubstr("pyramid"));
}

TEST(BenchSolid, WritesAllReports) {
    const ScratchFolder folder;
    const ProcessResult result = bench({"solid",
                                        "--solids",
                                        "basic,bevel",
                                        "--shapes",
                                        "star",
                                        "--techniques",
                                        "solid,bevel-printed,cone",
                                        "--elevations",
                                        "45,5",
                                        "--steps",
                                        "8",
                                        "--sizes",
                                        "32",
                                        "--frame",
                                        "29",
                                        "--repeat",
                                        "1",
                                        "--json",
                                        folder.file("solid.json"),
                                        "--plot",
                                        folder.file("solid.svg"),
                                        "--markdown",
                                        folder.file("solid.md")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    const auto report = nlohmann::json::parse(readBytes(folder.file("solid.json")));
    EXPECT_EQ(report.at("benchmark"), "solid");
    const auto& rows = report.at("rows");
    ASSERT_EQ(rows.size(), 2u * 2 * 3 * 2);
    EXPECT_EQ(parseTable(result.output).size(), 1 + rows.size());
    for (const auto& row : rows) {
        EXPECT_GT(row.at("milliseconds"), 0.0);
        EXPECT_EQ(row.at("shownAs"), row.at("technique") == "cone" ? "relief" : "solid");
        if (row.at("technique") == "solid" && row.at("stepBudget") != 8) {
            EXPECT_EQ(row.at("wrongPercent"), 0.0);
        }
    }
    EXPECT_THAT(readBytes(folder.file("solid.svg")), HasSubstr("bevel-printed"));
    EXPECT_THAT(readBytes(folder.file("solid.md")),
                AllOf(HasSubstr("## Our lookups at equal error"), HasSubstr("| bevel: cone |"),
                      HasSubstr("| bevel: bevel-printed |")));
}

TEST(Bench, HelpListsWhatThereIs) {
    const ProcessResult bake = bench({"bake", "--help"});
    EXPECT_EQ(bake.exitStatus, 0);
    EXPECT_THAT(bake.output, HasSubstr("cones-levels"));
    EXPECT_THAT(bake.output, HasSubstr("lettering"));
    EXPECT_THAT(bake.output, HasSubstr("Examples"));
    const ProcessResult render = bench({"render", "--help"});
    EXPECT_EQ(render.exitStatus, 0);
    EXPECT_THAT(render.output, HasSubstr("relief"));
    EXPECT_THAT(render.output, HasSubstr("Examples"));
    const ProcessResult shadow = bench({"shadow", "--help"});
    EXPECT_EQ(shadow.exitStatus, 0);
    const ProcessResult solid = bench({"solid", "--help"});
    EXPECT_EQ(solid.exitStatus, 0);
    EXPECT_THAT(solid.output, HasSubstr("chamfer-printed"));
    EXPECT_THAT(solid.output, HasSubstr("Examples"));
    EXPECT_THAT(shadow.output, HasSubstr("none, search, soft, horizon, ellipse"));
    EXPECT_THAT(shadow.output, HasSubstr("Examples"));
}

TEST(Bench, WrongUsageIsStatusTwoAndNoWork) {
    const ScratchFolder folder;
    const std::vector<Words> wrong = {
        {},
        {"paint"},
        {"bake", "--samples", "mountains"},
        {"bake", "--builders", "cones"},
        {"bake", "--sizes", "0"},
        {"bake", "--sizes", "big"},
        {"bake", "--repeat", "0"},
        {"bake", "--threads", "-1"},
        {"bake", "--strokes", "-1"},
        {"bake", "--rays", "many"},
        {"bake", "--elevations", "5"},
        {"bake", "--plot", folder.file("bake.pdf")},
        {"search", "--searches", "magic"},
        {"search", "--elevations", "91"},
        {"search", "--rays", "0"},
        {"render", "--techniques", "magic"},
        {"render", "--elevations", "0"},
        {"render", "--steps", "0"},
        {"render", "--backend", "vulkan"},
        {"render", "--normals", "none"},
        {"render", "--plot-against", "luck"},
        {"shadow", "--methods", "magic"},
        {"shadow", "--technique", "parallax"},
        {"shadow", "--light-sizes", "-1"},
        {"shadow", "--elevations", "0"},
        {"solid", "--solids", "magic"},
        {"solid", "--shapes", "noise"},
        {"solid", "--techniques", "parallax"},
        {"solid", "--sizes", "1"},
        {"solid", "--steps", "0"},
        {"sheet"},
        {"sheet", "--of", "magic", "-o", folder.file("sheet.png")},
        {"sheet", "--of", "shading", "--columns", "2", "-o", folder.file("sheet.png")},
        {"sheet", "--of", "shadows", "--techniques", "relief", "-o", folder.file("sheet.png")},
        {"sheet", "--sample", "mountains", "-o", folder.file("sheet.png")},
        {"sheet", "--elevation", "0", "-o", folder.file("sheet.png")},
        {"sheet", "--figures", "maps", "-o", folder.file("sheet.png")},
        {"sheet", "--of", "solids", "--columns", "2", "-o", folder.file("sheet.png")},
        {"sheet", "--of", "solids", "--figures", "4.1", "-o", folder.file("sheet.png")},
    };
    for (const Words& words : wrong) {
        const ProcessResult result = bench(words);
        EXPECT_EQ(result.exitStatus, 2) << testing::PrintToString(words);
        EXPECT_EQ(result.output, "");
        EXPECT_THAT(result.errors, StartsWith("relievo-bench: "));
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    }
    EXPECT_THAT(folder.list(), IsEmpty());
}

// The work is such that a failure after the work would run into the time limit of the test.
const Words kLongBake{"bake", "--sizes", "16384", "--repeat", "1000"};

TEST(Bench, AFolderThatDoesNotExistFailsBeforeTheWork) {
    const ProcessResult result = bench(kLongBake + Words{"--json", "/no-such-folder/bake.json"});
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_THAT(result.errors, HasSubstr("/no-such-folder/bake.json"));
}

TEST(Bench, AMissingGnuplotFailsBeforeTheWork) {
    const ScratchFolder folder;
    const ScopedPath path(folder.path());
    const ProcessResult result = bench(
        kLongBake + Words{"--json", folder.file("bake.json"), "--plot", folder.file("bake.svg")});
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_THAT(result.errors, HasSubstr("gnuplot"));
    EXPECT_THAT(folder.list(), IsEmpty());
}

TEST(Bench, AnInterruptLeavesNoFile) {
    const ScratchFolder folder;
    ProcessOptions options;
    options.signalWhen = [&](const std::string&) { return !folder.list().empty(); };
    const ProcessResult result =
        bench({"bake", "--sizes", "512", "--repeat", "1000", "--json", folder.file("bake.json")},
              options);
    EXPECT_EQ(result.exitStatus, 130);
    EXPECT_THAT(folder.list(), IsEmpty());
}

}  // namespace
}  // namespace relievo::tests
