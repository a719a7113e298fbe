// SPDX-License-Identifier: MIT
// Which widget a knob gets, from its declaration alone.
#pragma once

#include "renderer/settings/knob.h"

#include <string>

namespace romascope {

enum class WidgetKind {
    checkbox,
    slider,
    drag, ///< a number that is dragged: it has no end, or too many values for a slider
    combo,
    text
};

struct WidgetSpec {
    WidgetKind kind = WidgetKind::text;
    bool logarithmic = false; ///< of a slider: small values get as much room as large ones
    bool can_be_infinite = false;
    std::string format; ///< of a number, for printf: "%lld cells"
};

WidgetSpec widget_of(const KnobBase& knob);

/// The nearest value in the knob's range, for numbers; others as they are. Rounding to what a
/// widget shows may have left the range.
KnobValue into_range(const KnobBase& knob, KnobValue value);

} // namespace romascope
