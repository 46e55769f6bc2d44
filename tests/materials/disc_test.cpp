// The shares of a light's disc that the shadow methods work with, against counted points.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <memory>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "shaders/shader_library.h"
#include "tests/gl/full_screen_pass.h"

namespace relievo::materials {
namespace {

struct Slice {
    double low;
    double high;
    double line;  // what is beyond it counts
};

constexpr const char* kFragment = R"glsl(
#include "relievo/disc.glsl"
uniform vec3 slice;
layout(location = 0) out vec4 result;
void main() { result = vec4(reliefSliceBeyond(slice.x, slice.y, slice.z)); }
)glsl";

class DiscShares : public testing::Test {
  protected:
    double ofShader(const Slice& slice) {
        program_.set("slice", glm::vec3(slice.low, slice.high, slice.line));
        gl::Framebuffer target(1, 1, std::array<GLenum, 1>{GL_RGBA32F});
        gl::tests::drawFullScreen(program_, target);
        return static_cast<double>(target.read(0).front());
    }

  private:
    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
    gl::Program program_ = gl::tests::fullScreenProgram(
        shaders::expandShader("test", kFragment, "#version 450 core").text);
};

// The share of the points of a lattice over the disc.
double counted(const Slice& slice) {
    constexpr int kPoints = 2000;  // along the disc's diameter
    int inside = 0;
    int all = 0;
    for (int j = 0; j < kPoints; ++j)
        for (int i = 0; i < kPoints; ++i) {
            const double x = (2.0 * i + 1.0) / kPoints - 1.0;
            const double y = (2.0 * j + 1.0) / kPoints - 1.0;
            if (x * x + y * y > 1.0)
                continue;
            ++all;
            inside += x > slice.low && x < slice.high && y > slice.line;
        }
    return static_cast<double>(inside) / all;
}

constexpr double kTolerance = 1e-3;  // of the lattice

TEST_F(DiscShares, AreThoseOfCountedPoints) {
    constexpr double kBorders[] = {-1.0, -0.6, -0.5, 0.0, 0.3, 1.0};
    constexpr double kLines[] = {-0.9, -0.4, 0.0, 0.4, 0.7, 0.99};
    for (std::size_t i = 0; i + 1 < std::size(kBorders); ++i)
        for (const double line : kLines) {
            const Slice slice{kBorders[i], kBorders[i + 1], line};
            const double truth = counted(slice);
            EXPECT_NEAR(ofShader(slice), truth, kTolerance)
                << slice.low << " to " << slice.high << ", " << line;
            // A line a little farther out has another share, where enough is left to see it.
            const double other = counted({slice.low, slice.high, line + 0.05});
            if (truth - other > 2 * kTolerance) {
                EXPECT_GT(std::abs(ofShader(slice) - other), kTolerance);
            }
        }
}

// Nothing is left of a slice beyond its highest point, and all of it beyond its lowest: shadows
// that are full, and light that is, are exact.
TEST_F(DiscShares, OfWholeSlicesAreExactAndTheirSumIsOne) {
    for (int slices = 1; slices <= 16; ++slices) {
        // As shaders count: rounding may put the last border beyond the disc.
        const float width = 2.0f / static_cast<float>(slices);
        double sum = 0.0;
        for (int k = 0; k < slices; ++k) {
            const float low = static_cast<float>(k) * width - 1.0f;
            EXPECT_EQ(ofShader({low, low + width, 1.0}), 0.0);
            sum += ofShader({low, low + width, -1.0});
        }
        EXPECT_NEAR(sum, 1.0, 1e-6) << slices;
    }
}

}  // namespace
}  // namespace relievo::materials
