#include "viewer/window_help.h"

#include <imgui.h>

#include <array>

namespace relievo::viewer {
namespace {

// What WindowLoop and the panels answer.
constexpr std::array kEveryWindow = {
    KeyHelp{"S", "save the picture as view-001.png, view-002.png, …"},
    KeyHelp{"R, double click", "reset the view"},
    KeyHelp{"left drag", "orbit"},
    KeyHelp{"right drag", "pan (middle drag too)"},
    KeyHelp{"wheel", "zoom"},
    KeyHelp{"Ctrl + click", "type a value into a slider"},
    KeyHelp{"right click", "default value of a technique's slider"},
    KeyHelp{"H", "hide or show the panel"},
    KeyHelp{"F1", "this help"},
    KeyHelp{"Q, Esc", "quit"},
};

void addRows(std::span<const KeyHelp> keys) {
    for (const KeyHelp& entry : keys) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored({0.62f, 0.78f, 1.0f, 1.0f}, "%s", entry.keys);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(entry.meaning);
    }
}

}  // namespace

void drawHelp(const PictureArea& area, std::span<const KeyHelp> keys) {
    ImGui::SetNextWindowPos({area.left + area.width / 2, area.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.92f);
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        addRows(keys);
        addRows(kEveryWindow);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace relievo::viewer
