#pragma once

#include <string>

namespace CLI {
class App;
}

namespace relievo::preprocess {

/// The command line of `relievo-bake info`.
struct InfoArguments {
    std::string file;
    bool json = false;
};

/// Adds the subcommand `info`, which fills `arguments`.
CLI::App* addInfoCommand(CLI::App& app, InfoArguments& arguments);

/// Prints what a map file holds, or the size, type and channels of any other image. Throws
/// InputError.
void runInfoCommand(const InfoArguments& arguments);

}  // namespace relievo::preprocess
