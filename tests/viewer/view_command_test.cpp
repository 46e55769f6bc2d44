// relievo-view as a process: what it prints, writes and returns.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>

#include "materials/technique_registry.h"
#include "tests/commands/process.h"
#include "tests/viewer/map_fixture.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"
#include "textures/sample_reliefs.h"
#include "viewer/picture.h"

namespace relievo::tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::StartsWith;

class ViewCommandTest : public testing::Test {
  protected:
    static ProcessResult run(std::vector<std::string> words, const ProcessOptions& options = {}) {
        words.insert(words.begin(), RELIEVO_VIEW);
        return runProcess(words, options);
    }

    /// A headless run of small pictures of `map`, written to `output`.
    static ProcessResult render(const std::string& map, const std::string& output,
                                const std::vector<std::string>& options = {}) {
        std::vector<std::string> words = {map, "--headless", "-o", output, "--size", "96x80"};
        words.insert(words.end(), options.begin(), options.end());
        return run(words);
    }

    std::string map() {
        const std::string file = inputs_.file("waves.exr");
        if (!std::filesystem::exists(file))
            writeSampleMaps(file, "wave", 32, 32);
        return file;
    }

    /// A run must have failed with `status`, one sentence on stderr that contains `text`, and no
    /// file in the output folder.
    void expectFailure(const ProcessResult& result, int status, const std::string& text) {
        EXPECT_EQ(result.exitStatus, status) << result.errors;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_THAT(result.errors, AllOf(StartsWith("relievo-view: "), HasSubstr(text)));
        EXPECT_THAT(outputs_.list(), ElementsAre());
    }

    ScratchFolder inputs_;
    ScratchFolder outputs_;
};

TEST_F(ViewCommandTest, HelpNamesEveryOption) {
    const ProcessResult result = run({"--help"});
    EXPECT_EQ(result.exitStatus, 0);
    EXPECT_EQ(result.errors, "");
    for (const char* option :
         {"FILE",     "--technique", "--compare",        "--set",     "--mesh",    "--depth-scale",
          "--tiles",  "--camera",    "--light",          "--albedo",  "--size",    "--headless",
          "--output", "--error",     "--mark-exhausted", "--normals", "--backend", "--list",
          "--quiet",  "--version",   "Examples"})
        EXPECT_THAT(result.output, HasSubstr(option));
}

TEST_F(ViewCommandTest, CurvedObjectsAndMeshFilesCarryReliefs) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::string mesh = inputs_.file("triangle.obj");
    std::ofstream(mesh) << triangle << "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
    for (const std::string& object : {std::string("sphere"), std::string("torus"), mesh}) {
        const std::string picture = outputs_.file("picture.png");
        const ProcessResult result =
            render(map(), picture, {"--mesh", object, "--tiles", "8,4", "--camera", "0,20"});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        const ProcessResult compared =
            render(map(), picture, {"--mesh", object, "--error", outputs_.file("error.exr")});
        EXPECT_THAT(compared.output, HasSubstr("against the exact hits: 0.0")) << compared.errors;
    }
    std::filesystem::remove(outputs_.file("picture.png"));
    std::filesystem::remove(outputs_.file("error.exr"));
    std::ofstream(mesh) << triangle << "f 1 2 3\n";
    expectFailure(render(map(), outputs_.file("a.png"), {"--mesh", mesh}), 1,
                  "has no texture coordinates");
}

// A file with nothing but depths can be shown, shaded by their differences.
TEST_F(ViewCommandTest, NormalsComeFromWhatTheFileHas) {
    const std::string depths = inputs_.file("depths.exr");
    textures::MapSet maps;
    maps.channels = {{"depth", textures::generateSampleRelief("wave", 32, 32).depth}};
    textures::writeMapFile(depths, maps, textures::StorageFormat::Float);
    for (const std::string source : {"derivative", "height"}) {
        const std::string picture = outputs_.file(source + ".png");
        const ProcessResult result =
            render(source == "height" ? depths : map(), picture, {"--technique", "relief"});
        ASSERT_EQ(result.exitStatus, 0) << result.errors;
    }
    EXPECT_EQ(
        render(map(), outputs_.file("forced.png"), {"--technique", "relief", "--normals", "height"})
            .exitStatus,
        0);
    EXPECT_EQ(readBytes(outputs_.file("height.png")), readBytes(outputs_.file("forced.png")));
    EXPECT_EQ(readBytes(outputs_.file("height.png")), readBytes(outputs_.file("derivative.png")));
}

