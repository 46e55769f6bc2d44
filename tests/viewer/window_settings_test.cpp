#include "viewer/window_settings.h"

#include <gtest/gtest.h>

#include "materials/shadow_registry.h"

namespace relievo::viewer {
namespace {

ViewOptions optionsFor(std::vector<std::string> techniques) {
    ViewOptions options;
    options.files = {"map.exr"};
    options.techniques = std::move(techniques);
    return options;
}

TEST(WindowSettings, TheFirstTwoTechniquesAreAAndB) {
    const WindowSettings two = makeWindowSettings(optionsFor({"relief", "cone", "linear"}));
    EXPECT_EQ(two.techniqueA, "relief");
    EXPECT_EQ(two.techniqueB, "cone");
    EXPECT_EQ(two.mode, ComparisonMode::SideBySide);
    const WindowSettings one = makeWindowSettings(optionsFor({"relief"}));
    EXPECT_EQ(one.techniqueB, kReferenceName);
    EXPECT_EQ(one.mode, ComparisonMode::Single);
}

TEST(WindowSettings, ChoicesAreTheRegistryThenTheReference) {
    const auto choices = techniqueChoices();
    ASSERT_EQ(choices.size(), materials::techniques().size() + 1);
    EXPECT_EQ(choices.back(), kReferenceName);
    for (const std::string_view name : choices)
        EXPECT_FALSE(techniqueTitle(name).empty());
}

TEST(WindowSettings, ExactHitsAreTracedOnlyForWhatIsShown) {
    WindowSettings settings = makeWindowSettings(optionsFor({"relief"}));
    EXPECT_FALSE(needsReference(settings));  // B is the reference, but not shown
    settings.mode = ComparisonMode::Split;
    EXPECT_TRUE(needsReference(settings));
    settings.techniqueB = "cone";
    EXPECT_FALSE(needsReference(settings));
    settings.measureErrors = true;
    EXPECT_TRUE(needsReference(settings));
    settings.measureErrors = false;
    settings.mode = ComparisonMode::HeatMap;
    EXPECT_TRUE(needsReference(settings));
}

TEST(WindowSettings, ASliderChangesItsTechniqueOnly) {
    ViewOptions options = optionsFor({"linear", "relief"});
    options.parameters = {{"", "linear-steps", 100}};
    const materials::Technique& linear = materials::findTechnique("linear");
    const materials::Technique& relief = materials::findTechnique("relief");
    const auto steps = [&](const materials::Technique& technique) {
        return parameterValue(options, technique.name,
                              materials::findParameter(technique, "linear-steps"));
    };
    EXPECT_EQ(steps(linear), 100);
    EXPECT_EQ(steps(relief), 100);
    for (const double value : {7.0, 9.0}) {
        setParameterValue(options, relief.name, materials::findParameter(relief, "linear-steps"),
                          value);
        EXPECT_EQ(steps(relief), value);
        EXPECT_EQ(steps(linear), 100);
    }
    EXPECT_EQ(options.parameters.size(), 2u) << "dragging a slider must not pile up settings";
    options.parameters.clear();
    EXPECT_EQ(steps(linear), materials::findParameter(linear, "linear-steps").defaultValue);
}

// Like `--set NAME=VALUE`: the shadow method is that of both techniques.
TEST(WindowSettings, ASliderOfTheShadowMethodIsThatOfNoTechnique) {
    ViewOptions options = optionsFor({"relief"});
    const materials::TechniqueParameter& slices =
        *materials::budgetParameter(materials::findShadowMethod("soft"));
    EXPECT_EQ(parameterValue(options, "", slices), slices.defaultValue);
    options.parameters = {{"relief", std::string(slices.name), 9.0}};
    EXPECT_EQ(parameterValue(options, "", slices), slices.defaultValue);
    setParameterValue(options, "", slices, 2.0);
    EXPECT_EQ(parameterValue(options, "", slices), 2.0);
    EXPECT_EQ(options.parameters.back(), (ParameterSetting{"", std::string(slices.name), 2.0}));
}

}  // namespace
}  // namespace relievo::viewer
