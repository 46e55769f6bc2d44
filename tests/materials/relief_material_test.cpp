#include "materials/relief_material.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "gl/context.h"
#include "gl/framebuffer.h"
#include "materials/program_cache.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::string_view kShaded = "relievo/programs/shaded.frag";
constexpr std::string_view kMeasured = "relievo/programs/measured.frag";

textures::MapSet flatMaps(std::initializer_list<const char*> channels, float value = 0.5f) {
    textures::MapSet maps;
    for (const char* channel : channels)
        maps.channels.push_back({channel, textures::Plane(4, 4, value)});
    return maps;
}

class ReliefMaterialTest : public testing::Test {
  protected:
    static std::shared_ptr<ReliefMaps> fullMaps() {
        return std::make_shared<ReliefMaps>(flatMaps({"depth", "dx", "dy", "cone"}), "flat.exr");
    }

    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
    ProgramCache programs_;
};

TEST_F(ReliefMaterialTest, EveryTechniqueBindsToBothPrograms) {
    for (const Technique& technique : techniques())
        for (const std::string_view fragment : {kShaded, kMeasured}) {
            SCOPED_TRACE(std::string(technique.name) + " in " + std::string(fragment));
            const ReliefMaterial material(fullMaps(), technique);
            gl::Program& program = programs_.get(fragment, technique.file, material.defines());
            EXPECT_EQ(material.bind(program.id(), 3), 3 + technique.maps.size() + 1);
        }
}

TEST_F(ReliefMaterialTest, MissingChannelIsNamedWithTheFileAndTheRemedy) {
    const auto maps = std::make_shared<ReliefMaps>(flatMaps({"depth", "dx", "dy"}), "bricks.exr");
    EXPECT_NO_THROW(ReliefMaterial(maps, findTechnique("relief")));
    try {
        ReliefMaterial(maps, findTechnique("cone"));
        FAIL() << "cone tracing without cones was accepted";
    } catch (const textures::InputError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("bricks.exr"), HasSubstr("\"cone\""), HasSubstr("--maps")));
    }
    EXPECT_THROW(ReliefMaps(flatMaps({"dx", "dy"}), "x.exr"), textures::InputError);
    const auto noDerivative = std::make_shared<ReliefMaps>(flatMaps({"depth"}), "x.exr");
    EXPECT_THROW(ReliefMaterial(noDerivative, findTechnique("normal")), textures::InputError);
}

TEST_F(ReliefMaterialTest, ParametersKeepTheirRanges) {
    ReliefMaterial material(fullMaps(), findTechnique("relief"));
    material.setParameter("linear-steps", 7);
    EXPECT_EQ(material.parameter("linear-steps"), 7);
    EXPECT_THROW(material.setParameter("linear-steps", 0), textures::InputError);
    EXPECT_THROW(material.setParameter("linear-steps", 2.5), textures::InputError);
    EXPECT_THROW(material.setParameter("linear-steps", std::nan("")), textures::InputError);
    EXPECT_THROW(material.setParameter("cone-steps", 8), textures::InputError);
    EXPECT_EQ(material.parameter("linear-steps"), 7);
}

TEST_F(ReliefMaterialTest, ProgramOfAnotherTechniqueIsRefused) {
    const ReliefMaterial material(fullMaps(), findTechnique("relief"));
    gl::Program& linear = programs_.get(kShaded, findTechnique("linear").file, {});
    try {
        material.bind(linear.id());
        FAIL() << "a program without the technique's uniforms was accepted";
    } catch (const gl::GlError& error) {
        EXPECT_THAT(error.what(), HasSubstr("relievoBinarySteps"));
    }
}

TEST_F(ReliefMaterialTest, MapsAreUploadedOnceAndOnlyWhenNeeded) {
    const auto maps = fullMaps();
    EXPECT_EQ(maps->texture("depth").id(), maps->texture("depth").id());
    EXPECT_NE(maps->texture("depth").id(), maps->texture("cone").id());
}

TEST_F(ReliefMaterialTest, UnlimitedConesReachTheGpuAsFiniteNumbers) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy"});
    set.channels.push_back({"cone", textures::Plane(4, 4, std::numeric_limits<float>::infinity())});
    ReliefMaps maps(std::move(set), "x.exr");
    std::vector<float> texels(16);
    glGetTextureImage(maps.texture("cone").id(), 0, GL_RED, GL_FLOAT, 64, texels.data());
    for (const float texel : texels)
        EXPECT_TRUE(std::isfinite(texel) && texel >= 1e6f);
}

TEST_F(ReliefMaterialTest, EncodingSelectsTheProgram) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy", "cone"});
    set.encoding = textures::ConeEncoding::Radius;
    const ReliefMaterial radius(std::make_shared<ReliefMaps>(std::move(set), "x"),
                                findTechnique("cone"));
    const ReliefMaterial ratio(fullMaps(), findTechnique("cone"));
    programs_.get(kShaded, radius.technique().file, radius.defines());
    programs_.get(kShaded, ratio.technique().file, ratio.defines());
    programs_.get(kShaded, ratio.technique().file, ratio.defines());
    EXPECT_EQ(programs_.size(), 2u);
}

}  // namespace
}  // namespace relievo::materials
