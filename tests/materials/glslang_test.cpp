// The reference compiler for GLSL accepts every program that the registry can make, not only the
// driver that the other tests run on.
#include <gmock/gmock.h>

#include <fstream>

#include "materials/program_cache.h"
#include "materials/technique_registry.h"
#include "tests/commands/process.h"

namespace relievo::materials {
namespace {

// Compiles fragment shaders, all in one run of the compiler.
class Glslang {
  public:
    void add(const std::string& name, const std::string& text) {
        const std::string file = folder_.file(name + ".frag");
        std::ofstream(file) << text;
        command_.push_back(file);
    }
    [[nodiscard]] tests::ProcessResult run() const { return tests::runProcess(command_); }

  private:
    tests::ScratchFolder folder_;
    std::vector<std::string> command_ = {RELIEVO_GLSLANG_VALIDATOR};
};

TEST(GlslangTest, AcceptsEveryProgram) {
    const std::vector<std::vector<shaders::Define>> variants = {
        {},
        {{"RELIEVO_CONE_RADIUS", "1"}},
        {{"RELIEVO_CONE_BILINEAR", "1"}, {"RELIEVO_WRAP_MIRROR", "1"}},
        {{"RELIEVO_WRAP_CLAMP", "1"}},
        {{"RELIEVO_ALBEDO", "1"}, {"RELIEVO_MARK_EXHAUSTED", "1"}}};
    Glslang compiler;
    for (const Technique& technique : techniques())
        for (const std::string fragment : {"shaded", "measured"})
            for (std::size_t k = 0; k < variants.size(); ++k)
                compiler.add(std::string(technique.name) + "-" + fragment + "-" + std::to_string(k),
                             expandFragment("relievo/programs/" + fragment + ".frag",
                                            technique.file, variants[k])
                                 .text);
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

TEST(GlslangTest, RefusesABrokenProgramAmongOthers) {
    Glslang compiler;
    compiler.add("good", "#version 450 core\nvoid main() {}\n");
    compiler.add("broken", "#version 450 core\nvoid main() { undeclared = 1; }\n");
    const tests::ProcessResult result = compiler.run();
    EXPECT_NE(result.exitStatus, 0);
    EXPECT_THAT(result.output, testing::HasSubstr("undeclared"));
}

}  // namespace
}  // namespace relievo::materials
