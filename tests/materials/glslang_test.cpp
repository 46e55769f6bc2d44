// The reference compiler for GLSL accepts every program that the registry can make, not only the
// driver that the other tests run on.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "materials/program_cache.h"
#include "materials/shadow_registry.h"
#include "materials/solid_registry.h"
#include "materials/technique_registry.h"
#include "tests/commands/process.h"

namespace relievo::materials {
namespace {

// What a map may ask a technique's text to define.
const std::vector<std::vector<shaders::Define>> kVariants = {
    {},
    {{"RELIEVO_CONE_RADIUS", "1"}, {"RELIEVO_DEPTH_REVERSED", "1"}},
    {{"RELIEVO_CONE_BILINEAR", "1"}, {"RELIEVO_WRAP_MIRROR", "1"}},
    {{"RELIEVO_CONE_BILINEAR", "1"}, {"RELIEVO_CONE_SECTORS", "8"}, {"RELIEVO_WRAP_MIRROR", "1"}},
    {{"RELIEVO_WRAP_CLAMP", "1"}, {"RELIEVO_CLIP_ZERO_TO_ONE", "1"}},
    {{"RELIEVO_SLOPES_FROM_NORMAL", "1"}, {"RELIEVO_WRAP_MIRROR", "1"}},
    {{"RELIEVO_SLOPES_FROM_HEIGHT", "1"}},
    {{"RELIEVO_SLOPES_FROM_HEIGHT", "1"}, {"RELIEVO_MIPS", "1"}},
    {{"RELIEVO_MIPS", "1"}, {"RELIEVO_PIXEL_RAYS", "1"}},
    {{"RELIEVO_MIPS", "1"}, {"RELIEVO_WRAP_MIRROR", "1"}},
    {{"RELIEVO_MIPS", "1"}, {"RELIEVO_WRAP_CLAMP", "1"}},
    {{"RELIEVO_SHADOW_MAP", "1"}, {"RELIEVO_ALBEDO_MAP", "1"}, {"RELIEVO_MARK_EXHAUSTED", "1"}}};

// What a texture set may ask the shading's text to define.
const std::vector<std::vector<shaders::Define>> kShadings = {
    {},
    {{"RELIEVO_OCCLUSION_MAP", "1"}, {"RELIEVO_OCCLUSION_BAKED", "1"}},
    {{"RELIEVO_ORM_MAP", "1"}},
    {{"RELIEVO_MICROFACET", "1"}},
    {{"RELIEVO_MICROFACET", "1"}, {"RELIEVO_ORM_MAP", "1"}},
    {{"RELIEVO_MICROFACET", "1"},
     {"RELIEVO_ALBEDO_MAP", "1"},
     {"RELIEVO_ROUGHNESS_MAP", "1"},
     {"RELIEVO_METALNESS_MAP", "1"},
     {"RELIEVO_OCCLUSION_MAP", "1"}}};

constexpr const char* kEsHeader =
    "#version 300 es\n"
    "precision highp float;\n"
    "precision highp int;\n"
    "precision highp sampler2D;\n"
    "precision highp sampler2DArray;";

// Compiles fragment shaders, all in one run of the compiler.
class Glslang {
  public:
    void add(const std::string& name, const std::string& text) {
        const std::string file = folder_.file(name + ".frag");
        std::ofstream(file) << text;
        command_.push_back(file);
    }
    [[nodiscard]] tests::ProcessResult run() const { return tests::runProcess(command_); }

