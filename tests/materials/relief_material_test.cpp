#include "materials/relief_material.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

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
        return std::make_shared<ReliefMaps>(
            flatMaps({"depth", "dx", "dy", "cone", "roof", "ratio"}), "flat.exr");
    }

    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
    ProgramCache programs_;
};

TEST_F(ReliefMaterialTest, EveryTechniqueBindsToBothPrograms) {
    for (const Technique& technique : techniques())
        for (const std::string_view fragment : {kShaded, kMeasured}) {
            SCOPED_TRACE(std::string(technique.name) + " in " + std::string(fragment));
            // Each map to a unit of its own, and that of the shading once.
            std::set<std::string_view> maps(technique.maps.begin(), technique.maps.end());
            textures::MapSet set = flatMaps({"depth", "dx", "dy", "cone", "roof", "ratio", "dmin",
                                             "dmax", "cylinder", "volume0", "volume1", "vdm0"});
            set.attributes["relievo:vdm-views"] = "1 1 1";
            set.attributes["relievo:vdm-scale"] = "0.1";
            set.attributes["relievo:cone"] =
                maps.contains("relaxed-cone") ? "relaxed" : "conservative";
            const ReliefMaterial material(std::make_shared<ReliefMaps>(set, "x.exr"), technique);
            gl::Program& program = programs_.get(fragment, material.files(), material.defines());
            maps.insert("derivative");
            EXPECT_EQ(material.bind(program.id(), 3), 3 + maps.size());
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
}

TEST_F(ReliefMaterialTest, SlopesComeFromTheBestSourceOfTheFile) {
    const auto bestOf = [](std::initializer_list<const char*> channels) {
        textures::MapSet set = flatMaps(channels);
        set.attributes["relievo:normal-scale"] = "0.1";
        const auto maps = std::make_shared<ReliefMaps>(std::move(set), "x.exr");
        return ReliefMaterial(maps, findTechnique("normal")).slopeSource();
    };
    EXPECT_EQ(bestOf({"depth", "dx", "dy", "nx", "ny", "nz"}), SlopeSource::Derivative);
    EXPECT_EQ(bestOf({"depth", "dx", "nx", "ny", "nz"}), SlopeSource::Normal);
    EXPECT_EQ(bestOf({"depth", "nx", "ny"}), SlopeSource::Height);
}

// A map that the slopes do not come from is neither bound nor in the program.
TEST_F(ReliefMaterialTest, ProgramsReadNoOtherMapForSlopes) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy", "nx", "ny", "nz"});
    set.attributes["relievo:normal-scale"] = "0.1";
    ReliefMaterial material(std::make_shared<ReliefMaps>(set, "x.exr"), findTechnique("normal"));
    for (const SlopeSourceEntry& entry : slopeSources()) {
        SCOPED_TRACE(entry.name);
        material.setSlopeSource(entry.source);
        EXPECT_EQ(material.shownBy(findTechnique("linear")).slopeSource(), entry.source);
        gl::Program& program = programs_.get(kMeasured, material.files(), material.defines());
        EXPECT_EQ(material.bind(program.id()), entry.map.empty() ? 1u : 2u);
        for (const std::string_view map : {"derivative", "normal"})
            EXPECT_EQ(program.hasUniform(reliefMapFormat(map).sampler), map == entry.map) << map;
    }
}

TEST_F(ReliefMaterialTest, NormalsWithoutTheirScaleAreRefused) {
    textures::MapSet set = flatMaps({"depth", "nx", "ny", "nz"});
    for (const char* scale : {"", "0", "-1"}) {
        if (*scale != 0)
            set.attributes["relievo:normal-scale"] = scale;
        try {
            ReliefMaterial(std::make_shared<ReliefMaps>(set, "x.exr"), findTechnique("normal"));
            FAIL() << "'" << scale << "' was accepted";
        } catch (const textures::InputError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("x.exr"), HasSubstr("relievo:normal-scale")));
        }
    }
}

