// The reference compiler for GLSL accepts every program that the registry can make, not only the
// driver that the other tests run on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "materials/program_cache.h"
#include "materials/technique_registry.h"

namespace relievo::materials {
namespace {

int validate(const std::string& text) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "relievo_glslang_test.frag";
    std::ofstream(file) << text;
    return std::system(("glslangValidator " + file.string()).c_str());
}

TEST(Glslang, AcceptsEveryProgram) {
    const std::vector<std::vector<shaders::Define>> variants = {
        {},
        {{"RELIEVO_CONE_RADIUS", "1"}},
        {{"RELIEVO_CONE_BILINEAR", "1"}, {"RELIEVO_WRAP_MIRROR", "1"}},
        {{"RELIEVO_WRAP_CLAMP", "1"}},
        {{"RELIEVO_ALBEDO", "1"}, {"RELIEVO_MARK_EXHAUSTED", "1"}}};
    for (const Technique& technique : techniques())
        for (const char* fragment :
             {"relievo/programs/shaded.frag", "relievo/programs/measured.frag"})
            for (const auto& defines : variants) {
                const std::string text = expandFragment(fragment, technique.file, defines).text;
                EXPECT_EQ(validate(text), 0) << technique.name << " in " << fragment;
            }
}

TEST(Glslang, RefusesABrokenProgram) {
    EXPECT_NE(validate("#version 450 core\nvoid main() { undeclared = 1; }\n"), 0);
}

}  // namespace
}  // namespace relievo::materials
