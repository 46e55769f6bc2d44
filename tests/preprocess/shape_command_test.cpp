// relievo-bake shape as a process: what it makes of images, drawings and text, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "preprocess/shape_baker.h"
#include "tests/preprocess/bake_process.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace relievo::preprocess {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::ProcessResult;
using tests::ScratchFolder;
using textures::Plane;
using textures::ShapeMap;

using Words = std::vector<std::string>;

const std::string kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

constexpr const char* kDisc =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 30'>"
    "<circle cx='20' cy='15' r='10'/></svg>";

class Shape : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& bytes) {
        std::ofstream(folder.file(name), std::ios::binary) << bytes;
        return folder.file(name);
    }
    std::string svg(const std::string& name, const std::string& content) {
        return write(name, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 40'>" +
                               content + "</svg>");
    }
    std::string picture(const std::string& name, const Plane& plane) {
        textures::writePicture(folder.file(name), std::array{plane},
                               std::filesystem::path(name).extension() == ".exr"
                                   ? textures::StorageFormat::Float
                                   : textures::StorageFormat::U8);
        return folder.file(name);
    }

    ShapeMap baked(const std::string& source, const std::string& name, const Words& options = {}) {
        Words arguments{"shape", source, "-o", folder.file(name)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = bake(arguments);
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
        return textures::shapeMapOf(textures::readMapFile(folder.file(name)));
    }

    // One sentence that names `culprit`, and a folder as before.
    void expectRefused(const Words& arguments, int status, const std::string& culprit) {
        const std::vector<std::string> before = folder.list();
        const ProcessResult result = bake(arguments);
        EXPECT_EQ(result.exitStatus, status) << culprit << result.output;
        EXPECT_THAT(result.errors, testing::StartsWith("relievo-bake: "));
        EXPECT_THAT(result.errors, HasSubstr(culprit));
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_EQ(folder.list(), before) << culprit;
    }

    ScratchFolder folder;
};

// The circle is drawn at 0 and on it, whatever the file.
TEST_F(Shape, DrawingsInAllFormats) {
    const std::string disc = write("disc.svg", kDisc);
    for (const auto& [name, format] :
         {std::pair{"a.exr", "float"}, {"b.exr", "half"}, {"c.png", "u16"}, {"d.tif", "u8"}}) {
        const ShapeMap map = baked(disc, name, {"--format", format, "--wrap", "clamp"});
        EXPECT_EQ(map.width(), 512);
        EXPECT_EQ(map.height(), 384);
        EXPECT_TRUE(map.isSigned);
        for (int j = 3; j < 384; j += 20)
            for (int i = 5; i < 512; i += 20) {
                const double x = (i + 0.5) / 512 - 0.5;
                const double y = (j + 0.5) / 512 - 0.375;
                const double exact = std::hypot(x, y) - 0.25;
                EXPECT_NEAR(map.distance.at(i, j), exact, 0.02 / 512 + map.slack);
                EXPECT_NEAR(map.gradientX.at(i, j), x / std::hypot(x, y), 0.02);
                EXPECT_NEAR(map.gradientY.at(i, j), y / std::hypot(x, y), 0.02);
                EXPECT_NEAR(map.shape.at(i, j), exact < 0.0 ? 1.0 : 0.0, 0.51);
            }
        const ProcessResult verdict =
            bake({"verify", folder.file(name), "--rays", "20000", "--json"});
        EXPECT_EQ(verdict.exitStatus, 0) << verdict.errors;
        EXPECT_EQ(nlohmann::json::parse(verdict.output)["violations"], 0);
    }
    // The packed form of the thesis.
    const textures::MapSet packed = textures::readMapFile(folder.file("c.png"));
    ASSERT_EQ(packed.channels.size(), 4u);
    EXPECT_EQ(packed.channels[0].name, "gx");
    EXPECT_EQ(packed.channels[1].name, "gy");
    EXPECT_EQ(packed.channels[2].name, "distance");
    EXPECT_EQ(packed.channels[3].name, "shape");
    EXPECT_NEAR(std::stod(packed.attributes.at("relievo:tau")), 1.0 / 0.375, 0.01);
}

