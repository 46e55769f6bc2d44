#pragma once

#include "preprocess/verify_input.h"

namespace CLI {
class App;
}

namespace relievo::preprocess {

/// Adds the subcommand `verify`, which fills `arguments`.
CLI::App* addVerifyCommand(CLI::App& app, VerifyArguments& arguments);

/// Checks by exact rays that the cones of a file keep their promise, and prints what it found.
/// Throws InputError when a ray broke it, after printing, and for files that cannot be checked, and
/// UsageError for options that do not go with the file.
void runVerifyCommand(const VerifyArguments& arguments);

}  // namespace relievo::preprocess