  private:
    tests::ScratchFolder folder_;
    std::vector<std::string> command_ = {RELIEVO_GLSLANG_VALIDATOR};
};

TEST(GlslangTest, AcceptsEveryProgram) {
    Glslang compiler;
    const std::vector<shaders::Define> plain = {{"RELIEVO_PLAIN", "1"},
                                                {"RELIEVO_SHADOW_MAP", "1"}};
    for (const std::string fragment : {"plain", "coverage", "visible"})
        compiler.add(fragment,
                     expandFragment("relievo/programs/" + fragment + ".frag", {}, plain).text);
    for (std::size_t k = 0; k < kShadings.size(); ++k)
        compiler.add("shading-" + std::to_string(k),
                     expandFragment("relievo/programs/shaded.frag", {findTechnique("normal").file},
                                    kShadings[k])
                         .text);
    for (const Technique& technique : techniques())
        for (const std::string fragment : {"shaded", "measured", "visible", "depth"})
            for (std::size_t k = 0; k < kVariants.size(); ++k)
                compiler.add(std::string(technique.name) + "-" + fragment + "-" + std::to_string(k),
                             expandFragment("relievo/programs/" + fragment + ".frag",
                                            {technique.file}, kVariants[k])
                                 .text);
    for (const Technique* technique : {&findTechnique("exact"), &findTechnique("cone")})
        for (const ShadowMethod& method : shadowMethods())
            for (const std::string fragment : {"shaded", "measured"})
                for (std::size_t k = 0; k < kVariants.size(); ++k) {
                    std::vector<shaders::Define> defines = kVariants[k];
                    defines.push_back({"RELIEVO_SHADOW", "1"});
                    compiler.add(
                        fmt::format("{}-{}-{}-{}", method.name, technique->name, fragment, k),
                        expandFragment("relievo/programs/" + fragment + ".frag",
                                       {technique->file, method.file}, defines)
                            .text);
                }
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

constexpr const char* kEsMain = R"glsl(
#include "relievo/pixel_rays.glsl"
#include "relievo/seen_normals.glsl"
#include "relievo/shading.glsl"
uniform mat4 viewProjection;
uniform ReliefSurface middle;
uniform vec3 view;
out vec4 color;
void main() {
    ReliefPixel pixel = reliefPixel(middle, reliefAspect());
    ReliefSurface surface = reliefPixelSurface(pixel, pixel.rays - 1);
    ReliefFragment relief = traceRelief(surface, view, reliefRayFootprint(pixel, pixel.rays - 1));
    vec2 uv = relief.hit.position.xy;
    ReliefAppearance appearance = reliefAppearance(uv, dFdx(uv), dFdy(uv), relievoDepthScale);
    ReliefNormals normals = reliefSeenNormals(surface, relief);
    color = vec4(shadeRelief(appearance, normals, -view, -view, vec3(1.0)), 1.0);
    gl_FragDepth = reliefWindowDepth(relief.hit, relief.position, viewProjection);
}
)glsl";

// What the searches and the shading are made of is GLSL ES 3.00 as well.
TEST(GlslangTest, AcceptsEveryTechniqueInGlslEs) {
    const auto expand = [](const Technique& technique,
                           const std::vector<shaders::Define>& defines) {
        return shaders::expandShader("fragment shader",
                                     "#include \"" + std::string(technique.file) + "\"\n" + kEsMain,
                                     kEsHeader, defines)
            .text;
    };
    Glslang compiler;
    for (std::size_t k = 0; k < kShadings.size(); ++k)
        compiler.add("shading-" + std::to_string(k), expand(findTechnique("normal"), kShadings[k]));
    for (const Technique& technique : techniques())
        for (std::size_t k = 0; k < kVariants.size(); ++k)
            compiler.add(std::string(technique.name) + "-" + std::to_string(k),
                         expand(technique, kVariants[k]));
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

TEST(GlslangTest, AcceptsEveryShadowMethodInGlslEs) {
    constexpr const char* kMain = R"glsl(
uniform ReliefSurface surface;
uniform vec3 view;
uniform vec3 toLight;
out vec4 color;
void main() {
    ReliefFragment relief = traceRelief(surface, view);
    color = vec4(reliefVisibility(makeReliefLight(surface, relief.hit.position, toLight, 0.1)));
}
)glsl";
    Glslang compiler;
    for (const ShadowMethod& method : shadowMethods())
        for (std::size_t k = 0; k < kVariants.size(); ++k)
            compiler.add(
                fmt::format("{}-{}", method.name, k),
                shaders::expandShader("fragment shader",
                                      fmt::format("#include \"{}\"\n#include \"{}\"\n{}",
                                                  findTechnique("exact").file, method.file, kMain),
                                      kEsHeader, kVariants[k])
                    .text);
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

// A solid as the search of a SolidMaterial may meet it.
struct SolidVariant {
    std::string name;
    std::string_view file;
    std::vector<shaders::Define> defines;
};

// Every search, in a box and in a surface, of one and of three parts, of all kinds that it shows.
std::vector<SolidVariant> solidVariants() {
    std::vector<SolidVariant> variants;
    for (const SolidTechnique& technique : solidTechniques())
        for (const bool isBox : {false, true})
            for (const int parts :
                 technique.capabilities.compounds ? std::vector{1, 3} : std::vector{1})
                for (int kinds = 0; kinds < 1 << parts; ++kinds) {
                    const bool hasRevolution = kinds != 0;
                    const bool hasExtrusion = kinds != (1 << parts) - 1;
                    if ((hasRevolution && !technique.capabilities.revolution) ||
                        (hasExtrusion && !technique.capabilities.extrusion))
                        continue;
                    SolidVariant variant{
                        fmt::format("{}-{}-{}-{}", technique.technique.name,
                                    isBox ? "box" : "surface", parts, kinds),
                        technique.technique.file,
                        {{"RELIEVO_SOLID", "1"}, {"RELIEVO_SOLID_PARTS", std::to_string(parts)}}};
                    for (int part = 0; part < parts; ++part)
                        variant.defines.push_back({fmt::format("RELIEVO_SOLID_KIND{}", part),
                                                   std::to_string(kinds >> part & 1)});
                    if (isBox)
                        variant.defines.push_back({"RELIEVO_SHAPE_BOX", "1"});
                    variants.push_back(variant);
                    // Creases change the search of a kind, not how parts are joined.
                    if (!technique.capabilities.creases || (parts > 1 && kinds != 2))
                        continue;
                    variant.name += "-creased";
                    variant.defines.push_back({"RELIEVO_SOLID_CREASED", "1"});
                    variants.push_back(std::move(variant));
                }
    return variants;
}

// What a renderer may ask the programs of solids to define.
const std::vector<std::vector<shaders::Define>> kSolidPrograms = {
    {},
    {{"RELIEVO_SOLID_SHADOW", "1"}, {"RELIEVO_MARK_EXHAUSTED", "1"}},
    {{"RELIEVO_SOLID_SHADOW", "1"}, {"RELIEVO_SHADOW_MAP", "1"}, {"RELIEVO_ALBEDO_MAP", "1"}},
    {{"RELIEVO_CLIP_ZERO_TO_ONE", "1"}, {"RELIEVO_DEPTH_REVERSED", "1"}}};

TEST(GlslangTest, AcceptsEverySearchOfSolids) {
    Glslang compiler;
    for (const SolidVariant& variant : solidVariants())
        for (const std::string fragment : {"solid_shaded", "solid_measured", "solid_depth"})
            for (std::size_t k = 0; k < kSolidPrograms.size(); ++k) {
                std::vector<shaders::Define> defines = variant.defines;
                std::ranges::copy(kSolidPrograms[k], std::back_inserter(defines));
                compiler.add(fmt::format("{}-{}-{}", variant.name, fragment, k),
                             expandFragment("relievo/programs/" + fragment + ".frag",
                                            {variant.file}, defines)
                                 .text);
            }
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

TEST(GlslangTest, AcceptsEverySearchOfSolidsInGlslEs) {
    constexpr const char* kMain = R"glsl(
#include "relievo/shading.glsl"
#include "relievo/solid_material.glsl"
uniform mat4 viewProjection;
uniform ReliefSurface surface;
uniform vec3 view;
uniform vec3 toLight;
out vec4 color;
void main() {
#ifdef RELIEVO_SHAPE_BOX
    SolidTrace trace = traceSolid(surface.position, view, vec4(0.0, 0.0, 1.0, 1.0), viewProjection);
#else
    SolidTrace trace = traceSolid(surface, view);
#endif
    if (!solidIsShown(trace)) discard;
    SolidSurface seen = solidSurface(trace, view, dFdx(surface.position), dFdy(surface.position),
                                     dFdx(view), dFdy(view));
    ReliefAppearance appearance = reliefAppearance(seen.uv, seen.uvX, seen.uvY, 1.0);
    vec3 light = vec3(solidIsLit(trace, toLight) ? 1.0 : 0.0);
    color = vec4(shadeRelief(appearance, trace.normal, toLight, -view, light), 1.0);
    gl_FragDepth = solidWindowDepth(trace, viewProjection);
}
)glsl";
    Glslang compiler;
    for (const SolidVariant& variant : solidVariants())
        compiler.add(variant.name,
                     shaders::expandShader("fragment shader",
                                           fmt::format("#include \"{}\"\n{}", variant.file, kMain),
                                           kEsHeader, variant.defines)
                         .text);
    const tests::ProcessResult result = compiler.run();
    EXPECT_EQ(result.exitStatus, 0) << result.output;
}

TEST(GlslangTest, RefusesABrokenProgramAmongOthers) {
    Glslang compiler;
    compiler.add("good", "#version 450 core\nvoid main() {}\n");
    compiler.add("broken", "#version 450 core\nvoid main() { undeclared = 1; }\n");
    const tests::ProcessResult result = compiler.run();
    EXPECT_NE(result.exitStatus, 0);
    EXPECT_THAT(result.output, testing::HasSubstr("undeclared"));
}

}  // namespace
}  // namespace relievo::materials
