#include "viewer/control_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "materials/shadow_registry.h"
#include "viewer/imgui_session.h"

namespace relievo::viewer {
namespace {

// Of the style in imgui_session.cpp.
constexpr float kPaddingX = 12.0f;
constexpr float kPaddingY = 10.0f;
constexpr float kSpacing = 5.0f;
constexpr float kRowHeight = kFontSize + 2 * 3.0f;

constexpr float kListLeft = 36.0f;
constexpr float kListTop = kPaddingY;
constexpr float kSliderWidth = 150.0f;
// Above so many values a linear slider cannot reach the small ones.
constexpr double kLogarithmicRange = 200.0;
const ImVec4 kWarning{1.0f, 0.62f, 0.35f, 1.0f};
const ImVec4 kQuiet{0.62f, 0.62f, 0.64f, 1.0f};

void heading(const char* text) {
    ImGui::Dummy({0.0f, 2.0f});
    ImGui::TextColored(kQuiet, "%s", text);
    ImGui::Separator();
}

// A heading that hides what is below it when it is clicked. Returns whether that is shown.
bool section(const char* text, ImGuiTreeNodeFlags flags = 0) {
    ImGui::Dummy({0.0f, 2.0f});
    ImGui::PushStyleColor(ImGuiCol_Text, kQuiet);
    const bool isOpen = ImGui::TreeNodeEx(
        text, flags | ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
    ImGui::PopStyleColor();
    ImGui::Separator();
    return isOpen;
}

void techniqueList(const char* label, const char* id, std::string& technique) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(kListLeft);
    ImGui::SetNextItemWidth(-1.0f);
    if (!ImGui::BeginCombo(id, techniqueTitle(technique).data(), ImGuiComboFlags_HeightLargest))
        return;
    int key = 1;
    for (const std::string_view name : techniqueChoices()) {
        const std::string entry = key <= 9 ? fmt::format("{}  {}", key, techniqueTitle(name))
                                           : fmt::format("    {}", techniqueTitle(name));
        if (ImGui::Selectable(entry.c_str(), name == technique))
            technique = name;
        ++key;
    }
    ImGui::EndCombo();
}

void comparisonModes(WindowSettings& settings) {
    for (std::size_t k = 0; k < kComparisonModeNames.size(); ++k) {
        if (k % 2 == 1)
            ImGui::SameLine(kPanelWidth / 2.0f);
        const auto mode = static_cast<ComparisonMode>(k);
        if (ImGui::RadioButton(kComparisonModeNames[k].data(), settings.mode == mode))
            settings.mode = mode;
    }
}

void parameterSlider(ViewOptions& options, std::string_view technique,
                     const materials::TechniqueParameter& parameter) {
    const double before = parameterValue(options, technique, parameter);
    double after = before;
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    const double smallest = parameter.isInteger ? 1.0 : parameter.minimum;
    if (parameter.minimum >= 0 && parameter.maximum > kLogarithmicRange * smallest)
        flags |= ImGuiSliderFlags_Logarithmic;
    ImGui::SetNextItemWidth(kSliderWidth);
    if (parameter.isInteger) {
        int value = static_cast<int>(before);
        if (ImGui::SliderInt(parameter.name.data(), &value, static_cast<int>(parameter.minimum),
                             static_cast<int>(parameter.maximum), "%d", flags))
            after = value;
    } else {
        auto value = static_cast<float>(before);
        if (ImGui::SliderFloat(parameter.name.data(), &value, static_cast<float>(parameter.minimum),
                               static_cast<float>(parameter.maximum), "%.3g",
                               flags | ImGuiSliderFlags_NoRoundToFormat))
            after = std::clamp<double>(value, parameter.minimum, parameter.maximum);
    }
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
        after = parameter.defaultValue;
    if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
        ImGui::SetTooltip(
            "%s", fmt::format("{}\n{:g} to {:g}, default {:g} (right click)", parameter.description,
                              parameter.minimum, parameter.maximum, parameter.defaultValue)
                      .c_str());
    if (after != before)
        setParameterValue(options, technique, parameter, after);
}

void parameterSliders(ViewOptions& options, const std::string& name) {
    if (name == kReferenceName)
        return;
    const materials::Technique& technique = materials::findTechnique(name);
    if (technique.parameters.empty())
        return;
    heading(technique.title.data());
    ImGui::PushID(technique.name.data());
    for (const materials::TechniqueParameter& parameter : technique.parameters)
        parameterSlider(options, technique.name, parameter);
    ImGui::PopID();
}

void fileList(WindowSettings& settings) {
    const auto& files = settings.options.files;
    if (files.size() < 2)
        return;
    ImGui::SetNextItemWidth(kSliderWidth);
    if (!ImGui::BeginCombo("file", files[settings.file].filename().c_str()))
        return;
    for (std::size_t k = 0; k < files.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));  // files of different folders may share a name
        if (ImGui::Selectable(files[k].filename().c_str(), k == settings.file))
            settings.file = k;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

// Where slopes come from: the first entry leaves it to what the file has.
void slopeList(ViewOptions& options) {
    const std::string_view best = "best of the file";
    const std::string_view shown =
        options.normals ? materials::slopeSourceEntry(*options.normals).title : best;
    ImGui::SetNextItemWidth(kSliderWidth);
    if (!ImGui::BeginCombo("slopes", shown.data()))
        return;
    if (ImGui::Selectable(best.data(), !options.normals))
        options.normals.reset();
    for (const materials::SlopeSourceEntry& entry : materials::slopeSources())
        if (ImGui::Selectable(entry.title.data(), options.normals == entry.source))
            options.normals = entry.source;
    ImGui::EndCombo();
}

void shadowList(ViewOptions& options) {
    ImGui::SetNextItemWidth(kSliderWidth);
    if (!ImGui::BeginCombo("shadows", options.shadow.c_str()))
        return;
    if (ImGui::Selectable(kNoShadow, options.shadow == kNoShadow))
        options.shadow = kNoShadow;
    for (const materials::ShadowMethod& method : materials::shadowMethods())
        if (ImGui::Selectable(method.name.data(), options.shadow == method.name))
            options.shadow = method.name;
    ImGui::EndCombo();
}

bool slider(const char* name, float& value, float least, float most, const char* format,
            ImGuiSliderFlags flags = 0) {
    ImGui::SetNextItemWidth(kSliderWidth);
    return ImGui::SliderFloat(name, &value, least, most, format, flags);
}

// A mesh file can be chosen where the command line named one.
void objectButtons(ViewOptions& options) {
    int object = static_cast<int>(options.object);
    const auto button = [&](const char* name, ObjectKind kind) {
        ImGui::RadioButton(name, &object, static_cast<int>(kind));
    };
    button("quad", ObjectKind::Quad);
    ImGui::SameLine(kPanelWidth / 2.0f);
    button("box", ObjectKind::Box);
    button("sphere", ObjectKind::Sphere);
    ImGui::SameLine(kPanelWidth / 2.0f);
    button("torus", ObjectKind::Torus);
    if (!options.meshFile.empty())
        button(options.meshFile.filename().string().c_str(), ObjectKind::File);
    options.object = static_cast<ObjectKind>(object);
}

void sceneControls(WindowSettings& settings) {
    if (!section("scene", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    ViewOptions& options = settings.options;
    fileList(settings);
    if (slider("depth scale", options.depthScale, 0.0f, 0.5f, "%.3f"))
        options.depthScale = std::clamp(options.depthScale, 0.0f, 1000.0f);
    ImGui::SetNextItemWidth(kSliderWidth);
    ImGui::SliderFloat2("tiles u, v", &options.tiles.x, 0.25f, 16.0f, "%.2f",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    objectButtons(options);
}

void lightControls(ViewOptions& options) {
    if (!section("light and shadows", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    slider("light azimuth", options.light.x, -180.0f, 180.0f, "%.0f°");
    slider("light elevation", options.light.y, 0.0f, 90.0f, "%.0f°");
    shadowList(options);
    // The light has a size, and the method parameters, only where there are shadows.
    if (options.shadow == kNoShadow)
        return;
    slider("light size", options.lightSize, 0.0f, 30.0f, "%.1f°");
    for (const materials::TechniqueParameter& parameter :
         materials::findShadowMethod(options.shadow).parameters)
        parameterSlider(options, "", parameter);
}

void shadingControls(ViewOptions& options) {
    using materials::ShadingModel;
    if (!section("shading"))
        return;
    slopeList(options);
    int model = static_cast<int>(options.shading.model);
    ImGui::RadioButton("Blinn–Phong", &model, static_cast<int>(ShadingModel::BlinnPhong));
    ImGui::SameLine(kPanelWidth / 2.0f);
    ImGui::RadioButton("microfacet", &model, static_cast<int>(ShadingModel::Microfacet));
    options.shading.model = static_cast<ShadingModel>(model);
    if (options.shading.model != ShadingModel::Microfacet || options.textures.contains("orm"))
        return;
    const auto share = [&](const char* name, float& value) {
        if (!options.textures.contains(name))
            slider(name, value, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    };
    share("roughness", options.shading.roughness);
    share("metalness", options.shading.metalness);
}

// Left of the finest level the slider says auto.
void levelSlider(ViewOptions& options, int levelCount) {
    constexpr int kAuto = -1;
    int level = options.level ? std::min(*options.level, levelCount - 1) : kAuto;
    ImGui::SetNextItemWidth(kSliderWidth);
    if (ImGui::SliderInt("MIP level", &level, kAuto, levelCount - 1, level == kAuto ? "auto" : "%d",
                         ImGuiSliderFlags_AlwaysClamp))
        options.level = level == kAuto ? std::nullopt : std::optional(level);
}

void pixelControls(ViewOptions& options, int levelCount) {
    if (!section("pixels"))
        return;
    ImGui::SetNextItemWidth(kSliderWidth);
    ImGui::SliderInt("most rays", &options.rays, 1, kMostRays, "%d",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (levelCount > 1)
        levelSlider(options, levelCount);
    ImGui::Checkbox("mark exhausted", &options.markExhausted);
}

// A row of the readings: `text` says what a pane has, or nothing.
void readingsRow(const char* label, const PanelReport& report, std::size_t shown,
                 const std::function<std::string(const PaneReadings&)>& text) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(kQuiet, "%s", label);
    for (std::size_t pane = 0; pane < shown; ++pane) {
        ImGui::TableNextColumn();
        const std::string value = text(report.readings[pane]);
        ImGui::TextUnformatted(value.empty() ? "–" : value.c_str());
    }
}

void workRows(const PanelReport& report, std::size_t shown) {
    const auto row = [&](const char* label, auto&& value) {
        readingsRow(label, report, shown, [&](const PaneReadings& pane) {
            return pane.work ? value(*pane.work) : std::string();
        });
    };
    row("steps a pixel", [](const WorkCounts& w) { return fmt::format("{:.1f}", w.meanSteps); });
    row("fetches a pixel",
        [](const WorkCounts& w) { return fmt::format("{:.1f}", w.meanFetches); });
    row("ran out of steps", [](const WorkCounts& w) {
        return w.pixels == 0 ? std::string()
                             : fmt::format("{:.2f} %", 100.0 * static_cast<double>(w.exhausted) /
                                                           static_cast<double>(w.pixels));
    });
}

void errorRows(const PanelReport& report, std::size_t shown) {
    using reference::ErrorStatistics;
    const auto row = [&](const char* label, auto&& value) {
        readingsRow(label, report, shown, [&](const PaneReadings& pane) {
            return pane.errors ? value(*pane.errors) : std::string();
        });
    };
    row("wrong first hits",
        [](const ErrorStatistics& e) { return fmt::format("{:.2f} %", 100 * e.wrongShare); });
    row("mean error",
        [](const ErrorStatistics& e) { return fmt::format("{:.3f} texels", e.meanDistance); });
    row("largest error",
        [](const ErrorStatistics& e) { return fmt::format("{:.1f} texels", e.maximumDistance); });
}

void readingsTable(WindowSettings& settings, const PanelReport& report) {
    heading("readings");
    const std::size_t shown = showsSecond(settings) ? 2 : 1;
    if (ImGui::BeginTable("readings", static_cast<int>(shown) + 1)) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 112.0f);
        ImGui::TableSetupColumn("A");
        if (shown == 2)
            ImGui::TableSetupColumn("B");
        if (shown == 2)
            ImGui::TableHeadersRow();
        readingsRow("frame time", report, shown, [](const PaneReadings& pane) {
            return pane.milliseconds ? fmt::format("{:.1f} ms", *pane.milliseconds) : std::string();
        });
        workRows(report, shown);
        errorRows(report, shown);
        ImGui::EndTable();
    }
    ImGui::Checkbox("measure errors", &settings.measureErrors);
    if (report.isTracing) {
        ImGui::SameLine(kPanelWidth / 2.0f);
        ImGui::TextColored(kWarning, "tracing… %.0f %%", 100.0 * report.progress);
    }
}

void problems(const WindowSettings& settings, const PanelReport& report) {
    const std::size_t shown = showsSecond(settings) ? 2 : 1;
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    for (std::size_t pane = 0; pane < shown; ++pane)
        if (!report.readings[pane].problem.empty())
            ImGui::TextWrapped("%s", report.readings[pane].problem.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

WindowPoint techniqueListCenter() {
    return {static_cast<int>(kListLeft + kPanelWidth) / 2,
            static_cast<int>(kListTop + kRowHeight / 2)};
}

WindowPoint techniqueEntryCenter(int index) {
    const float top = kListTop + kRowHeight + kPaddingY;
    return {
        techniqueListCenter().x,
        static_cast<int>(top + kFontSize / 2 + static_cast<float>(index) * (kFontSize + kSpacing))};
}

PanelActions drawControlPanel(WindowSettings& settings, const PanelReport& report, float height) {
    PanelActions actions;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({kPanelWidth, height});
    ImGui::Begin("controls", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus);
    // The first thing in the panel: techniqueListCenter counts on it.
    techniqueList("A", "##A", settings.techniqueA);
    if (showsSecond(settings))
        techniqueList("B", "##B", settings.techniqueB);
    comparisonModes(settings);
    problems(settings, report);
    parameterSliders(settings.options, settings.techniqueA);
    if (showsSecond(settings) && settings.techniqueB != settings.techniqueA)
        parameterSliders(settings.options, settings.techniqueB);
    sceneControls(settings);
    lightControls(settings.options);
    shadingControls(settings.options);
    pixelControls(settings.options, report.levelCount);
    readingsTable(settings, report);
    ImGui::Dummy({0.0f, 2.0f});
    actions.save = ImGui::Button("Save picture");
    ImGui::SameLine();
    actions.resetCamera = ImGui::Button("Reset view");
    ImGui::SameLine();
    actions.help = ImGui::Button("Help (F1)");
    if (!report.message.empty())
        ImGui::TextWrapped("%s", report.message.c_str());
    ImGui::End();
    return actions;
}

}  // namespace relievo::viewer
