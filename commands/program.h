#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace relievo::commands {

/// Wrong usage found after parsing (options that do not go together): exit status 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Parses the command line of `app` and runs `work`, the frame of every Relievo command:
/// exit status 0 done, 1 the work failed, 2 wrong usage; errors as one line `NAME: message` on
/// stderr; `--help`, `--version` and `--quiet` on the program; temporary outputs removed on Ctrl-C
/// (status 130) and SIGTERM. `work` runs only after a successful parse.
int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& work);

/// Prints to stdout unless --quiet was given.
void say(const std::string& line);
/// Prints `NAME: note: line` to stderr unless --quiet was given.
void note(const std::string& line);

}  // namespace relievo::commands
