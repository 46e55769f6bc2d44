#include "viewer/view_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "commands/program.h"
#include "materials/shadow_registry.h"
#include "materials/technique_registry.h"

namespace relievo::viewer {
namespace {

using commands::UsageError;

constexpr int kMostLevels = 30;

double parseNumber(std::string_view text, std::string_view option) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw CLI::ValidationError(std::string(option),
                                   fmt::format("\"{}\" is not a number", text));
    return value;
}

// "AZ,EL" or "1,2,3": between `least` and `most` numbers.
std::vector<float> parseNumbers(std::string_view text, char separator, std::size_t least,
                                std::size_t most, std::string_view option) {
    std::vector<float> numbers;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        numbers.push_back(static_cast<float>(parseNumber(text.substr(start, end - start), option)));
        start = end + 1;
    }
    if (numbers.size() < least || numbers.size() > most)
        throw CLI::ValidationError(
            std::string(option),
            fmt::format(
                "\"{}\" has {} numbers, expected {}", text, numbers.size(),
                least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most)));
    return numbers;
}

ParameterSetting parseSetting(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw CLI::ValidationError(
            "--set",
            fmt::format("\"{}\" has no =, expected NAME=VALUE such as cone-steps=64", text));
    ParameterSetting setting;
    setting.name = text.substr(0, equals);
    setting.value = parseNumber(std::string_view(text).substr(equals + 1), "--set");
    if (const std::size_t dot = setting.name.find('.'); dot != std::string::npos) {
        setting.technique = setting.name.substr(0, dot);
        setting.name.erase(0, dot + 1);
    }
    return setting;
}

void setObject(ViewOptions& options, const std::string& name) {
    static const std::map<std::string, ObjectKind> kObjects = {{"quad", ObjectKind::Quad},
                                                               {"box", ObjectKind::Box},
                                                               {"sphere", ObjectKind::Sphere},
                                                               {"torus", ObjectKind::Torus},
                                                               {"shape-box", ObjectKind::ShapeBox}};
    const auto known = kObjects.find(name);
    if (known == kObjects.end() && !std::filesystem::exists(name))
        throw CLI::ValidationError(
            "--mesh", fmt::format("there is no file {}, expected one or quad, box, sphere, torus "
                                  "or shape-box",
                                  name));
    options.object = known == kObjects.end() ? ObjectKind::File : known->second;
    options.meshFile = known == kObjects.end() ? std::filesystem::path(name) : "";
}

void addSceneOptions(CLI::App& app, ViewOptions& options) {
    app.add_option_function<std::string>(
           "--mesh", [&options](const std::string& name) { setObject(options, name); },
           "Object that carries the relief or the solid: quad, box, sphere, torus, or a mesh file "
           "with texture coordinates (OBJ, PLY, glTF, ...); or shape-box, the box that a whole "
           "solid is in")
        ->type_name("FILE|quad|box|sphere|torus|shape-box")
        ->default_str("quad");
    app.add_option("--depth-scale", options.depthScale,
                   "Depth of the relief in tile widths; 0 is flat")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    app.add_option_function<std::string>(
           "--tiles",
           [&options](const std::string& text) {
               const auto n = parseNumbers(text, ',', 2, 2, "--tiles");
               options.tiles = {n[0], n[1]};
           },
           "Repetitions of the map across the object, in u and v")
        ->type_name("X,Y")
        ->default_str("1,1");
    app.add_option_function<std::string>(
           "--camera",
           [&options](const std::string& text) {
               const auto n = parseNumbers(text, ',', 2, 3, "--camera");
               options.sceneOptions.insert("camera");
               options.camera.azimuth = n[0];
               options.camera.elevation = n[1];
               if (n.size() > 2)
                   options.camera.distance = n[2];
           },
           "Eye around the object: azimuth and elevation in degrees, distance in object widths")
        ->type_name("AZ,EL[,DISTANCE]")
        ->default_str("35,40,1.8");
    app.add_option_function<std::string>(
           "--light",
           [&options](const std::string& text) {
               const auto n = parseNumbers(text, ',', 2, 2, "--light");
               options.sceneOptions.insert("light");
               options.light = {n[0], n[1]};
           },
           "Direction towards the light: azimuth and elevation in degrees")
        ->type_name("AZ,EL")
        ->default_str("-50,40");
    addNormalsOption(app, options.normals, "the first of these that the file has");
}

