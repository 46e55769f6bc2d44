#include "preprocess/sample_command.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "commands/program.h"
#include "preprocess/command_options.h"
#include "textures/file_extension.h"
#include "textures/input_error.h"
#include "textures/picture_file.h"
#include "textures/sample_albedo.h"
#include "textures/sample_reliefs.h"

namespace relievo::preprocess {
namespace {

using commands::UsageError;

constexpr int kLargestSize = 32768;  // the largest image that is read

// `packed` for pictures, Float for .exr.
textures::StorageFormat formatFor(const std::string& file, textures::StorageFormat packed) {
    const auto format =
        textures::lowerExtension(file) == ".exr" ? textures::StorageFormat::Float : packed;
    try {
        textures::requireExtensionFor(file, format);
    } catch (const textures::InputError& error) {
        throw UsageError(error.what());
    }
    return format;
}

void listSamples() {
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        commands::answer(fmt::format("{:<12} {}", sample.name, sample.description));
}

void writeAlbedo(const SampleArguments& arguments, const MapSize& size,
                 textures::StorageFormat format) {
    textures::writePicture(
        arguments.albedo,
        textures::generateSampleAlbedo(arguments.name, size.width, size.height, arguments.seed),
        format);
    commands::say(fmt::format("{}: its colours", arguments.albedo));
}

void requireSample(const std::string& name) {
    const auto samples = textures::sampleReliefs();
    if (std::none_of(samples.begin(), samples.end(),
                     [&](const textures::SampleRelief& sample) { return sample.name == name; }))
        throw UsageError(
            fmt::format("'{}' is no sample relief: relievo-bake sample --list shows them", name));
}

}  // namespace

CLI::App* addSampleCommand(CLI::App& app, SampleArguments& arguments) {
    CLI::App* command = app.add_subcommand("sample", "Write a generated relief as a height image");
    command->add_option("NAME", arguments.name, "Sample relief, one of --list");
    command->add_option("-o,--output", arguments.output, "Image to write: .png, .tif, .exr");
    command->add_option("--albedo", arguments.albedo, "Picture of its colours to write as well");
    command->add_option("--size", arguments.size, "Width and height in texels, WxH")
        ->capture_default_str();
    command->add_option("--seed", arguments.seed, "Another relief of the same kind")
        ->capture_default_str();
    command->add_flag("--list", arguments.list, "List the sample reliefs");
    command->footer(
        "Examples:\n"
        "  relievo-bake sample --list\n"
        "  relievo-bake sample cobbles -o cobbles.png --size 1024x1024 --albedo "
        "cobbles-albedo.png");
    return command;
}

void runSampleCommand(const SampleArguments& arguments) {
    if (arguments.list) {
        listSamples();
        return;
    }
    if (arguments.name.empty() || arguments.output.empty())
        throw UsageError("sample: expected NAME and -o FILE, or --list");
    requireSample(arguments.name);
    const MapSize size = parseSize(arguments.size, kLargestSize);
    const auto heightFormat = formatFor(arguments.output, textures::StorageFormat::U16);
    if (!arguments.albedo.empty())
        writeAlbedo(arguments, size, formatFor(arguments.albedo, textures::StorageFormat::U8));
    textures::Plane height =
        textures::generateSampleRelief(arguments.name, size.width, size.height, arguments.seed)
            .depth;
    for (float& value : height.texels)
        value = 1.0f - value;
    textures::writePicture(arguments.output, {&height, 1}, heightFormat);
    commands::say(fmt::format("{}: {}, {}×{}, seed {}", arguments.output, arguments.name,
                              size.width, size.height, arguments.seed));
}

}  // namespace relievo::preprocess
