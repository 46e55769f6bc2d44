#include "preprocess/verify_shape.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "commands/program.h"
#include "commands/progress.h"
#include "reference/shape_check.h"
#include "textures/input_error.h"
#include "textures/map_file.h"
#include "textures/shape_map.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {
namespace {

// Keeps the order in which things are said.
using Json = nlohmann::ordered_json;
using reference::ShapeReport;
using textures::ShapeMap;

ShapeMap readShape(const std::string& file) {
    const textures::MapSet maps = textures::readMapFile(file);
    try {
        return textures::shapeMapOf(maps);
    } catch (const textures::InputError& error) {
        throw textures::InputError(fmt::format("{}: {}", file, error.what()));
    }
}

ShapeReport check(const ShapeMap& shape, const VerifyArguments& arguments) {
    reference::ShapeCheckOptions options;
    options.rays = static_cast<std::uint64_t>(arguments.rays);
    options.seed = arguments.seed;
    commands::Progress progress("rays", options.rays);
    options.advance = [&](std::size_t rays) { progress.advance(rays); };
    return reference::checkShape(shape, options);
}

const char* descriptionOf(const ShapeMap& shape) {
    return shape.isSigned ? "signed distances of a shape" : "unsigned distances of a shape";
}

Json describe(const ShapeMap& shape, const ShapeReport& report, const VerifyArguments& arguments) {
    Json description{{"map", descriptionOf(shape)},
                     {"width", shape.width()},
                     {"height", shape.height()},
                     {"wrap", textures::wrapModeName(shape.wrap)},
                     {"violations", report.violations},
                     {"contradictions", report.contradictions},
                     {"slack", shape.slack},
                     {"meanStep", report.meanStep}};
    if (report.worst) {
        const auto& [origin, direction] = report.worst->step;
        description["worst"] = {{"ray", report.worst->ray},
                                {"start", Json::array({origin.x, origin.y})},
                                {"direction", Json::array({direction.x, direction.y})},
                                {"offset", origin.z},
                                {"length", report.worst->length},
                                {"worstAt", report.worst->worstAt},
                                {"depth", report.worst->depth}};
    }
    return Json{{"file", arguments.file},
                {"rays", report.rays},
                {"seed", arguments.seed},
                {"violations", report.violations},
                {"checks", Json::array({description})}};
}

void print(const ShapeMap& shape, const ShapeReport& report, const VerifyArguments& arguments) {
    commands::answer(fmt::format("{}: {}, {}×{}, {}", arguments.file, descriptionOf(shape),
                                 shape.width(), shape.height(),
                                 textures::wrapModeName(shape.wrap)));
    commands::answer(fmt::format("  rays        {} with seed {}", report.rays, arguments.seed));
    commands::answer(fmt::format(
        "  violations  {} ({:.3g} %)", report.violations,
        100.0 * static_cast<double>(report.violations) / static_cast<double>(report.rays)));
    commands::answer(fmt::format("  sides       {} texels whose distance and shape contradict",
                                 report.contradictions));
    commands::answer(fmt::format("  mean step   {:.6g} texels, slack {:.3g} texels",
                                 report.meanStep, shape.slack * shape.width()));
    if (!report.worst)
        return;
    const auto& [origin, direction] = report.worst->step;
    commands::answer(fmt::format("  worst       ray {}, the solid of the offset {}",
                                 report.worst->ray, origin.z));
    commands::answer(fmt::format("              from (u,v) = ({}, {})", origin.x, origin.y));
    commands::answer(fmt::format("              along ({}, {}) for {}", direction.x, direction.y,
                                 report.worst->length));
    commands::answer(fmt::format("              is {:.6g} tile widths inside after {}",
                                 report.worst->depth, report.worst->worstAt));
}

}  // namespace

bool isShapeFile(const std::string& file) {
    return textures::isMapFile(file) && textures::readMapDescription(file).kind == "shape";
}

void verifyShape(const VerifyArguments& arguments) {
    refuseOptionsOfOtherTools(arguments);
    const ShapeMap shape = readShape(arguments.file);
    const ShapeReport report = check(shape, arguments);
    if (arguments.json)
        commands::answer(describe(shape, report, arguments).dump(2));
    else
        print(shape, report, arguments);
    if (report.violations > 0)
        throw textures::InputError(
            fmt::format("{}: {} of {} steps by its distances enter the solid, expected none",
                        arguments.file, report.violations, report.rays));
    if (report.contradictions > 0)
        throw textures::InputError(fmt::format(
            "{}: the distances of {} texels contradict the channel 'shape', expected none",
            arguments.file, report.contradictions));
}

}  // namespace relievo::preprocess
