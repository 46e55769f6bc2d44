// relievo-bake verify as a process: what it lets pass, what it finds guilty, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/preprocess/bake_process.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace relievo::preprocess {
namespace {

using testing::HasSubstr;
using tests::ProcessResult;
using tests::ScratchFolder;
using textures::Plane;

using Words = std::vector<std::string>;

Words operator+(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// A ridge with a level top, the same in all rows: 8-bit codes that fall by ten a texel on both
// sides of it to 160, in tiles of 40 texels. Where it slopes, empty cones have the ratio of the
// slope, 255 / (10·40) = 0.6375: as 8-bit codes 162 is safe and 163, the nearest one, is not.
// Relaxed cones may reach over the top to its far edge: (24/40) / (160/255) = 0.956 at the bottom.
constexpr int kWidth = 40;
constexpr int kHeight = 6;
constexpr float kSafeRatio = 0.637499f;
constexpr float kSafeCode = 162.0f / 255.0f;
constexpr float kNearestCode = 163.0f / 255.0f;

Plane ridge() {
    Plane depth(kWidth, kHeight);
    for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i)
            depth.at(i, j) =
                static_cast<float>(10 * std::max(std::min(i, kWidth - i) - 4, 0)) / 255.0f;
    return depth;
}

class Verify : public testing::Test {
  protected:
    std::string mapFile(const std::string& name, float ratio,
                        const std::string& kind = "conservative") {
        textures::MapSet maps;
        maps.attributes["relievo:cone"] = kind;
        maps.channels = {{"depth", ridge()}, {"cone", Plane(kWidth, kHeight, ratio)}};
        textures::writeMapFile(folder.file(name), maps, textures::StorageFormat::Float);
        return folder.file(name);
    }
    // A picture with other channels than ours: red holds nothing, green cones, blue depths.
    std::string foreignFile(const std::string& name, float cone,
                            textures::StorageFormat format = textures::StorageFormat::U8) {
        textures::writePicture(
            folder.file(name),
            std::array{Plane(kWidth, kHeight, 1.0f), Plane(kWidth, kHeight, cone), ridge()},
            format);
        return folder.file(name);
    }
    static Words foreign(const std::string& file) {
        return {"verify",          file, "--rays",  "40000", "--cone-channel", "G",
                "--depth-channel", "B",  "--input", "depth"};
    }

    void expectPassed(const Words& command) {
        const ProcessResult result = bake(command);
        EXPECT_EQ(result.exitStatus, 0) << result.output << result.errors;
        EXPECT_THAT(result.output, HasSubstr("violations  0 (0 %)"));
    }
    void expectGuilty(const Words& command) {
        const ProcessResult result = bake(command);
        EXPECT_EQ(result.exitStatus, 1) << result.output;
        EXPECT_THAT(result.output, HasSubstr("worst "));
        EXPECT_THAT(result.errors, HasSubstr("rays break the promise of its cones"));
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1);
    }
    void expectRefused(const Words& command, int status, const std::string& why) {
        const ProcessResult result = bake(command);
        EXPECT_EQ(result.exitStatus, status) << why;
        EXPECT_THAT(result.errors, HasSubstr(why));
        EXPECT_EQ(result.output, "");
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1);
    }

    ScratchFolder folder;
};

TEST_F(Verify, SafeConesPassAndConesAFifthTooWideDoNot) {
    expectPassed({"verify", mapFile("safe.exr", kSafeRatio), "--rays", "4e4"});
    expectGuilty({"verify", mapFile("wide.exr", 1.2f * kSafeRatio), "--rays", "4e4"});
}

TEST_F(Verify, RelaxedConesMayBeWider) {
    expectGuilty({"verify", mapFile("conservative.exr", 0.94f), "--rays", "4e4"});
    expectPassed({"verify", mapFile("relaxed.exr", 0.94f, "relaxed"), "--rays", "4e4"});
    expectGuilty({"verify", mapFile("wider.exr", 0.98f, "relaxed"), "--rays", "4e4"});
}

// A ridge along v: rays with du < 0 and du > 0 have the same cones, those along v have none to
// fear.
TEST_F(Verify, EverySectorIsChecked) {
    const auto sectorFile = [&](const std::string& name, std::vector<float> ratios) {
        textures::MapSet maps;
        maps.attributes["relievo:cone"] = "relaxed";
        maps.channels = {{"depth", ridge()}};
        for (std::size_t k = 0; k < ratios.size(); ++k)
            maps.channels.push_back(
                {"cone" + std::to_string(k), Plane(kWidth, kHeight, ratios[k])});
        textures::writeMapFile(folder.file(name), maps, textures::StorageFormat::Float);
        return folder.file(name);
    };
    const std::string safe = sectorFile("safe.exr", {0.94f, 0.94f, 0.94f, 0.94f});
    expectPassed({"verify", safe, "--rays", "4e4"});
    EXPECT_THAT(bake({"verify", safe, "--rays", "100"}).output,
                HasSubstr("relaxed cones in 4 sectors"));
    EXPECT_THAT(bake({"info", safe}).output, HasSubstr("encoding   ratio"));
    for (std::size_t k = 0; k < 4; ++k) {
        std::vector<float> ratios(4, 0.94f);
        ratios[k] = 1.05f;
        expectGuilty({"verify", sectorFile("wide.exr", ratios), "--rays", "4e4"});
    }
    expectRefused({"verify", sectorFile("three.exr", {0.9f, 0.9f, 0.9f})}, 1,
                  "has cones for 3 sectors of directions, expected 4 or 8");
}

