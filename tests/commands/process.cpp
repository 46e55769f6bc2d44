#include "tests/commands/process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <thread>

namespace relievo::tests {
namespace {

constexpr int kCannotStart = 127;
constexpr std::chrono::seconds kPatience{60};

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// Output goes to unnamed files: nobody has to read them while the program runs.
File unnamedFile() {
    File file(std::tmpfile(), std::fclose);
    if (!file)
        throw std::runtime_error("cannot make a temporary file");
    return file;
}

// Also while the program writes: reading leaves the place alone where it does.
std::string contents(std::FILE* file) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t count =
            pread(fileno(file), buffer.data(), buffer.size(), static_cast<off_t>(text.size()));
        if (count <= 0)
            return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

// Runs between fork and exec: only async-signal-safe calls.
[[noreturn]] void becomeProgram(char* const* arguments, const ProcessOptions& options,
                                int outputFile, int errorFile) {
    dup2(outputFile, STDOUT_FILENO);
    dup2(errorFile, STDERR_FILENO);
    if (!options.folder.empty() && chdir(options.folder.c_str()) != 0)
        _exit(kCannotStart);
    if (options.fileSizeLimit) {
        const rlimit limit{*options.fileSizeLimit, *options.fileSizeLimit};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    // A test runner in the background has SIGINT ignored, and programs keep that.
    std::signal(SIGINT, SIG_DFL);
    execv(arguments[0], arguments);
    _exit(kCannotStart);
}

bool hasEnded(pid_t child) {
    siginfo_t state = {};
    return waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           state.si_pid == child;
}

// Sends the signal when it is time to. A program that has ended is still there until waited for.
void interrupt(pid_t child, const ProcessOptions& options, std::FILE* output) {
    if (options.signalAfter) {
        std::this_thread::sleep_for(*options.signalAfter);
        kill(child, options.signal);
    }
    if (!options.signalWhen)
        return;
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!hasEnded(child)) {
        if (options.signalWhen(contents(output))) {
            kill(child, options.signal);
            return;
        }
        if (std::chrono::steady_clock::now() > end) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
            throw std::runtime_error("the program does not come to where it is to be signalled");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

int waitForEnd(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            throw std::runtime_error("cannot wait for the program");
    return status;
}

}  // namespace

ProcessResult runProcess(const std::vector<std::string>& command, const ProcessOptions& options) {
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const File output = unnamedFile();
    const File errors = unnamedFile();

    const pid_t child = fork();
    if (child < 0)
        throw std::runtime_error("cannot fork");
    if (child == 0)
        becomeProgram(arguments.data(), options, fileno(output.get()), fileno(errors.get()));
    interrupt(child, options, output.get());
    const int status = waitForEnd(child);

    ProcessResult result;
    if (WIFEXITED(status))
        result.exitStatus = WEXITSTATUS(status);
    else
        result.killedBy = WTERMSIG(status);
    result.output = contents(output.get());
    result.errors = contents(errors.get());
    if (result.exitStatus == kCannotStart)
        throw std::runtime_error("cannot start " + command.at(0));
    return result;
}

ScratchFolder::ScratchFolder() {
    std::string pattern = std::filesystem::temp_directory_path() / "relievo-test-XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr)
        throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::vector<std::string> ScratchFolder::list() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string readBytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace relievo::tests
