#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gl/context.h"
#include "materials/relief_material.h"
#include "materials/slope_sources.h"
#include "materials/surface_textures.h"
#include "viewer/camera.h"
#include "viewer/solid_options.h"

namespace CLI {
class App;
}

namespace relievo::viewer {

/// Names no shadow method in --shadow.
inline constexpr const char* kNoShadow = "none";

/// The most that --rays takes.
inline constexpr int kMostRays = 64;

/// The object that carries the relief or the solid; File: a mesh that is read; ShapeBox: the box
/// that a whole solid is in.
enum class ObjectKind { Quad, Box, Sphere, Torus, File, ShapeBox };

/// A value for a technique's parameter: "NAME=VALUE" for all techniques that have it, or
/// "TECHNIQUE.NAME=VALUE".
struct ParameterSetting {
    std::string technique;  ///< empty for all
    std::string name;
    double value = 0.0;

    friend bool operator==(const ParameterSetting&, const ParameterSetting&) = default;
};

/// What the command line of relievo-view asks for.
struct ViewOptions {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> techniques;  ///< of the registry, or "reference"
    std::vector<ParameterSetting> parameters;
    ObjectKind object = ObjectKind::Quad;
    std::filesystem::path meshFile;  ///< of ObjectKind::File; stays when another object is chosen
    SolidOptions solid;              ///< of a shape
    float depthScale = 0.1f;
    glm::vec2 tiles{1.0f};
    OrbitCamera camera;
    glm::vec2 light{-50.0f, 40.0f};  ///< azimuth and elevation in degrees
    float lightSize = 0.0f;          ///< what the light's disc spans in degrees; 0: a point
    std::string shadow = kNoShadow;  ///< of materials::shadowMethods(), or kNoShadow
    int shadowTexels = 2048;         ///< of a scene's shadow map, on a side
    int width = 512;
    int height = 512;
    /// Where slopes come from; none: the best source that the file has.
    std::optional<materials::SlopeSource> normals;
    materials::Shading shading;
    /// Pictures by the names of materials::surfaceTextureFormats().
    std::map<std::string, std::filesystem::path> textures;
    /// Those of --roughness, --metalness and --light-size that the command line has: alone they
    /// would do nothing.
    std::set<std::string> dependentOptions;
    /// Those of --camera, --light and --shadow-texels that the command line has: the first two go
    /// over a scene's own, the last is for scenes alone.
    std::set<std::string> sceneOptions;
    bool bakedOcclusion = false;            ///< take the occlusion of the map file
    std::optional<int> level;               ///< the MIP level for all pixels; none: each its own
    int rays = materials::kUsualPixelRays;  ///< the most in a pixel
    std::filesystem::path output;           ///< headless: the picture
    std::filesystem::path errorFile;        ///< headless: raw errors
    bool headless = false;
    bool list = false;
    bool markExhausted = false;
    gl::Backend backend = gl::Backend::OSMesa;  ///< of a headless run

    friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

/// The name of the exact picture in --technique and --compare.
inline constexpr std::string_view kReferenceName = "reference";

/// Adds `--normals`: where slopes come from. `standard` tells the help what they do by default,
/// when `normals` stays empty.
void addNormalsOption(CLI::App& app, std::optional<materials::SlopeSource>& normals,
                      const std::string& standard);

/// Adds the options of relievo-view to `app`; parsing fills `options`.
void addViewOptions(CLI::App& app, ViewOptions& options);

/// Checks what the parser cannot: options that do not go together, names of techniques and
/// parameters. Throws commands::UsageError or textures::InputError.
void checkViewOptions(const ViewOptions& options);

/// Throws commands::UsageError when the command line has --shadow-texels: what is shown is no
/// scene.
void requireNoShadowTexels(const ViewOptions& options);

/// The part of it that concerns scenes and shapes as well: sizes, and what goes with --headless.
void checkOutputOptions(const ViewOptions& options);

}  // namespace relievo::viewer
