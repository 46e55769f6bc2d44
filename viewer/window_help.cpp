#include "viewer/window_help.h"

#include <imgui.h>

namespace relievo::viewer {

void drawHelp(const PictureArea& area, std::span<const KeyHelp> keys) {
    ImGui::SetNextWindowPos({area.left + area.width / 2, area.height / 2}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowBgAlpha(0.92f);
    ImGui::Begin("keys", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const KeyHelp& entry : keys) {
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
