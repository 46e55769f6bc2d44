#include "viewer/panel_widgets.h"

#include <fmt/format.h>

#include <algorithm>

#include "viewer/window_settings.h"

namespace relievo::viewer {
namespace {

// Above so many values a linear slider cannot reach the small ones.
constexpr double kLogarithmicRange = 200.0;

}  // namespace

void beginPanel(float height) {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({kPanelWidth, height});
    ImGui::Begin("controls", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

PanelActions endPanel(const std::string& message) {
    PanelActions actions;
    ImGui::Dummy({0.0f, 2.0f});
    actions.save = ImGui::Button("Save picture");
    ImGui::SameLine();
    actions.resetCamera = ImGui::Button("Reset view");
    ImGui::SameLine();
    actions.help = ImGui::Button("Help (F1)");
    if (!message.empty())
        ImGui::TextWrapped("%s", message.c_str());
    ImGui::End();
    return actions;
}

void heading(const char* text) {
    ImGui::Dummy({0.0f, 2.0f});
    ImGui::TextColored(kQuiet, "%s", text);
    ImGui::Separator();
}

bool section(const char* text, ImGuiTreeNodeFlags flags) {
    ImGui::Dummy({0.0f, 2.0f});
    ImGui::PushStyleColor(ImGuiCol_Text, kQuiet);
    const bool isOpen = ImGui::TreeNodeEx(
        text, flags | ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
    ImGui::PopStyleColor();
    ImGui::Separator();
    return isOpen;
}

void warning(const std::string& text) {
    if (text.empty())
        return;
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

bool slider(const char* name, float& value, float least, float most, const char* format,
            ImGuiSliderFlags flags) {
    ImGui::SetNextItemWidth(kSliderWidth);
    return ImGui::SliderFloat(name, &value, least, most, format, flags);
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

void lightSliders(ViewOptions& options) {
    slider("light azimuth", options.light.x, -180.0f, 180.0f, "%.0f°");
    slider("light elevation", options.light.y, 0.0f, 90.0f, "%.0f°");
}

void shadingModel(ViewOptions& options) {
    using materials::ShadingModel;
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

}  // namespace relievo::viewer
