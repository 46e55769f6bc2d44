#include "textures/height_image.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "random_planes.h"
#include "temporary_folder.h"
#include "textures/image_writer.h"

namespace relievo::textures {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class HeightImageTest : public TemporaryFolder {
  protected:
    std::filesystem::path writeFile(const char* name, std::vector<Plane> planes,
                                    StorageFormat format,
                                    std::vector<std::string> channelNames = {}) {
        ImageContent content;
        content.planes = std::move(planes);
        content.format = format;
        content.channelNames = std::move(channelNames);
        writeImage(file(name), content);
        return file(name);
    }

    /// Reads as depth, so that the values are those of the file, and collects the notices.
    Plane read(const std::filesystem::path& path, const std::string& channel = "") {
        notices_.clear();
        HeightImageOptions options;
        options.isDepth = true;
        options.channel = channel;
        options.notice = [this](const std::string& notice) { notices_.push_back(notice); };
        return readHeightImage(path, options).depth.depth;
    }

    std::vector<std::string> notices_;
};

Plane codes(int width, int height, float maximum, std::uint32_t seed) {
    Plane plane = randomPlane(width, height, 0.0f, maximum + 1.0f, seed);
    for (float& value : plane.texels)
        value = std::min(std::floor(value), maximum);
    plane.texels.front() = maximum;
    return plane;
}

TEST_F(HeightImageTest, IntegersAreDividedByTheirMaximum) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{1, 7}, std::array{37, 13}})
        for (const char* name : {"a.png", "a.tif"})
            for (const auto& [format, maximum] :
                 {std::pair{StorageFormat::U8, 255.0f}, {StorageFormat::U16, 65535.0f}}) {
                const Plane stored = codes(width, height, maximum, 3);
                const Plane depth = read(writeFile(name, {stored}, format));
                ASSERT_EQ(depth.width, width);
                ASSERT_EQ(depth.height, height);
                for (std::size_t t = 0; t < stored.texels.size(); ++t)
                    EXPECT_EQ(depth.texels[t],
                              static_cast<float>(stored.texels[t] / static_cast<double>(maximum)));
            }
}

TEST_F(HeightImageTest, FloatsAreTakenAsTheyAre) {
    const Plane values = randomPlane(19, 5, 0.0f, 1.0f, 8);
    EXPECT_EQ(read(writeFile("a.exr", {values}, StorageFormat::Float)).texels, values.texels);
    const Plane halves = storedValues(values, "depth", StorageFormat::Half);
    EXPECT_EQ(read(writeFile("b.exr", {halves}, StorageFormat::Half)).texels, halves.texels);
}

TEST_F(HeightImageTest, HeightIsOneMinusDepth) {
    const std::filesystem::path path =
        writeFile("a.exr", {randomPlane(6, 6, 0.0f, 1.0f, 1)}, StorageFormat::Float);
    HeightImageOptions options;
    options.wrap = WrapMode::Clamp;
    const HeightImage asHeight = readHeightImage(path, options);
    options.isDepth = true;
    const HeightImage asDepth = readHeightImage(path, options);
    EXPECT_EQ(asHeight.depth.wrap, WrapMode::Clamp);
    for (std::size_t t = 0; t < asDepth.depth.depth.texels.size(); ++t)
        EXPECT_EQ(asHeight.depth.depth.texels[t], 1.0f - asDepth.depth.depth.texels[t]);
    EXPECT_NE(asHeight.source, asDepth.source);
}

TEST_F(HeightImageTest, TexelZeroIsAtTheTopLeft) {
    // Through OpenImageIO itself, whose first scanline is the top one, as every viewer shows it.
    for (const char* name : {"a.png", "a.tif", "a.bmp", "a.tga", "a.pgm"}) {
        const auto output = OIIO::ImageOutput::create(file(name).string());
        ASSERT_TRUE(output);
        ASSERT_TRUE(output->open(file(name).string(), {3, 2, 1, OIIO::TypeDesc::UINT8}));
        const std::array<std::uint8_t, 6> pixels{255, 0, 0, 0, 0, 51};
        ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
        const Plane depth = read(file(name));
        EXPECT_EQ(depth.at(0, 0), 1.0f) << name;
        EXPECT_EQ(depth.at(2, 0), 0.0f) << name;
        EXPECT_EQ(depth.at(0, 1), 0.0f) << name;
        EXPECT_EQ(depth.at(2, 1), 0.2f) << name;
    }
}

TEST_F(HeightImageTest, ThePgmOfATextEditorReadsTopDown) {
    writeBytes(file("a.pgm"), "P2\n2 2\n255\n255 0\n0 51\n");
    EXPECT_EQ(read(file("a.pgm")).texels, (std::vector{1.0f, 0.0f, 0.0f, 0.2f}));
}

