#include "bench/sheet_command.h"

#include <fmt/format.h>

#include "bench/benchmark_options.h"
#include "bench/shading_sheet.h"
#include "bench/shadow_sheet.h"
#include "bench/solid_sheet.h"
#include "bench/technique_sheet.h"
#include "commands/program.h"
#include "materials/technique_registry.h"
#include "textures/sample_reliefs.h"
#include "viewer/picture.h"

namespace relievo::bench {

SheetCommand::SheetCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "sheet",
          "A sheet of pictures: one view by every search technique, shadow method or shading, or "
          "figures of solids")) {
    command_
        ->add_option("--of", subject_,
                     "What differs from picture to picture: techniques, shadows, or shading and "
                     "depth scale; or solids: figures of extrusions and revolutions")
        ->check(CLI::IsMember({"techniques", "shadows", "shading", "solids"}).description(""))
        ->type_name("NAME")
        ->capture_default_str();
    for (const materials::Technique& technique : materials::techniques())
        techniques_.emplace_back(technique.name);
    addNamesOption(*command_, "--techniques", techniques_, "Search techniques");
    std::vector<std::string> groups = figureGroups();
    groups.emplace_back("all");
    command_->add_option("--figures", figures_, "Which figures of solids")
        ->check(CLI::IsMember(groups))
        ->type_name("NAME")
        ->capture_default_str();
    std::vector<std::string> samples;
    for (const textures::SampleRelief& sample : textures::sampleReliefs())
        samples.emplace_back(sample.name);
    const auto add = [this](const char* name, auto& value, const char* description) {
        return command_->add_option(name, value, description)->capture_default_str();
    };
    add("--sample", options_.sample, "Generated relief")
        ->check(CLI::IsMember(samples))
        ->type_name("NAME");
    add("--size", options_.size,
        "Texels of the relief on a side; of solids, of shape maps from left to right")
        ->check(CLI::Range(1, 8192));
    add("--width", options_.width, "Pixels of each picture")->check(CLI::Range(16, 4096));
    add("--height", options_.height, "Pixels of each picture")->check(CLI::Range(16, 4096));
    add("--columns", options_.columns, "Pictures in a row")->check(CLI::Range(1, 100));
    add("--elevation", options_.elevation, "Degrees of the eye above the surface")
        ->check(CLI::Range(1.0, 90.0));
    add("--azimuth", options_.azimuth, "Degrees of the eye around the surface's normal")
        ->check(CLI::Range(-360.0, 360.0));
    add("--depth-scale", options_.depthScale, "Depth of the relief in tile widths")
        ->check(CLI::Range(0.0, 1e3));
    addBackendOption(*command_, options_.backend);
    command_->add_option("-o,--output", output_, "The sheet: .png, .tif or .exr")
        ->type_name("FILE")
        ->required();
    command_->footer(
        "Examples:\n"
        "  relievo-bench sheet -o sheet.png\n"
        "  relievo-bench sheet --of shadows --elevation 40 --columns 3 -o shadows.png\n"
        "  relievo-bench sheet --sample bricks --techniques relief,cone,exact --columns 2 -o "
        "b.png\n"
        "  relievo-bench sheet --of solids --figures boxes --size 512 -o boxes.png");
}

void SheetCommand::checkOptions() const {
    std::vector<std::string> useless;
    if (subject_ != "techniques")
        useless.emplace_back("--techniques");
    if (subject_ == "shading")
        useless.insert(useless.end(), {"--columns", "--depth-scale"});
    if (subject_ == "solids")
        useless.insert(useless.end(),
                       {"--sample", "--columns", "--elevation", "--azimuth", "--depth-scale"});
    else
        useless.emplace_back("--figures");
    for (const std::string& option : useless)
        if (command_->count(option) > 0)
            throw commands::UsageError(
                fmt::format("{} does nothing for a sheet of {}", option, subject_));
}

viewer::Picture SheetCommand::makeSheet() const {
    if (subject_ == "shadows")
        return makeShadowSheet(options_);
    if (subject_ == "shading")
        return makeShadingSheet(options_);
    if (subject_ == "solids")
        return makeSolidSheet(options_, figures_);
    return makeTechniqueSheet(options_, techniques_);
}

void SheetCommand::run() const {
    checkOptions();
    viewer::requirePictureFile(output_);
    viewer::writePicture(output_, makeSheet());
    commands::say(fmt::format("wrote {}", output_.string()));
}

}  // namespace relievo::bench
