#include "gl/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "gl/context.h"

namespace relievo::gl {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class TextureTest : public ::testing::TestWithParam<bool> {
  protected:
    /// With and without the exceptions of a debug context: the checks must not rest on them.
    std::unique_ptr<Context> context_ = createContext(Backend::OSMesa, {.debug = GetParam()});
};

std::vector<float> rampOf(int count) {
    std::vector<float> values(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i) / 64.0f;
    return values;
}

std::vector<float> contentOf(const Texture& texture, GLenum format, int count, int level = 0) {
    std::vector<float> values(static_cast<std::size_t>(count));
    glGetTextureImage(texture.id(), level, format, GL_FLOAT,
                      static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
    return values;
}

TEST_P(TextureTest, HoldsWhatWasUploadedForEachChannelCount) {
    const GLenum storage[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    const GLenum format[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    for (int channels = 1; channels <= 4; ++channels) {
        const std::vector<float> texels = rampOf(5 * 3 * channels);
        Texture texture(5, 3, storage[channels - 1]);
        texture.upload(texels, channels);
        EXPECT_EQ(contentOf(texture, format[channels - 1], 5 * 3 * channels), texels);
    }
}

TEST_P(TextureTest, LayersAreApart) {
    Texture texture(2, 2, GL_R32F, 3);
    for (int layer = 0; layer < 3; ++layer)
        texture.upload(std::vector<float>(4, static_cast<float>(layer + 1)), 1, layer);
    EXPECT_EQ(contentOf(texture, GL_RED, 12),
              (std::vector<float>{1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3}));
    EXPECT_THROW(texture.upload(std::vector<float>(4), 1, 3), GlError);
    EXPECT_THROW(texture.upload(std::vector<float>(4), 1, -1), GlError);
}

TEST_P(TextureTest, LevelsHalveRoundingDown) {
    Texture texture(5, 3, GL_R32F, 0, 3);
    const int counts[] = {15, 2, 1};
    for (int level = 0; level < 3; ++level)
        texture.upload(std::vector<float>(static_cast<std::size_t>(counts[level]),
                                          static_cast<float>(level + 1)),
                       1, 0, level);
    for (int level = 0; level < 3; ++level)
        EXPECT_THAT(contentOf(texture, GL_RED, counts[level], level),
                    testing::Each(static_cast<float>(level + 1)));
    EXPECT_THROW(texture.upload(std::vector<float>(3), 1, 0, 1), GlError);
    EXPECT_THROW(texture.upload(std::vector<float>(1), 1, 0, 3), GlError);
    EXPECT_THROW(texture.upload(std::vector<float>(1), 1, 0, -1), GlError);
}

TEST_P(TextureTest, WrongUploadsAreErrorsWithTheNumbers) {
    Texture texture(5, 3, GL_R32F);
    EXPECT_THAT([&] { texture.upload(rampOf(14), 1); },
                ThrowsMessage<GlError>(HasSubstr("takes 15 values, not 14")));
    EXPECT_THROW(texture.upload(rampOf(16), 1), GlError);
    EXPECT_THROW(texture.upload({}, 1), GlError);
    EXPECT_THROW(texture.upload({}, 0), GlError);
    EXPECT_THROW(texture.upload(rampOf(75), 5), GlError);
    EXPECT_THROW(texture.upload(rampOf(15), 1, 1), GlError);
    EXPECT_THROW(texture.upload(rampOf(2), 1, 0, 1), GlError);
}

TEST_P(TextureTest, RefusedSizesAndFormatsAreErrors) {
    EXPECT_THROW(Texture(0, 1, GL_R32F), GlError);
    EXPECT_THROW(Texture(1, -1, GL_R32F), GlError);
    EXPECT_THROW(Texture(1 << 20, 1, GL_R32F), GlError);
    EXPECT_THROW(Texture(1, 1, GL_R32F, 1 << 20), GlError);
    EXPECT_THROW(Texture(1, 1, GL_R32F, -1), GlError);
    EXPECT_THROW(Texture(4, 4, GL_R32F, 0, 4), GlError);  // a chain of 3 levels ends at 1 x 1
    EXPECT_THROW(Texture(4, 4, GL_R32F, 0, 0), GlError);
    EXPECT_THROW(Texture(4, 4, 0x1234), GlError);
}

INSTANTIATE_TEST_SUITE_P(Debug, TextureTest, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "On" : "Off"; });

}  // namespace
}  // namespace relievo::gl
