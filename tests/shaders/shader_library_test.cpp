#include "shaders/shader_library.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

namespace relievo::shaders {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::size_t occurrences(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST(ShaderLibrary, IsSortedAndFindsEveryFile) {
    EXPECT_TRUE(std::ranges::is_sorted(libraryFiles(), {}, &LibraryFile::path));
    EXPECT_GE(libraryFiles().size(), 10u);
    for (const LibraryFile& file : libraryFiles())
        EXPECT_EQ(libraryText(file.path), file.text);
    EXPECT_FALSE(libraryText("relievo/no_such_file.glsl"));
    EXPECT_FALSE(libraryText("zzz"));
}

TEST(ShaderLibrary, EveryFileExpandsAloneWithoutIncludesLeft) {
    for (const LibraryFile& file : libraryFiles()) {
        const ExpandedShader shader = expandShader(file.path, file.text, "#version 450 core");
        EXPECT_THAT(shader.text, testing::Not(HasSubstr("#include"))) << file.path;
        EXPECT_TRUE(shader.text.starts_with("#version 450 core\n")) << file.path;
    }
}

TEST(ExpandShader, TakesEachFileOnce) {
    const ExpandedShader shader = expandShader("main",
                                               "#include \"relievo/ray.glsl\"\n"
                                               "  #include \"relievo/ray.glsl\"\n"
                                               "#include \"relievo/constants.h\"\n"
                                               "void main() {}\n",
                                               "#version 450 core");
    EXPECT_EQ(occurrences(shader.text, "struct ReliefRay {"), 1u);
    EXPECT_THAT(shader.files,
                testing::ElementsAre("main", "relievo/ray.glsl", "relievo/constants.h"));
}

TEST(ExpandShader, PutsDefinesBetweenVersionAndText) {
    const Define defines[] = {{"RELIEVO_CONE_RADIUS", "1"}};
    const ExpandedShader shader = expandShader("main", "text", "#version 450 core", defines);
    EXPECT_EQ(shader.text, "#version 450 core\n#define RELIEVO_CONE_RADIUS 1\n#line 1 0\ntext\n");
}

// Counting lines from each #line directive must lead back to the line of the source.
TEST(ExpandShader, LineDirectivesPointToTheSource) {
    const std::string source = "first\n#include \"relievo/constants.h\"\nthird\n";
    const ExpandedShader shader = expandShader("main", source, "#version 450 core");
    EXPECT_THAT(shader.text, HasSubstr("#line 1 0\nfirst\n#line 1 1\n"));
    EXPECT_THAT(shader.text, HasSubstr("#line 3 0\nthird\n"));
}

TEST(ExpandShader, MissingIncludeNamesFileLineAndPath) {
    try {
        expandShader("mine.frag", "\n\n#include \"relievo/absent.glsl\"\n", "");
        FAIL() << "an unknown include was accepted";
    } catch (const IncludeError& error) {
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("mine.frag:3"), HasSubstr("relievo/absent.glsl")));
    }
    EXPECT_THROW(expandShader("mine.frag", "#include <angle.glsl>\n", ""), IncludeError);
}

TEST(ExpandShader, KeepsTextWithoutFinalNewline) {
    EXPECT_EQ(expandShader("main", "a", "v").text, "v\n#line 1 0\na\n");
    EXPECT_EQ(expandShader("main", "", "v").text, "v\n#line 1 0\n");
}

}  // namespace
}  // namespace relievo::shaders
