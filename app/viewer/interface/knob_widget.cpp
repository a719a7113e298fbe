// SPDX-License-Identifier: MIT
#include "app/viewer/interface/knob_widget.h"

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// More values than this are not told apart on a slider; typing and dragging are better.
constexpr double kMostSteps = 1e8;
/// From this ratio of the range's ends on, a slider is logarithmic.
constexpr double kWideRatio = 1000.0;
/// So is one whose default lies in this part at its lower end.
constexpr double kLowPart = 0.05;

double number(const KnobValue& value) {
    if (const auto* integer = std::get_if<int64_t>(&value))
        return static_cast<double>(*integer);
    return std::get<double>(value);
}

bool is_wide(const KnobBase& knob) {
    const double low = knob.minimum(), high = knob.maximum();
    if (low < 0.0)
        return false;
    const double part = (number(knob.default_value()) - low) / (high - low);
    const double smallest = std::max(low, 1.0);
    return high / smallest >= kWideRatio || (part > 0.0 && part < kLowPart);
}

std::string number_format(const KnobBase& knob) {
    std::string format = knob.kind() == KnobKind::integer ? "%lld" : "%.4g";
    if (!knob.unit().empty())
        format += ' ';
    for (const char c : knob.unit())
        format += c == '%' ? std::string("%%") : std::string(1, c);
    return format;
}

} // namespace

WidgetSpec widget_of(const KnobBase& knob) {
    switch (knob.kind()) {
    case KnobKind::boolean:
        return {.kind = WidgetKind::checkbox, .format = {}};
    case KnobKind::choice:
        return {.kind = WidgetKind::combo, .format = {}};
    case KnobKind::text:
        return {.kind = WidgetKind::text, .format = {}};
    case KnobKind::integer:
    case KnobKind::real:
        break;
    }
    const double span = knob.maximum() - knob.minimum();
    WidgetSpec spec{.kind = WidgetKind::slider, .format = number_format(knob)};
    if (!std::isfinite(span) || (knob.kind() == KnobKind::integer && span > kMostSteps))
        spec.kind = WidgetKind::drag;
    else
        spec.logarithmic = is_wide(knob);
    spec.can_be_infinite = std::isinf(knob.maximum());
    return spec;
}

KnobValue into_range(const KnobBase& knob, KnobValue value) {
    if (auto* integer = std::get_if<int64_t>(&value))
        *integer = std::clamp(*integer, static_cast<int64_t>(knob.minimum()),
                              static_cast<int64_t>(knob.maximum()));
    else if (auto* real = std::get_if<double>(&value))
        *real = std::clamp(*real, knob.minimum(), knob.maximum());
    return value;
}

} // namespace romascope