TEST_F(Verify, ConesOfTexelCentresAreNotSafeForTheBilinearSurface) {
    const std::string height = folder.file("height.png");
    const std::string maps = folder.file("maps.exr");
    ASSERT_EQ(bake({"sample", "cobbles", "-o", height, "--size", "48x32"}).exitStatus, 0);
    ASSERT_EQ(bake({"relief", height, "-o", maps, "--guarantee", "texel"}).exitStatus, 0);
    expectGuilty({"verify", maps, "--rays", "4e4"});
}

TEST_F(Verify, EveryLevelOfAFileIsChecked) {
    const std::string height = folder.file("height.png");
    ASSERT_EQ(bake({"sample", "blocks", "-o", height, "--size", "40x24"}).exitStatus, 0);
    for (const std::string cone : {"conservative", "relaxed", "roof"}) {
        const std::string maps = folder.file(cone + ".exr");
        ASSERT_EQ(bake({"relief", height, "-o", maps, "--mips", "--cone", cone}).exitStatus, 0);
        const ProcessResult result = bake({"verify", maps, "--rays", "20000"});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        for (int level = 1; level <= 5; ++level)
            EXPECT_THAT(result.output, HasSubstr("of level " + std::to_string(level)));
    }
}

TEST_F(Verify, FilesOfOtherTools) {
    expectPassed(foreign(foreignFile("down.png", kSafeCode)));
    expectGuilty(foreign(foreignFile("nearest.png", kNearestCode)));
    expectPassed(foreign(foreignFile("float.exr", kSafeRatio, textures::StorageFormat::Float)));
    expectPassed(foreign(foreignFile("half.png", 0.5f * kSafeCode)) +
                 Words{"--cone-scale", "1.99"});
    expectGuilty(foreign(foreignFile("down.png", kSafeCode)) + Words{"--cone-scale", "1.2"});
    expectPassed(foreign(foreignFile("nearest.png", kNearestCode)) + Words{"--kind", "relaxed"});
    // Taken as radii they are ratios of at least 1/D, which is more than 1.
    expectGuilty(foreign(foreignFile("down.png", kSafeCode)) + Words{"--encode", "radius"});
    // Where the tile ends the slope goes on: clamped it is level there, which is safe as well.
    expectPassed(foreign(foreignFile("down.png", kSafeCode)) + Words{"--wrap", "clamp"});
}

// On the ridge the roof of a cell is three texels of slope above its surface, and one more level
// cell than the block is at least a texel away.
TEST_F(Verify, RoofCones) {
    textures::MapSet maps;
    const Plane depth = ridge();
    Plane roof(kWidth, kHeight);
    for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i) {
            roof.at(i, j) = 1.0f;
            for (int x = -1; x <= 2; ++x)
                roof.at(i, j) = std::min(roof.at(i, j), depth.at((i + x + kWidth) % kWidth, j));
        }
    const auto write = [&](const std::string& name, const std::vector<std::string>& layers,
                           float ratio, float roofScale, const std::string& block) {
        maps.channels = {{"depth", depth}};
        maps.attributes = {{"relievo:cone", "roof"}, {"relievo:block", block}};
        Plane roofs = roof;
        for (float& value : roofs.texels)
            value *= roofScale;
        for (const std::string& layer : layers) {
            maps.channels.push_back({"roof" + layer, roofs});
            maps.channels.push_back({"ratio" + layer, Plane(kWidth, kHeight, ratio)});
        }
        textures::writeMapFile(folder.file(name), maps, textures::StorageFormat::Float);
        return folder.file(name);
    };
    const Words rays{"--rays", "4e4"};
    const Words four{"0", "1", "2", "3"};
    expectPassed(Words{"verify", write("one.exr", {""}, kSafeRatio, 1.0f, "1")} + rays);
    expectPassed(Words{"verify", write("four.exr", four, kSafeRatio, 1.0f, "1")} + rays);
    expectGuilty(Words{"verify", write("wide.exr", {""}, 1.5f, 1.0f, "1")} + rays);
    expectGuilty(Words{"verify", write("deep.exr", four, kSafeRatio, 1.2f, "1")} + rays);
    expectGuilty(Words{"verify", write("block.exr", four, kSafeRatio, 1.0f, "3")} + rays);
    expectRefused({"verify", write("three.exr", {"0", "1", "2"}, 0.5f, 1.0f, "1")}, 1,
                  "3 layers of roof cones");
    expectRefused({"verify", write("word.exr", {""}, 0.5f, 1.0f, "few")}, 1, "relievo:block");
    maps.channels.pop_back();
    textures::writeMapFile(folder.file("half.exr"), maps, textures::StorageFormat::Float);
    expectRefused({"verify", folder.file("half.exr")}, 1, "lacks the channel 'ratio'");

    const std::string foreignRoofs = folder.file("foreign.exr");
    textures::writePicture(foreignRoofs,
                           std::array{depth, roof, Plane(kWidth, kHeight, kSafeRatio)},
                           textures::StorageFormat::Float);
    const Words command = Words{"verify",  foreignRoofs, "--depth-channel", "R",
                                "--input", "depth",      "--cone-channel",  "B"} +
                          rays;
    expectPassed(command + Words{"--kind", "roof", "--roof-channel", "G"});
    expectRefused(command + Words{"--kind", "roof"}, 2, "--roof-channel");
    expectRefused(command + Words{"--roof-channel", "G"}, 2, "--kind roof");
}

