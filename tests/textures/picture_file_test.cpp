#include "textures/picture_file.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>

#include "random_planes.h"
#include "temporary_folder.h"

namespace relievo::textures {
namespace {

using testing::HasSubstr;

class PictureFile : public TemporaryFolder {};

std::vector<Plane> randomPicture(std::size_t channels) {
    std::vector<Plane> planes;
    for (std::size_t c = 0; c < channels; ++c)
        planes.push_back(randomPlane(21, 9, 0.0f, 1.0f, static_cast<std::uint32_t>(c + 1)));
    return planes;
}

TEST_F(PictureFile, ReadsBackWhatWasRounded) {
    for (const std::size_t channels : {1u, 3u, 4u})
        for (const char* name : {"a.png", "a.tif"})
            for (const auto& [format, maximum] :
                 {std::pair{StorageFormat::U8, 255.0}, {StorageFormat::U16, 65535.0}}) {
                const std::vector<Plane> planes = randomPicture(channels);
                writePicture(file(name), planes, format);
                const std::vector<Plane> read = readPicture(file(name));
                ASSERT_EQ(read.size(), channels);
                for (std::size_t c = 0; c < channels; ++c)
                    for (std::size_t t = 0; t < planes[c].texels.size(); ++t)
                        EXPECT_NEAR(read[c].texels[t], planes[c].texels[t], 0.51 / maximum);
            }
}

TEST_F(PictureFile, FloatsAreExactAndUnbounded) {
    std::vector<Plane> planes = randomPicture(3);
    planes[1].texels[4] = -7.25f;
    writePicture(file("a.exr"), planes, StorageFormat::Float);
    const std::vector<Plane> read = readPicture(file("a.exr"));
    ASSERT_EQ(read.size(), 3u);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(read[c].texels, planes[c].texels);
}

TEST_F(PictureFile, ValuesOutsideTheRangeAreClamped) {
    writePicture(file("a.png"),
                 std::array{Plane(1, 1, -3.0f), Plane(1, 1, 2.0f), Plane(1, 1, 0.4f)},
                 StorageFormat::U8);
    const std::vector<Plane> read = readPicture(file("a.png"));
    EXPECT_EQ(read[0].texels[0], 0.0f);
    EXPECT_EQ(read[1].texels[0], 1.0f);
    EXPECT_EQ(read[2].texels[0], 0.4f);
}

TEST_F(PictureFile, TheExtensionMustFit) {
    EXPECT_THAT(errorOf([&] { writePicture(file("a.jpg"), randomPicture(1), StorageFormat::U8); }),
                HasSubstr("a.jpg: cannot hold the format u8"));
}

}  // namespace
}  // namespace relievo::textures
