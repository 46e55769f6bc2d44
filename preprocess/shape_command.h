#pragma once

#include <string>

namespace CLI {
class App;
}

namespace relievo::preprocess {

/// The command line of `relievo-bake shape`, as words.
struct ShapeArguments {
    std::string source;
    std::string output;
    std::string inside = "black";
    std::string wrap = "repeat";
    std::string gradient = "exact";
    std::string channel;
    std::string corners;  ///< empty: sharp where the file can hold them
    std::string format;   ///< empty: that of the extension
    std::string size;     ///< empty: 512 wide
    bool isSigned = false;
    bool isUnsigned = false;
    bool force = false;
    int threads = 0;  ///< 0: all cores
};

/// Adds the subcommand `shape`, which fills `arguments`.
CLI::App* addShapeCommand(CLI::App& app, ShapeArguments& arguments);

/// Bakes the shape map of an image, a drawing or a text. Prints each stage with its counts and
/// time. Throws UsageError for arguments that do not go together, before any work, and InputError.
void runShapeCommand(const ShapeArguments& arguments);

}  // namespace relievo::preprocess
