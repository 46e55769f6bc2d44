#include "commands/program.h"

#include <fmt/core.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <new>

#include "textures/atomic_file.h"
#include "textures/version.h"

namespace relievo::commands {
namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;
constexpr int kSignalStatus = 128;  // the shell's convention: 128 + number of the signal

// One program per process, so its name and its --quiet are the process's.
std::string programName;
std::atomic<bool> quiet{false};

void removeOutputsAndExit(int signal) {
    textures::removeTemporaryFiles();
    _exit(kSignalStatus + signal);
}

void installSignalHandlers() {
    struct sigaction action = {};
    action.sa_handler = removeOutputsAndExit;
    sigfillset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction previous = {};
        sigaction(signal, nullptr, &previous);
        // A shell starts background jobs with SIGINT ignored, nohup does it for SIGHUP: keep that.
        if (previous.sa_handler != SIG_IGN)
            sigaction(signal, &action, nullptr);
    }
    // Passing the limit on file sizes must fail like a full disk, with a message, not kill us.
    std::signal(SIGXFSZ, SIG_IGN);
}

int fail(const std::string& message, int status) {
    fmt::print(stderr, "{}: {}\n", programName, message);
    return status;
}

void addCommonOptions(CLI::App& app) {
    app.set_version_flag("--version", programName + " " + std::string(textures::kVersion));
    app.add_flag_callback(
        "-q,--quiet", [] { quiet = true; }, "Print errors only");
    for (CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
        subcommand->fallthrough();
}

int runWork(const std::function<void()>& work) {
    try {
        work();
    } catch (const UsageError& error) {
        return fail(fmt::format("{} (see {} --help)", error.what(), programName), kWrongUsage);
    } catch (const std::bad_alloc&) {
        return fail("out of memory", kFailed);
    } catch (const std::exception& error) {
        return fail(error.what(), kFailed);
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail("cannot write to the standard output", kFailed);
    return kDone;
}

}  // namespace

int runProgram(CLI::App& app, int argc, const char* const* argv,
               const std::function<void()>& work) {
    programName = app.get_name();
    quiet = false;
    installSignalHandlers();
    addCommonOptions(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0)
            return app.exit(error);  // --help and --version
        return fail(fmt::format("{} (see {} --help)", error.what(), programName), kWrongUsage);
    }
    return runWork(work);
}

void answer(const std::string& line) {
    fmt::print("{}\n", line);
}

void say(const std::string& line) {
    if (quiet)
        return;
    answer(line);
    std::fflush(stdout);  // at once, also through a pipe: what comes next may take long
}

void note(const std::string& line) {
    if (!quiet)
        fmt::print(stderr, "{}: note: {}\n", programName, line);
}

bool isQuiet() noexcept {
    return quiet;
}

}  // namespace relievo::commands