TEST_F(Verify, DepthsInAFileOfTheirOwn) {
    const std::string cones = folder.file("cones.png");
    textures::writePicture(cones, std::array{Plane(kWidth, kHeight, kSafeCode)},
                           textures::StorageFormat::U8);
    const std::string depths = foreignFile("depths.png", 0.0f);
    expectPassed({"verify", cones, "--rays", "4e4", "--depth", depths, "--depth-channel", "B",
                  "--input", "depth"});
    textures::writePicture(cones, std::array{Plane(kWidth, kWidth, kSafeCode)},
                           textures::StorageFormat::U8);
    expectRefused({"verify", cones, "--depth", depths, "--depth-channel", "B"}, 1, "40×40");
}

TEST_F(Verify, JsonHasTheWorstExampleAndRepeats) {
    const Words command{"verify", mapFile("wide.exr", 2.0f), "--rays", "4e4", "--seed", "7",
                        "--json"};
    const ProcessResult result = bake(command);
    EXPECT_EQ(result.exitStatus, 1);
    const auto json = nlohmann::json::parse(result.output);
    EXPECT_EQ(json["rays"], 40000);
    EXPECT_EQ(json["seed"], 7);
    EXPECT_GT(json["violations"], 0);
    const auto& check = json["checks"].at(0);
    EXPECT_EQ(check["map"], "conservative cones");
    EXPECT_EQ(check["width"], kWidth);
    EXPECT_FLOAT_EQ(check["meanRatio"].get<float>(), 2.0f);
    EXPECT_GT(check["worst"]["depth"], 1e-6);
    EXPECT_LT(check["worst"]["texel"][0], kWidth);
    EXPECT_EQ(bake(command).output, result.output);
}

TEST_F(Verify, WrongUsageAndFilesThatCannotBeChecked) {
    const std::string map = mapFile("map.exr", kSafeRatio);
    const std::string other = foreignFile("other.png", kSafeCode);
    for (const Words& option : {Words{"--wrap", "clamp"},
                                {"--kind", "relaxed"},
                                {"--encode", "ratio"},
                                {"--input", "depth"},
                                {"--depth", other},
                                {"--cone-scale", "2"},
                                {"--cone-channel", "0"},
                                {"--depth-channel", "0"}})
        expectRefused(Words{"verify", map} + option, 2, option[0]);
    expectRefused({"verify", other}, 2, "--depth-channel or --depth");
    expectRefused({"verify", other, "--depth-channel", "B"}, 2, "--cone-channel");
    expectRefused({"verify", map, "--rays", "0"}, 2, "--rays");
    expectRefused({"verify", map, "--rays", "1.5"}, 2, "--rays 1.5");
    expectRefused({"verify", map, "--rays", "nan"}, 2, "--rays nan");
    expectRefused(foreign(other) + Words{"--cone-scale", "nan"}, 2, "--cone-scale");
    expectRefused(foreign(other) + Words{"--cone-scale", "0"}, 2, "--cone-scale");
    expectRefused(foreign(other) + Words{"--kind", "wide"}, 2, "--kind");
    expectRefused({"verify"}, 2, "FILE");
    expectRefused({"verify", folder.file("missing.exr")}, 1, "missing.exr: no such file");
    expectRefused({"verify", other, "--depth-channel", "B", "--cone-channel", "Z"}, 1, "'Z'");

    textures::MapSet depthOnly;
    depthOnly.channels = {{"depth", ridge()}};
    textures::writeMapFile(folder.file("depth.exr"), depthOnly, textures::StorageFormat::Float);
    expectRefused({"verify", folder.file("depth.exr")}, 1, "holds no cones");
    depthOnly.channels.front().name = "cone";
    textures::writeMapFile(folder.file("cone.exr"), depthOnly, textures::StorageFormat::Float);
    expectRefused({"verify", folder.file("cone.exr")}, 1, "depth");
    const std::string negative = foreignFile("negative.exr", -0.5f, textures::StorageFormat::Float);
    expectRefused(foreign(negative), 1, "has the value -0.5 at texel 0,0");
}

}  // namespace
}  // namespace relievo::preprocess
