// SPDX-License-Identifier: MIT
#include "app/viewer/interface/overlay.h"

#include "app/viewer/interface/rows.h"
#include "app/viewer/interface/ui_map.h"
#include "app/viewer/keys.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace romascope {
namespace {

constexpr double kSecondsShown = 10.0;
constexpr double kSecondsWithoutPanel = 5.0;
constexpr size_t kMostShown = 6;
// In heights of the font.
constexpr float kWidth = 42.0f;
constexpr float kLeastWidth = 16.0f;

ImVec4 color_of(Severity severity) {
    if (severity == Severity::error)
        return kErrorColor;
    return severity == Severity::notice ? kAccent : ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

} // namespace

std::optional<double> seconds_shown(Severity severity, bool panel) {
    switch (severity) {
    case Severity::error:
        return std::nullopt;
    case Severity::notice:
        return panel ? kSecondsShown : 0.0;
    case Severity::info:
        break;
    }
    return panel ? kSecondsShown : kSecondsWithoutPanel;
}

bool Overlay::is_dismissed(const Message& message) const {
    return std::ranges::any_of(dismissed_, [&](const auto& entry) {
        return entry.first == message.told && entry.second == message.text;
    });
}

void Overlay::draw(const Messages& messages, InterfaceState& state, float left, UiMap& map) {
    std::erase_if(dismissed_, [&](const auto& entry) {
        return std::ranges::none_of(messages.all(), [&](const Message& message) {
            return entry.first == message.told && entry.second == message.text;
        });
    });
    draw_messages(messages, state.panel, left, map);
    if (state.help)
        draw_help(state.help, map);
}

void Overlay::draw_messages(const Messages& messages, bool panel, float left, UiMap& map) {
    seconds_to_change_.reset();
    const auto now = std::chrono::steady_clock::now();
    std::vector<const Message*> shown;
    for (auto message = messages.all().rbegin(); message != messages.all().rend(); ++message) {
        const std::optional<double> seconds = seconds_shown(message->severity, panel);
        const double passed = std::chrono::duration<double>(now - message->told).count();
        if (is_dismissed(*message) || (seconds && passed >= *seconds))
            continue;
        if (seconds)
            seconds_to_change_ = std::min(seconds_to_change_.value_or(*seconds), *seconds - passed);
        shown.push_back(&*message);
    }
    if (shown.empty())
        return;
    const float em = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float room = screen.x - left > kLeastWidth * em ? screen.x - left : screen.x;
    const float width = std::min(kWidth * em, room - em);
    ImGui::SetNextWindowPos({screen.x - 0.5f * em, screen.y - 0.5f * em}, ImGuiCond_Always,
                            {1.0f, 1.0f});
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, 0.5f * screen.y});
    if (ImGui::Begin("###messages", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing)) {
        const size_t count = std::min(shown.size(), kMostShown);
        for (size_t i = 0; i < count; ++i) {
            const Message& message = *shown[i];
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::SmallButton("x"))
                dismissed_.emplace_back(message.told, message.text);
            map.note(fmt::format("dismiss:{}", i));
            ImGui::PopID();
            ImGui::SameLine();
            ImGui::PushStyleColor(ImGuiCol_Text, color_of(message.severity));
            ImGui::PushTextWrapPos();
            const std::string text = message.times > 1
                                         ? fmt::format("{} ({} times)", message.text, message.times)
                                         : message.text;
            ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
            ImGui::PopTextWrapPos();
            ImGui::PopStyleColor();
        }
        if (shown.size() > count) {
            if (ImGui::SmallButton("dismiss all"))
                for (const Message* message : shown)
                    dismissed_.emplace_back(message->told, message->text);
            map.note("dismiss_all");
            ImGui::SameLine();
            ImGui::TextDisabled("and %zu older", shown.size() - count);
        }
    }
    ImGui::End();
}

void draw_help(bool& open, UiMap& map) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x * 0.5f, screen.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, screen);
    if (ImGui::Begin("Keys and mouse###help", &open,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings) &&
        ImGui::BeginTable("##keys", 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) {
        const auto row = [](std::string_view name, std::string_view help) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextColored(kAccent, "%.*s", static_cast<int>(name.size()), name.data());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(help.data(), help.data() + help.size());
        };
        for (const KeyBinding& binding : key_bindings())
            row(binding.name, binding.help);
        for (const Gesture& gesture : gestures())
            row(gesture.name, gesture.help);
        ImGui::EndTable();
        map.note("help");
    }
    ImGui::End();
}

} // namespace romascope
