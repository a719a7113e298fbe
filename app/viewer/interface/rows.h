// SPDX-License-Identifier: MIT
// The columns that all of the panel's widgets share: label, widget, reset.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace romascope {

/// Begins the table; false if it is not seen. End it with ImGui::EndTable().
bool begin_rows();

/// Begins a row, writes its label and goes to the widget's column, which the next item fills.
/// Whether the mouse is over the label.
bool begin_row(std::string_view label, bool marked = false);

/// In the column after the widget's: a small button with an arrow that turns back.
bool reset_button(const std::string& id);

/// Whether the mouse has rested over the last widget, or it is being waited for.
bool is_hovered_for_long();

/// Text that is wrapped at a width that suits reading, as a tooltip of the last item.
void tooltip(const std::string& text);

/// Of marked labels and buttons that stand out; of errors.
inline const ImVec4 kAccent(0.98f, 0.72f, 0.32f, 1.0f);
inline const ImVec4 kErrorColor(1.0f, 0.42f, 0.38f, 1.0f);

} // namespace romascope
