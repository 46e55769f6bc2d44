#include "preprocess/verify_command.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "commands/program.h"
#include "commands/progress.h"
#include "preprocess/verify_shape.h"
#include "reference/guarantee_check.h"
#include "textures/input_error.h"
#include "textures/wrap_mode.h"

namespace relievo::preprocess {
namespace {

// Keeps the order in which things are said.
using Json = nlohmann::ordered_json;
using reference::GuaranteeReport;
using reference::GuaranteeViolation;

constexpr double kMostRays = 1e12;

struct Verdict {
    const ConesToVerify& cones;
    GuaranteeReport report;
};

GuaranteeReport check(const ConesToVerify& cones, const VerifyArguments& arguments) {
    reference::GuaranteeCheckOptions options;
    options.rays = static_cast<std::uint64_t>(arguments.rays);
    options.seed = arguments.seed;
    commands::Progress progress("rays", options.rays);
    options.advance = [&](std::size_t rays) { progress.advance(rays); };
    if (const auto* roofs = std::get_if<reference::RoofMap>(&cones.cones))
        return reference::checkRoofs(cones.relief, *roofs, options);
    const auto& surface = std::get<SurfaceCones>(cones.cones);
    return reference::checkCones(cones.relief, surface.ratios, surface.promise, options);
}

Json describe(const glm::dvec3& vector) {
    return Json::array({vector.x, vector.y, vector.z});
}

Json describe(const Verdict& verdict) {
    const auto& [cones, report] = verdict;
    Json description{
        {"map", cones.description},        {"width", cones.relief.width()},
        {"height", cones.relief.height()}, {"wrap", textures::wrapModeName(cones.relief.wrap)},
        {"violations", report.violations}, {"meanRatio", report.meanRatio},
        {"unlimited", report.unlimited}};
    if (report.worst)
        description["worst"] = {{"ray", report.worst->ray},
                                {"texel", Json::array({report.worst->i, report.worst->j})},
                                {"start", describe(report.worst->step.origin)},
                                {"direction", describe(report.worst->step.direction)},
                                {"length", report.worst->length},
                                {"worstAt", report.worst->worstAt},
                                {"depth", report.worst->depth}};
    return description;
}

// What went wrong with a step, as the end of a sentence about the promise.
const char* breachOf(const ConesToVerify& cones) {
    const auto* surface = std::get_if<SurfaceCones>(&cones.cones);
    return surface != nullptr && surface->promise == reference::ConePromise::Relaxed
               ? "comes out of the relief again by"
               : "passes the first hit and is below the surface by";
}

void print(const Verdict& verdict, const VerifyArguments& arguments) {
    const auto& [cones, report] = verdict;
    commands::answer(fmt::format("{}: {}, {}×{}, {}", arguments.file, cones.description,
                                 cones.relief.width(), cones.relief.height(),
                                 textures::wrapModeName(cones.relief.wrap)));
    commands::answer(fmt::format("  rays        {} with seed {}", report.rays, arguments.seed));
    commands::answer(fmt::format(
        "  violations  {} ({:.3g} %)", report.violations,
        100.0 * static_cast<double>(report.violations) / static_cast<double>(report.rays)));
    commands::answer(
        fmt::format("  mean ratio  {:.6g}, {} unlimited", report.meanRatio, report.unlimited));
    if (!report.worst)
        return;
    const GuaranteeViolation& worst = *report.worst;
    const auto& [origin, direction] = worst.step;
    commands::answer(fmt::format("  worst       ray {}, the cone of texel ({},{})", worst.ray,
                                 worst.i, worst.j));
    commands::answer(
        fmt::format("              from (u,v,z) = ({}, {}, {})", origin.x, origin.y, origin.z));
    commands::answer(fmt::format("              along ({}, {}, {}) for {}", direction.x,
                                 direction.y, direction.z, worst.length));
    commands::answer(fmt::format("              {} {:.6g} of the depth after {}", breachOf(cones),
                                 worst.depth, worst.worstAt));
}

void addOptionsForOtherTools(CLI::App& command, VerifyArguments& arguments) {
    const auto add = [&](const char* name, std::string& word, const char* description) {
        return command.add_option(name, word, description)->group("For files of other tools");
    };
    add("--cone-channel", arguments.coneChannel,
        "Channel of the cones, by number or name [the only one]");
    add("--roof-channel", arguments.roofChannel, "Channel of the roofs of --kind roof, as depths");
    add("--depth-channel", arguments.depthChannel,
        "Channel of the depths or heights, by number or name");
    add("--depth", arguments.depthFile, "Image with the depths or heights, if not in FILE");
    add("--kind", arguments.kind, "What the cones promise [conservative]")
        ->check(CLI::IsMember({"conservative", "relaxed", "roof"}));
    add("--encode", arguments.encoding, "Cones as ratios or as radii = ratio·depth [ratio]")
        ->check(CLI::IsMember({"ratio", "radius"}));
    add("--wrap", arguments.wrap, "How the relief continues outside its tile [repeat]")
        ->check(CLI::IsMember({"repeat", "mirror", "clamp"}));
    add("--input", arguments.input, "What white means: high, or deep [height]")
        ->check(CLI::IsMember({"height", "depth"}));
    command
        .add_option("--cone-scale", arguments.coneScale,
                    "Cones are the stored values (integers: from 0 to 1) times this [1]")
        ->check(CLI::PositiveNumber)
        ->group("For files of other tools");
}

}  // namespace

CLI::App* addVerifyCommand(CLI::App& app, VerifyArguments& arguments) {
    CLI::App* command = app.add_subcommand(
        "verify", "Check by exact rays that cones and shape distances keep their promise");
    command->add_option("FILE", arguments.file, "Map file, or image of another tool")->required();
    command->add_option("--rays", arguments.rays, "Rays to draw for each map")
        ->check(CLI::Range(1.0, kMostRays))
        ->capture_default_str();
    command->add_option("--seed", arguments.seed, "Other rays")->capture_default_str();
    command->add_flag("--json", arguments.json, "As JSON, for scripts");
    addOptionsForOtherTools(*command, arguments);
    command->footer(
        "Ratios are in tile widths per unit of depth. Exit status 1 unless no ray breaks the "
        "promise.\n"
        "Examples:\n"
        "  relievo-bake verify star.exr --seed 7\n"
        "  relievo-bake verify bricks.exr --rays 1e7\n"
        "  relievo-bake verify other.png --cone-channel B --depth-channel A --input depth "
        "--kind relaxed");
    return command;
}

void runVerifyCommand(const VerifyArguments& arguments) {
    if (arguments.rays != std::floor(arguments.rays))
        throw commands::UsageError(
            fmt::format("--rays {}: expected a whole number", arguments.rays));
    if (!std::isfinite(arguments.coneScale.value_or(1.0)))  // passes every check of a range
        throw commands::UsageError("--cone-scale: expected a number");
    if (isShapeFile(arguments.file)) {
        verifyShape(arguments);
        return;
    }
    const std::vector<ConesToVerify> all = readConesToVerify(arguments);
    std::uint64_t violations = 0;
    Json checks = Json::array();
    for (const ConesToVerify& cones : all) {
        const Verdict verdict{cones, check(cones, arguments)};
        violations += verdict.report.violations;
        if (arguments.json)
            checks.push_back(describe(verdict));
        else
            print(verdict, arguments);
    }
    if (arguments.json)
        commands::answer(Json{
            {"file", arguments.file},
            {"rays", static_cast<std::uint64_t>(arguments.rays)},
            {"seed", arguments.seed},
            {"violations", violations},
            {"checks",
             checks}}.dump(2));
    if (violations > 0)
        throw textures::InputError(fmt::format(
            "{}: {} of {} rays break the promise of its cones, expected none", arguments.file,
            violations, static_cast<double>(all.size()) * arguments.rays));
}

}  // namespace relievo::preprocess
