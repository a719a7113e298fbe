// SPDX-License-Identifier: MIT
#include "app/viewer/interface/rows.h"

#include <imgui_internal.h>

#include <cmath>

namespace romascope {
namespace {

/// Of the panel's width, that labels take.
constexpr float kLabelPart = 0.4f;
constexpr float kWidgetPart = 0.6f;
/// Seconds over a widget before its tooltip comes.
constexpr float kHoverSeconds = 0.5f;
/// Characters in a line of a tooltip.
constexpr float kTooltipWidth = 36.0f;
constexpr float kTurn = 6.2831853f;

/// Three quarters of a circle with a tip at its end.
void draw_turn_back(ImVec2 center, float radius, ImU32 color) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float begin = -0.35f * kTurn, end = 0.4f * kTurn;
    const float thickness = std::fmax(1.0f, radius * 0.3f);
    list.PathArcTo(center, radius, begin, end, 16);
    list.PathStroke(color, ImDrawFlags_None, thickness);
    const ImVec2 tip(center.x + radius * std::cos(begin), center.y + radius * std::sin(begin));
    const float size = radius * 0.75f;
    list.AddTriangleFilled({tip.x - size, tip.y + size * 0.6f}, {tip.x + size * 0.7f, tip.y + size},
                           {tip.x - size * 0.2f, tip.y - size}, color);
}

} // namespace

bool begin_rows() {
    const float em = ImGui::GetFontSize();
    if (!ImGui::BeginTable("##rows", 3, ImGuiTableFlags_SizingStretchProp))
        return false;
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, kLabelPart);
    ImGui::TableSetupColumn("widget", ImGuiTableColumnFlags_WidthStretch, kWidgetPart);
    ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, 1.3f * em);
    return true;
}

bool begin_row(std::string_view label, bool marked) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text,
                          marked ? kAccent : ImGui::GetStyleColorVec4(ImGuiCol_Text));
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
    ImGui::PopStyleColor();
    const bool hovered = ImGui::IsItemHovered();
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-FLT_MIN);
    return hovered;
}

bool reset_button(const std::string& id) {
    const float size = ImGui::GetFrameHeight();
    const bool pressed = ImGui::InvisibleButton(id.c_str(), {size, size});
    const ImVec2 low = ImGui::GetItemRectMin();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(low, ImGui::GetItemRectMax(),
                                                  ImGui::GetColorU32(ImGuiCol_ButtonHovered),
                                                  ImGui::GetStyle().FrameRounding);
    draw_turn_back({low.x + size * 0.5f, low.y + size * 0.5f}, size * 0.26f,
                   hovered ? ImGui::GetColorU32(ImGuiCol_Text) : ImGui::GetColorU32(kAccent));
    return pressed;
}

bool is_hovered_for_long() {
    return ImGui::IsItemHovered() && !ImGui::IsAnyItemActive() &&
           ImGui::GetCurrentContext()->HoveredIdTimer > kHoverSeconds;
}

void tooltip(const std::string& text) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipWidth);
    ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

} // namespace romascope