TEST_F(HeightImageTest, EqualColoursAreTakenSilently) {
    const Plane grey = codes(9, 9, 255.0f, 2);
    const Plane alpha = codes(9, 9, 255.0f, 3);
    for (const char* name : {"a.png", "a.tif"}) {
        const Plane alone = read(writeFile(name, {grey}, StorageFormat::U8));
        EXPECT_EQ(read(writeFile(name, {grey, grey, grey}, StorageFormat::U8)).texels,
                  alone.texels);
        EXPECT_EQ(read(writeFile(name, {grey, grey, grey, alpha}, StorageFormat::U8)).texels,
                  alone.texels);
        EXPECT_TRUE(notices_.empty());
    }
}

TEST_F(HeightImageTest, AlphaIsUsedOnlyWhenAskedFor) {
    const Plane grey = codes(9, 9, 255.0f, 2), alpha = codes(9, 9, 255.0f, 3);
    const auto path = writeFile("a.png", {grey, alpha}, StorageFormat::U8);
    const Plane alone = read(writeFile("b.png", {grey}, StorageFormat::U8));
    EXPECT_EQ(read(path).texels, alone.texels);
    EXPECT_TRUE(notices_.empty());
    const Plane transparency = read(writeFile("c.png", {alpha}, StorageFormat::U8));
    EXPECT_EQ(read(path, "A").texels, transparency.texels);
    EXPECT_EQ(read(path, "1").texels, transparency.texels);
}

TEST_F(HeightImageTest, UnequalColoursGiveTheirLuminanceWithANotice) {
    const Plane red(2, 2, 1.0f), green(2, 2, 0.5f), blue(2, 2, 0.25f);
    const auto path = writeFile("a.exr", {red, green, blue}, StorageFormat::Float, {"R", "G", "B"});
    EXPECT_FLOAT_EQ(read(path).texels[0], 0.2126f + 0.7152f * 0.5f + 0.0722f * 0.25f);
    EXPECT_THAT(notices_, ElementsAre(HasSubstr("Rec. 709 luminance")));
    EXPECT_EQ(read(path, "G").texels, green.texels);
    EXPECT_TRUE(notices_.empty());
}

TEST_F(HeightImageTest, ChannelsAreFoundByNameWhateverTheirOrder) {
    const Plane first(2, 2, 0.25f), second(2, 2, 0.5f), third(2, 2, 0.75f);
    const auto path =
        writeFile("a.exr", {first, second, third}, StorageFormat::Half, {"wear", "Y", "bump"});
    EXPECT_EQ(read(path).texels, second.texels) << "Y comes before anything else";
    EXPECT_EQ(read(path, "wear").texels, first.texels);
    EXPECT_EQ(read(path, "bump").texels, third.texels);
}

TEST_F(HeightImageTest, TheChannelMustBeThereAndClear) {
    const auto path =
        writeFile("a.exr", {Plane(2, 2), Plane(2, 2)}, StorageFormat::Half, {"p", "q"});
    EXPECT_THAT(errorOf([&] { read(path, "r"); }),
                HasSubstr("a.exr: has no channel 'r', expected one of p, q (or 0 to 1)"));
    EXPECT_THAT(errorOf([&] { read(path, "2"); }), HasSubstr("no channel '2'"));
    EXPECT_THAT(errorOf([&] { read(path, "-1"); }), HasSubstr("no channel '-1'"));
    EXPECT_THAT(errorOf([&] { read(path); }), HasSubstr("has the channels p, q, expected Y"));
}

TEST_F(HeightImageTest, TheSourceIsThatOfTheContent) {
    const Plane values = codes(12, 8, 255.0f, 5);
    const auto sourceOf = [&](const std::filesystem::path& path) {
        return readHeightImage(path, {}).source;
    };
    const std::string png = sourceOf(writeFile("a.png", {values}, StorageFormat::U8));
    EXPECT_EQ(png.size(), 16u);
    EXPECT_EQ(sourceOf(writeFile("a.tif", {values}, StorageFormat::U8)), png);
    Plane wide = values;
    for (float& value : wide.texels)
        value *= 257.0f;
    EXPECT_EQ(sourceOf(writeFile("b.png", {wide}, StorageFormat::U16)), png);
    wide.texels[7] += 1.0f;
    EXPECT_NE(sourceOf(writeFile("b.png", {wide}, StorageFormat::U16)), png);
    Plane turned = values;
    std::swap(turned.width, turned.height);
    EXPECT_NE(sourceOf(writeFile("c.png", {turned}, StorageFormat::U8)), png);
}

TEST_F(HeightImageTest, ATurnedPhotographIsNoticed) {
    const auto output = OIIO::ImageOutput::create(file("a.tif").string());
    OIIO::ImageSpec spec(3, 2, 1, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", 6);
    ASSERT_TRUE(output->open(file("a.tif").string(), spec));
    const std::array<std::uint8_t, 6> pixels{};
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
    EXPECT_EQ(read(file("a.tif")).width, 3);
    EXPECT_THAT(notices_, ElementsAre(HasSubstr("orientation 6")));
}

}  // namespace
}  // namespace relievo::textures
