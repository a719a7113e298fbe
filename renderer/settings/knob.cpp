// SPDX-License-Identifier: MIT
#include "renderer/settings/knob.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace romascope {
namespace {

struct ValueText {
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(const std::string& value) const { return value; }
};

} // namespace

std::string_view kind_name(KnobKind kind) {
    switch (kind) {
    case KnobKind::boolean:
        return "boolean";
    case KnobKind::integer:
        return "integer";
    case KnobKind::real:
        return "real";
    case KnobKind::choice:
        return "choice";
    case KnobKind::text:
        return "text";
    }
    return "";
}

int KnobBase::choice_index(std::string_view name) const {
    const auto found = std::find(choices_.begin(), choices_.end(), name);
    return found == choices_.end() ? -1 : static_cast<int>(found - choices_.begin());
}

std::string to_text(const KnobValue& value) { return std::visit(ValueText{}, value); }

std::string range_text(const KnobBase& knob) {
    switch (knob.kind()) {
    case KnobKind::boolean:
        return "true | false";
    case KnobKind::choice:
        return fmt::format("{}", fmt::join(knob.choices(), " | "));
    case KnobKind::text:
        return "any text";
    case KnobKind::integer:
    case KnobKind::real:
        break;
    }
    const bool has_minimum = std::isfinite(knob.minimum());
    const bool has_maximum = std::isfinite(knob.maximum());
    if (has_minimum && has_maximum)
        return fmt::format("{} to {}", knob.minimum(), knob.maximum());
    if (has_minimum)
        return fmt::format("at least {}", knob.minimum());
    if (has_maximum)
        return fmt::format("at most {}", knob.maximum());
    return "any number";
}

} // namespace romascope