void addShadowOptions(CLI::App& app, ViewOptions& options) {
    app.add_option("--shadow", options.shadow,
                   "Shadows that the relief casts on itself: none, or a method of --list, which "
                   "the exact picture shows too")
        ->type_name("NAME")
        ->default_str(kNoShadow);
    app.add_option("--light-size", options.lightSize,
                   "Degrees that the light spans in the sky, for soft shadows: 0 is a point, 0.5 "
                   "the sun")
        ->check(CLI::Range(0.0, 90.0))
        ->each([&options](const std::string&) { options.dependentOptions.insert("light-size"); })
        ->capture_default_str();
    app.add_option(
           "--shadow-texels", options.shadowTexels,
           "Texels of a scene's shadow map on a side: more make finer edges and take longer")
        ->check(CLI::Range(16, 8192))
        ->each([&options](const std::string&) { options.sceneOptions.insert("shadow-texels"); })
        ->capture_default_str();
}

// A picture, or one number for the whole surface.
void addTextureOrValue(CLI::App& app, ViewOptions& options, const std::string& name, float& value,
                       const std::string& description) {
    app.add_option_function<std::string>(
           "--" + name,
           [&options, &value, name](const std::string& text) {
               options.dependentOptions.insert(name);
               float number = 0.0f;
               const auto [end, error] =
                   std::from_chars(text.data(), text.data() + text.size(), number);
               if (error == std::errc() && end == text.data() + text.size())
                   value = number;
               else
                   options.textures[name] = text;
           },
           description)
        ->type_name("FILE|VALUE")
        ->default_str(fmt::format("{:g}", value));
}

void addShadingOptions(CLI::App& app, ViewOptions& options) {
    using materials::ShadingModel;
    app.add_option("--shading", options.shading.model,
                   "How the surface answers light: blinn-phong, or microfacet (metallic-roughness)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, ShadingModel>{
                                                {"blinn-phong", ShadingModel::BlinnPhong},
                                                {"microfacet", ShadingModel::Microfacet}})
                        .description(""))
        ->type_name("NAME")
        ->default_str("blinn-phong");
    const auto addTexture = [&](const std::string& name, const char* description) {
        app.add_option_function<std::string>(
               "--" + name,
               [&options, name](const std::string& file) { options.textures[name] = file; },
               description)
            ->type_name("FILE");
    };
    addTexture("albedo", "Colours (sRGB) of the surface; default grey");
    addTextureOrValue(app, options, "roughness", options.shading.roughness,
                      "Roughness of the microfacet model, a picture or a number in [0,1]");
    addTextureOrValue(app, options, "metalness", options.shading.metalness,
                      "Metalness of the microfacet model, a picture or a number in [0,1]");
    addTexture("orm", "Occlusion, roughness and metalness as red, green and blue of one picture");
    app.add_option_function<std::string>(
           "--occlusion",
           [&options](const std::string& text) {
               options.bakedOcclusion = text == "baked";
               if (!options.bakedOcclusion)
                   options.textures["occlusion"] = text;
           },
           "Share of the light from all around that arrives: a picture, or baked for the channel "
           "of the map file, which follows the depth scale")
        ->type_name("FILE|baked");
}

void addFilterOptions(CLI::App& app, ViewOptions& options) {
    app.add_option_function<std::string>(
           "--level",
           [&options](const std::string& text) {
               if (text == "auto") {
                   options.level.reset();
                   return;
               }
               const double level = parseNumber(text, "--level");
               if (!(level >= 0 && level <= kMostLevels && std::nearbyint(level) == level))
                   throw CLI::ValidationError(
                       "--level", fmt::format("\"{}\" is no level, expected auto or a whole "
                                              "number from 0 to {}",
                                              text, kMostLevels));
               options.level = static_cast<int>(level);
           },
           "MIP level of the maps for all pixels, 0 being the finest; auto: each pixel takes the "
           "one of its size. Files without levels have level 0 only")
        ->type_name("auto|N")
        ->default_str("auto");
    app.add_option("--rays", options.rays,
                   "The most rays in a pixel, for pictures that do not sparkle far away: a pixel "
                   "takes as many as it covers texels of the first level")
        ->check(CLI::Range(1, kMostRays))
        ->capture_default_str();
}

