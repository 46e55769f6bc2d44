#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "random_planes.h"
#include "temporary_folder.h"
#include "textures/height_image.h"
#include "textures/image_writer.h"
#include "textures/map_file.h"
#include "textures/picture_file.h"

namespace relievo::textures {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class BadImage : public TemporaryFolder {
  protected:
    /// What readHeightImage says about the file: one line that begins with its name.
    std::string complaint(const std::filesystem::path& path) {
        const std::string message = errorOf([&] { readHeightImage(path, {}); });
        EXPECT_THAT(message, AllOf(StartsWith(path.string() + ": "), Not(HasSubstr("\n"))));
        return message;
    }
    std::string complaintAbout(const char* name, const std::string& bytes) {
        writeBytes(file(name), bytes);
        return complaint(file(name));
    }
    std::string complaintAboutFloats(Plane values) {
        ImageContent content;
        content.planes = {std::move(values)};
        content.format = StorageFormat::Float;
        writeImage(file("a.exr"), content);
        return complaint(file("a.exr"));
    }
};

TEST_F(BadImage, NoFileOrNoImage) {
    EXPECT_THAT(complaint(file("none.png")), HasSubstr("no such file"));
    EXPECT_THAT(complaint(folder()), HasSubstr("is a folder"));
    EXPECT_THAT(complaint("/dev/null"), HasSubstr("is no regular file"));
    EXPECT_THAT(complaintAbout("a.png", ""), HasSubstr("is empty (0 bytes)"));
    EXPECT_THAT(complaintAbout("a.png", "What is written here is no image at all."),
                HasSubstr("is not an image that can be read"));
    EXPECT_THAT(complaintAbout("a.txt", std::string(5000, '\x7F')),
                HasSubstr("is not an image that can be read"));
}

TEST_F(BadImage, SizesThatCannotBe) {
    complaintAbout("a.pgm", "P5\n0 0\n255\n");
    EXPECT_THAT(complaintAbout("a.pgm", "P5\n40000 1\n255\n" + std::string(40000, 'x')),
                HasSubstr("is 40000 x 1 texels, expected at most 32768 per side"));
    EXPECT_THAT(complaintAbout("a.ppm", "P6\n32000 32000\n255\nxyz"),
                HasSubstr("takes 11719 MiB when decoded (32000 x 32000 texels, 3 channels)"));
}

TEST_F(BadImage, ValuesThatAreNoDepths) {
    Plane values(5, 4, 0.5f);
    values.at(3, 2) = std::numeric_limits<float>::quiet_NaN();
    values.at(1, 3) = std::numeric_limits<float>::infinity();
    EXPECT_THAT(complaintAboutFloats(values),
                HasSubstr("has 2 values that are NaN or infinite (the first at texel 3,2)"));
    values = Plane(5, 4, 0.5f);
    values.at(0, 0) = -0.25f;
    values.at(4, 3) = 3.5f;
    EXPECT_THAT(complaintAboutFloats(values),
                HasSubstr("has values from -0.25 to 3.5, expected 0 to 1: normalise it to [0,1]"));
}

TEST_F(BadImage, EveryTruncationIsNoticed) {
    const Plane noise = randomPlane(67, 41, 0.0f, 255.0f, 6);
    std::vector<float> pixels;
    for (const float value : noise.texels)
        pixels.push_back(value / 255.0f);
    for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg", "a.bmp", "a.pgm"}) {
        const auto output = OIIO::ImageOutput::create(file(name).string());
        ASSERT_TRUE(output) << name;
        const bool isExr = std::string(name) == "a.exr";
        const OIIO::ImageSpec spec(67, 41, 1,
                                   isExr ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        ASSERT_TRUE(output->open(file(name).string(), spec) &&
                    output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
        EXPECT_NO_THROW(readHeightImage(file(name), {})) << name;
        const std::string whole = readBytes(file(name));
        for (int percent = 1; percent < 100; percent += 7) {
            writeBytes(file(name), whole.substr(0, whole.size() * percent / 100));
            EXPECT_THROW(readHeightImage(file(name), {}), InputError) << name << " " << percent;
        }
        writeBytes(file(name), whole.substr(0, whole.size() - 1));
        EXPECT_THROW(readHeightImage(file(name), {}), InputError) << name << " less one byte";
    }
}

TEST_F(BadImage, OurOwnTiffPicturesNoticeATruncation) {
    const std::array height{randomPlane(64, 64, 0.0f, 1.0f, 6)};
    writePicture(file("a.tif"), height, StorageFormat::U16);
    const std::string whole = readBytes(file("a.tif"));
    for (int percent = 1; percent < 100; percent += 7) {
        writeBytes(file("a.tif"), whole.substr(0, whole.size() * percent / 100));
        EXPECT_THROW(readHeightImage(file("a.tif"), {}), InputError) << percent;
    }
}

// The library would take the memory first and find out later.
TEST_F(BadImage, ExrHeadersThatClaimTooMuch) {
    ImageContent content;
    content.planes = {Plane(3, 2)};
    content.format = StorageFormat::Float;
    content.attributes = {{"relievo:kind", "relief"}};
    writeImage(file("whole.exr"), content);
    const std::string whole = readBytes(file("whole.exr"));
    const auto withBytes = [&](const std::string& before, std::size_t skip,
                               const std::string& bytes) {
        std::string damaged = whole;
        const std::size_t place = whole.find(before);
        EXPECT_NE(place, std::string::npos);
        return complaintAbout("a.exr",
                              damaged.replace(place + before.size() + skip, bytes.size(), bytes));
    };
    EXPECT_THAT(withBytes("relievo:kind", 8, "\xFF\xFF\xFF\x7F"), HasSubstr("in its header"));
    EXPECT_THAT(withBytes("dataWindow", 7 + 4 + 8, "\xFF\xFF\xFF\x7F"),
                HasSubstr("claims more texels than 32768 per side"));
    EXPECT_THAT(complaintAbout("a.exr", whole.substr(0, 100)), HasSubstr("a.exr: is truncated"));
    writeBytes(file("a.exr"), whole);
    EXPECT_NO_THROW(readHeightImage(file("a.exr"), {}));
}

TEST_F(BadImage, APreviewInTheHeaderDoesNotHideATruncatedJpeg) {
    const std::string preview = "\xFF\xDA data \xFF\xD9";
    const std::string start = "\xFF\xD8\xFF\xE1" + preview + "\xFF\xDA";
    EXPECT_THAT(complaintAbout("a.jpg", start + " half of the d"), HasSubstr("is truncated"));
}

TEST_F(BadImage, PartOfAPictureIsNotTakenForTheTile) {
    const auto output = OIIO::ImageOutput::create(file("a.exr").string());
    OIIO::ImageSpec spec(4, 4, 1, OIIO::TypeDesc::FLOAT);
    spec.full_width = 8;
    spec.full_height = 8;
    const std::array<float, 16> pixels{};
    ASSERT_TRUE(output->open(file("a.exr").string(), spec) &&
                output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close());
    EXPECT_THAT(complaint(file("a.exr")), HasSubstr("holds 4 x 4 texels of a picture of 8 x 8"));
}

TEST_F(BadImage, MapFilesAreCheckedLikeImages) {
    EXPECT_THAT(errorOf([&] { readMapFile(file("none.exr")); }), HasSubstr("no such file"));
    writeBytes(file("a.png"), "P5 1 1 255 x");
    EXPECT_THAT(errorOf([&] { readMapFile(file("a.png")); }), HasSubstr("a.png: "));
    ImageContent picture;
    picture.planes = {Plane(2, 2)};
    writeImage(file("b.png"), picture);
    EXPECT_THAT(errorOf([&] { readMapFile(file("b.png")); }),
                HasSubstr("lacks the attribute 'relievo:kind', expected a map file"));
}

}  // namespace
}  // namespace relievo::textures
