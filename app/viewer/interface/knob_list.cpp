// SPDX-License-Identifier: MIT
#include "app/viewer/interface/knob_list.h"

#include "app/viewer/interface/knob_widget.h"
#include "app/viewer/interface/known_names.h"
#include "app/viewer/interface/rows.h"
#include "app/viewer/interface/ui_map.h"
#include "app/viewer/session.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace romascope {
namespace {

constexpr float kUnusedAlpha = 0.5f;
/// Without these a picture is no less what it is.
bool is_of_window(const KnobBase& knob) { return &knob == &kWidth || &knob == &kHeight; }

bool is_changed(const KnobBase& knob, const Session& session) {
    return is_of_window(knob) ? !session.follows_window()
                              : session.settings().value(knob) != session.reset_value(knob);
}

std::string with_unit(const std::string& number, const KnobBase& knob) {
    return knob.unit().empty() ? number : fmt::format("{} {}", number, knob.unit());
}

std::string value_text(const KnobBase& knob, const KnobValue& value) {
    const std::string text = to_text(value);
    return text.empty() ? "empty" : with_unit(text, knob);
}

std::string knob_help(const KnobBase& knob, const Session& session) {
    std::string text = fmt::format("{}\n\n{}\n\nRange: {}\nDefault: {} ({})", knob.key(),
                                   knob.help(), with_unit(range_text(knob), knob),
                                   value_text(knob, knob.default_value()), knob.source());
    const KnobValue reset = session.reset_value(knob);
    if (is_of_window(knob))
        text += "\nUnless set here, the window's.";
    else if (reset != knob.default_value())
        text += fmt::format("\nIn this window: {}", value_text(knob, reset));
    if (const std::string wakes = what_wakes(knob, session.settings()); !wakes.empty())
        text += fmt::format("\nThe picture depends on it only with {}.", wakes);
    return text;
}

} // namespace

void KnobList::draw(Session& session, std::string& filter, UiMap& map) {
    const std::string reset_all = "Reset all";
    const float button =
        ImGui::CalcTextSize(reset_all.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
    ImGui::InputTextWithHint("##filter", "find a knob", &filter);
    map.note("filter");
    ImGui::SameLine();
    if (ImGui::Button(reset_all.c_str()))
        session.reset_all();
    map.note("reset_all");
    if (is_hovered_for_long())
        tooltip("All knobs to their defaults, but camera, time and size (Ctrl+R)");

    bool found = false;
    for (const KnobGroup& group : knob_groups(session.settings().table())) {
        const bool any = std::ranges::any_of(
            group.knobs, [&](const KnobBase* knob) { return matches(*knob, filter); });
        if (any)
            draw_group(group, session, filter, map);
        found = found || any;
    }
    if (!found)
        ImGui::TextDisabled("No knob has that in its name or help.");
}

void KnobList::draw_group(const KnobGroup& group, Session& session, const std::string& filter,
                          UiMap& map) {
    const bool in_use = std::ranges::any_of(
        group.knobs, [&](const KnobBase* knob) { return is_in_use(*knob, session.settings()); });
    const auto before = in_use_.find(group.key);
    if (!filter.empty())
        ImGui::SetNextItemOpen(true);
    else if (before == in_use_.end() || before->second != in_use)
        ImGui::SetNextItemOpen(in_use);
    in_use_[group.key] = in_use;

    const bool changed = std::ranges::any_of(
        group.knobs, [&](const KnobBase* knob) { return is_changed(*knob, session); });
    const std::string id = fmt::format("{}###group:{}", group.title, group.key);
    const float right = ImGui::GetWindowContentRegionMax().x;
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha,
                        ImGui::GetStyle().Alpha * (in_use ? 1.0f : kUnusedAlpha));
    const bool open = ImGui::CollapsingHeader(id.c_str(), ImGuiTreeNodeFlags_AllowItemOverlap);
    ImGui::PopStyleVar();
    map.note(fmt::format("group:{}", group.key));
    if (changed) {
        ImGui::SameLine(right - ImGui::GetFrameHeight());
        if (reset_button(fmt::format("##reset:{}", group.key)))
            for (const KnobBase* knob : group.knobs)
                session.reset(*knob);
        map.note(fmt::format("reset:{}", group.key));
        if (is_hovered_for_long())
            tooltip(fmt::format("Reset all of \"{}\"", group.title));
    }
    if (!open || !begin_rows())
        return;
    for (const KnobBase* knob : group.knobs)
        if (matches(*knob, filter))
            draw_row(*knob, session, map);
    ImGui::EndTable();
}

void KnobList::draw_row(const KnobBase& knob, Session& session, UiMap& map) {
    const std::string key(knob.key());
    const bool changed = is_changed(knob, session);
    const bool in_use = is_in_use(knob, session.settings());
    const KnobValue value = session.settings().value(knob);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha,
                        ImGui::GetStyle().Alpha * (in_use ? 1.0f : kUnusedAlpha));
    const bool over_label = begin_row(knob_label(knob), changed);

    const bool can_be_infinite = widget_of(knob).can_be_infinite;
    const float tick = ImGui::GetFrameHeight() + ImGui::CalcTextSize("inf").x +
                       2.0f * ImGui::GetStyle().ItemInnerSpacing.x;
    if (can_be_infinite)
        ImGui::SetNextItemWidth(-tick);
    ImGui::BeginGroup(); // a text has a field and a list
    std::optional<KnobValue> wanted = editor_.edit(knob, value, known_names(knob, session));
    ImGui::EndGroup();
    map.note(key);
    const bool over_widget = is_hovered_for_long();
    if (can_be_infinite) {
        ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
        if (auto toggled = editor_.edit_infinity(knob, std::get<double>(value)))
            wanted = toggled;
        map.note("inf:" + key);
    }
    ImGui::TableNextColumn();
    const bool reset = changed && reset_button("##reset:" + key);
    if (changed) {
        map.note("reset:" + key);
        if (is_hovered_for_long())
            tooltip(fmt::format("Reset to {}", is_of_window(knob)
                                                   ? "the window's"
                                                   : value_text(knob, session.reset_value(knob))));
    }
    ImGui::PopStyleVar();
    if (over_label || over_widget)
        tooltip(knob_help(knob, session));
    if (reset)
        session.reset(knob);
    else if (wanted)
        session.set(knob, *wanted);
}

} // namespace romascope
