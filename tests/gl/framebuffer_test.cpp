#include "gl/framebuffer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "full_screen_pass.h"
#include "gl/context.h"
#include "gl/texture.h"

namespace relievo::gl {
namespace {

using ::testing::Each;
using ::testing::FloatEq;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::array<GLenum, 1> kFloatColor = {GL_RGBA32F};

class FramebufferTest : public ::testing::Test {
  protected:
    std::unique_ptr<Context> context_ = createContext(Backend::OSMesa, {.debug = true});
};

/// Draws a texture over a framebuffer of its size, (0,0) at `origin` of the picture's uv, and
/// returns the red channel from the top.
std::vector<float> redOfDrawn(const Texture& texture, const std::string& uv) {
    const Framebuffer target(texture.width(), texture.height(), kFloatColor);
    Program program = tests::fullScreenProgram(R"(#version 450 core
in vec2 uv;
out vec4 color;
uniform sampler2D picture;
void main() { color = texture(picture, )" + uv +
                                               R"(); }
)");
    program.set("picture", 3);
    texture.bind(3);
    tests::drawFullScreen(program, target);
    const std::vector<float> pixels = target.read(0);
    std::vector<float> red;
    for (std::size_t i = 0; i < pixels.size(); i += 4)
        red.push_back(pixels[i]);
    return red;
}

TEST_F(FramebufferTest, FirstTexelUploadedIsTheFirstPixelRead) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {5, 3}, {4, 4}}) {
        std::vector<float> picture(static_cast<std::size_t>(width * height));
        for (std::size_t i = 0; i < picture.size(); ++i)
            picture[i] = static_cast<float>(i + 1);
        Texture texture(width, height, GL_R32F);
        texture.upload(picture, 1);
        EXPECT_EQ(redOfDrawn(texture, "uv"), picture);
        // Upside down must not pass where there is more than one row.
        EXPECT_EQ(redOfDrawn(texture, "vec2(uv.x, 1.0 - uv.y)") == picture, height == 1);
    }
}

TEST_F(FramebufferTest, ClearsEachAttachmentByItself) {
    constexpr std::array<GLenum, 2> kFormats = {GL_RGBA32F, GL_RGBA8};
    Framebuffer target(3, 2, kFormats);
    target.clearColor(0, 0.25f, 0.5f, -7.0f, 1e6f);
    target.clearColor(1, 1.0f, 1.0f, 1.0f, 1.0f);
    target.clearDepth(0.375f);
    const std::vector<float> first = target.read(0);
    ASSERT_EQ(first.size(), 24u);
    EXPECT_EQ(std::vector<float>(first.begin() + 20, first.end()),
              (std::vector<float>{0.25f, 0.5f, -7.0f, 1e6f}));
    EXPECT_THAT(target.read(1), Each(FloatEq(1.0f)));
    const std::vector<float> depth = target.readDepth();
    EXPECT_EQ(depth.size(), 6u);
    EXPECT_THAT(depth, Each(FloatEq(0.375f)));
    EXPECT_THROW(target.clearColor(2, 0, 0, 0, 0), std::out_of_range);
    EXPECT_THROW(static_cast<void>(target.read(-1)), std::out_of_range);
}

TEST_F(FramebufferTest, DepthsAreReadFromTheTop) {
    Framebuffer target(4, 3, kFloatColor);
    target.clearDepth();
    glEnable(GL_DEPTH_TEST);
    tests::drawFullScreen(tests::fullScreenProgram(R"(#version 450 core
in vec2 uv;
out vec4 color;
void main() { color = vec4(0.0); gl_FragDepth = 0.5 * uv.y + 0.125 * uv.x; }
)"),
                          target);
    const std::vector<float> depth = target.readDepth();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            EXPECT_NEAR(depth[row * 4 + column], 0.5 * (row + 0.5) / 3 + 0.125 * (column + 0.5) / 4,
                        1e-6);
}

TEST_F(FramebufferTest, IncompleteIsAnErrorWithTheReason) {
    constexpr std::array<GLenum, 1> kNotDrawable = {GL_RGB9_E5};
    EXPECT_THAT([&] { Framebuffer(4, 4, kNotDrawable); },
                ThrowsMessage<GlError>(HasSubstr("4 x 4 with the formats 0x8c3d")));
    EXPECT_THAT([&] { Framebuffer(0, 4, kFloatColor); },
                ThrowsMessage<GlError>(HasSubstr("0 x 4")));
}

}  // namespace
}  // namespace relievo::gl
