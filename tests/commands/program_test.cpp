#include "commands/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <vector>

#include "textures/input_error.h"
#include "textures/version.h"

namespace relievo::commands {
namespace {

using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

struct Outcome {
    int status = -1;
    std::string output;
    std::string errors;
};

// A program `relievo-test` with one subcommand `twice` that has one number, run in this process.
Outcome runWords(std::vector<const char*> words, const std::function<void()>& work) {
    CLI::App app("A program for tests", "relievo-test");
    int number = 0;
    app.add_subcommand("twice", "doubles")->add_option("number", number)->required();
    words.insert(words.begin(), "relievo-test");
    CaptureStdout();
    CaptureStderr();
    Outcome result;
    result.status = runProgram(app, static_cast<int>(words.size()), words.data(), work);
    result.output = GetCapturedStdout();
    result.errors = GetCapturedStderr();
    return result;
}

TEST(RunProgram, DoesTheWorkAndReturnsZero) {
    bool worked = false;
    const Outcome result = runWords({"twice", "4"}, [&] { worked = true; });
    EXPECT_TRUE(worked);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.errors, "");
}

TEST(RunProgram, WrongUsageIsStatusTwoOneLineAndNoWork) {
    const std::vector<std::vector<const char*>> wrong = {
        {"twice"}, {"twice", "four"}, {"twice", "4", "5"}, {"thrice"}, {"--verbose"}};
    for (const std::vector<const char*>& words : wrong) {
        const Outcome result = runWords(words, [] { FAIL() << "ran on wrong usage"; });
        EXPECT_EQ(result.status, 2) << words.front();
        EXPECT_THAT(result.errors, testing::StartsWith("relievo-test: "));
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    }
}

TEST(RunProgram, HelpAndVersionAreStatusZeroAndNoWork) {
    const auto noWork = [] { FAIL() << "ran after --help or --version"; };
    const Outcome help = runWords({"--help"}, noWork);
    EXPECT_EQ(help.status, 0);
    EXPECT_THAT(help.output, HasSubstr("--quiet"));
    const Outcome version = runWords({"--version"}, noWork);
    EXPECT_EQ(version.status, 0);
    EXPECT_EQ(version.output, std::string("relievo-test ") + textures::kVersion + "\n");
}

TEST(RunProgram, ErrorsOfTheWorkBecomeOneLineAndAStatus) {
    const Outcome input =
        runWords({}, [] { throw textures::InputError("a.png: is not an image"); });
    EXPECT_EQ(input.status, 1);
    EXPECT_EQ(input.errors, "relievo-test: a.png: is not an image\n");
    const Outcome usage = runWords({}, [] { throw UsageError("--a and --b exclude each other"); });
    EXPECT_EQ(usage.status, 2);
    EXPECT_THAT(usage.errors, HasSubstr("--a and --b exclude each other"));
    const Outcome memory = runWords({}, [] { throw std::bad_alloc(); });
    EXPECT_EQ(memory.status, 1);
    EXPECT_EQ(memory.errors, "relievo-test: out of memory\n");
}

TEST(RunProgram, QuietKeepsAnswersAndErrorsOnly) {
    const auto talk = [] {
        say("a stage");
        note("a choice");
        answer("a list");
    };
    const Outcome loud = runWords({"twice", "4"}, talk);
    EXPECT_EQ(loud.output, "a stage\na list\n");
    EXPECT_EQ(loud.errors, "relievo-test: note: a choice\n");
    for (const std::vector<const char*>& words :
         {std::vector<const char*>{"-q", "twice", "4"}, {"twice", "4", "--quiet"}}) {
        const Outcome quiet = runWords(words, talk);
        EXPECT_EQ(quiet.status, 0);
        EXPECT_EQ(quiet.output, "a list\n");
        EXPECT_EQ(quiet.errors, "");
    }
}

TEST(RunProgramDeathTest, SignalsEndTheProgramWithTheShellsStatus) {
    for (const auto& [signal, status] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
        const auto interrupted = [signal = signal] {
            std::signal(signal, SIG_DFL);
            CLI::App app("", "relievo-test");
            const char* const words[] = {"relievo-test"};
            runProgram(app, 1, words, [&] { raise(signal); });
        };
        EXPECT_EXIT(interrupted(), testing::ExitedWithCode(status), "");
    }
}

TEST(RunProgramDeathTest, AnIgnoredInterruptStaysIgnored) {
    const auto inBackground = [] {
        std::signal(SIGINT, SIG_IGN);
        CLI::App app("", "relievo-test");
        const char* const words[] = {"relievo-test"};
        std::_Exit(runProgram(app, 1, words, [] { raise(SIGINT); }));
    };
    EXPECT_EXIT(inBackground(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace relievo::commands
