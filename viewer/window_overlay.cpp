#include "viewer/window_overlay.h"

#include <imgui.h>

#include <array>
#include <cmath>

namespace relievo::viewer {
namespace {

constexpr float kMargin = 10.0f;
constexpr float kLabelPaddingX = 7.0f;
constexpr float kLabelPaddingY = 4.0f;
constexpr ImU32 kLabelColor = IM_COL32(240, 240, 240, 255);
constexpr ImU32 kNoteColor = IM_COL32(255, 170, 90, 255);
constexpr ImU32 kLabelGround = IM_COL32(20, 20, 22, 190);
constexpr ImU32 kLineColor = IM_COL32(250, 250, 250, 220);

struct KeyHelp {
    const char* keys;
    const char* meaning;
};

constexpr std::array kKeys = {
    KeyHelp{"1 … 9, ↑ ↓", "technique A of the list"},
    KeyHelp{"0", "the exact picture as A"},
    KeyHelp{"Shift + these", "technique B"},
    KeyHelp{"M", "next comparison: single, side by side, split, error"},
    KeyHelp{"Space", "animate the depth scale"},
    KeyHelp{"S", "save the picture as view-001.png, view-002.png, …"},
    KeyHelp{"R, double click", "reset the view"},
    KeyHelp{"left drag", "orbit; in a split picture also drags the line"},
    KeyHelp{"right drag", "pan (middle drag too)"},
    KeyHelp{"wheel", "zoom"},
    KeyHelp{"Ctrl + click", "type a value into a slider"},
    KeyHelp{"right click", "default value of a technique's slider"},
    KeyHelp{"H", "hide or show the panel"},
    KeyHelp{"F1", "this help"},
    KeyHelp{"Q, Esc", "quit"},
};

ImVec2 labelSize(const char* text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    return {size.x + 2 * kLabelPaddingX, size.y + 2 * kLabelPaddingY};
}

void drawLabel(const char* text, ImVec2 corner, ImU32 color) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = labelSize(text);
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, kLabelGround, 4.0f);
    list.AddText({corner.x + kLabelPaddingX, corner.y + kLabelPaddingY}, color, text);
}

void drawDivider(float x, float height) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine({x, 0.0f}, {x, height}, kLineColor, 1.0f);
    // The handle stands low, out of the middle of the picture.
    const ImVec2 handle{x, 0.85f * height};
    list.AddCircleFilled(handle, 9.0f, kLabelGround);
    list.AddCircle(handle, 9.0f, kLineColor);
    list.AddTriangleFilled({x - 7, handle.y}, {x - 2, handle.y - 4}, {x - 2, handle.y + 4},
                           kLineColor);
    list.AddTriangleFilled({x + 7, handle.y}, {x + 2, handle.y + 4}, {x + 2, handle.y - 4},
                           kLineColor);
}

}  // namespace

void drawOverlay(const WindowSettings& settings, const PictureArea& area, bool isTracing) {
    std::string first(techniqueTitle(settings.techniqueA));
    if (settings.mode == ComparisonMode::HeatMap)
        first = "error of " + first;
    drawLabel(first.c_str(), {area.left + kMargin, kMargin}, kLabelColor);
    if (showsSecond(settings)) {
        const std::string second(techniqueTitle(settings.techniqueB));
        const float right = area.left + area.width - kMargin - labelSize(second.c_str()).x;
        drawLabel(second.c_str(), {right, kMargin}, kLabelColor);
    }
    if (settings.mode == ComparisonMode::Split)
        drawDivider(area.left + std::round(settings.split * area.width), area.height);
    if (isTracing) {
        const char* note = "tracing the exact hits…";
        const ImVec2 size = labelSize(note);
        drawLabel(note, {area.left + area.width - kMargin - size.x, area.height - kMargin - size.y},
                  kNoteColor);
    }
}

void drawHelp(const PictureArea& area) {
    ImGui::SetNextWindowPos({area.left + area.width / 2, area.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.92f);
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const KeyHelp& entry : kKeys) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextColored({0.62f, 0.78f, 1.0f, 1.0f}, "%s", entry.keys);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(entry.meaning);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace relievo::viewer
