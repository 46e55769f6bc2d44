#pragma once

#include <optional>
#include <string>

#include "preprocess/view_grid.h"

namespace CLI {
class App;
}

namespace relievo::preprocess {

/// The command line of `relievo-bake relief`, as words; an empty format means the extension's.
struct ReliefArguments {
    std::string height;
    std::string output;
    std::string maps = "depth,derivative,cone";
    std::string cone;       ///< "": usualCone
    std::string guarantee;  ///< empty: that of the first method that fits
    std::optional<int> sectors;
    std::string method;  ///< empty: the first that fits
    std::string wrap = "repeat";
    std::string input = "height";
    std::string channel;
    std::string encoding;  ///< empty: that of the kind of cones
    std::string format;
    double normalScale = 0.1;
    int reach = 4;
    double cylinderTolerance = 0.01;
    int azimuths = 8;
    int slices = 16;
    double volumeScale = 0.1;
    ViewGrid views;
    int terms = 8;
    bool mips = false;
    bool force = false;
    int threads = 0;  ///< 0: all cores
};

/// Adds the subcommand `relief`, which fills `arguments`.
CLI::App* addReliefCommand(CLI::App& app, ReliefArguments& arguments);

/// Bakes the maps of a height image into a map file. Prints each stage with its counts and time.
/// Throws UsageError for arguments that do not go together, before any work, and InputError.
void runReliefCommand(const ReliefArguments& arguments);

}  // namespace relievo::preprocess
