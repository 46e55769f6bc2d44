#include "gl/shader_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace relievo::gl {
namespace {

using ::testing::ElementsAre;

const std::vector<std::string> kFiles = {"main.frag", "shaders/ray.glsl"};
const std::vector<SourceLine> kLines = {{0, 1}, {0, 2}, {1, 1}, {1, 2}, {0, 4}, {2, 7}};

std::string locate(std::string_view log) {
    return locateMessages(log, kLines, kFiles);
}

TEST(ShaderLog, TellsEachDriversFormByFileAndLine) {
    EXPECT_EQ(locate("0:2(5): error: `x' undeclared"), "main.frag:2: error: `x' undeclared");
    EXPECT_EQ(locate("0(4) : error C1008: undefined variable \"x\""),
              "shaders/ray.glsl:2: error C1008: undefined variable \"x\"");
    EXPECT_EQ(locate("ERROR: 0:5: 'x' : undeclared identifier"),
              "main.frag:4: ERROR: 'x' : undeclared identifier");
}

TEST(ShaderLog, TellsSeveralLinesAndDropsEmptyOnes) {
    EXPECT_EQ(locate("0:4(1): error: a\n\n0:5(1): warning: b: c\r\n\n"),
              "shaders/ray.glsl:2: error: a\nmain.frag:4: warning: b: c");
    EXPECT_EQ(locate(""), "");
    EXPECT_EQ(locate(std::string_view("0:1(1): error: a\n\0", 19)), "main.frag:1: error: a");
}

TEST(ShaderLog, KeepsWhatItCannotPlace) {
    for (const char* text :
         {"error: main() is missing", "1:1(5): error: not the source that was given",
          "0:6(1): error: file 2 is not listed", "0:7(1): error: no such line",
          "0:0(1): error: no line", "0:99999999999999999999999(1): error: no such line",
          "12 errors", "0:x(5): error", "0:2(x): error", "0:2 error", "0(2: error", "0"})
        EXPECT_EQ(locate(text), text);
    EXPECT_EQ(locateMessages("0:1(5): error: x", kLines, {}), "0:1(5): error: x");
}

TEST(ShaderLog, TracesLinesThroughDirectives) {
    const TracedText traced =
        traceLines("#version 450\n#line 1 1\na\nb\n  # line 3 0 // back\nc\n#line 9\nd");
    EXPECT_EQ(traced.text, "#version 450\n\na\nb\n\nc\n\nd\n");
    EXPECT_THAT(traced.lines, ElementsAre(SourceLine{0, 1}, SourceLine{0, 2}, SourceLine{1, 1},
                                          SourceLine{1, 2}, SourceLine{1, 3}, SourceLine{0, 3},
                                          SourceLine{0, 4}, SourceLine{0, 9}, SourceLine{0, 10}));
    EXPECT_EQ(traceLines("").lines.size(), 1u);
    EXPECT_EQ(traceLines("#line 99999999999 99999999999\na\nb").lines.size(), 4u);
    // Not directives: in a comment, or of another name.
    for (const char* text : {"// #line 5 1\n", "#lines 5\n", "#line\n", "#line x\n", "#line5\n"})
        EXPECT_EQ(traceLines(text).text, text);
}

}  // namespace
}  // namespace relievo::gl