TEST_F(ViewCommandTest, ShadingAndItsTexturesAreSeen) {
    const std::string picture = outputs_.file("picture.png");
    const auto pixels = [&](const std::vector<std::string>& options) {
        std::vector<std::string> words = {"--technique", "relief"};
        words.insert(words.end(), options.begin(), options.end());
        const ProcessResult result = render(map(), picture, words);
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        return readBytes(picture);
    };
    const std::string grey = inputs_.file("4grey.png");
    const std::array planes = {textures::Plane(2, 2, 0.25f)};
    textures::writePicture(grey, planes, textures::StorageFormat::U8);
    const std::string phong = pixels({});
    EXPECT_EQ(pixels({"--shading", "blinn-phong"}), phong);
    const std::string rough = pixels({"--shading", "microfacet", "--roughness", "0.9"});
    EXPECT_NE(rough, phong);
    EXPECT_NE(pixels({"--shading", "microfacet", "--roughness", grey}), rough);
    EXPECT_NE(pixels({"--shading", "microfacet", "--roughness", "0.9", "--metalness", "1"}), rough);
    EXPECT_NE(pixels({"--occlusion", grey}), phong);
}

TEST_F(ViewCommandTest, TexturesThatDoNotFitAreRefused) {
    const std::string picture = outputs_.file("x.png");
    const std::string grey = inputs_.file("grey.png");
    const std::array planes = {textures::Plane(2, 2, 0.25f)};
    textures::writePicture(grey, planes, textures::StorageFormat::U8);
    expectFailure(render(map(), picture, {"--roughness", "0.2"}), 2, "--shading microfacet");
    // The usual value as well.
    expectFailure(render(map(), picture, {"--roughness", "0.5"}), 2, "--shading microfacet");
    expectFailure(render(map(), picture, {"--metalness", grey}), 2, "--shading microfacet");
    expectFailure(render(map(), picture, {"--shading", "microfacet", "--metalness", "2"}), 2,
                  "0 to 1");
    expectFailure(render(map(), picture, {"--orm", grey, "--occlusion", grey}), 2, "--orm");
    expectFailure(render(map(), picture, {"--orm", grey}), 1, "grey.png: too few channels (1)");
    expectFailure(render(map(), picture, {"--occlusion", "baked"}), 1, "\"occlusion\"");
    expectFailure(render(map(), picture, {"--occlusion", inputs_.file("none.png")}), 1, "none.png");
}

TEST_F(ViewCommandTest, ALightHasNoSizeWithoutShadows) {
    const std::string picture = outputs_.file("x.png");
    expectFailure(render(map(), picture, {"--light-size", "8"}), 2, "--shadow");
    const ProcessResult result =
        render(map(), picture, {"--light-size", "8", "--shadow", "soft", "--technique", "relief"});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
}

TEST_F(ViewCommandTest, NormalsThatTheFileLacksAreRefused) {
    const std::vector<std::string> normals = {"--technique", "relief", "--normals", "normal"};
    expectFailure(render(map(), outputs_.file("x.png"), normals), 1, "\"nx\"");
    expectFailure(render(map(), outputs_.file("x.png"), {"--normals", "best"}), 2, "--normals");
}

TEST_F(ViewCommandTest, ListNamesTechniquesAndParameters) {
    const ProcessResult result = run({"--list"});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    for (const materials::Technique& technique : materials::techniques()) {
        EXPECT_THAT(result.output, HasSubstr(std::string(technique.name) + ": "));
        for (const materials::TechniqueParameter& parameter : technique.parameters)
            EXPECT_THAT(result.output, HasSubstr(std::string(parameter.name) + ": "));
    }
    EXPECT_THAT(result.output, HasSubstr("reference"));
}

TEST_F(ViewCommandTest, OneTechniqueIsAPictureOfTheSizeAskedFor) {
    const ProcessResult result = render(map(), outputs_.file("a.png"));
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    const viewer::Picture picture = viewer::readPicture(outputs_.file("a.png"));
    EXPECT_EQ(picture.width, 96);
    EXPECT_EQ(picture.height, 80);
    EXPECT_THAT(outputs_.list(), ElementsAre("a.png"));
}

TEST_F(ViewCommandTest, AComparisonIsASheetWithAPictureEach) {
    const ProcessResult result =
        render(map(), outputs_.file("sheet.png"), {"--compare", "normal,relief,reference"});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    const viewer::Picture sheet = viewer::readPicture(outputs_.file("sheet.png"));
    EXPECT_GE(sheet.width, 3 * 96);
    EXPECT_LT(sheet.width, 3 * 96 + 60);
    EXPECT_GT(sheet.height, 80);
    EXPECT_LT(sheet.height, 2 * 80);
}

