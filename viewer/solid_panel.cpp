#include "viewer/solid_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <utility>

#include "materials/shadow_registry.h"
#include "materials/solid_registry.h"
#include "viewer/panel_widgets.h"

namespace relievo::viewer {
namespace {

using solids::ProfileShape;
using solids::SolidKind;
using solids::SolidTexturing;

// Ranges of sliders. Typing goes beyond some of them, as far as the command line does.
constexpr double kMostTypedOffset = 10.0;  // tile widths
constexpr float kMostDepthScale = 1.0f;
constexpr float kMostTypedDepthScale = 1000.0f;
constexpr float kLeastDepth = 0.01f;  // of a shape box, which cannot be flat
constexpr float kLeastTiles = 0.25f;
constexpr float kMostTiles = 8.0f;
constexpr int kMostDepthTiles = 16;
constexpr float kLeastEdge = 0.05f;
constexpr float kMostEdge = 1.0f;  // fits the view that a window begins with
constexpr float kMostTypedEdge = 1000.0f;

constexpr std::array kCurves = {ProfileShape::Bevel, ProfileShape::Round, ProfileShape::Cove,
                                ProfileShape::Ogee};
constexpr std::array kTexturings = {SolidTexturing::PlanarZ,        SolidTexturing::PlanarY,
                                    SolidTexturing::PlanarDiagonal, SolidTexturing::Cylindrical,
                                    SolidTexturing::Spherical,      SolidTexturing::Box};

template <typename Choice>
using Named = std::pair<const char*, Choice>;

void preciseSlider(const char* name, double& value, float least, float most, const char* format,
                   ImGuiSliderFlags flags = 0) {
    auto number = static_cast<float>(value);
    if (slider(name, number, least, most, format, flags))
        value = number;
}

void offsetSlider(const char* name, double& offset) {
    preciseSlider(name, offset, -kMostOffset, kMostOffset, "%.3f");
    offset = std::clamp(offset, -kMostTypedOffset, kMostTypedOffset);
}

template <typename Choice, std::size_t count>
void radioRow(Choice& chosen, const std::array<Named<Choice>, count>& choices) {
    constexpr float kColumn = (kPanelWidth - kPaddingX) / static_cast<float>(count);
    for (std::size_t k = 0; k < count; ++k) {
        if (k > 0)
            ImGui::SameLine(kPaddingX + static_cast<float>(k) * kColumn);
        if (ImGui::RadioButton(choices[k].first, chosen == choices[k].second))
            chosen = choices[k].second;
    }
}

template <typename Choices, typename Choice, typename Name>
void list(const char* label, Choice& chosen, const Choices& choices, Name&& name) {
    ImGui::SetNextItemWidth(kSliderWidth);
    if (!ImGui::BeginCombo(label, name(chosen).data()))
        return;
    for (const Choice choice : choices)
        if (ImGui::Selectable(name(choice).data(), choice == chosen))
            chosen = choice;
    ImGui::EndCombo();
}

// Begins with the extension at the top of the panel: extensionSliderEnd counts on it.
void outlineControls(SolidOptions& solid) {
    offsetSlider("extension e", solid.extension);
    if (solid.kind == SolidKind::Revolution)
        return;
    offsetSlider("bevel b", solid.bevel);
    preciseSlider("chamfer c", solid.chamfer, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    list("curve", solid.curve, kCurves, solids::profileShapeName);
}

void revolutionControls(SolidOptions& solid) {
    glm::vec2 axis(solid.axis);
    ImGui::SetNextItemWidth(kSliderWidth);
    if (ImGui::SliderFloat2("axis u, v", &axis.x, 0.0f, 1.0f, "%.2f"))
        solid.axis = axis;
    ImGui::SetNextItemWidth(kSliderWidth);
    ImGui::SliderInt("depth tiles", &solid.depthTiles, 1, kMostDepthTiles, "%d",
                     ImGuiSliderFlags_AlwaysClamp);
}

// An extrusion in a box that is not distorted is as deep as the depth scale says.
bool followsDepthScale(const ViewOptions& options) {
    return options.object != ObjectKind::ShapeBox ||
           (options.solid.kind == SolidKind::Extrusion && options.solid.boxSize.x == 0.0f);
}

void depthControls(ViewOptions& options) {
    if (!followsDepthScale(options))
        return;
    const bool isBox = options.object == ObjectKind::ShapeBox;
    const float least = isBox ? kLeastDepth : 0.0f;
    if (slider("depth scale", options.depthScale, least, kMostDepthScale, "%.3f"))
        options.depthScale = std::clamp(options.depthScale, least, kMostTypedDepthScale);
}

glm::vec3 undistortedSize(const ViewOptions& options, const textures::ShapeMap& shape) {
    SolidOptions solid = options.solid;
    solid.boxSize = glm::vec3(0.0f);
    return glm::max(glm::vec3(boxSizeOf(solid, shape, options.tiles, options.depthScale)),
                    kLeastEdge);
}

// The box has the size that is set, or that which distorts nothing.
void boxControls(ViewOptions& options, const textures::ShapeMap& shape) {
    glm::vec3& edges = options.solid.boxSize;
    bool isUndistorted = edges.x == 0.0f;
    if (ImGui::Checkbox("undistorted", &isUndistorted))
        edges = isUndistorted ? glm::vec3(0.0f) : undistortedSize(options, shape);
    if (isUndistorted)
        return;
    constexpr std::array kNames = {"size S x", "size S y", "size S z"};
    for (int axis = 0; axis < 3; ++axis)
        if (slider(kNames[static_cast<std::size_t>(axis)], edges[axis], kLeastEdge, kMostEdge,
                   "%.2f"))
            edges[axis] = std::clamp(edges[axis], kLeastEdge, kMostTypedEdge);
}

void objectControls(ViewOptions& options, const textures::ShapeMap& shape) {
    if (!section("object", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    radioRow<ObjectKind, 3>(options.object, {{{"quad", ObjectKind::Quad},
                                              {"box", ObjectKind::Box},
                                              {"shape box", ObjectKind::ShapeBox}}});
    ImGui::SetNextItemWidth(kSliderWidth);
    ImGui::SliderFloat2("tiles u, v", &options.tiles.x, kLeastTiles, kMostTiles, "%.2f",
                        ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    depthControls(options);
    if (options.object == ObjectKind::ShapeBox)
        boxControls(options, shape);
    else
        ImGui::Checkbox("floor around the solid", &options.solid.hasFloor);
}

void shapeControls(ViewOptions& options, const textures::ShapeMap& shape) {
    SolidOptions& solid = options.solid;
    outlineControls(solid);
    radioRow<SolidKind, 2>(
        solid.kind, {{{"extrusion", SolidKind::Extrusion}, {"revolution", SolidKind::Revolution}}});
    if (solid.kind == SolidKind::Revolution)
        revolutionControls(solid);
    if (options.textures.contains("albedo"))
        list("texturing", solid.texturing, kTexturings, solids::solidTexturingName);
    objectControls(options, shape);
}

void searchControls(ViewOptions& options) {
    if (!section("search", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    const auto techniques = materials::solidTechniques();
    std::string& chosen = options.techniques.front();
    ImGui::SetNextItemWidth(kSliderWidth);
    if (ImGui::BeginCombo("technique",
                          materials::findSolidTechnique(chosen).technique.title.data())) {
        for (const materials::SolidTechnique& entry : techniques)
            if (ImGui::Selectable(entry.technique.title.data(), entry.technique.name == chosen))
                chosen = entry.technique.name;
        ImGui::EndCombo();
    }
    const materials::Technique& technique = materials::findSolidTechnique(chosen).technique;
    for (const materials::TechniqueParameter& parameter : technique.parameters)
        parameterSlider(options, technique.name, parameter);
    ImGui::Checkbox("mark exhausted", &options.markExhausted);
}

void lightControls(ViewOptions& options, bool isShape) {
    if (!section("light", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    lightSliders(options);
    // Scenes and solids in boxes always have shadows.
    if (!isShape || options.object == ObjectKind::ShapeBox)
        return;
    bool hasShadow = options.shadow != kNoShadow;
    if (ImGui::Checkbox("shadows", &hasShadow))
        options.shadow = hasShadow ? materials::shadowMethods().front().name : kNoShadow;
}

void row(const char* label, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(kQuiet, "%s", label);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.empty() ? "–" : value.c_str());
}

void sceneRows(const SceneTriangles& triangles) {
    row("boxes", fmt::format("{}", triangles.boxes));
    row("triangles", fmt::format("{}", triangles.drawn));
    row("of meshes", fmt::format("at least {}", triangles.tessellated));
    if (triangles.uncounted > 0)
        row("parts not counted", fmt::format("{}", triangles.uncounted));
}

void workRows(const std::optional<WorkCounts>& work) {
    const auto text = [&](const char* format, double value) {
        return work && work->pixels > 0 ? fmt::format(fmt::runtime(format), value) : std::string();
    };
    row("steps a pixel", text("{:.1f}", work ? work->meanSteps : 0.0));
    row("fetches a pixel", text("{:.1f}", work ? work->meanFetches : 0.0));
    row("ran out of steps",
        text("{:.2f} %", work ? 100.0 * static_cast<double>(work->exhausted) /
                                    static_cast<double>(std::max<std::size_t>(1, work->pixels))
                              : 0.0));
}

void readingsTable(const SolidPanelReport& report) {
    heading("readings");
    if (!ImGui::BeginTable("readings", 2))
        return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, 124.0f);
    const auto& milliseconds = report.readings.milliseconds;
    row("frame time", milliseconds ? fmt::format("{:.1f} ms", *milliseconds) : std::string());
    if (report.triangles)
        sceneRows(*report.triangles);
    else
        workRows(report.readings.work);
    ImGui::EndTable();
}

}  // namespace

WindowPoint extensionSliderEnd() {
    return {static_cast<int>(kPaddingX + kSliderWidth) - 2,
            static_cast<int>(kPaddingY + kRowHeight / 2)};
}

PanelActions drawSolidPanel(ViewOptions& options, const SolidPanelReport& report, float height) {
    beginPanel(height);
    if (report.shape)
        shapeControls(options, *report.shape);
    warning(report.readings.problem);
    lightControls(options, report.shape != nullptr);
    if (section("shading"))
        shadingModel(options);
    searchControls(options);
    readingsTable(report);
    return endPanel(report.message);
}

}  // namespace relievo::viewer
