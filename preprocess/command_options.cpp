#include "preprocess/command_options.h"

#include <fmt/core.h>

#include <charconv>
#include <cstddef>
#include <utility>

#include "commands/program.h"
#include "textures/file_extension.h"
#include "textures/input_error.h"

namespace relievo::preprocess {

using commands::UsageError;
using textures::StorageFormat;

MapSize parseSize(const std::string& text, int largest) {
    const char* const end = text.data() + text.size();
    MapSize size;
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        const auto fits = [&](int value) { return value >= 1 && value <= largest; };
        if (height.ec == std::errc() && height.ptr == end && fits(size.width) && fits(size.height))
            return size;
    }
    throw UsageError(fmt::format("--size {}: expected WxH with both from 1 to {}", text, largest));
}

StorageFormat outputFormat(const std::string& output, const std::string& format) {
    const bool isExr = textures::lowerExtension(output) == ".exr";
    // Half would keep 11 bits of what a 16-bit image has.
    const StorageFormat chosen = format.empty()
                                     ? (isExr ? StorageFormat::Float : StorageFormat::U16)
                                     : *textures::storageFormatFromName(format);
    try {
        textures::requireExtensionFor(output, chosen);
    } catch (const textures::InputError& error) {
        throw UsageError(error.what());
    }
    return chosen;
}

tbb::global_control limitThreads(int threads) {
    using tbb::global_control;
    return {global_control::max_allowed_parallelism,
            threads > 0 ? static_cast<std::size_t>(threads)
                        : global_control::active_value(global_control::max_allowed_parallelism)};
}

Stage::Stage(std::string name) : name_(std::move(name)), start_(std::chrono::steady_clock::now()) {}

void Stage::done(const std::string& counts) const {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start_;
    commands::say(fmt::format("{:<10} {:<62} {:7.2f} s", name_, counts, time.count()));
}

}  // namespace relievo::preprocess
