#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "full_screen_pass.h"
#include "gl/buffer.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace relievo::gl {
namespace {

constexpr std::array<GLenum, 1> kFloatColor = {GL_RGBA32F};

class OwnershipTest : public ::testing::Test {
  protected:
    std::unique_ptr<Context> context_ = createContext(Backend::OSMesa, {.debug = true});
};

/// Moves a into new homes and checks by `exists` that each object lives as long as its last owner.
template <typename Object>
void checkMoves(const std::function<Object()>& make,
                const std::function<GLboolean(GLuint)>& exists) {
    static_assert(!std::is_copy_constructible_v<Object> && !std::is_copy_assignable_v<Object>);
    static_assert(std::is_nothrow_move_constructible_v<Object> &&
                  std::is_nothrow_move_assignable_v<Object>);
    GLuint first = 0;
    GLuint second = 0;
    {
        Object source = make();
        first = source.id();
        Object target(std::move(source));
        EXPECT_EQ(source.id(), 0u);  // NOLINT: what a moved-from object holds is promised
        EXPECT_EQ(target.id(), first);
        EXPECT_TRUE(exists(first));

        Object other = make();
        second = other.id();
        ASSERT_NE(first, second);
        target = std::move(other);
        EXPECT_EQ(target.id(), second);
        EXPECT_EQ(other.id(), 0u);  // NOLINT
        EXPECT_FALSE(exists(first));

        Object& same = target;
        target = std::move(same);
        EXPECT_EQ(target.id(), second);
        EXPECT_TRUE(exists(second));
    }
    EXPECT_FALSE(exists(second));
    const Object empty;
    EXPECT_EQ(empty.id(), 0u);
}

TEST_F(OwnershipTest, ObjectsLiveAsLongAsTheirLastOwner) {
    checkMoves<Texture>([] { return Texture(2, 2, GL_R32F); },
                        [](GLuint id) { return glIsTexture(id); });
    checkMoves<Framebuffer>([] { return Framebuffer(2, 2, kFloatColor); },
                            [](GLuint id) { return glIsFramebuffer(id); });
    checkMoves<Buffer>([] { return Buffer(std::as_bytes(std::span("abc"))); },
                       [](GLuint id) { return glIsBuffer(id); });
    checkMoves<Program>(
        [] {
            return tests::fullScreenProgram(
                "#version 450 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
        },
        [](GLuint id) { return glIsProgram(id); });
}

TEST_F(OwnershipTest, NothingIsLeftOfAnObjectThatCouldNotBeMade) {
    EXPECT_THROW(Texture(4, 4, 0x1234), GlError);
    EXPECT_THROW(Framebuffer(4, 4, std::array<GLenum, 1>{GL_RGB9_E5}), GlError);
    EXPECT_THROW(tests::fullScreenProgram("no GLSL"), GlError);
    int left = 0;
    for (GLuint id = 1; id < 1000; ++id)
        left += glIsTexture(id) + glIsFramebuffer(id) + glIsShader(id) + glIsProgram(id);
    EXPECT_EQ(left, 0);
}

TEST_F(OwnershipTest, BufferHoldsACopyOfItsBytes) {
    std::vector<std::uint32_t> values = {1, 2, 3};
    const Buffer buffer(std::as_bytes(std::span(values)));
    EXPECT_EQ(buffer.size(), 12u);
    values.assign(3, 0);
    glGetNamedBufferSubData(buffer.id(), 0, 12, values.data());
    EXPECT_EQ(values, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_THROW(Buffer(std::span<const std::byte>{}), GlError);
}

TEST_F(OwnershipTest, VertexArrayReadsInterleavedAttributesByIndex) {
    // Position and colour, with a gap of one float before each vertex; the first vertex is a decoy.
    const std::vector<float> vertices = {9, 0,  0,  0, 0,   0,  //
                                         9, -1, -1, 1, 0.5, 0,  //
                                         9, 3,  -1, 1, 0.5, 0,  //
                                         9, -1, 3,  1, 0.5, 0};
    const std::vector<std::uint32_t> order = {1, 2, 3};
    const Buffer vertexBuffer(std::as_bytes(std::span(vertices)));
    const Buffer indexBuffer(std::as_bytes(std::span(order)));
    VertexArray moved;
    moved.attribute(0, vertexBuffer, 2, 6 * sizeof(float), 1 * sizeof(float));
    moved.attribute(1, vertexBuffer, 3, 6 * sizeof(float), 3 * sizeof(float));
    moved.indices(indexBuffer);
    const VertexArray vertexArray(std::move(moved));

    const Program program({{GL_VERTEX_SHADER,
                            "#version 450 core\nlayout(location = 0) in vec2 position;\n"
                            "layout(location = 1) in vec3 tint;\nout vec3 passed;\n"
                            "void main() { passed = tint; gl_Position = vec4(position, 0, 1); }\n",
                            {}},
                           {GL_FRAGMENT_SHADER,
                            "#version 450 core\nin vec3 passed;\nout vec4 color;\n"
                            "void main() { color = vec4(passed, 1.0); }\n",
                            {}}});
    Framebuffer target(2, 1, kFloatColor);
    target.clearColor(0, 0, 0, 0, 0);
    target.bind();
    program.use();
    vertexArray.bind();
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, nullptr);
    EXPECT_EQ(target.read(0), (std::vector<float>{1, 0.5f, 0, 1, 1, 0.5f, 0, 1}));
}

}  // namespace
}  // namespace relievo::gl
