// Every option of the programs is in their documents, and the documents name no option that does
// not exist; likewise the uniforms of the techniques.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "materials/relief_maps.h"
#include "materials/shadow_registry.h"
#include "materials/slope_sources.h"
#include "materials/solid_registry.h"
#include "materials/surface_textures.h"
#include "materials/technique_registry.h"
#include "tests/commands/process.h"

namespace relievo {
namespace {

const std::string kSources = RELIEVO_SOURCE_FOLDER;

// Options of every program that need no row in each document's tables.
const std::set<std::string> kCommon = {"--help", "--version", "--quiet"};

std::set<std::string> optionsIn(const std::string& text) {
    static const std::regex kOption("--[a-z][a-z-]*");
    std::set<std::string> options;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), kOption);
         match != std::sregex_iterator(); ++match)
        options.insert(match->str());
    return options;
}

std::string helpOf(const std::string& program, const std::vector<std::string>& subcommands) {
    std::string help;
    for (const std::string& subcommand : subcommands) {
        std::vector<std::string> command = {std::string(RELIEVO_PROGRAM_FOLDER) + "/" + program};
        if (!subcommand.empty())
            command.push_back(subcommand);
        command.emplace_back("--help");
        const tests::ProcessResult result = tests::runProcess(command);
        EXPECT_EQ(result.exitStatus, 0) << program << " " << subcommand;
        help += result.output;
    }
    return help;
}

// The options that only one of the two has.
std::set<std::string> difference(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::set<std::string> result;
    for (const std::string& option : a)
        if (!b.contains(option) && !kCommon.contains(option))
            result.insert(option);
    return result;
}

void expectSameOptions(const std::string& program, const std::vector<std::string>& subcommands) {
    SCOPED_TRACE(program);
    const std::set<std::string> offered = optionsIn(helpOf(program, subcommands));
    const std::set<std::string> documented =
        optionsIn(tests::readBytes(kSources + "/docs/" + program + ".md"));
    EXPECT_EQ(difference(offered, documented), std::set<std::string>()) << "not documented";
    EXPECT_EQ(difference(documented, offered), std::set<std::string>()) << "not offered";
}

TEST(Documentation, HasTheOptionsOfThePrograms) {
    expectSameOptions("relievo-bake", {"", "relief", "shape", "info", "verify", "sample"});
    expectSameOptions("relievo-view", {""});
    expectSameOptions("relievo-bench", {"", "bake", "render", "scene", "search", "shadow", "sheet",
                                        "solid", "sparkle"});
}

TEST(Documentation, TheCheckSeesAnOptionThatIsMissing) {
    EXPECT_EQ(difference({"--size", "--seed", "--help"}, {"--size"}),
              std::set<std::string>{"--seed"});
}

TEST(Documentation, HasTheUniformsOfTheTechniques) {
    const std::string document = tests::readBytes(kSources + "/docs/materials.md");
    for (const materials::Technique& technique : materials::techniques()) {
        for (const materials::TechniqueParameter& parameter : technique.parameters)
            EXPECT_NE(document.find(parameter.uniform), std::string::npos) << parameter.uniform;
        for (const std::string_view map : technique.maps)
            EXPECT_NE(document.find(materials::reliefMapFormat(map).sampler), std::string::npos)
                << map;
    }
}

TEST(Documentation, HasTheTextureSetAndTheSourcesOfSlopes) {
    const std::string document = tests::readBytes(kSources + "/docs/materials.md");
    for (const materials::SurfaceTextureFormat& format : materials::surfaceTextureFormats())
        for (const std::string_view name : {format.sampler, format.define})
            EXPECT_NE(document.find("`" + std::string(name) + "`"), std::string::npos) << name;
    for (const materials::SlopeSourceEntry& entry : materials::slopeSources())
        EXPECT_NE(document.find("| `" + std::string(entry.name) + "` |"), std::string::npos)
            << entry.name;
}

TEST(Documentation, HasTheUniformsOfTheShadowMethods) {
    const std::string document = tests::readBytes(kSources + "/docs/materials.md");
    const std::string methods = tests::readBytes(kSources + "/docs/techniques.md");
    for (const materials::ShadowMethod& method : materials::shadowMethods()) {
        for (const materials::TechniqueParameter& parameter : method.parameters)
            EXPECT_NE(document.find(parameter.uniform), std::string::npos) << parameter.uniform;
        for (const std::string_view map : method.maps)
            EXPECT_NE(document.find(materials::reliefMapFormat(map).sampler), std::string::npos)
                << map;
        const std::string row =
            "| `" + std::string(method.name) + "` | " + std::string(method.origin) + " |";
        EXPECT_NE(methods.find(row), std::string::npos) << row;
    }
}

TEST(Documentation, HasEveryTechnique) {
    const std::string document = tests::readBytes(kSources + "/docs/techniques.md");
    for (const materials::Technique& technique : materials::techniques()) {
        const std::string row =
            "| `" + std::string(technique.name) + "` | " + std::string(technique.origin) + " |";
        EXPECT_NE(document.find(row), std::string::npos) << row;
    }
}

TEST(Documentation, HasEverySearchOfSolids) {
    const std::string uniforms = tests::readBytes(kSources + "/docs/materials.md");
    const std::string searches = tests::readBytes(kSources + "/docs/techniques.md");
    for (const materials::SolidTechnique& search : materials::solidTechniques()) {
        const materials::Technique& technique = search.technique;
        const std::string row =
            "| `" + std::string(technique.name) + "` | " + std::string(technique.origin) + " |";
        EXPECT_NE(searches.find(row), std::string::npos) << row;
        for (const materials::TechniqueParameter& parameter : technique.parameters)
            EXPECT_NE(uniforms.find("| `" + std::string(parameter.uniform)), std::string::npos)
                << parameter.uniform;
    }
}

// A link to a page or file that is not there sends the reader nowhere.
TEST(Documentation, LinksLeadSomewhere) {
    static const std::regex kLink(R"(\]\(([^)#:]+)\))");
    for (const std::string document :
         {"README.md", "CONTRIBUTING.md", "docs/architecture.md", "docs/materials.md",
          "docs/measurements.md", "docs/techniques.md", "docs/relievo-bake.md",
          "docs/relievo-view.md", "docs/relievo-bench.md", "docs/scenes.md"}) {
        const std::filesystem::path file = kSources + "/" + document;
        const std::string text = tests::readBytes(file);
        for (auto link = std::sregex_iterator(text.begin(), text.end(), kLink);
             link != std::sregex_iterator(); ++link)
            EXPECT_TRUE(std::filesystem::exists(file.parent_path() / (*link)[1].str()))
                << document << " links to " << (*link)[1];
    }
}

}  // namespace
}  // namespace relievo