// Creases are in signed EXR files of outlines with corners, unless they are not wanted, and their
// steps are found safe.
TEST_F(Shape, CornersAreSharpWhereTheFileCanHoldThem) {
    const std::string square =
        svg("square.svg", "<rect x='9' y='8' width='20' height='21' transform='rotate(9)'/>");
    for (const std::string format : {"float", "half"}) {
        const std::string name = "sharp-" + format + ".exr";
        const ShapeMap sharp = baked(square, name, {"--format", format, "--size", "96x96"});
        EXPECT_TRUE(sharp.isCreased());
        const ProcessResult result = bake({"verify", folder.file(name), "--rays", "200000"});
        EXPECT_EQ(result.exitStatus, 0) << result.errors;
    }
    EXPECT_FALSE(baked(square, "round.exr", {"--corners", "round"}).isCreased());
    EXPECT_FALSE(baked(square, "unsigned.exr", {"--unsigned"}).isCreased());
    EXPECT_FALSE(baked(square, "packed.png").isCreased());
    EXPECT_FALSE(baked(write("disc.svg", kDisc), "disc.exr").isCreased());
    expectRefused({"shape", square, "-o", folder.file("a.png"), "--corners", "sharp"}, 2,
                  "--corners");
    expectRefused({"shape", square, "-o", folder.file("a.exr"), "--corners", "sharp", "--unsigned"},
                  2, "--corners");
}

TEST_F(Shape, ImagesOfEitherPolarityAndUnsigned) {
    Plane image(48, 32, 1.0f);  // white, with a black square
    for (int j = 10; j < 20; ++j)
        for (int i = 12; i < 30; ++i)
            image.at(i, j) = 0.0f;
    const std::string file = picture("square.png", image);
    const ShapeMap black = baked(file, "black.exr");
    EXPECT_NEAR(48.0 * black.distance.at(20, 12), -2.5, 1e-4);
    EXPECT_NEAR(48.0 * black.distance.at(20, 5), 4.5, 1e-4);
    const ShapeMap white = baked(file, "white.exr", {"--inside", "white"});
    for (std::size_t t = 0; t < white.distance.texels.size(); ++t)
        EXPECT_NEAR(white.distance.texels[t], -black.distance.texels[t], 1e-6);
    const ShapeMap thesis =
        baked(file, "thesis.png", {"--unsigned", "--gradient", "5", "--format", "u8"});
    EXPECT_FALSE(thesis.isSigned);
    EXPECT_EQ(thesis.distance.at(20, 12), 0.0f);
    EXPECT_NEAR(48.0 * thesis.distance.at(20, 5), 5.0, 48.0 * thesis.slack + 1e-4);
    EXPECT_EQ(bake({"verify", folder.file("thesis.png"), "--rays", "20000"}).exitStatus, 0);
}

TEST_F(Shape, TextHasItsFont) {
    ASSERT_TRUE(std::filesystem::exists(kFont)) << kFont << " is in scripts/debian_packages.txt";
    const ShapeMap map = baked(kFont + ":I I", "text.exr");
    EXPECT_EQ(map.width(), 512);
    const auto& row = map.distance;  // through two strokes with a space between them
    int strokes = 0;
    for (int i = 1; i < 512; ++i)
        strokes += row.at(i, 190) < 0.0f && row.at(i - 1, 190) >= 0.0f ? 1 : 0;
    EXPECT_EQ(strokes, 2);
    expectRefused({"shape", kFont + ":\xE4\xBD\xA0", "-o", folder.file("x.exr")}, 1, "no glyph");
    expectRefused({"shape", kFont + ":a\xFFz", "-o", folder.file("x.exr")}, 1, "UTF-8");
    expectRefused({"shape", kFont + ":", "-o", folder.file("x.exr")}, 1, "covers nothing");
    expectRefused({"shape", kFont + ": ", "-o", folder.file("x.exr")}, 1, "covers nothing");
}

