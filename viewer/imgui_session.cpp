#include "viewer/imgui_session.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <filesystem>

namespace relievo::viewer {
namespace {

constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

void loadFont() {
    // Latin; dashes and the ellipsis; arrows.
    static constexpr ImWchar kRanges[] = {0x0020, 0x00FF, 0x2010, 0x2026, 0x2190, 0x2193, 0};
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    if (std::filesystem::exists(kFontFile)) {
        fonts.AddFontFromFileTTF(kFontFile, kFontSize, nullptr, kRanges);
        return;
    }
    ImFontConfig builtIn;
    builtIn.SizePixels = kFontSize;
    fonts.AddFontDefault(&builtIn);
}

void setStyle() {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowBorderSize = 0.0f;
    style.WindowRounding = 0.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.PopupRounding = 3.0f;
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {6.0f, 3.0f};
    style.ItemSpacing = {8.0f, 5.0f};
    style.Colors[ImGuiCol_WindowBg] = {0.13f, 0.13f, 0.14f, 1.0f};
    style.Colors[ImGuiCol_FrameBg] = {0.21f, 0.22f, 0.24f, 1.0f};
    style.Colors[ImGuiCol_Text] = {0.92f, 0.92f, 0.92f, 1.0f};
}

}  // namespace

ImGuiSession::ImGuiSession(GLFWwindow* window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // a viewer leaves no files in the current folder
    setStyle();
    loadFont();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450");
}

ImGuiSession::~ImGuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiSession::begin() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void ImGuiSession::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace relievo::viewer
