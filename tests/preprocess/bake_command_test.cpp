// relievo-bake as a process: what it makes of good input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "preprocess/cone_encoding.h"
#include "preprocess/conservative_cones.h"
#include "preprocess/derivatives.h"
#include "preprocess/displacement_factors.h"
#include "preprocess/view_displacement.h"
#include "tests/preprocess/bake_process.h"
#include "tests/preprocess/cone_oracle.h"
#include "textures/height_image.h"
#include "textures/map_file.h"

namespace relievo::preprocess {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using tests::ProcessResult;
using tests::ScratchFolder;
using textures::DepthMap;
using textures::MapSet;
using textures::Plane;

class Bake : public testing::Test {
  protected:
    // A generated relief as a 16-bit height image.
    std::string sample(const std::string& name, const std::string& size) {
        const std::string file = folder.file(name + "-" + size + ".png");
        const ProcessResult result = bake({"sample", name, "-o", file, "--size", size});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        return file;
    }

    MapSet baked(const std::string& height, const std::string& name,
                 std::vector<std::string> options = {}) {
        const std::string file = folder.file(name);
        std::vector<std::string> arguments = {"relief", height,   "-o",
                                              file,     "--cone", "conservative"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = bake(arguments);
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        return textures::readMapFile(file);
    }

    ScratchFolder folder;
};

// Cones of a baked file against brute force: single texels of the whole map, and a crop of it.
void expectTrueCones(const MapSet& maps) {
    const DepthMap relief = textures::depthMapOf(maps);
    std::mt19937 generator(1);
    for (int k = 0; k < 20; ++k) {
        const int i = static_cast<int>(generator() % static_cast<unsigned>(relief.width()));
        const int j = static_cast<int>(generator() % static_cast<unsigned>(relief.height()));
        const double truth = bruteForceRatio(relief, i, j, 1);
        const float ratio = maps.find("cone")->at(i, j);
        if (truth < textures::kLargestHalf)
            EXPECT_TRUE(isTrueRatio(ratio, truth)) << i << "," << j << " " << ratio << " " << truth;
        else
            EXPECT_EQ(ratio, textures::kLargestHalf);
    }
    DepthMap crop{Plane(128, 128), textures::WrapMode::Clamp};
    for (int j = 0; j < 128; ++j)
        for (int i = 0; i < 128; ++i)
            crop.depth.at(i, j) = relief.at(i + 200, j + 150);
    EXPECT_EQ(countWrongRatios(buildConservativeCones(crop, ConeGuarantee::Texel), crop, 0), 0u);
}

TEST_F(Bake, ConesOfALarge16BitSampleEqualBruteForce) {
    expectTrueCones(baked(sample("cobbles", "1024x1024"), "cobbles.exr",
                          {"--encode", "ratio", "--guarantee", "texel"}));
}

TEST_F(Bake, ConesOfAScannedReliefEqualBruteForce) {
    const char* const given = std::getenv("RELIEVO_SHARED_DATA");
    const std::filesystem::path data =
        given != nullptr ? given : RELIEVO_SOURCE_DIR "/../shared/data";
    const std::filesystem::path planks = data / "relief" / "planks-height.png";
    if (!std::filesystem::exists(planks))
        GTEST_SKIP() << "skipped: no file " << planks;
    expectTrueCones(baked(planks, "planks.exr", {"--encode", "ratio", "--guarantee", "texel"}));
}

TEST_F(Bake, FileHoldsTheMapsOfTheDepthsItStores) {
    const std::string height = sample("noise", "48x32");
    const DepthMap input = textures::readHeightImage(height, {}).depth;
    for (const auto& [name, format] :
         {std::pair{"a.exr", "float"}, {"b.exr", "half"}, {"c.png", "u16"}, {"d.tif", "u8"}}) {
        const MapSet maps = baked(height, name, {"--format", format});
        const DepthMap relief = textures::depthMapOf(maps);
        EXPECT_EQ(maps.encoding, textures::ConeEncoding::Ratio);
        const Plane ratio = buildConservativeCones(relief, ConeGuarantee::Bilinear);
        const Derivatives derivatives = buildDerivatives(relief);
        const Plane stored = decodeCones(*maps.find("cone"), relief.depth, maps.encoding);
        for (std::size_t k = 0; k < ratio.texels.size(); ++k) {
            EXPECT_NEAR(relief.depth.texels[k], input.depth.texels[k], 0.5 / 255 + 1e-6);
            // Safe for the depths in the file, and close to as wide as they allow.
            if (relief.depth.texels[k] > 0.0f) {
                EXPECT_LE(stored.texels[k], ratio.texels[k]) << name;
            }
            EXPECT_NEAR(maps.find("dx")->texels[k], derivatives.dx.texels[k], 0.4);
        }
    }
}

TEST_F(Bake, DefaultFormatsLoseNothingOfA16BitImage) {
    const std::string height = sample("wave", "64x64");
    const DepthMap input = textures::readHeightImage(height, {}).depth;
    EXPECT_EQ(textures::depthMapOf(baked(height, "a.exr")).depth.texels, input.depth.texels);
    const Plane packed = textures::depthMapOf(baked(height, "a.png")).depth;
    for (std::size_t k = 0; k < packed.texels.size(); ++k)
        EXPECT_NEAR(packed.texels[k], input.depth.texels[k], 1e-7);
}

TEST_F(Bake, OptionsReachTheFile) {
    const std::string height = sample("bricks", "40x30");
    const MapSet maps = baked(height, "a.exr",
                              {"--maps", "normal,cone,depth", "--wrap", "mirror", "--encode",
                               "ratio", "--method", "levels", "--normal-scale", "0.25"});
    EXPECT_EQ(maps.wrap, textures::WrapMode::Mirror);
    EXPECT_EQ(maps.encoding, textures::ConeEncoding::Ratio);
    EXPECT_EQ(maps.attributes.at("relievo:method"), "levels");
    EXPECT_EQ(maps.attributes.at("relievo:normal-scale"), "0.25");
    EXPECT_EQ(maps.find("dx"), nullptr);
    EXPECT_NE(maps.find("nz"), nullptr);
    const MapSet inverted = baked(height, "b.exr", {"--input", "depth", "--maps", "depth"});
    for (std::size_t k = 0; k < inverted.find("depth")->texels.size(); ++k)
        EXPECT_NEAR(inverted.find("depth")->texels[k], 1.0f - maps.find("depth")->texels[k], 1e-6);
    EXPECT_NE(inverted.source, maps.source);
}

TEST_F(Bake, SameBytesForOneAndTwoThreads) {
    const std::string height = sample("blocks", "200x130");
    for (const std::string extension : {".exr", ".png", ".tif"}) {
        baked(height, "one" + extension, {"--threads", "1"});
        baked(height, "two" + extension, {"--threads", "2"});
        EXPECT_EQ(tests::readBytes(folder.file("one" + extension)),
                  tests::readBytes(folder.file("two" + extension)));
    }
}

TEST_F(Bake, RoofConesAreTheUsualOnesWhereTheyFit) {
    const std::string height = sample("bricks", "32x32");
    const auto channelsOf = [&](const std::vector<std::string>& arguments) {
        const std::string file = folder.file(arguments.front());
        std::vector<std::string> all = {"relief", height, "-o", file};
        all.insert(all.end(), arguments.begin() + 1, arguments.end());
        EXPECT_EQ(bake(all).exitStatus, 0);
        std::vector<std::string> names;
        for (const textures::Channel& channel : textures::readMapFile(file).channels)
            names.push_back(channel.name);
        return names;
    };
    EXPECT_THAT(channelsOf({"a.exr"}), IsSupersetOf({"roof0", "ratio0", "roof3", "ratio3", "dx"}));
    EXPECT_THAT(channelsOf({"b.exr", "--sectors", "1"}), IsSupersetOf({"roof", "ratio"}));
    EXPECT_THAT(channelsOf({"c.exr", "--guarantee", "texel"}), Contains("cone"));
    EXPECT_THAT(channelsOf({"d.png"}), Contains("cone"));
    // Relaxed ones have sectors as well, but in packed files.
    EXPECT_THAT(channelsOf({"e.exr", "--cone", "relaxed"}), IsSupersetOf({"cone0", "cone7"}));
    EXPECT_THAT(channelsOf({"f.exr", "--cone", "relaxed", "--sectors", "1"}), Contains("cone"));
    EXPECT_THAT(channelsOf({"g.png", "--cone", "relaxed"}), Contains("cone"));
}

TEST_F(Bake, StagesAreToldUnlessQuiet) {
    const std::string height = sample("wave", "32x32");
    const ProcessResult loud = bake({"relief", height, "-o", folder.file("a.exr")});
    for (const char* stage : {"read ", "plan ", "cone ", "derivative ", "write ", "1024 texels"})
        EXPECT_THAT(loud.output, HasSubstr(stage));
    const ProcessResult quiet = bake({"relief", height, "-o", folder.file("a.exr"), "--quiet"});
    EXPECT_EQ(quiet.output + quiet.errors, "");
}

// The factors of a file with 16 azimuths, by its channels and attributes alone.
DisplacementFactors factorsIn(const MapSet& maps, std::size_t terms) {
    DisplacementFactors factors;
    std::istringstream weights(maps.attributes.at("relievo:vdm-weights"));
    for (std::size_t k = 0; k < terms * 16; ++k)
        factors.factors.push_back(*maps.find("vdmfactor" + std::to_string(k)));
    factors.weights.assign(terms, std::vector<float>(8 * 5));
    for (std::vector<float>& term : factors.weights)
        for (float& weight : term)
            EXPECT_TRUE(weights >> weight);
    return factors;
}

TEST_F(Bake, DisplacementsComeBackFromTheFile) {
    const std::string height = sample("cobbles", "20x15");
    const ViewGrid grid;
    for (const std::string format : {"float", "half"}) {
        const MapSet packed =
            baked(height, "a.exr", {"--maps", "depth,vdm", "--vdm-terms", "5", "--format", format});
        const MapSet whole =
            baked(height, "b.exr", {"--maps", "depth,vdm", "--vdm-terms", "0", "--format", format});
        const DisplacementFactors factors = factorsIn(packed, 5);
        const std::vector<Plane> table = buildViewDisplacement(textures::depthMapOf(packed), grid);
        double greatest = 0.0;
        for (std::size_t view = 0; view < table.size(); ++view) {
            const Plane& stored = *whole.find("vdm" + std::to_string(view));
            for (std::size_t texel = 0; texel < stored.texels.size(); ++texel) {
                const float truth = table[view].texels[texel];
                ASSERT_EQ(stored.texels[texel] == kNoHit, truth == kNoHit);
                ASSERT_LE(stored.texels[texel], truth);
                ASSERT_GE(stored.texels[texel], truth - 1e-3f * std::abs(truth) - 1e-7f);
                if (truth != kNoHit)
                    greatest = std::max(
                        greatest, std::abs(displacementOf(factors, grid, view, texel) - truth));
            }
        }
        std::istringstream error(packed.attributes.at("relievo:vdm-error"));
        double mean = 0.0;
        double percentile = 0.0;
        double stated = 0.0;
        error >> mean >> percentile >> stated;
        EXPECT_NEAR(greatest, stated, 1e-6 * stated);
        EXPECT_TRUE(0.0 < mean && mean < percentile && percentile < stated);
    }
    EXPECT_THAT(bake({"info", folder.file("a.exr")}).output, HasSubstr("... ("));
}

TEST_F(Bake, SizesAreToldBeforeTheWork) {
    const std::string height = sample("wave", "16x16");
    const std::string out = folder.file("a.exr");
    const std::string told = bake({"relief", height, "-o", out, "--maps", "vdm"}).output;
    // 8·16 factors and 16·2 numbers of misses, of 1024 bytes each.
    EXPECT_THAT(told, HasSubstr("640 views, 655360 bytes as a table, 163840 as 8 terms"));
    EXPECT_LT(told.find("163840 bytes as floats"), told.find("\nvdm "));
    EXPECT_EQ(textures::readMapFile(out).channels.size(), 160u);
}

TEST_F(Bake, TablesThatDoNotFitAreRefusedBeforeTheWork) {
    const ProcessResult result =
        bake({"relief", sample("wave", "512x512"), "-o", folder.file("a.exr"), "--maps", "vdm",
              "--vdm-terms", "0", "--vdm-azimuths", "64", "--vdm-elevations", "16",
              "--vdm-curvatures", "15"});
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_EQ(result.output, "");
    EXPECT_THAT(result.errors, HasSubstr("15360 channels are too many for a map file, expected at "
                                         "most 8 GiB"));
}

TEST_F(Bake, WhatIsUpToDateIsLeftAlone) {
    const std::string height = sample("wave", "32x32");
    const std::string out = folder.file("a.exr");
    const std::vector<std::string> usual = {"relief", height, "-o", out};
    const auto isBaked = [&](const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments = usual;
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = bake(arguments);
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        const bool isLeft = result.output.find("is up to date") != std::string::npos;
        EXPECT_NE(isLeft, result.output.find("write ") != std::string::npos) << result.output;
        return !isLeft;
    };
    EXPECT_TRUE(isBaked());
    EXPECT_FALSE(isBaked());
    EXPECT_FALSE(isBaked({"--threads", "1"})) << "which changes nothing";
    EXPECT_TRUE(isBaked({"--force"}));
    EXPECT_TRUE(isBaked({"--wrap", "clamp"}));
    EXPECT_TRUE(isBaked({"--wrap", "clamp", "--input", "depth"})) << "other depths";
    EXPECT_TRUE(isBaked({"--wrap", "clamp", "--input", "depth", "--mips"}));
    EXPECT_TRUE(isBaked());
    const std::string whole = tests::readBytes(out);
    std::filesystem::resize_file(out, whole.size() - 10);
    EXPECT_TRUE(isBaked()) << "damaged";
    EXPECT_EQ(tests::readBytes(out), whole);
    EXPECT_FALSE(isBaked());
}

TEST_F(Bake, LevelsAreInTheFileAndAreTold) {
    const std::string height = sample("blocks", "50x20");
    for (const std::string name : {"a.exr", "a.tif"}) {
        baked(height, name, {"--mips", "--encode", "ratio"});
        const std::vector<MapSet> levels = textures::readMapLevels(folder.file(name));
        ASSERT_EQ(levels.size(), 6u) << name;
        for (const MapSet& level : levels) {
            const Plane ratio =
                buildConservativeCones(textures::depthMapOf(level), ConeGuarantee::Bilinear);
            for (std::size_t k = 0; k < ratio.texels.size(); ++k)
                EXPECT_LE(level.find("cone")->texels[k],
                          std::min(ratio.texels[k], textures::kLargestHalf));
        }
        const auto info = nlohmann::json::parse(bake({"info", folder.file(name), "--json"}).output);
        EXPECT_EQ(info["levels"].size(), 6u);
        EXPECT_EQ(info["levels"][1], "25x10");
    }
    const ProcessResult png = bake({"relief", height, "-o", folder.file("a.png"), "--mips"});
    EXPECT_EQ(png.exitStatus, 2);
    EXPECT_THAT(png.errors, HasSubstr("expected .exr or .tif"));
}

TEST_F(Bake, WarnsWhenAPackedFileNarrowsCones) {
    const std::string height = sample("ridge", "64x64");
    const ProcessResult result = bake({"relief", height, "-o", folder.file("a.png"), "--guarantee",
                                       "texel", "--encode", "ratio"});
    EXPECT_EQ(result.exitStatus, 0);
    EXPECT_THAT(result.errors, HasSubstr("note: "));
    EXPECT_THAT(result.errors, HasSubstr("wider than 1"));
}

TEST_F(Bake, InfoTellsMapFilesAndImages) {
    const std::string height = sample("wave", "32x16");
    baked(height, "a.exr", {"--wrap", "clamp"});
    const auto maps = nlohmann::json::parse(bake({"info", folder.file("a.exr"), "--json"}).output);
    EXPECT_EQ(maps["kind"], "relief");
    EXPECT_EQ(maps["width"], 32);
    EXPECT_EQ(maps["height"], 16);
    EXPECT_EQ(maps["format"], "float");
    EXPECT_EQ(maps["wrap"], "clamp");
    EXPECT_EQ(maps["encoding"], "ratio");
    EXPECT_EQ(maps["attributes"]["relievo:guarantee"], "bilinear");
    EXPECT_EQ(maps["channels"].size(), 4u);
    EXPECT_THAT(bake({"info", folder.file("a.exr")}).output, HasSubstr("relievo:guarantee"));
    const auto image = nlohmann::json::parse(bake({"info", height, "--json"}).output);
    EXPECT_EQ(image["kind"], "image");
    EXPECT_EQ(image["format"], "u16");
    EXPECT_EQ(image["channels"].size(), 1u);
}

TEST_F(Bake, SampleListsAndWritesHeightAndColours) {
    EXPECT_THAT(bake({"sample", "--list"}).output, HasSubstr("cobbles"));
    const ProcessResult result = bake({"sample", "bricks", "-o", folder.file("h.exr"), "--size",
                                       "20x10", "--seed", "4", "--albedo", folder.file("c.png")});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_THAT(folder.list(), ElementsAre("c.png", "h.exr"));
    const DepthMap relief = textures::readHeightImage(folder.file("h.exr"), {}).depth;
    EXPECT_EQ(relief.width(), 20);
    EXPECT_EQ(relief.height(), 10);
}

TEST_F(Bake, SmallestAndLongestMaps) {
    for (const char* size : {"1x1", "1x37", "128x2"}) {
        const MapSet maps = baked(sample("noise", size), std::string(size) + ".exr");
        EXPECT_EQ(maps.channels.size(), 4u);
    }
}

}  // namespace
}  // namespace relievo::preprocess