TEST_F(Shape, OpenAndSelfIntersectingPathsFillAsSvgSays) {
    // Open: closed by a straight line. A figure of eight: both halves.
    const ShapeMap open = baked(svg("open.svg", "<path d='M10 10 H30 V30'/>"), "open.exr");
    EXPECT_LT(open.distance.at(512 * 25 / 40, 512 * 15 / 40), 0.0f);
    EXPECT_GT(open.distance.at(512 * 15 / 40, 512 * 25 / 40), 0.0f);
    const ShapeMap eight =
        baked(svg("eight.svg", "<path d='M5 5 L35 35 V5 L5 35 z'/>"), "eight.exr");
    EXPECT_LT(eight.distance.at(512 * 8 / 40, 256), 0.0f);
    EXPECT_LT(eight.distance.at(512 * 32 / 40, 256), 0.0f);
    EXPECT_GT(eight.distance.at(256, 512 * 8 / 40), 0.0f);
    for (const std::string name : {"open.exr", "eight.exr"})
        EXPECT_EQ(bake({"verify", folder.file(name), "--rays", "20000"}).exitStatus, 0);
}

TEST_F(Shape, EmptyAndFullShapesAreDefined) {
    const ShapeMap empty = baked(svg("empty.svg", ""), "empty.exr");
    EXPECT_NEAR(empty.distance.at(7, 7), 4.0 * std::sqrt(2.0), 1e-5);
    const ShapeMap full = baked(svg("full.svg", "<rect width='40' height='40'/>"), "full.exr");
    EXPECT_NEAR(full.distance.at(7, 7), -4.0 * std::sqrt(2.0), 1e-5);
    const ShapeMap none = baked(folder.file("full.svg"), "none.exr", {"--unsigned"});
    EXPECT_EQ(none.distance.at(7, 7), 0.0f);
    const ProcessResult result =
        bake({"shape", folder.file("empty.svg"), "-o", folder.file("empty.exr"), "--force"});
    EXPECT_THAT(result.errors, HasSubstr("note:"));
    for (const std::string name : {"empty.exr", "full.exr", "none.exr"})
        EXPECT_EQ(bake({"verify", folder.file(name), "--rays", "2000"}).exitStatus, 0);
}

TEST_F(Shape, UpToDateFilesAreLeftAlone) {
    const std::string disc = write("disc.svg", kDisc);
    baked(disc, "disc.exr", {"--size", "64x48"});
    const Words again{"shape", disc, "-o", folder.file("disc.exr"), "--size", "64x48"};
    EXPECT_THAT(bake(again).output, HasSubstr("up to date"));
    Words other = again;
    other.back() = "128x96";
    EXPECT_THAT(bake(other).output, testing::Not(HasSubstr("up to date")));
    for (const Words& option : {Words{"--force"}, Words{"--unsigned"}, Words{"--gradient", "3"},
                                Words{"--wrap", "clamp"}}) {
        Words changed = again;
        changed.insert(changed.end(), option.begin(), option.end());
        bake(again);
        EXPECT_THAT(bake(changed).output, testing::Not(HasSubstr("up to date"))) << option.front();
    }
}

TEST_F(Shape, TheSameBytesForAnyNumberOfThreads) {
    const std::string disc = write("disc.svg", kDisc);
    baked(disc, "one.exr", {"--threads", "1"});
    baked(disc, "two.exr", {"--threads", "2"});
    EXPECT_EQ(tests::readBytes(folder.file("one.exr")), tests::readBytes(folder.file("two.exr")));
}