// Cone tracing in relaxed cones would pass first hits without a word.
TEST_F(ReliefMaterialTest, ConesOfAnotherKindAreRefused) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy", "cone"});
    set.attributes["relievo:cone"] = "relaxed";
    try {
        ReliefMaterial(std::make_shared<ReliefMaps>(set, "x.exr"), findTechnique("cone"));
        FAIL() << "relaxed cones were accepted";
    } catch (const textures::InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("x.exr"), HasSubstr("relaxed cones"),
                                        HasSubstr("--cone conservative")));
    }
    set.attributes["relievo:cone"] = "conservative";
    EXPECT_NO_THROW(
        ReliefMaterial(std::make_shared<ReliefMaps>(set, "x.exr"), findTechnique("cone")));
}

TEST_F(ReliefMaterialTest, RoofConesGoToALayerForEachSector) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy"});
    for (int k = 0; k < 4; ++k) {
        set.channels.push_back({"roof" + std::to_string(k), textures::Plane(4, 4, 0.1f)});
        set.channels.push_back(
            {"ratio" + std::to_string(k), textures::Plane(4, 4, static_cast<float>(k))});
    }
    ReliefMaps maps(set, "x.exr");
    std::vector<float> texels(4 * 16 * 2);
    glGetTextureImage(maps.texture("roof").id(), 0, GL_RG, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
    for (std::size_t k = 0; k < texels.size(); ++k)
        EXPECT_EQ(texels[k], k % 2 == 0 ? 0.1f : static_cast<float>(k / 32));
    set.channels.pop_back();
    ReliefMaps broken(set, "broken.exr");
    EXPECT_THROW(broken.texture("roof"), textures::InputError);
}

TEST_F(ReliefMaterialTest, NumbersOfAMapComeFromItsAttributes) {
    textures::MapSet set = flatMaps({"depth", "dx", "dy", "dmin", "dmax", "volume0"});
    EXPECT_EQ(ReliefMaps(set, "x.exr").number("extrema"), 4.0);
    set.attributes["relievo:reach"] = "7";
    set.attributes["relievo:volume-scale"] = "0.25";
    EXPECT_EQ(ReliefMaps(set, "x.exr").number("extrema"), 7.0);
    EXPECT_EQ(ReliefMaps(set, "x.exr").number("volume"), 0.25);
    for (const char* wrong : {"", "many", "0", "-1", "1.5", "inf"}) {
        set.attributes["relievo:reach"] = wrong;
        try {
            ReliefMaterial(std::make_shared<ReliefMaps>(set, "x.exr"),
                           findTechnique("safety-zones"));
            FAIL() << "'" << wrong << "' was accepted";
        } catch (const textures::InputError& error) {
            EXPECT_THAT(error.what(), AllOf(HasSubstr("x.exr"), HasSubstr("relievo:reach")));
        }
    }
}

TEST_F(ReliefMaterialTest, ThePyramidHoldsTheLeastDepthsOfItsNodes) {
    textures::MapSet set = flatMaps({"dx", "dy"});
    textures::Plane depth(3, 2, 0.75f);
    depth.at(2, 1) = 0.25f;
    set.channels = {{"depth", depth}};
    set.wrap = textures::WrapMode::Clamp;
    ReliefMaps maps(set, "x.exr");
    const gl::Texture& pyramid = maps.texture("pyramid");
    EXPECT_EQ(pyramid.width(), 4);
    EXPECT_EQ(pyramid.height(), 2);
    const std::vector<std::vector<float>> levels = {
        {0.75f, 0.25f, 0.25f, 1.0f, 0.75f, 0.25f, 0.25f, 1.0f}, {0.25f, 0.25f}, {0.25f}};
    for (std::size_t level = 0; level < levels.size(); ++level) {
        std::vector<float> texels(levels[level].size());
        glGetTextureImage(pyramid.id(), static_cast<GLint>(level), GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
        EXPECT_EQ(texels, levels[level]) << level;
    }
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
    gl::Program& linear = programs_.get(kShaded, {findTechnique("linear").file}, {});
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
    programs_.get(kShaded, radius.files(), radius.defines());
    programs_.get(kShaded, ratio.files(), ratio.defines());
    programs_.get(kShaded, ratio.files(), ratio.defines());
    EXPECT_EQ(programs_.size(), 2u);
}

}  // namespace
}  // namespace relievo::materials
