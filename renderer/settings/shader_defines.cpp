// SPDX-License-Identifier: MIT
#include "renderer/settings/shader_defines.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <stdexcept>

namespace romascope {
namespace {

[[noreturn]] void mistake(const KnobBase& knob, std::string_view what) {
    throw std::logic_error(fmt::format("knob '{}' as a shader define: {}", knob.key(), what));
}

std::string define_name(std::string_view text) {
    std::string name(text);
    for (char& c : name)
        c = c == '.' || c == '-' ? '_' : (c >= 'a' && c <= 'z') ? static_cast<char>(c - 32) : c;
    return name;
}

std::string in_parentheses(bool negative, std::string text) {
    return negative ? "(" + text + ")" : text;
}

std::string integer_literal(const KnobBase& knob, int64_t value) {
    // Without the smallest int, whose literal is a minus and a number that is too large.
    constexpr double kLargest = std::numeric_limits<int>::max();
    if (knob.minimum() < -kLargest || knob.maximum() > kLargest)
        mistake(knob, "its range does not fit an int of GLSL");
    return in_parentheses(value < 0, fmt::format("{}", value));
}

std::string float_literal(double value) {
    // A conversion to float that overflows is undefined.
    const bool infinite = std::abs(value) > std::numeric_limits<float>::max();
    if (infinite)
        return value > 0 ? "uintBitsToFloat(0x7F800000u)" : "uintBitsToFloat(0xFF800000u)";
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == text.npos)
        text += ".0";
    return in_parentheses(std::signbit(value), text);
}

} // namespace

std::vector<ShaderDefine> shader_defines(const Settings& settings,
                                         const std::vector<const KnobBase*>& knobs) {
    std::vector<ShaderDefine> defines;
    std::set<std::string> taken;
    const auto add = [&](const KnobBase& knob, std::string name, std::string value) {
        if (name.starts_with("GL_"))
            mistake(knob, name + " is reserved in GLSL");
        if (!taken.insert(name).second)
            mistake(knob, name + " is defined twice");
        defines.push_back({std::move(name), std::move(value)});
    };
    for (const KnobBase* knob : knobs) {
        const KnobValue value = settings.value(*knob);
        const std::string name = define_name(knob->key());
        switch (knob->kind()) {
        case KnobKind::boolean:
            add(*knob, name, std::get<bool>(value) ? "1" : "0");
            break;
        case KnobKind::integer:
            add(*knob, name, integer_literal(*knob, std::get<int64_t>(value)));
            break;
        case KnobKind::real:
            add(*knob, name, float_literal(std::get<double>(value)));
            break;
        case KnobKind::choice:
            add(*knob, name, fmt::format("{}", knob->choice_index(std::get<std::string>(value))));
            for (size_t i = 0; i < knob->choices().size(); ++i)
                add(*knob, name + "_" + define_name(knob->choices()[i]), fmt::format("{}", i));
            break;
        case KnobKind::text:
            mistake(*knob, "a shader has no text");
        }
    }
    return defines;
}

} // namespace romascope