TEST_F(ViewCommandTest, ErrorsAreChannelsNamedAfterTheTechnique) {
    const ProcessResult result =
        render(map(), outputs_.file("sheet.png"),
               {"--compare", "normal,cone", "--error", outputs_.file("error.exr")});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
    const auto image = OIIO::ImageInput::open(outputs_.file("error.exr"));
    ASSERT_TRUE(image);
    EXPECT_EQ(image->spec().width, 96);
    EXPECT_EQ(image->spec().height, 80);
    std::vector<std::string> expected;
    for (const char* technique : {"normal", "cone"})
        for (const char* quantity : {"distance", "normal_angle", "verdict", "steps", "fetches"})
            expected.push_back(std::string(technique) + "." + quantity);
    EXPECT_THAT(image->spec().channelnames, testing::UnorderedElementsAreArray(expected));
}

TEST_F(ViewCommandTest, TheSameRunWritesTheSameBytes) {
    for (const char* name : {"one.png", "two.png"})
        ASSERT_EQ(
            render(map(), outputs_.file(name), {"--compare", "relief,cone,reference"}).exitStatus,
            0);
    EXPECT_EQ(readBytes(outputs_.file("one.png")), readBytes(outputs_.file("two.png")));
    // Bytes of another scene differ, so the comparison means something.
    ASSERT_EQ(render(map(), outputs_.file("three.png"),
                     {"--compare", "relief,cone,reference", "--depth-scale", "0.2"})
                  .exitStatus,
              0);
    EXPECT_NE(readBytes(outputs_.file("one.png")), readBytes(outputs_.file("three.png")));
}

TEST_F(ViewCommandTest, QuietPrintsNothing) {
    const ProcessResult result = render(map(), outputs_.file("a.png"), {"--quiet"});
    EXPECT_EQ(result.exitStatus, 0);
    EXPECT_EQ(result.output + result.errors, "");
}

TEST_F(ViewCommandTest, WrongUsageIsStatusTwo) {
    const std::string picture = outputs_.file("a.png");
    expectFailure(run({}), 2, "no map file");
    expectFailure(run({map(), "--no-such-option"}), 2, "--no-such-option");
    expectFailure(run({map(), "--headless"}), 2, "-o");
    expectFailure(run({map(), "-o", picture}), 2, "--headless");
    expectFailure(render(map(), picture, {"--tiles", "-1,1"}), 2, "--tiles");
    expectFailure(render(map(), picture, {"--tiles", "1"}), 2, "--tiles");
    expectFailure(render(map(), picture, {"--camera", "1,2,-3"}), 2, "--camera");
    expectFailure(render(map(), picture, {"--depth-scale", "-1"}), 2, "--depth-scale");
    expectFailure(render(map(), picture, {"--mesh", "torso"}), 2, "--mesh");
    expectFailure(render(map(), picture, {"--set", "no-such-steps=3"}), 2, "no-such-steps");
    expectFailure(render(map(), picture, {"--set", "cone-steps"}), 2, "cone-steps");
    expectFailure(render(map(), picture, {"--technique", "cone", "--compare", "cone,relief"}), 2,
                  "--compare");
    for (const char* size : {"8x100", "100", "0x0", "axb", "100x9000", "nanx100"})
        expectFailure(run({map(), "--headless", "-o", picture, "--size", size}), 2, "--size");
}

// Of a shape the searches are compared with the exact hits of their rays: ours is right, and the
// printed one is not at this angle.
TEST_F(ViewCommandTest, ComparesSearchesOfAShapeWithExactHits) {
    const std::string drawing = inputs_.file("disc.svg");
    std::ofstream(drawing) << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 4">)"
                           << R"(<circle cx="2" cy="2" r="1.2"/></svg>)";
    const ProcessResult result = render(
        drawing, outputs_.file("sheet.png"),
        {"--solid", "revolution", "--tiles", "8,8", "--depth-scale", "1", "--camera", "20,8,1.2",
         "--compare", "solid,revolution-printed", "--error", outputs_.file("error.exr")});
    ASSERT_EQ(result.exitStatus, 0) << result.errors;
    EXPECT_THAT(outputs_.list(), ElementsAre("error.exr", "sheet.png"));
    const std::string wrong = "against the exact hits: ";
    const std::size_t ours = result.output.find(wrong + "0.00 % wrong");
    EXPECT_NE(ours, std::string::npos) << result.output;
    const std::size_t printed = result.output.find(wrong, ours + 1);
    ASSERT_NE(printed, std::string::npos) << result.output;
    EXPECT_NE(result.output.substr(printed + wrong.size(), 4), "0.00") << result.output;
}

