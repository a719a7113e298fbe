// SPDX-License-Identifier: MIT
#include "app/viewer/interface/knob_editor.h"

#include "app/viewer/interface/knob_widget.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

namespace romascope {
namespace {

/// A pixel of dragging changes a number by this part of it, or of 1 where it is smaller.
constexpr double kDragPart = 0.01;
/// Stands where a value stops being infinite, if there was no finite one before.
constexpr double kFirstFinite = 1.0;

std::string label(const KnobBase& knob) { return std::string("##").append(knob.key()); }

/// A slider, or a number to drag, for a value of ImGui's type.
template <class T>
bool number_input(ImGuiDataType type, const KnobBase& knob, const WidgetSpec& spec, T& value) {
    const std::string name = label(knob);
    if (spec.kind == WidgetKind::drag) {
        const double speed = kDragPart * std::max(std::abs(static_cast<double>(value)), 1.0);
        return ImGui::DragScalar(name.c_str(), type, &value, static_cast<float>(speed), nullptr,
                                 nullptr, spec.format.c_str());
    }
    const T low = static_cast<T>(knob.minimum()), high = static_cast<T>(knob.maximum());
    return ImGui::SliderScalar(name.c_str(), type, &value, &low, &high, spec.format.c_str(),
                               spec.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

} // namespace

std::string shown_name(const KnownNames& names, const std::string& value) {
    const auto known = std::ranges::find(names.names, value, &KnownName::value);
    return known != names.names.end() ? known->label : value.empty() ? names.empty : value;
}

std::optional<KnobValue> KnobEditor::edit(const KnobBase& knob, const KnobValue& value,
                                          const KnownNames& names) {
    switch (knob.kind()) {
    case KnobKind::boolean: {
        bool on = std::get<bool>(value);
        if (ImGui::Checkbox(label(knob).c_str(), &on))
            return KnobValue(on);
        return std::nullopt;
    }
    case KnobKind::choice:
        return edit_choice(knob, value);
    case KnobKind::text:
        return edit_text(knob, std::get<std::string>(value), names);
    case KnobKind::integer:
    case KnobKind::real:
        break;
    }
    return edit_number(knob, value);
}

std::optional<KnobValue> KnobEditor::edit_number(const KnobBase& knob, const KnobValue& value) {
    const WidgetSpec spec = widget_of(knob);
    if (const double* real = std::get_if<double>(&value); real && std::isinf(*real)) {
        // Nothing that could be dragged.
        std::string text = "inf ";
        text.append(knob.unit());
        ImGui::BeginDisabled();
        ImGui::InputText(label(knob).c_str(), &text, ImGuiInputTextFlags_ReadOnly);
        ImGui::EndDisabled();
        return std::nullopt;
    }
    // A text field gives a value with each key; only the last one counts.
    const ImGuiID id = ImGui::GetID(label(knob).c_str());
    const bool was_typing = ImGui::TempInputIsActive(id);
    KnobValue next = value;
    const bool changed =
        std::holds_alternative<int64_t>(next)
            ? number_input(ImGuiDataType_S64, knob, spec, std::get<int64_t>(next))
            : number_input(ImGuiDataType_Double, knob, spec, std::get<double>(next));
    if (changed && !was_typing && !ImGui::TempInputIsActive(id))
        return into_range(knob, next);
    const bool typing = ImGui::TempInputIsActive(id);
    if (was_typing || typing) {
        const std::optional<KnobValue> now = changed ? std::optional(next) : std::nullopt;
        if (!typing) { // Enter, or Escape, which brings the old value back
            typed_ = {};
            return now;
        }
        typed_ = {&knob, now, ImGui::GetFrameCount()};
        return std::nullopt;
    }
    // The field closes before this by a click elsewhere or by Tab.
    if (typed_.knob != &knob)
        return std::nullopt;
    const Typed done = std::exchange(typed_, {});
    return done.frame == ImGui::GetFrameCount() - 1 ? done.value : std::nullopt;
}

std::optional<KnobValue> KnobEditor::edit_infinity(const KnobBase& knob, double value) {
    if (std::isfinite(value))
        last_finite_[&knob] = value;
    bool infinite = std::isinf(value);
    if (!ImGui::Checkbox(std::string("inf##inf:").append(knob.key()).c_str(), &infinite))
        return std::nullopt;
    if (infinite)
        return KnobValue(knob.maximum());
    const auto last = last_finite_.find(&knob);
    return KnobValue(last != last_finite_.end() ? last->second : into_range(knob, kFirstFinite));
}

std::optional<KnobValue> KnobEditor::edit_choice(const KnobBase& knob, const KnobValue& value) {
    const std::string& current = std::get<std::string>(value);
    std::optional<KnobValue> chosen;
    if (!ImGui::BeginCombo(label(knob).c_str(), current.c_str(), ImGuiComboFlags_HeightLarge))
        return chosen;
    for (const std::string_view name : knob.choices()) {
        const std::string text(name);
        if (ImGui::Selectable(text.c_str(), text == current))
            chosen = text;
    }
    ImGui::EndCombo();
    return chosen;
}

std::optional<KnobValue> KnobEditor::edit_text(const KnobBase& knob, const std::string& value,
                                               const KnownNames& names) {
    std::optional<KnobValue> entered;
    const float width = ImGui::CalcItemWidth();
    if (!names.only_these) {
        std::string text = value;
        ImGui::SetNextItemWidth(width - ImGui::GetFrameHeight());
        if (ImGui::InputTextWithHint(label(knob).c_str(), names.empty.c_str(), &text,
                                     ImGuiInputTextFlags_EnterReturnsTrue))
            entered = text;
        ImGui::SameLine(0.0f, 0.0f);
    }
    ImGui::SetNextItemWidth(width);
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {FLT_MAX, FLT_MAX});
    if (ImGui::BeginCombo(
            std::string("##names:").append(knob.key()).c_str(), shown_name(names, value).c_str(),
            names.only_these ? ImGuiComboFlags_None
                             : ImGuiComboFlags_NoPreview | ImGuiComboFlags_PopupAlignLeft)) {
        for (const KnownName& name : names.names) {
            if (ImGui::Selectable(name.label.c_str(), name.value == value))
                entered = name.value;
            if (!name.help.empty() && ImGui::IsItemHovered())
                ImGui::SetTooltip("%s", name.help.c_str());
        }
        ImGui::EndCombo();
    }
    return entered;
}

} // namespace romascope
