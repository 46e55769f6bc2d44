#include "commands/progress.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <vector>

#include "commands/program.h"

namespace relievo::commands {
namespace {

using testing::HasSubstr;

// What `work` writes to stderr when that is a terminal. The work must write less than a terminal
// buffers (4 kB).
template <class Work>
std::string onTerminal(const Work& work) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
        throw std::runtime_error("cannot make a terminal");
    const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    std::fflush(stderr);
    const int before = dup(STDERR_FILENO);
    dup2(screen, STDERR_FILENO);
    work();
    std::fflush(stderr);
    dup2(before, STDERR_FILENO);

    std::string text;
    std::array<char, 4096> buffer;
    for (ssize_t count; (count = read(terminal, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    close(before);
    close(screen);
    close(terminal);
    return text;
}

// --quiet belongs to the process: these tests start from a program run without it, or with it.
void startProgram(std::vector<const char*> words) {
    CLI::App app("A program for tests", "relievo-test");
    words.insert(words.begin(), "relievo-test");
    runProgram(app, static_cast<int>(words.size()), words.data(), [] {});
}

void halfDoneAfterASecond() {
    Progress progress("cones", 100);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    progress.advance(50);
}

TEST(Progress, ShowsShareAndTimeLeftAfterASecondAndClearsItself) {
    startProgram({});
    const std::string text = onTerminal(halfDoneAfterASecond);
    EXPECT_THAT(text, HasSubstr("cones [###############...............]  50 %  "));
    EXPECT_THAT(text, HasSubstr(" s left"));
    EXPECT_THAT(text, testing::EndsWith("\r\033[K"));
}

TEST(Progress, SaysNothingOnATerminalInTheFirstSecond) {
    startProgram({});
    EXPECT_EQ(onTerminal([] { Progress("cones", 2).advance(); }), "");
}

TEST(Progress, SaysNothingWhenStderrIsNoTerminal) {
    startProgram({});
    testing::internal::CaptureStderr();
    halfDoneAfterASecond();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, SaysNothingWhenQuiet) {
    startProgram({"--quiet"});
    EXPECT_EQ(onTerminal(halfDoneAfterASecond), "");
}

TEST(DurationText, ReadsLikeAPersonWrites) {
    EXPECT_EQ(durationText(-1.0), "0 s");
    EXPECT_EQ(durationText(2.1), "3 s");
    EXPECT_EQ(durationText(125.0), "2 min 05 s");
    EXPECT_EQ(durationText(4200.0), "1 h 10 min");
}

}  // namespace
}  // namespace relievo::commands
