#include "gl/context.h"

#include <glad/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <thread>
#include <vector>

#include "full_screen_pass.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace relievo::gl {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::array kWindowless = {Backend::OSMesa, Backend::Egl};

/// A picture that depends on rounding in most pixels, from objects made in the current context.
std::vector<float> renderPattern() {
    constexpr std::array<GLenum, 1> kFormats = {GL_RGBA32F};
    const Framebuffer target(37, 23, kFormats);
    tests::drawFullScreen(tests::fullScreenProgram(R"(#version 450 core
in vec2 uv;
out vec4 color;
void main() { color = vec4(sin(31.0 * uv.x) * exp(uv.y), uv / 3.0, sqrt(uv.x + 1.0)); }
)"),
                          target);
    return target.read(0);
}

TEST(Context, NamesOfBackEndsRoundTrip) {
    for (const Backend backend : {Backend::OSMesa, Backend::Egl, Backend::Glfw})
        EXPECT_EQ(backendFromName(backendName(backend)), backend);
    EXPECT_EQ(backendFromName("glx"), std::nullopt);
}

TEST(Context, IsCoreOfVersion45) {
    for (const Backend backend : kWindowless) {
        const auto context = createContext(backend);
        EXPECT_EQ(context->backend(), backend);
        EXPECT_THAT(context->description(), HasSubstr("OpenGL 4.5"));
        GLint profile = 0;
        glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    }
}

TEST(Context, BackEndsInTurnGiveTheSamePixels) {
    std::vector<float> first;
    for (int round = 0; round < 6; ++round) {
        const auto context = createContext(kWindowless[round % 2]);
        const std::vector<float> pixels = renderPattern();
        if (round == 0)
            first = pixels;
        EXPECT_EQ(pixels, first) << "round " << round;
    }
    EXPECT_NE(first[0], first[4]);
}

TEST(Context, BackEndsAliveTogetherDoNotMix) {
    const auto osmesa = createContext(Backend::OSMesa);
    const std::vector<float> expected = renderPattern();
    const auto egl = createContext(Backend::Egl);
    const auto second = createContext(Backend::OSMesa);
    for (int round = 0; round < 3; ++round) {
        for (Context* context : {osmesa.get(), egl.get(), second.get()}) {
            context->makeCurrent();
            // Each context has a state of its own, which tells whether the calls really reach it.
            GLfloat width = 0.0f;
            glGetFloatv(GL_POINT_SIZE, &width);
            EXPECT_EQ(width, round == 0 ? 1.0f : static_cast<float>(1 + round));
            glPointSize(static_cast<float>(2 + round));
            EXPECT_EQ(renderPattern(), expected);
        }
    }
}

TEST(Context, ThreadsWithContextsOfTheirOwnDrawTheSame) {
    std::array<std::vector<float>, 4> pixels;
    {
        std::vector<std::jthread> threads;
        for (std::vector<float>& result : pixels)
            threads.emplace_back([&result] {
                const auto context = createContext(Backend::OSMesa);
                result = renderPattern();
            });
    }
    EXPECT_FALSE(pixels[0].empty());
    for (const std::vector<float>& result : pixels)
        EXPECT_EQ(result, pixels[0]);
}

TEST(Context, OneThatIsDestroyedLeavesTheCurrentOneAlone) {
    const auto first = createContext(Backend::OSMesa);
    auto second = createContext(Backend::Egl);
    auto third = createContext(Backend::OSMesa);
    third.reset();  // was current
    first->makeCurrent();
    second.reset();  // was not
    EXPECT_FALSE(renderPattern().empty());
}

TEST(Context, DebugTurnsAnErrorIntoAnExceptionAtTheCall) {
    for (const Backend backend : kWindowless) {
        const auto context = createContext(backend, {.debug = true});
        try {
            glEnable(0xFFFF);
            ADD_FAILURE() << "no exception through " << backendName(backend);
        } catch (const GlError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("glEnable"), HasSubstr("GL_INVALID_ENUM")));
        }
        EXPECT_NO_THROW(glEnable(GL_DEPTH_TEST));  // the error is told once
        EXPECT_FALSE(renderPattern().empty());
    }
}

TEST(Context, DestructorsNeverThrowTheErrorOfAnEarlierCall) {
    const auto context = createContext(Backend::OSMesa, {.debug = true});
    {
        const Texture texture(1, 1, GL_R32F);
        glad_glEnable(0xFFFF);  // past the wrapper, as a library with a loader of its own does
    }
    EXPECT_THROW(glEnable(GL_DEPTH_TEST), GlError);
    EXPECT_NO_THROW(glEnable(GL_DEPTH_TEST));
}

TEST(Context, WithoutDebugErrorsStayInTheDriver) {
    const auto watched = createContext(Backend::OSMesa, {.debug = true});
    const auto context = createContext(Backend::OSMesa);
    EXPECT_NO_THROW(glEnable(0xFFFF));
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
    // Both ways again, because the functions of the process are switched over.
    watched->makeCurrent();
    EXPECT_THROW(glEnable(0xFFFF), GlError);
    context->makeCurrent();
    EXPECT_NO_THROW(glEnable(0xFFFF));
}

TEST(Context, WindowWithoutDisplaySaysWhy) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    try {
        createContext(Backend::Glfw);
        ADD_FAILURE() << "a window without a display";
    } catch (const GlError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("glfw"), HasSubstr("DISPLAY")));
    }
    EXPECT_NO_THROW(createContext(Backend::OSMesa));
}

}  // namespace
}  // namespace relievo::gl
