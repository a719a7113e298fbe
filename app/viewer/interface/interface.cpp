// SPDX-License-Identifier: MIT
#include "app/viewer/interface/interface.h"

#include "app/viewer/session.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace romascope {
namespace {

/// The size that ImGui's own font is drawn for.
constexpr float kFontPixels = 13.0f;
constexpr float kLeastScale = 0.5f, kMostScale = 6.0f;
/// How often a blinking cursor and a tooltip to come are looked after.
constexpr double kBlinkSeconds = 0.1;
/// While nothing changes.
constexpr double kIdleSeconds = 3600.0;

constexpr const char* kPanelLayout = "Panel"; ///< its part of the layout's file

void set_style(float scale) {
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.WindowPadding = {9, 8};
    style.FramePadding = {6, 3};
    style.ItemSpacing = {7, 5};
    style.CellPadding = {3, 2};
    style.WindowRounding = 4;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.PopupRounding = 3;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = {0.09f, 0.10f, 0.11f, 0.95f};
    style.Colors[ImGuiCol_PopupBg] = {0.12f, 0.13f, 0.14f, 0.98f};
    style.Colors[ImGuiCol_TitleBg] = {0.13f, 0.14f, 0.16f, 1.0f};
    style.Colors[ImGuiCol_TitleBgActive] = {0.16f, 0.18f, 0.21f, 1.0f};
    style.Colors[ImGuiCol_TitleBgCollapsed] = {0.13f, 0.14f, 0.16f, 0.85f};
    style.Colors[ImGuiCol_FrameBg] = {0.19f, 0.21f, 0.24f, 1.0f};
    style.Colors[ImGuiCol_FrameBgHovered] = {0.25f, 0.28f, 0.32f, 1.0f};
    style.Colors[ImGuiCol_FrameBgActive] = {0.28f, 0.32f, 0.37f, 1.0f};
    style.Colors[ImGuiCol_Header] = {0.17f, 0.20f, 0.24f, 1.0f};
    style.Colors[ImGuiCol_HeaderHovered] = {0.24f, 0.30f, 0.37f, 1.0f};
    style.Colors[ImGuiCol_HeaderActive] = {0.27f, 0.35f, 0.44f, 1.0f};
    style.Colors[ImGuiCol_Button] = {0.22f, 0.28f, 0.35f, 1.0f};
    style.Colors[ImGuiCol_ButtonHovered] = {0.29f, 0.38f, 0.48f, 1.0f};
    style.Colors[ImGuiCol_ButtonActive] = {0.30f, 0.48f, 0.66f, 1.0f};
    style.Colors[ImGuiCol_SliderGrab] = {0.45f, 0.62f, 0.80f, 0.55f}; // numbers shine through
    style.Colors[ImGuiCol_SliderGrabActive] = {0.50f, 0.70f, 0.90f, 0.75f};
    style.Colors[ImGuiCol_TextDisabled] = {0.58f, 0.60f, 0.63f, 1.0f};
    style.Colors[ImGuiCol_CheckMark] = {0.60f, 0.77f, 0.95f, 1.0f};
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

/// Pixels of the framebuffer per unit of the window's coordinates; none while the window is being
/// resized: the two sizes are asked for one after the other.
std::optional<float> pixels_per_unit(GLFWwindow* window) {
    int before = 0, pixels = 0, after = 0, height = 0;
    glfwGetWindowSize(window, &before, &height);
    glfwGetFramebufferSize(window, &pixels, &height);
    glfwGetWindowSize(window, &after, &height);
    if (before != after || before < 1 || pixels < 1)
        return std::nullopt;
    return static_cast<float>(pixels) / static_cast<float>(before);
}

/// Equal for equal pictures of the widgets.
size_t fingerprint(const ImDrawData& drawn) {
    size_t sum = 0;
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const ImVector<ImDrawVert>& vertices = drawn.CmdLists[i]->VtxBuffer;
        const std::string_view bytes(reinterpret_cast<const char*>(vertices.Data),
                                     static_cast<size_t>(vertices.size_in_bytes()));
        sum = sum * 31 + std::hash<std::string_view>{}(bytes);
    }
    return sum;
}

void load_layout(const std::filesystem::path& file) {
    std::error_code none;
    if (file.empty() || !std::filesystem::is_regular_file(file, none))
        return;
    try {
        const std::string text = read_text_file(file);
        ImGui::LoadIniSettingsFromMemory(text.data(), text.size());
    } catch (const Error&) {
        return; // then the panel has its default width
    }
}

} // namespace

Interface::Interface(GLFWwindow* window, std::filesystem::path layout_file,
                     std::filesystem::path ui_map)
    : window_(window), context_(ImGui::CreateContext()), layout_file_(std::move(layout_file)),
      map_(std::move(ui_map)) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // saved here: whole or not at all, and its folder made
    io.LogFilename = nullptr;
    add_layout_of_panel();
    load_layout(layout_file_);
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    input_.emplace(window_);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    set_scale(x);
}