void addOutputOptions(CLI::App& app, ViewOptions& options) {
    app.add_option_function<std::string>(
           "--size",
           [&options](const std::string& text) {
               const auto n = parseNumbers(text, 'x', 2, 2, "--size");
               options.width = static_cast<int>(n[0]);
               options.height = static_cast<int>(n[1]);
           },
           "Size in pixels of each picture of a headless run, or of the picture in the window, "
           "which stands beside the panel (16 to 8192)")
        ->type_name("WxH")
        ->default_str("512x512, in a window 768x768");
    app.add_flag("--headless", options.headless, "Render without a window and write -o");
    app.add_option("-o,--output", options.output,
                   "Picture of a headless run (.png, or .exr as half floats); several techniques "
                   "make a contact sheet with labels")
        ->type_name("FILE");
    app.add_option("--error", options.errorFile,
                   "Compare with the exact hits: a row of heat maps on the sheet, and the raw "
                   "errors per technique in this .exr (distance in texels, normal_angle in "
                   "degrees, verdict, steps, fetches)")
        ->type_name("MAP.exr");
    app.add_flag("--mark-exhausted", options.markExhausted,
                 "Paint pixels whose search ran out of steps magenta instead of leaving holes");
    app.add_option("--backend", options.backend, "Context of a headless run: osmesa, egl or glfw")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, gl::Backend>{{"osmesa", gl::Backend::OSMesa},
                                               {"egl", gl::Backend::Egl},
                                               {"glfw", gl::Backend::Glfw}}))
        ->default_str("osmesa");
}

void checkTechniques(const ViewOptions& options) {
    for (const std::string& name : options.techniques)
        if (name != kReferenceName)
            materials::findTechnique(name);
}

// Raw errors are channels named after techniques, and after the files where there are several.
void checkErrorOutput(const ViewOptions& options) {
    if (options.errorFile.empty())
        return;
    if (std::ranges::all_of(options.techniques,
                            [](const std::string& name) { return name == kReferenceName; }))
        throw UsageError("--error: the exact picture has no error, expected a technique");
    std::set<std::string> stems;
    for (const std::filesystem::path& file : options.files)
        if (!stems.insert(file.stem().string()).second)
            throw UsageError(
                fmt::format("--error: two files are called {}, expected different names",
                            file.stem().string()));
}

bool hasShadowParameter(const ViewOptions& options, const ParameterSetting& setting) {
    return options.shadow != kNoShadow && setting.technique.empty() &&
           std::ranges::any_of(materials::findShadowMethod(options.shadow).parameters,
                               [&](const auto& info) { return info.name == setting.name; });
}

void checkShading(const ViewOptions& options) {
    const auto given = [&](const char* name) { return options.textures.contains(name); };
    const auto check = [&](const char* name, float value) {
        if (!(value >= 0.0f && value <= 1.0f))
            throw UsageError(fmt::format("--{} {}: expected a file or 0 to 1", name, value));
        const bool isSet = options.dependentOptions.contains(name);
        if (isSet && options.shading.model != materials::ShadingModel::Microfacet)
            throw UsageError(fmt::format("--{} belongs to --shading microfacet", name));
        if (isSet && given("orm"))
            throw UsageError(fmt::format("--orm holds the {} already", name));
    };
    check("roughness", options.shading.roughness);
    check("metalness", options.shading.metalness);
    if (given("orm") && (given("occlusion") || options.bakedOcclusion))
        throw UsageError("--orm holds the occlusion already");
}

