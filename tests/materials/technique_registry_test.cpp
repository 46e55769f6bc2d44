#include "materials/technique_registry.h"

#include <gmock/gmock.h>

#include <set>

#include "materials/relief_maps.h"
#include "shaders/shader_library.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

using testing::HasSubstr;

TEST(TechniqueRegistry, NamesAreUnique) {
    std::set<std::string_view> names;
    for (const Technique& technique : techniques())
        EXPECT_TRUE(names.insert(technique.name).second) << technique.name;
    EXPECT_FALSE(names.contains(givenHitsTechnique().name));
}

TEST(TechniqueRegistry, EveryEntryIsCompleteAndItsUniformsExist) {
    for (const Technique& technique : techniques()) {
        SCOPED_TRACE(technique.name);
        EXPECT_FALSE(technique.title.empty());
        EXPECT_FALSE(technique.origin.empty());
        const auto text = shaders::libraryText(technique.file);
        ASSERT_TRUE(text) << technique.file;
        const shaders::ExpandedShader shader = shaders::expandShader(technique.file, *text, "");
        EXPECT_THAT(shader.text, HasSubstr("ReliefHit searchRelief(ReliefRay ray)"));
        for (const TechniqueParameter& parameter : technique.parameters)
            EXPECT_THAT(shader.text, HasSubstr(std::string(parameter.uniform) + ";"));
        for (const std::string_view map : technique.maps)
            EXPECT_THAT(shader.text, HasSubstr(std::string(reliefMapFormat(map).sampler)));
    }
}

TEST(TechniqueRegistry, DefaultsAreWithinTheirRanges) {
    for (const Technique& technique : techniques())
        for (const TechniqueParameter& parameter : technique.parameters) {
            SCOPED_TRACE(parameter.name);
            EXPECT_LE(parameter.minimum, parameter.defaultValue);
            EXPECT_LE(parameter.defaultValue, parameter.maximum);
            EXPECT_FALSE(parameter.description.empty());
        }
}

TEST(TechniqueRegistry, FindsByNameAndListsTheNamesOtherwise) {
    for (const Technique& technique : techniques())
        EXPECT_EQ(&findTechnique(technique.name), &technique);
    try {
        findTechnique("conee");
        FAIL() << "an unknown technique was found";
    } catch (const textures::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("conee"));
        for (const Technique& technique : techniques())
            EXPECT_THAT(error.what(), HasSubstr(std::string(technique.name)));
    }
    EXPECT_THROW(findParameter(findTechnique("normal"), "linear-steps"), textures::InputError);
}

TEST(TechniqueRegistry, BudgetIsTheParameterMarkedAsSuch) {
    EXPECT_EQ(budgetParameter(findTechnique("normal")), nullptr);
    ASSERT_NE(budgetParameter(findTechnique("cone")), nullptr);
    EXPECT_EQ(budgetParameter(findTechnique("cone"))->name, "cone-steps");
}

}  // namespace
}  // namespace relievo::materials
