#include "gl/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "full_screen_pass.h"
#include "gl/context.h"
#include "gl/framebuffer.h"

namespace relievo::gl {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

class ProgramTest : public ::testing::Test {
  protected:
    std::unique_ptr<Context> context_ = createContext(Backend::OSMesa, {.debug = true});
};

/// The colour that a fragment shader writes.
std::vector<float> drawnColor(const Program& program) {
    constexpr std::array<GLenum, 1> kFormats = {GL_RGBA32F};
    const Framebuffer target(1, 1, kFormats);
    tests::drawFullScreen(program, target);
    return target.read(0);
}

constexpr const char* kEveryType = R"(#version 450 core
out vec4 color;
uniform int anInt;
uniform float aFloat;
uniform bool aBool;
uniform ivec2 anIvec2;
uniform vec2 aVec2;
uniform vec3 aVec3;
uniform vec4 aVec4;
uniform mat3 aMat3;
uniform mat4 aMat4;
uniform float array[3];
uniform struct { vec2 inner; } record;
uniform uint anUint;
uniform sampler2D aSampler;
uniform int which;
void main() {
    color = vec4(-1.0);
    switch (which) {
        case 0: color = vec4(anInt, aFloat, aBool, 0.0); break;
        case 1: color = vec4(anIvec2, aVec2); break;
        case 2: color = vec4(aVec3, 0.0); break;
        case 3: color = aVec4; break;
        case 4: color = vec4(aMat3[0][0], aMat3[0][2], aMat3[2][0], aMat3[2][2]); break;
        case 5: color = vec4(aMat4[0][0], aMat4[0][3], aMat4[3][0], aMat4[3][3]); break;
        case 6: color = vec4(array[0], array[1], array[2], record.inner.y); break;
        case 7: color = vec4(anUint) + texture(aSampler, vec2(0.0)); break;
    }
}
)";

TEST_F(ProgramTest, EveryTypeOfUniformArrives) {
    Program program = tests::fullScreenProgram(kEveryType);
    program.set("anInt", -3);
    program.set("aFloat", 0.1f);
    program.set("aBool", 1);
    program.set("anIvec2", glm::ivec2(4, -5));
    program.set("aVec2", glm::vec2(0.25f, 0.5f));
    program.set("aVec3", glm::vec3(1.0f, 2.0f, 3.0f));
    program.set("aVec4", glm::vec4(4.0f, 5.0f, 6.0f, 7.0f));
    // Columns first, as glm and GLSL have it: [0][2] is the lower left element.
    program.set("aMat3", glm::mat3(1, 2, 3, 4, 5, 6, 7, 8, 9));
    program.set("aMat4", glm::mat4(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16));
    program.set("array", 0.5f);
    program.set("array[1]", 1.5f);
    program.set("array[2]", 2.5f);
    program.set("record.inner", glm::vec2(8.0f, 9.0f));

    const std::vector<std::vector<float>> expected = {
        {-3.0f, 0.1f, 1.0f, 0.0f}, {4.0f, -5.0f, 0.25f, 0.5f}, {1.0f, 2.0f, 3.0f, 0.0f},
        {4.0f, 5.0f, 6.0f, 7.0f},  {1.0f, 3.0f, 7.0f, 9.0f},   {1.0f, 4.0f, 13.0f, 16.0f},
        {0.5f, 1.5f, 2.5f, 9.0f}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        program.set("which", static_cast<int>(i));
        EXPECT_EQ(drawnColor(program), expected[i]) << "group " << i;
    }
}

TEST_F(ProgramTest, MissingUniformIsAnErrorThatListsTheOthers) {
    Program program = tests::fullScreenProgram(R"(#version 450 core
out vec4 color;
uniform float depthScale;
uniform vec2 tiles;
uniform float unused;
void main() { color = vec4(depthScale, tiles, 1.0); }
)");
    EXPECT_THAT([&] { program.set("depthscale", 0.1f); },
                ThrowsMessage<GlError>(AllOf(HasSubstr("'depthscale'"), HasSubstr("depthScale"),
                                             HasSubstr("tiles"), Not(HasSubstr("unused")))));
    EXPECT_THROW(program.set("unused", 0.1f), GlError);
    EXPECT_TRUE(program.hasUniform("depthScale"));
    EXPECT_FALSE(program.hasUniform("unused"));
    EXPECT_FALSE(program.hasUniform(""));
    EXPECT_NO_THROW(program.set("depthScale", 0.1f));
}

TEST_F(ProgramTest, UniformOfAnotherTypeIsAnError) {
    Program program = tests::fullScreenProgram(kEveryType);
    EXPECT_THAT(
        [&] { program.set("aFloat", 1); },
        ThrowsMessage<GlError>(AllOf(HasSubstr("'aFloat'"), HasSubstr("float"), HasSubstr("int"))));
    EXPECT_THROW(program.set("anInt", 1.0f), GlError);
    EXPECT_THROW(program.set("aVec2", glm::vec3(0.0f)), GlError);
    EXPECT_THROW(program.set("aVec2", glm::ivec2(0)), GlError);
    EXPECT_THROW(program.set("aMat3", glm::mat4(1.0f)), GlError);
    EXPECT_THROW(program.set("anUint", 1), GlError);
    EXPECT_THROW(program.set("aSampler", 1.0f), GlError);
    EXPECT_NO_THROW(program.set("aSampler", 1));
}

/// What a preprocessor makes of main.frag, whose line 3 includes ray.glsl.
ShaderText expandedShader(const std::string& inMain, const std::string& inIncluded) {
    return {GL_FRAGMENT_SHADER,
            "#version 450 core\n"
            "out vec4 color;\n"
            "#line 1 1\n"
            "// The first line of ray.glsl.\n" +
                inIncluded +
                "\n"
                "#line 4 0\n"
                "void main() {\n" +
                inMain +
                "\n"
                "}\n",
            {"main.frag", "shaders/ray.glsl"}};
}

TEST_F(ProgramTest, CompilerMessagesNameFileAndLineThroughIncludes) {
    EXPECT_THAT([] { Program({expandedShader("color = vec4(0.0);", "float f() { return x; }")}); },
                ThrowsMessage<GlError>(AllOf(HasSubstr("fragment shader"),
                                             HasSubstr("shaders/ray.glsl:2: "),
                                             Not(HasSubstr("main.frag")))));
    EXPECT_THAT([] { Program({expandedShader("color = vec4(y);", "float f() { return 1.0; }")}); },
                ThrowsMessage<GlError>(AllOf(HasSubstr("main.frag:5: "), HasSubstr("`y'"),
                                             Not(HasSubstr("ray.glsl")))));
    EXPECT_NO_THROW(Program({expandedShader("color = vec4(f());", "float f() { return 1.0; }")}));
}

TEST_F(ProgramTest, LinkingErrorsAreTold) {
    EXPECT_THAT(
        [] {
            Program({{GL_FRAGMENT_SHADER,
                      "#version 450 core\nfloat f();\nout vec4 color;\n"
                      "void main() { color = vec4(f()); }\n",
                      {"a.frag"}}});
        },
        ThrowsMessage<GlError>(AllOf(HasSubstr("link"), HasSubstr("f"))));
    EXPECT_THROW(Program({{0x1234, "", {}}}), GlError);
}

}  // namespace
}  // namespace relievo::gl
