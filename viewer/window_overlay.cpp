#include "viewer/window_overlay.h"

#include <imgui.h>

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

void drawNote(const char* note, const PictureArea& area) {
    const ImVec2 size = labelSize(note);
    drawLabel(note, {area.left + area.width - kMargin - size.x, area.height - kMargin - size.y},
              kNoteColor);
}

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
    if (isTracing)
        drawNote("tracing the exact hits…", area);
}

}  // namespace relievo::viewer