// What would do nothing for a shape is refused.
TEST_F(ViewCommandTest, OptionsOfReliefsAreNotThoseOfShapes) {
    const std::string picture = outputs_.file("a.png");
    const std::string drawing = inputs_.file("square.svg");
    std::ofstream(drawing) << R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 4">)"
                           << R"(<path d="M1 1 H3 V3 H1 Z"/></svg>)";
    expectFailure(render(drawing, picture, {"--set", "cone-steps=3"}), 2, "cone-steps");
    expectFailure(render(drawing, picture, {"--set", "cone.solid-steps=3"}), 2, "solid-steps");
    expectFailure(render(drawing, picture, {"--normals", "height"}), 2, "--normals");
    expectFailure(render(drawing, picture, {"--level", "1"}), 2, "--level");
    expectFailure(render(drawing, picture, {"--orm", "orm.png"}), 2, "--orm");
    expectFailure(render(drawing, picture, {"--light-size", "1"}), 2, "--light-size");
    expectFailure(render(drawing, picture, {"--shadow-texels", "512"}), 2, "--shadow-texels");
    expectFailure(render(map(), picture, {"--shadow-texels", "512"}), 2, "--shadow-texels");
    expectFailure(render(drawing, picture, {"--technique", "cone"}), 1, "cone");
    expectFailure(render(drawing, picture, {"--mesh", "shape-box", "--depth-scale", "0"}), 1,
                  "depth");
    EXPECT_EQ(render(drawing, picture, {"--set", "solid-steps=99"}).exitStatus, 0);
}

TEST_F(ViewCommandTest, BadInputIsStatusOneOneSentenceAndNoOutput) {
    const std::string picture = outputs_.file("a.png");
    expectFailure(render(inputs_.file("missing.exr"), picture), 1, "missing.exr");

    const std::string text = inputs_.file("text.exr");
    std::ofstream(text) << "no image at all";
    expectFailure(render(text, picture), 1, "text.exr");

    // A picture is no map: it has no metadata.
    const std::string plain = inputs_.file("plain.png");
    viewer::writePicture(plain, viewer::Picture(16, 16));
    expectFailure(render(plain, picture), 1, "plain.png");

    const std::string bare = inputs_.file("bare.exr");
    writeSampleMaps(bare, "wave", 16, 16, ConeChannel::Missing);
    expectFailure(render(bare, picture, {"--technique", "cone"}), 1, "cone");

    const std::string truncated = inputs_.file("truncated.exr");
    const std::string whole = readBytes(map());
    std::ofstream(truncated, std::ios::binary) << whole.substr(0, whole.size() / 2);
    expectFailure(render(truncated, picture), 1, "truncated.exr");

    expectFailure(render(map(), picture, {"--technique", "no-such-technique"}), 1,
                  "no-such-technique");
    expectFailure(render(map(), picture, {"--set", "exact-steps=0"}), 1, "exact-steps");
    expectFailure(render(map(), picture, {"--set", "exact-steps=2.5"}), 1, "exact-steps");
    expectFailure(render(map(), picture, {"--albedo", inputs_.file("none.png")}), 1, "none.png");
    expectFailure(render(map(), outputs_.file("no-such-folder/a.png")), 1, "no-such-folder");
    expectFailure(render(map(), outputs_.file("a.xyz")), 1, "a.xyz");
    expectFailure(render(map(), picture, {"--error", outputs_.file("error.png")}), 1, "error.png");
}

TEST_F(ViewCommandTest, WhatFitsStaysWithoutTheConeChannel) {
    const std::string bare = inputs_.file("bare.exr");
    writeSampleMaps(bare, "wave", 16, 16, ConeChannel::Missing);
    const ProcessResult result = render(bare, outputs_.file("a.png"), {"--technique", "relief"});
    EXPECT_EQ(result.exitStatus, 0) << result.errors;
}

TEST_F(ViewCommandTest, AFullDiskLeavesNothing) {
    ProcessOptions options;
    options.fileSizeLimit = 512;
    const ProcessResult result =
        run({map(), "--headless", "-o", outputs_.file("a.png"), "--size", "256x256"}, options);
    expectFailure(result, 1, "a.png");
}

TEST_F(ViewCommandTest, AnInterruptedRunLeavesNoHalfFile) {
    // The map is read, and the first of the pictures alone takes minutes.
    ProcessOptions options;
    options.signalWhen = [](const std::string& output) {
        return output.find(": 32x32, ") != std::string::npos;
    };
    options.signal = SIGINT;
    const ProcessResult result =
        run({map(), "--headless", "-o", outputs_.file("a.png"), "--size", "4096x4096", "--compare",
             "linear,relief,cone,reference", "--set", "linear-steps=4096", "--error",
             outputs_.file("error.exr")},
            options);
    EXPECT_EQ(result.exitStatus, 128 + SIGINT);
    EXPECT_THAT(outputs_.list(), ElementsAre());
}

TEST_F(ViewCommandTest, WithoutADisplayTheWindowSaysSo) {
    const ProcessResult result =
        runProcess({"/usr/bin/env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", RELIEVO_VIEW, map()});
    expectFailure(result, 1, "DISPLAY");
    EXPECT_THAT(result.errors, HasSubstr("--headless"));
}

}  // namespace
}  // namespace relievo::tests
