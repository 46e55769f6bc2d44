#include "tests/viewer/background_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace relievo::tests {

BackgroundProcess::BackgroundProcess(const std::vector<std::string>& command,
                                     const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (const std::string& word : command)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    child_ = fork();
    if (child_ < 0)
        throw std::runtime_error("cannot fork");
    if (child_ == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is killed leaves nothing behind
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        if (chdir(folder.c_str()) == 0)
            execvp(arguments[0], arguments.data());
        _exit(127);
    }
}

BackgroundProcess::~BackgroundProcess() {
    if (status())
        return;
    kill(child_, SIGTERM);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (!status() && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (status())
        return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
}

std::optional<int> BackgroundProcess::status() {
    int status = 0;
    if (!status_ && waitpid(child_, &status, WNOHANG) == child_)
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_;
}

}  // namespace relievo::tests