TEST_F(Shape, AWrongFileIsFoundGuilty) {
    const std::string file = folder.file("disc.exr");
    baked(write("disc.svg", kDisc), "disc.exr", {"--size", "128x96"});
    textures::MapSet maps = textures::readMapFile(file);
    const auto change = [&](const std::string& channel, float factor) {
        textures::MapSet changed = maps;
        for (textures::Channel& each : changed.channels)
            if (each.name == channel)
                for (float& value : each.plane.texels)
                    value *= factor;
        textures::writeMapFile(folder.file("wrong.exr"), changed, textures::StorageFormat::Float);
    };
    change("distance", 1.1f);
    ProcessResult result = bake({"verify", folder.file("wrong.exr"), "--rays", "20000"});
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_THAT(result.output, HasSubstr("worst "));
    EXPECT_THAT(result.errors, HasSubstr("enter the solid"));
    change("distance", -1.0f);
    result = bake({"verify", folder.file("wrong.exr"), "--rays", "20000"});
    EXPECT_EQ(result.exitStatus, 1);
    EXPECT_THAT(result.errors, HasSubstr("contradict"));
    maps.attributes.erase("relievo:slack");
    textures::writeMapFile(folder.file("wrong.exr"), maps, textures::StorageFormat::Float);
    expectRefused({"verify", folder.file("wrong.exr")}, 1, "relievo:slack");
    expectRefused({"verify", file, "--cone-channel", "B"}, 2, "--cone-channel");
    EXPECT_THAT(bake({"info", file}).output, HasSubstr("relievo:tau"));
}

TEST_F(Shape, BadSources) {
    const std::string out = folder.file("out.exr");
    expectRefused({"shape", folder.file("missing.png"), "-o", out}, 1, "missing.png");
    expectRefused({"shape", folder.file("missing.svg"), "-o", out}, 1, "missing.svg");
    expectRefused({"shape", folder.file("missing.ttf") + ":A", "-o", out}, 1, "missing.ttf");
    expectRefused({"shape", write("empty.svg", ""), "-o", out}, 1, "empty.svg");
    expectRefused({"shape", write("broken.svg", "<svg"), "-o", out}, 1, "broken.svg");
    expectRefused({"shape", write("font.txt", "no font") + ":A", "-o", out}, 1, "font.txt");
    expectRefused({"shape", write("text.png", "no image"), "-o", out}, 1, "text.png");
    expectRefused({"shape", svg("path.svg", "<path d='M0 0 Q'/>"), "-o", out}, 1, "path.svg");
    expectRefused({"shape", svg("far.svg", "<path d='M0 0 L1e30 5 L7 7z'/>"), "-o", out}, 1,
                  "far.svg");
    Plane odd(5, 4, 0.5f);
    odd.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
    expectRefused({"shape", picture("nan.exr", odd), "-o", out}, 1, "nan.exr");
    expectRefused({"shape",
                   write("tall.svg",
                         "<svg xmlns='http://www.w3.org/2000/svg' "
                         "viewBox='0 0 1 1000'><rect width='1' height='9'/></svg>"),
                   "-o", out},
                  1, "tall.svg");
    const std::string disc = write("disc.svg", kDisc);
    expectRefused({"shape", disc, "-o", out, "--size", "512x512"}, 1, "512x384");
    expectRefused({"shape", disc, "-o", folder.file("missing/out.exr")}, 1, "missing/out.exr");
}

TEST_F(Shape, WrongUsage) {
    const std::string out = folder.file("out.exr");
    const std::string image = picture("image.png", Plane(8, 8, 0.5f));
    const std::string disc = write("disc.svg", kDisc);
    for (const Words& arguments :
         {Words{"shape"}, Words{"shape", image}, Words{"shape", image, "-o", image},
          Words{"shape", image, "-o", out, "--size", "16x16"},
          Words{"shape", disc, "-o", out, "--channel", "R"},
          Words{"shape", disc, "-o", out, "--size", "0x4"},
          Words{"shape", disc, "-o", out, "--size", "99999x99999"},
          Words{"shape", disc, "-o", out, "--gradient", "4"},
          Words{"shape", disc, "-o", out, "--inside", "red"},
          Words{"shape", disc, "-o", out, "--signed", "--unsigned"},
          Words{"shape", disc, "-o", out, "--format", "u8"},
          Words{"shape", disc, "-o", folder.file("out.jpg")}})
        expectRefused(arguments, 2, "");
}

}  // namespace
}  // namespace relievo::preprocess