// Every --set must reach the shadows or at least one technique that is shown.
void checkParameters(const ViewOptions& options) {
    for (const ParameterSetting& setting : options.parameters) {
        const bool used = hasShadowParameter(options, setting) ||
                          std::ranges::any_of(options.techniques, [&](const std::string& name) {
                              if (name == kReferenceName)
                                  return false;
                              if (!setting.technique.empty() && setting.technique != name)
                                  return false;
                              return std::ranges::any_of(
                                  materials::findTechnique(name).parameters,
                                  [&](const auto& info) { return info.name == setting.name; });
                          });
        if (!used)
            throw UsageError(
                fmt::format("--set {}: no technique shown has a parameter of that name; "
                            "see relievo-view --list",
                            setting.name));
    }
}

}  // namespace

void addNormalsOption(CLI::App& app, std::optional<materials::SlopeSource>& normals,
                      const std::string& standard) {
    std::map<std::string, materials::SlopeSource> sources;
    for (const materials::SlopeSourceEntry& entry : materials::slopeSources())
        sources.emplace(entry.name, entry.source);
    app.add_option("--normals", normals,
                   "Where slopes come from: the map of derivatives, stored normals (normal), or "
                   "differences of depths (height); default " +
                       standard)
        ->transform(CLI::CheckedTransformer(sources).description(""))
        ->type_name("derivative|normal|height");
}

void addViewOptions(CLI::App& app, ViewOptions& options) {
    app.add_option(
        "FILE", options.files,
        "Map files made by relievo-bake relief; or one shape (made by relievo-bake shape, an "
        "SVG drawing, FONT:TEXT), or one scene (.json)");
    auto* technique = app.add_option_function<std::string>(
        "--technique", [&options](const std::string& name) { options.techniques = {name}; },
        "Technique to show; see --list. \"reference\" is the exact picture");
    technique->type_name("NAME")->default_str("exact");
    app.add_option_function<std::vector<std::string>>(
           "--compare",
           [&options](const std::vector<std::string>& names) { options.techniques = names; },
           "Techniques to show next to each other, comma separated")
        ->type_name("A,B,...")
        ->delimiter(',')
        ->excludes(technique);
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&options](const std::vector<std::string>& settings) {
               for (const std::string& text : settings)
                   options.parameters.push_back(parseSetting(text));
           },
           "Parameter of a technique (see --list): NAME=VALUE or TECHNIQUE.NAME=VALUE; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    addSceneOptions(app, options);
    addShadowOptions(app, options);
    addShadingOptions(app, options);
    addFilterOptions(app, options);
    addSolidOptions(app, options.solid);
    addOutputOptions(app, options);
    app.add_flag("--list", options.list, "List the techniques with their parameters and exit");
}

void checkOutputOptions(const ViewOptions& options) {
    if (options.files.empty())
        throw UsageError("no map file given, expected a file made by relievo-bake relief");
    if (options.headless && options.output.empty())
        throw UsageError("--headless needs -o FILE for the picture");
    if (!options.headless && (!options.output.empty() || !options.errorFile.empty()))
        throw UsageError("-o and --error belong to --headless");
    if (options.width < 16 || options.width > 8192 || options.height < 16 || options.height > 8192)
        throw UsageError(fmt::format("--size {}x{}: expected 16 to 8192 pixels a side",
                                     options.width, options.height));
    if (!(options.tiles.x > 0 && options.tiles.y > 0))
        throw UsageError("--tiles: expected two numbers above 0");
    if (!(options.camera.distance > 0))
        throw UsageError("--camera: expected a distance above 0");
}

void requireNoShadowTexels(const ViewOptions& options) {
    if (options.sceneOptions.contains("shadow-texels"))
        throw UsageError("--shadow-texels is for scenes, not for reliefs and single shapes");
}

void checkViewOptions(const ViewOptions& options) {
    if (options.list)
        return;
    checkOutputOptions(options);
    requireNoShadowTexels(options);
    if (options.object == ObjectKind::ShapeBox)
        throw UsageError("--mesh shape-box is that of shapes, expected another for a relief");
    checkTechniques(options);
    if (options.shadow != kNoShadow)
        materials::findShadowMethod(options.shadow);
    else if (options.dependentOptions.contains("light-size"))
        throw UsageError("--light-size is that of soft shadows, expected --shadow as well");
    checkShading(options);
    checkErrorOutput(options);
    checkParameters(options);
}

}  // namespace relievo::viewer