Interface::~Interface() {
    if (context_->SettingsDirtyTimer > 0.0f) { // changed, and not yet saved
        try {
            save_layout();
        } catch (const Error&) {
            // Nobody is left to be told, and the next start has the default width.
        }
    }
    input_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext(context_);
}

void Interface::set_scale(float scale) {
    const float wanted = std::clamp(scale, kLeastScale, kMostScale);
    if (wanted != scale_) {
        scale_ = wanted;
        ImGuiIO& io = ImGui::GetIO();
        ImFontConfig config;
        config.SizePixels = std::round(kFontPixels * wanted);
        io.Fonts->Clear();
        io.Fonts->AddFontDefault(&config);
        ImGui_ImplOpenGL3_DestroyDeviceObjects(); // the next frame makes them anew
    }
    // Widgets are laid out in the window's units, which on some systems are larger than pixels.
    pixels_per_unit_ = pixels_per_unit(window_).value_or(pixels_per_unit_);
    ImGui::GetIO().FontGlobalScale = 1.0f / pixels_per_unit_;
    if (style_scale_ != scale_ / pixels_per_unit_) {
        style_scale_ = scale_ / pixels_per_unit_;
        set_style(style_scale_);
    }
}

void Interface::begin_frame() {
    set_scale(scale_);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::GetIO().DisplayFramebufferScale = {pixels_per_unit_, pixels_per_unit_};
    keys_ = input_->feed();
    ImGui::NewFrame();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
        ImGui::ClosePopupToLevel(0, true); // lists of choices; ImGui by itself closes none
    if (wants_keyboard())
        keys_.clear();
    map_.begin_frame();
}

Requests Interface::draw(Session& session, InterfaceState& state, const Activity& activity) {
    Requests requests;
    if (state.panel)
        panel_.draw(session, state, activity, map_, requests);
    else
        panel_.hide();
    overlay_.draw(session.messages(), state, state.panel ? panel_.right_edge() : 0.0f, map_);
    if (ImGui::GetIO().WantSaveIniSettings) {
        try {
            save_layout();
        } catch (const Error& error) {
            layout_file_.clear(); // once is enough
            session.messages().tell(Severity::notice, error.what());
        }
    }
    map_.finish_frame(session, state);
    return requests;
}

void Interface::end_frame() {
    ImGui::Render();
    const size_t now = fingerprint(*ImGui::GetDrawData());
    is_settled_ = now == fingerprint_;
    fingerprint_ = now;
    GLint framebuffer = 0, viewport[4] = {};
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glGetIntegerv(GL_VIEWPORT, viewport);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

bool Interface::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }
bool Interface::wants_keyboard() const { return ImGui::GetIO().WantTextInput; }

double Interface::seconds_to_change() const {
    if (!input_->empty())
        return 0.0;
    if (!is_settled_) // windows take a frame or two to be as large as what is in them
        return 0.0;
    double seconds = kIdleSeconds;
    for (const auto& part : {panel_.seconds_to_change(), overlay_.seconds_to_change()})
        seconds = std::min(seconds, part.value_or(kIdleSeconds));
    if (wants_keyboard() || ImGui::IsAnyItemHovered() || map_.is_behind())
        seconds = std::min(seconds, kBlinkSeconds);
    return seconds;
}

/// The panel's width in the file of ImGui, which has it in units of the window: on a screen of
/// other pixels those are another number of letters.
void Interface::add_layout_of_panel() {
    ImGuiSettingsHandler handler;
    handler.TypeName = kPanelLayout;
    handler.TypeHash = ImHashStr(kPanelLayout);
    handler.UserData = &panel_;
    handler.ReadOpenFn = [](ImGuiContext*, ImGuiSettingsHandler* self, const char*) {
        return self->UserData;
    };
    handler.ReadLineFn = [](ImGuiContext*, ImGuiSettingsHandler*, void* panel, const char* line) {
        float width = 0.0f;
        if (std::sscanf(line, "FontHeights=%f", &width) == 1 && std::isfinite(width))
            static_cast<Panel*>(panel)->set_width(width);
    };
    handler.WriteAllFn = [](ImGuiContext*, ImGuiSettingsHandler* self, ImGuiTextBuffer* text) {
        text->appendf("[%s][Width]\nFontHeights=%.3f\n\n", self->TypeName,
                      static_cast<double>(static_cast<Panel*>(self->UserData)->width()));
    };
    context_->SettingsHandlers.push_back(handler);
}

void Interface::save_layout() {
    ImGui::GetIO().WantSaveIniSettings = false;
    if (layout_file_.empty())
        return;
    size_t size = 0;
    const char* text = ImGui::SaveIniSettingsToMemory(&size);
    write_file_atomically(layout_file_, std::string(text, size));
}

} // namespace romascope
