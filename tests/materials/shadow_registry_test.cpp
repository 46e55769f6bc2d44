#include "materials/shadow_registry.h"

#include <gmock/gmock.h>

#include <memory>
#include <set>

#include "gl/context.h"
#include "materials/relief_material.h"
#include "shaders/shader_library.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ShadowRegistry, EveryEntryIsCompleteAndItsUniformsExist) {
    std::set<std::string_view> names;
    for (const ShadowMethod& method : shadowMethods()) {
        SCOPED_TRACE(method.name);
        EXPECT_TRUE(names.insert(method.name).second);
        EXPECT_FALSE(method.title.empty());
        EXPECT_FALSE(method.origin.empty());
        const auto text = shaders::libraryText(method.file);
        ASSERT_TRUE(text) << method.file;
        const shaders::ExpandedShader shader = shaders::expandShader(method.file, *text, "");
        EXPECT_THAT(shader.text, HasSubstr("float reliefVisibility(ReliefLight light)"));
        for (const TechniqueParameter& parameter : method.parameters)
            EXPECT_THAT(shader.text, HasSubstr(std::string(parameter.uniform) + ";"));
        for (const std::string_view map : method.maps)
            EXPECT_THAT(shader.text, HasSubstr(std::string(reliefMapFormat(map).sampler)));
    }
    EXPECT_FALSE(names.contains(givenShadowMethod().name));
}

TEST(ShadowRegistry, FindsByNameAndListsTheNamesOtherwise) {
    for (const ShadowMethod& method : shadowMethods())
        EXPECT_EQ(&findShadowMethod(method.name), &method);
    try {
        findShadowMethod("serch");
        FAIL() << "an unknown method was found";
    } catch (const textures::InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("serch"), HasSubstr("search, soft")));
    }
}

TEST(ShadowRegistry, KnowsWhatTradesTimeForError) {
    EXPECT_EQ(budgetParameter(findShadowMethod("horizon")), nullptr);
    ASSERT_NE(budgetParameter(findShadowMethod("soft")), nullptr);
    EXPECT_EQ(budgetParameter(findShadowMethod("soft"))->name, "shadow-slices");
}

class ShadowedMaterial : public testing::Test {
  protected:
    static std::shared_ptr<ReliefMaps> flatMaps() {
        textures::MapSet maps;
        for (const char* channel : {"depth", "dx", "dy"})
            maps.channels.push_back({channel, textures::Plane(4, 4, 0.5f)});
        return std::make_shared<ReliefMaps>(std::move(maps), "flat.exr");
    }

    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
};

TEST_F(ShadowedMaterial, HasTheFilesAndParametersOfItsMethodAndLosesThemAgain) {
    ReliefMaterial material(flatMaps(), findTechnique("relief"));
    material.setParameter("linear-steps", 7);
    material.setShadow(&findShadowMethod("soft"));
    EXPECT_THAT(material.files(), testing::ElementsAre("relievo/techniques/relief.glsl",
                                                       "relievo/shadows/soft.glsl"));
    material.setParameter("shadow-halvings", 3);
    EXPECT_EQ(material.parameter("shadow-halvings"), 3);
    EXPECT_EQ(material.parameter("linear-steps"), 7);
    EXPECT_THROW(material.setParameter("shadow-halvings", -1), textures::InputError);
    material.setShadow(nullptr);
    EXPECT_THROW(material.setParameter("shadow-halvings", 3), textures::InputError);
    EXPECT_THAT(material.files(), testing::ElementsAre("relievo/techniques/relief.glsl"));
}

// A technique that takes the first point that it looks at for the hit would put all in shadow.
TEST_F(ShadowedMaterial, LightRaysNeedATechniqueThatSearches) {
    ReliefMaterial material(flatMaps(), findTechnique("parallax"));
    try {
        material.setShadow(&findShadowMethod("search"));
        FAIL() << "parallax mapping was to follow light rays";
    } catch (const textures::InputError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("parallax mapping"), HasSubstr("\"search\"")));
    }
    EXPECT_EQ(material.shadow(), nullptr);
}

}  // namespace
}  // namespace relievo::materials
