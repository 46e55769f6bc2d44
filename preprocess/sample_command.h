#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
}

namespace relievo::preprocess {

/// The command line of `relievo-bake sample`.
struct SampleArguments {
    std::string name;
    std::string output;
    std::string albedo;  ///< picture to write the colours to, or ""
    std::string size = "512x512";
    std::uint32_t seed = 1;
    bool list = false;
};

/// Adds the subcommand `sample`, which fills `arguments`.
CLI::App* addSampleCommand(CLI::App& app, SampleArguments& arguments);

/// Writes a generated relief as a height image (white is high): 16-bit for .png and .tif, float for
/// .exr; and its colours as a picture if asked for. Or lists the reliefs. Throws UsageError and
/// InputError.
void runSampleCommand(const SampleArguments& arguments);

}  // namespace relievo::preprocess
