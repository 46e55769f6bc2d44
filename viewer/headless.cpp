#include "viewer/headless.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <memory>
#include <optional>

#include "commands/program.h"
#include "gl/context.h"
#include "reference/error_metrics.h"
#include "viewer/contact_sheet.h"
#include "viewer/error_image.h"
#include "viewer/heat_map.h"
#include "viewer/light_errors.h"
#include "viewer/view_session.h"

namespace relievo::viewer {
namespace {

// What one file contributes to the output.
struct FileResult {
    std::vector<SheetCell> pictures;
    std::vector<SheetCell> heatMaps;
    std::vector<NamedPlane> errors;
};

class HeadlessRun {
  public:
    // `relief` names the relief on the sheet and in the raw errors; "" when there is only one.
    HeadlessRun(SceneRenderer& renderer, const ViewOptions& options, std::string relief)
        : renderer_(renderer),
          options_(options),
          relief_(std::move(relief)),
          view_(makeView(options,
                         static_cast<float>(options.width) / static_cast<float>(options.height))),
          target_(options.width, options.height, std::array<GLenum, 1>{GL_RGBA8}) {}

    FileResult run() {
        for (const std::string& name : options_.techniques) {
            if (name == kReferenceName)
                addReference();
            else
                addTechnique(materials::findTechnique(name));
        }
        return std::move(result_);
    }

  private:
    // The exact hits are the same for all techniques: traced once, when they are first needed.
    const ReferenceFrame& reference() {
        if (!reference_) {
            const auto start = std::chrono::steady_clock::now();
            reference_ = renderer_.trace(view_, options_.width, options_.height);
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
            commands::say(fmt::format("  exact reference: {} rays in {:.2f} s",
                                      reference_->pixels.size(), time.count()));
        }
        return *reference_;
    }

    Picture readTarget() const {
        Picture picture(options_.width, options_.height);
        picture.rgba = target_.read(0);
        return picture;
    }

    void addReference() {
        renderer_.drawReference(reference(), view_, target_);
        result_.pictures.push_back(
            {readTarget(), withRelief("exact reference", " "), "first hits in double precision"});
        if (!options_.errorFile.empty())
            result_.heatMaps.push_back(explanationCell());
    }

    std::string withRelief(std::string_view text, std::string_view separator) const {
        return relief_.empty() ? std::string(text)
                               : fmt::format("{}{}{}", relief_, separator, text);
    }

    // Under the exact picture there is no error to show: the place serves the scale's explanation.
    SheetCell explanationCell() const {
        Picture empty(options_.width, options_.height);
        for (std::size_t k = 0; k < empty.rgba.size(); ++k)
            empty.rgba[k] = k % 4 == 3 ? 1.0f : 0.13f;
        return {empty, "distance from the exact hit", "along the ray; wrong: by over a texel"};
    }

    void addTechnique(const materials::Technique& technique) {
        materials::ReliefMaterial material = makeConfiguredMaterial(renderer_, technique, options_);
        renderer_.draw(material, view_, target_);
        const MeasuredFrame frame =
            renderer_.measure(material, view_, options_.width, options_.height);
        const WorkCounts work = countWork(frame);
        std::string counts =
            fmt::format("{:.1f} steps, {:.1f} fetches a pixel", work.meanSteps, work.meanFetches);
        if (work.exhausted > 0)
            counts += fmt::format(", {} ran out", work.exhausted);
        commands::say(fmt::format("  {}: {}", technique.title, counts));
        result_.pictures.push_back({readTarget(), withRelief(technique.title, " "), counts});
        if (!options_.errorFile.empty())
            addErrors(technique, frame);
    }

    void addErrors(const materials::Technique& technique, const MeasuredFrame& frame) {
        const textures::DepthMap& map = renderer_.depthMap();
        const auto comparisons = compareFrames(frame, reference(), map, view_.depthScale);
        const double texel = 1.0 / map.width();
        const reference::ErrorStatistics errors = reference::summarizeErrors(comparisons, texel);
        const std::string summary =
            fmt::format("{:.2f} % wrong, mean {:.3f}, max {:.1f} texels", 100 * errors.wrongShare,
                        errors.meanDistance / texel, errors.maximumDistance / texel);
        commands::say(
            fmt::format("    against the exact hits: {}, 99 % within {:.2f}, normals {:.2f}°",
                        summary, errors.percentile99Distance / texel, errors.meanNormalAngle));
        const ErrorImage image = makeErrorImage(frame, reference(), map, view_.depthScale);
        result_.heatMaps.push_back(
            {heatMap(image), fmt::format("error of {}", technique.title), summary});
        for (NamedPlane& plane : namedPlanes(image, withRelief(technique.name, ".")))
            result_.errors.push_back(std::move(plane));
        if (view_.lightRays > 0)
            addLightErrors(technique, frame);
    }

    void addLightErrors(const materials::Technique& technique, const MeasuredFrame& frame) {
        const LightErrors errors = summarizeLight(frame, reference());
        commands::say(fmt::format(
            "    shadows by \"{}\": {:.2f} % wrong, mean {:.4f} of the light, {:.1f} fetches a "
            "pixel",
            options_.shadow, 100 * errors.wrongShare, errors.meanError, errors.meanFetches));
        result_.errors.push_back({withRelief(fmt::format("{}.light", technique.name), "."),
                                  lightErrorPlane(frame, reference())});
    }

    SceneRenderer& renderer_;
    const ViewOptions& options_;
    std::string relief_;
    View view_;
    gl::Framebuffer target_;
    std::optional<ReferenceFrame> reference_;
    FileResult result_;
};

// A single technique without errors is a plain picture; anything else is a sheet.
Picture assemble(std::vector<FileResult>& results, bool withErrors) {
    if (results.size() == 1 && results[0].pictures.size() == 1 && !withErrors)
        return std::move(results[0].pictures[0].picture);
    std::vector<std::vector<SheetCell>> rows;
    for (FileResult& result : results) {
        rows.push_back(std::move(result.pictures));
        if (withErrors)
            rows.push_back(std::move(result.heatMaps));
    }
    const int width = rows.front().front().picture.width;
    const int columns = static_cast<int>(rows.front().size());
    const Picture footer =
        withErrors ? heatScale(std::max(480, std::min(columns, 2) * width)) : Picture();
    return makeContactSheet(rows, footer);
}

}  // namespace

void runHeadless(const ViewOptions& options) {
    // Outputs that cannot be written are found out before the work, not after it.
    requirePictureFile(options.output);
    if (!options.errorFile.empty())
        requireChannelFile(options.errorFile);
    const auto context = gl::createContext(options.backend);
    commands::say(context->description());
    std::vector<FileResult> results;
    std::vector<NamedPlane> errors;
    for (const std::filesystem::path& file : options.files) {
        const auto renderer = openRelief(file, options);
        commands::say(fmt::format("{}: {}x{}, {}", file.string(), renderer->depthMap().width(),
                                  renderer->depthMap().height(),
                                  textures::wrapModeName(renderer->depthMap().wrap)));
        const std::string relief = options.files.size() > 1 ? file.stem().string() : "";
        results.push_back(HeadlessRun(*renderer, options, relief).run());
        std::ranges::move(results.back().errors, std::back_inserter(errors));
    }
    if (!options.errorFile.empty()) {
        writeChannels(options.errorFile, errors);
        commands::say(fmt::format("wrote {}", options.errorFile.string()));
    }
    writePicture(options.output, assemble(results, !options.errorFile.empty()));
    commands::say(fmt::format("wrote {}", options.output.string()));
}

}  // namespace relievo::viewer
