#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

namespace relievo::commands {

/// Wrong usage found after parsing (options that do not go together): exit status 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Parses the command line of `app` and runs `work`, the frame of every Relievo command:
/// exit status 0 done, 1 the work failed, 2 wrong usage; errors as one line `NAME: message` on
/// stderr; `--help`, `--version` and `--quiet` on the program and all its subcommands; temporary
/// outputs removed on Ctrl-C (status 130), SIGTERM (143), a closed terminal and a closed pipe.
/// `work` runs only after a successful parse. `app` must have a name.
int runProgram(CLI::App& app, int argc, const char* const* argv, const std::function<void()>& work);

/// Prints a line to stdout unless --quiet was given: what the program does and has done.
void say(const std::string& line);
/// Prints a line to stdout, --quiet or not: what the user asked for (a list, a report).
void answer(const std::string& line);
/// Prints `NAME: note: line` to stderr unless --quiet was given.
void note(const std::string& line);
/// Whether --quiet was given.
bool isQuiet() noexcept;

}  // namespace relievo::commands
