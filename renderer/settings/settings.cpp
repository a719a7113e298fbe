// SPDX-License-Identifier: MIT
#include "renderer/settings/settings.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/settings/quote.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <system_error>

namespace romascope {
namespace {

/// "a whole number, 32 to 256 (cells)".
std::string allowed_text(const KnobBase& knob) {
    std::string text;
    switch (knob.kind()) {
    case KnobKind::boolean:
        return "true or false";
    case KnobKind::choice:
        return "one of " + range_text(knob);
    case KnobKind::text:
        return "text in valid UTF-8";
    case KnobKind::integer:
        text = "a whole number";
        break;
    case KnobKind::real:
        text = "a number";
        break;
    }
    const std::string range = range_text(knob);
    if (range != "any number")
        text += ", " + range;
    if (!knob.unit().empty())
        text += fmt::format(" ({})", knob.unit());
    return text;
}

[[noreturn]] void refuse(const KnobBase& knob, std::string_view given) {
    std::string text = fmt::format("setting '{}' cannot be {}: it takes {}", knob.key(),
                                   quote(given), allowed_text(knob));
    if (knob.kind() == KnobKind::choice) {
        const std::vector<std::string> names(knob.choices().begin(), knob.choices().end());
        text += did_you_mean(given, names, "; ");
    }
    throw Error(text, kBadInput);
}

bool in_range(const KnobBase& knob, double number) { // false for NaN
    return number >= knob.minimum() && number <= knob.maximum();
}

/// Whether a value of the knob's own type is one of its values.
bool is_allowed(const KnobBase& knob, const KnobValue& value) {
    switch (knob.kind()) {
    case KnobKind::boolean:
        return std::holds_alternative<bool>(value);
    case KnobKind::integer: {
        const int64_t* integer = std::get_if<int64_t>(&value);
        return integer && in_range(knob, static_cast<double>(*integer));
    }
    case KnobKind::real: {
        const double* real = std::get_if<double>(&value);
        return real && in_range(knob, *real);
    }
    case KnobKind::choice: {
        const std::string* name = std::get_if<std::string>(&value);
        return name && knob.choice_index(*name) >= 0;
    }
    case KnobKind::text: {
        const std::string* text = std::get_if<std::string>(&value);
        return text && is_utf8(*text);
    }
    }
    return false;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    const size_t begin = text.find_first_not_of(kBlanks);
    return begin == text.npos ? std::string_view()
                              : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// The whole text as a number, whatever the locale.
template <class T>
std::optional<T> number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

std::optional<bool> truth(std::string_view text) {
    if (text == "true" || text == "on" || text == "1")
        return true;
    if (text == "false" || text == "off" || text == "0")
        return false;
    return std::nullopt;
}

} // namespace

Settings::Settings(const KnobTable& table) : table_(&table) {
    for (const KnobBase* knob : table.all())
        values_.push_back(knob->default_value());
}

void Settings::set_value(const KnobBase& knob, KnobValue value) {
    const size_t index = table_->index_of(knob);
    if (const int64_t* integer = std::get_if<int64_t>(&value);
        integer && knob.kind() == KnobKind::real)
        value = static_cast<double>(*integer);
    if (!is_allowed(knob, value))
        refuse(knob, to_text(value));
    values_[index] = std::move(value);
}

void Settings::set_text(std::string_view key, std::string_view value_text) {
    const KnobBase& knob = table_->at(key);
    const std::string_view word = trimmed(value_text);
    const auto set_parsed = [&](const auto& parsed) {
        // What was typed says more than the number it was read as.
        if (!parsed || !is_allowed(knob, *parsed))
            refuse(knob, value_text);
        set_value(knob, *parsed);
    };
    switch (knob.kind()) {
    case KnobKind::boolean:
        return set_parsed(truth(word));
    case KnobKind::integer:
        return set_parsed(number<int64_t>(word));
    case KnobKind::real:
        return set_parsed(number<double>(word));
    case KnobKind::choice:
        return set_value(knob, std::string(word));
    case KnobKind::text:
        return set_value(knob, std::string(value_text));
    }
}

void Settings::set_assignment(std::string_view assignment) {
    const size_t equals = assignment.find('=');
    if (equals == assignment.npos)
        throw Error(fmt::format("{} sets nothing: write key=value", quote(assignment)), kBadInput);
    set_text(trimmed(assignment.substr(0, equals)), assignment.substr(equals + 1));
}

} // namespace romascope
