// SPDX-License-Identifier: MIT
#include "app/viewer/interface/panel.h"

#include "app/viewer/interface/rows.h"
#include "app/viewer/interface/ui_map.h"
#include "app/viewer/session.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>

namespace romascope {
namespace {

// In heights of the font.
constexpr float kPanelWidth = 29.0f;
constexpr float kLeastWidth = 18.0f;
constexpr float kCostsWidth = 24.0f;
/// Without this much room beside the panel, the costs are its last part.
constexpr float kLeastPicture = 12.0f;

/// A button, and whether it goes on in this line: it does if the next one fits.
bool button_in_flow(const std::string& label, bool first) {
    if (!first) {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float width =
            ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0f * style.FramePadding.x;
        const float end = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
        if (end < ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x)
            ImGui::SameLine();
    }
    return ImGui::Button(label.c_str());
}

std::string counted(size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string facts(const Scene& scene) {
    std::string text =
        fmt::format("{}, {}", counted(scene.triangle_count(), "triangle", "triangles"),
                    counted(scene.cameras.size(), "camera", "cameras"));
    if (!scene.lights.empty())
        text += fmt::format(", {}", counted(scene.lights.size(), "light", "lights"));
    if (!scene.motion.animations.empty())
        text +=
            fmt::format(", {}", counted(scene.motion.animations.size(), "animation", "animations"));
    return text;
}

} // namespace

void Panel::draw(Session& session, InterfaceState& state, const Activity& activity, UiMap& map,
                 Requests& requests) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    costs_shown_ = false;
    const bool open = begin_panel();
    map.note_window("panel");
    const bool costs_apart = screen.x - right_edge_ > (kCostsWidth + kLeastPicture) * em;
    if (open) {
        draw_scene(session, map, requests);
        if (ImGui::CollapsingHeader("Screenshot and settings###group:picture"))
            draw_picture(session, state, activity, map, requests);
        map.note("group:picture");
        ImGui::Spacing();
        knobs_.draw(session, state.filter, map);
        if (!costs_apart && ImGui::CollapsingHeader("Costs###group:costs"))
            draw_costs(session, map);
    }
    ImGui::End();
    if (costs_apart)
        draw_costs_window(session, map);
}

Panel::Panel() : width_(kPanelWidth) {}

void Panel::set_width(float font_heights) {
    width_ = std::max(font_heights, kLeastWidth);
    screen_width_ = 0.0f; // laid out anew
}

/// As high as the window. Its width is the user's, but for as long as the window is too small.
bool Panel::begin_panel() {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    const float least = std::min(kLeastWidth * em, screen.x);
    const bool laid_out = screen.x == screen_width_ && em == font_height_;
    screen_width_ = screen.x;
    font_height_ = em;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    if (!laid_out)
        ImGui::SetNextWindowSize({std::clamp(width_ * em, least, screen.x), screen.y});
    ImGui::SetNextWindowSizeConstraints({least, screen.y}, {screen.x, screen.y});
    const bool open = ImGui::Begin("romascope###panel", nullptr, ImGuiWindowFlags_NoMove);
    const float width = ImGui::GetCurrentWindow()->SizeFull.x; // when collapsed, too
    right_edge_ = ImGui::IsWindowCollapsed() ? 0.0f : width;
    if (laid_out && width != shown_width_) // dragged
        width_ = width / em;
    shown_width_ = width;
    return open;
}

void Panel::draw_costs(Session& session, UiMap& map) {
    costs_.draw(session, map);
    costs_shown_ = true;
}

void Panel::draw_costs_window(Session& session, UiMap& map) {
    const float em = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - 0.5f * em, 0.5f * em}, ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({kCostsWidth * em, 0.0f},
                                        {kCostsWidth * em, screen.y - em});
    if (ImGui::Begin("Costs###costs", nullptr,
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize))
        draw_costs(session, map);
    ImGui::End();
}

void Panel::draw_scene(Session& session, UiMap& map, Requests& requests) {
    if (!begin_rows())
        return;
    begin_row("scene");
    const std::string name = session.has_scene() ? session.scene().name : "none";
    if (ImGui::BeginCombo("##scene", name.c_str())) {
        for (const BuiltInScene& scene : built_in_) {
            if (ImGui::Selectable(scene.name.c_str(), scene.name == name))
                requests.open = scene.name;
            map.note("scene:" + scene.name);
        }
        ImGui::EndCombo();
    }
    map.note("scene");
    if (session.has_scene() && is_hovered_for_long())
        tooltip(session.scene_file().string());
    begin_row("open");
    if (ImGui::InputTextWithHint("##open", "path of a .gltf or .glb", &path_,
                                 ImGuiInputTextFlags_EnterReturnsTrue) &&
        !path_.empty())
        requests.open = path_;
    map.note("open");
    if (is_hovered_for_long())
        tooltip("Enter opens it; a file that is dropped on the window opens too.");
    if (session.has_scene()) {
        draw_camera(session, map);
        draw_time(session, map);
    }
    draw_technique(session, map);
    ImGui::EndTable();
}

