#include "bench/sample_stages.h"

#include <array>

#include "bench/stopwatch.h"
#include "bench/technique_maps.h"
#include "preprocess/relief_baker.h"
#include "textures/sample_reliefs.h"

namespace relievo::bench {

double frameSeconds(SampleStage& stage, materials::ReliefMaterial& material,
                    const viewer::View& view, int repeat) {
    const auto draw = [&] {
        stage.renderer.draw(material, view, stage.target);
        glFinish();
    };
    // The first frame compiles the program and uploads the maps.
    draw();
    return leastSeconds(repeat, draw);
}

SampleStages::SampleStages(const std::string& sample, const StageSetting& setting)
    : name_(sample),
      setting_(setting),
      relief_(textures::generateSampleRelief(sample, setting.size, setting.size)) {}

SampleStage& SampleStages::of(const materials::Technique& technique,
                              const materials::ShadowMethod* shadow) {
    preprocess::ReliefPlan plan = planFor(technique, shadow);
    if (setting_.slopes)
        if (const auto map = materials::slopeSourceEntry(*setting_.slopes).map;
            !map.empty() && !plan.has(map))
            plan.maps.emplace_back(map);
    const std::string key = preprocess::optionWords(plan);
    if (const auto found = stages_.find(key); found != stages_.end())
        return found->second;
    SampleStage stage{
        viewer::SceneRenderer(preprocess::bakeRelief(relief_, plan), name_, {}),
        gl::Framebuffer(setting_.width, setting_.height, std::array<GLenum, 1>{GL_RGBA8})};
    stage.renderer.setSurface(surfaces::makeQuad(setting_.tiles, 1.0f));
    return stages_.emplace(key, std::move(stage)).first->second;
}

}  // namespace relievo::bench
