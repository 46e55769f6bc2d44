#include "bench/shading_sheet.h"

#include <fmt/format.h>

#include <array>

#include "bench/technique_maps.h"
#include "preprocess/relief_baker.h"
#include "textures/sample_albedo.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {
namespace {

constexpr float kLightElevation = 35.0f;  // degrees
constexpr float kDepthScales[] = {0.0f, 0.05f, 0.2f};

enum class Colours { OfTheSample, Grey };

struct Substance {
    std::string_view title;
    Colours colours;
    materials::Shading shading;
};

constexpr Substance kSubstances[] = {
    {"Blinn-Phong", Colours::OfTheSample, {}},
    {"microfacets, a dielectric",
     Colours::OfTheSample,
     {.model = materials::ShadingModel::Microfacet, .roughness = 0.35f}},
    {"microfacets, a metal",
     Colours::Grey,
     {.model = materials::ShadingModel::Microfacet, .roughness = 0.4f, .metalness = 1.0f}}};

viewer::SceneRenderer makeRenderer(const SheetOptions& options, Colours colours) {
    preprocess::ReliefPlan plan = planFor(materials::findTechnique("exact"));
    plan.maps.emplace_back("occlusion");
    textures::MapSet maps = preprocess::bakeRelief(
        textures::generateSampleRelief(options.sample, options.size, options.size), plan);
    materials::TextureSet set;
    set.pictures["occlusion"] = {*maps.find("occlusion")};
    set.occlusionScale = static_cast<float>(plan.normalScale);
    if (colours == Colours::OfTheSample) {
        const auto albedo =
            textures::generateSampleAlbedo(options.sample, options.size, options.size);
        set.pictures["albedo"].assign(albedo.begin(), albedo.end());
    }
    viewer::SceneRenderer renderer(std::move(maps), options.sample, std::move(set));
    renderer.setSurface(surfaces::makeQuad(kSheetTiles, 1.0f));
    return renderer;
}

}  // namespace

viewer::Picture makeShadingSheet(const SheetOptions& options) {
    const auto context = gl::createContext(options.backend);
    std::array renderers = {makeRenderer(options, Colours::OfTheSample),
                            makeRenderer(options, Colours::Grey)};
    gl::Framebuffer target(options.width, options.height, std::array<GLenum, 1>{GL_RGBA8});
    viewer::View view = sheetView(options, kLightElevation);
    std::vector<viewer::SheetCell> cells;
    for (const float depthScale : kDepthScales)
        for (const Substance& substance : kSubstances) {
            viewer::SceneRenderer& renderer =
                renderers[static_cast<std::size_t>(substance.colours)];
            view.depthScale = depthScale;
            view.shading = substance.shading;
            materials::ReliefMaterial material =
                renderer.makeMaterial(materials::findTechnique("exact"));
            renderer.draw(material, view, target);
            cells.push_back({pictureIn(target), std::string(substance.title),
                             fmt::format("depth scale {:g}", depthScale)});
        }
    return sheetOf(cells, static_cast<int>(std::size(kSubstances)));
}

}  // namespace relievo::bench