void Panel::draw_camera(Session& session, UiMap& map) {
    const Scene& scene = session.scene();
    begin_row("");
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", facts(scene).c_str());
    ImGui::PopTextWrapPos();
    begin_row("camera");
    const std::string current = session.settings().get(kCamera);
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
        const std::string& name = scene.cameras[i].name;
        const bool chosen = current.empty() ? i == 0 : name == current;
        ImGui::PushStyleColor(
            ImGuiCol_Button,
            ImGui::GetStyleColorVec4(chosen ? ImGuiCol_ButtonActive : ImGuiCol_Button));
        if (button_in_flow(fmt::format("{}##camera{}", name, i), i == 0))
            session.choose_camera(i);
        ImGui::PopStyleColor();
        map.note(fmt::format("camera:{}", i + 1));
    }
    if (button_in_flow("fit##fit", scene.cameras.empty()))
        session.fit_view();
    map.note("fit");
    if (is_hovered_for_long())
        tooltip("All of the scene (F)");
}

void Panel::draw_time(Session& session, UiMap& map) {
    if (!session.is_animated())
        return;
    begin_row("time");
    const bool playing = session.playback().playing();
    if (ImGui::Button(playing ? "pause###play" : "play###play"))
        session.play(!playing);
    map.note("play");
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(-FLT_MIN);
    const double zero = 0.0, duration = session.duration();
    double time = wrapped_time(session.settings().get(kTime), duration);
    if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &time, &zero, &duration, "%.3f s",
                            ImGuiSliderFlags_NoInput)) {
        session.play(false);
        session.set(kTime, std::clamp(time, zero, duration));
    }
    map.note("time");
    if (is_hovered_for_long())
        tooltip(fmt::format("Of {:.3f} s; Space plays and pauses, comma and dot go by 1/30 s",
                            duration));
}

void Panel::draw_technique(Session& session, UiMap& map) {
    begin_row("technique");
    const std::string& current = session.technique();
    if (ImGui::BeginCombo("##technique", current.empty() ? "none chosen" : current.c_str())) {
        for (const Technique& technique : techniques()) {
            if (ImGui::Selectable(technique.name.c_str(), technique.name == current))
                session.choose_technique(technique.name);
            map.note("technique:" + technique.name);
            if (ImGui::IsItemHovered())
                tooltip(technique.description);
        }
        ImGui::EndCombo();
    }
    map.note("technique");
    if (is_hovered_for_long())
        tooltip("Sets the knobs of a method to values that suit it.");
}

void Panel::draw_picture(Session& session, InterfaceState& state, const Activity& activity,
                         UiMap& map, Requests& requests) {
    if (activity.screenshot) {
        ImGui::ProgressBar(static_cast<float>(*activity.screenshot),
                           {-8.0f * ImGui::GetFontSize(), 0});
        ImGui::SameLine();
        requests.cancel_screenshot = ImGui::Button("cancel");
        map.note("cancel_screenshot");
    }
    ImGui::BeginDisabled(activity.screenshot.has_value() || !session.has_scene());
    const float whole = ImGui::GetContentRegionAvail().x;
    requests.screenshot = ImGui::Button("Screenshot", {whole * 0.35f, 0.0f});
    map.note("screenshot");
    if (is_hovered_for_long())
        tooltip("Saves the picture as it is seen (F12)");
    ImGui::SameLine();
    requests.large_screenshot = ImGui::Button("at size");
    map.note("large_screenshot");
    if (is_hovered_for_long())
        tooltip("Renders and saves it at this size (Shift+F12)");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    int size[2] = {state.shot_size.x, state.shot_size.y};
    if (ImGui::InputInt2("##shot_size", size))
        state.shot_size = {std::clamp(size[0], 1, static_cast<int>(kWidth.maximum())),
                           std::clamp(size[1], 1, static_cast<int>(kHeight.maximum()))};
    map.note("shot_size");

    bool follow = session.follows_window();
    if (ImGui::Checkbox("picture as large as the window", &follow))
        session.follow_window(follow);
    map.note("follow_window");

    requests.copy_command = button_in_flow("Copy as command", true);
    map.note("copy_command");
    if (is_hovered_for_long())
        tooltip("The command that renders this picture without a window (Ctrl+C)");
    requests.save_settings = button_in_flow("Start with these", false);
    map.note("save_settings");
    if (is_hovered_for_long())
        tooltip("Keeps the settings as those that the viewer starts with");
    ImGui::BeginDisabled(!activity.saved_settings);
    requests.forget_settings = button_in_flow("Forget", false);
    ImGui::EndDisabled();
    map.note("forget_settings");
    if (is_hovered_for_long())
        tooltip("Starts with the defaults again");
    if (!session.shader_folder().empty()) {
        requests.reload_shaders = button_in_flow("Reload shaders", false);
        map.note("reload_shaders");
    }
}

} // namespace romascope
