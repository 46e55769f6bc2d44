#include "materials/solid_registry.h"

#include <gmock/gmock.h>

#include <array>
#include <set>

#include "gl/context.h"
#include "gl/program.h"
#include "materials/program_cache.h"
#include "materials/solid_material.h"
#include "shaders/shader_library.h"
#include "textures/input_error.h"

namespace relievo::materials {
namespace {

using solids::makeProfile;
using solids::ProfileShape;
using testing::AllOf;
using testing::HasSubstr;

std::shared_ptr<const textures::ShapeMap> smallShape() {
    auto shape = std::make_shared<textures::ShapeMap>();
    shape->distance = textures::Plane(4, 4, 0.25f);
    shape->gradientX = shape->gradientY = shape->shape = textures::Plane(4, 4, 0.0f);
    return shape;
}

solids::Compound extrusion(const solids::Profile& profile) {
    solids::SolidPart part;
    part.solid.shape = smallShape();
    part.solid.profile = profile;
    return {{part}};
}

solids::Compound revolution() {
    solids::Compound compound = extrusion(makeProfile(0.0));
    compound.parts[0].solid.kind = solids::SolidKind::Revolution;
    return compound;
}

bool isShown(std::string_view technique, const solids::Compound& compound) {
    return solidProblem(findSolidTechnique(technique), compound).empty();
}

TEST(SolidRegistry, NamesAreUniqueAndEntriesComplete) {
    std::set<std::string_view> names;
    for (const SolidTechnique& entry : solidTechniques()) {
        const Technique& technique = entry.technique;
        SCOPED_TRACE(technique.name);
        EXPECT_TRUE(names.insert(technique.name).second);
        EXPECT_FALSE(technique.title.empty());
        EXPECT_FALSE(technique.origin.empty());
        ASSERT_NE(budgetParameter(technique), nullptr);
        const auto text = shaders::libraryText(technique.file);
        ASSERT_TRUE(text) << technique.file;
        const std::array<shaders::Define, 2> defines{
            {{"RELIEVO_SOLID_PARTS", "1"}, {"RELIEVO_SOLID_KIND0", "0"}}};
        const std::string shader = shaders::expandShader(technique.file, *text, "", defines).text;
        EXPECT_THAT(shader, HasSubstr("SolidHit searchSolid(SolidRay ray)"));
        for (const TechniqueParameter& parameter : technique.parameters) {
            EXPECT_THAT(shader, HasSubstr(std::string(parameter.uniform) + ";"));
            EXPECT_LE(parameter.minimum, parameter.defaultValue);
            EXPECT_LE(parameter.defaultValue, parameter.maximum);
            EXPECT_FALSE(parameter.description.empty());
        }
    }
}

TEST(SolidRegistry, FindsByNameAndListsTheNamesOtherwise) {
    for (const SolidTechnique& entry : solidTechniques())
        EXPECT_EQ(&findSolidTechnique(entry.technique.name), &entry);
    try {
        findSolidTechnique("extrusion");
        FAIL() << "an unknown search was found";
    } catch (const textures::InputError& error) {
        for (const SolidTechnique& entry : solidTechniques())
            EXPECT_THAT(error.what(), HasSubstr(std::string(entry.technique.name)));
    }
}

TEST(SolidRegistry, SearchesShowTheProfilesTheyWerePrintedFor) {
    struct Case {
        const char* name;
        solids::Profile profile;
        bool extrusion, bevel, chamfer;
    };
    constexpr std::array<glm::dvec2, 3> kRisen{{{0.2, 0.1}, {0.2, 0.2}, {0.9, 0.2}}};
    const Case cases[] = {
        {"basic", makeProfile(0.0), true, true, true},
        {"extended", makeProfile(0.1), true, true, true},
        {"bevel", makeProfile(0.1, 0.2), false, true, true},
        {"chamfer", makeProfile(0.0, 0.2, 0.3), false, false, true},
        {"a bevel that narrows", makeProfile(0.1, -0.1), false, false, false},
        {"a chamfer that narrows", makeProfile(0.1, -0.1, 0.3), false, false, false},
        {"a step", solids::profileThrough(kRisen), false, false, false},
        {"round", makeProfile(0.0, 0.2, 0.3, ProfileShape::Round), false, false, false},
    };
    for (const Case& test : cases) {
        SCOPED_TRACE(test.name);
        EXPECT_TRUE(isShown("solid", extrusion(test.profile)));
        EXPECT_EQ(isShown("extrusion-printed", extrusion(test.profile)), test.extrusion);
        EXPECT_EQ(isShown("bevel-printed", extrusion(test.profile)), test.bevel);
        EXPECT_EQ(isShown("chamfer-printed", extrusion(test.profile)), test.chamfer);
        EXPECT_FALSE(isShown("revolution-printed", extrusion(test.profile)));
    }
    EXPECT_TRUE(isShown("solid", revolution()));
    EXPECT_TRUE(isShown("revolution-printed", revolution()));
    EXPECT_FALSE(isShown("extrusion-printed", revolution()));
    EXPECT_FALSE(isShown("bevel-printed", revolution()));
    EXPECT_FALSE(isShown("chamfer-printed", revolution()));
}

TEST(SolidRegistry, SaysWhatASearchDoesNotShow) {
    const auto refusal = [](std::string_view technique, const solids::Compound& compound) {
        return solidProblem(findSolidTechnique(technique), compound);
    };
    EXPECT_THAT(refusal("bevel-printed", extrusion(makeProfile(0.0, 0.1, 0.5))),
                AllOf(HasSubstr("bevel-printed"), HasSubstr("bevels"), HasSubstr("profile")));
    EXPECT_THAT(refusal("chamfer-printed", revolution()), HasSubstr("revolutions"));
    EXPECT_THAT(refusal("revolution-printed", extrusion(makeProfile(0.0))),
                HasSubstr("extrusions"));
    solids::Compound two = extrusion(makeProfile(0.0));
    two.parts.push_back(two.parts[0]);
    EXPECT_THAT(refusal("extrusion-printed", two), HasSubstr("single part, not 2"));
    EXPECT_EQ(refusal("solid", two), "");
}

class SolidMaterialTest : public testing::Test {
  protected:
    std::unique_ptr<gl::Context> context_ = gl::createContext(gl::Backend::OSMesa, {.debug = true});
    std::shared_ptr<ShapeTextureCache> shapes_ = std::make_shared<ShapeTextureCache>();
    ProgramCache programs_;
};

TEST_F(SolidMaterialTest, EverySearchBindsToEveryProgram) {
    for (const SolidTechnique& technique : solidTechniques())
        for (const std::string fragment : {"solid_shaded", "solid_measured", "solid_depth"}) {
            SCOPED_TRACE(std::string(technique.technique.name) + " in " + fragment);
            const SolidMaterial material(
                shapes_,
                technique.capabilities.extrusion ? extrusion(makeProfile(0.0)) : revolution(),
                technique);
            gl::Program& program = programs_.get("relievo/programs/" + fragment + ".frag",
                                                 material.files(), material.defines());
            EXPECT_EQ(material.bind(program.id(), 3), 5U);
        }
}

TEST_F(SolidMaterialTest, AProfileThatWasEditedIsRefusedWhenItIsDrawn) {
    SolidMaterial material(shapes_, extrusion(makeProfile(0.0, 0.1)),
                           findSolidTechnique("bevel-printed"));
    gl::Program& program =
        programs_.get("relievo/programs/solid_depth.frag", material.files(), material.defines());
    EXPECT_NO_THROW(material.bind(program.id()));
    material.compound.parts[0].solid.profile = makeProfile(0.0, 0.1, 0.5);
    EXPECT_THROW(material.bind(program.id()), textures::InputError);
    EXPECT_THROW(SolidMaterial(shapes_, material.compound, findSolidTechnique("bevel-printed")),
                 textures::InputError);
}

}  // namespace
}  // namespace relievo::materials
