// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace romascope {

enum class KnobKind { boolean, integer, real, choice, text };

/// "boolean", "integer", "real", "choice" or "text".
std::string_view kind_name(KnobKind kind);

/// A choice is held by its name.
using KnobValue = std::variant<bool, int64_t, double, std::string>;

/// What people read about a knob. All of it must be string literals: nothing is copied.
struct KnobText {
    std::string_view key;    ///< lower-case words with dots: "roma.angular_resolution"
    std::string_view unit;   ///< "cells", "m", "degrees"; empty: a pure number, a name
    std::string_view help;   ///< one sentence
    std::string_view source; ///< where the default comes from: paper and section, or a measurement
};

/// One setting, declared once, as an `inline const Knob<T>` in the folder of the method it belongs
/// to. From that declaration come the TOML key, `--set` and its errors, the list of knobs, the
/// shader define, and the widget. Its value lives in Settings. A knob is known by its address.
/// Declarations are not checked here but by KnobTable, where a mistake can be reported.
class KnobBase {
public:
    KnobBase(const KnobBase&) = delete;
    KnobBase& operator=(const KnobBase&) = delete;

    std::string_view key() const { return text_.key; }
    std::string_view unit() const { return text_.unit; }
    std::string_view help() const { return text_.help; }
    std::string_view source() const { return text_.source; }
    KnobKind kind() const { return kind_; }
    const KnobValue& default_value() const { return default_; }

    /// Both ends belong to the range; infinite where there is no limit. Integer and real only.
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

    /// Names in the order of the enumerators; empty unless this is a choice.
    const std::vector<std::string_view>& choices() const { return choices_; }
    /// Place of `name` in `choices()`, or -1.
    int choice_index(std::string_view name) const;

protected:
    KnobBase(const KnobText& text, KnobKind kind, KnobValue default_value, double minimum = 0,
             double maximum = 0, std::vector<std::string_view> choices = {})
        : text_(text), kind_(kind), default_(std::move(default_value)), minimum_(minimum),
          maximum_(maximum), choices_(std::move(choices)) {}
    ~KnobBase() = default;

    /// The name at `index`; empty if there is none, which no check of values lets pass.
    static std::string choice_name(const std::vector<std::string_view>& choices, int64_t index) {
        const bool known = index >= 0 && index < static_cast<int64_t>(choices.size());
        return known ? std::string(choices[static_cast<size_t>(index)]) : std::string();
    }

private:
    KnobText text_;
    KnobKind kind_;
    KnobValue default_;
    double minimum_, maximum_;
    std::vector<std::string_view> choices_;
};

/// T: bool, an integer, double, std::string, or an enum class with enumerators 0, 1, 2, ...
template <class T>
class Knob;

template <>
class Knob<bool> final : public KnobBase {
public:
    Knob(const KnobText& text, bool default_value)
        : KnobBase(text, KnobKind::boolean, default_value) {}
    static KnobValue to_value(bool value) { return value; }
    static bool from_value(const KnobValue& value) { return std::get<bool>(value); }
};

/// Limits must be smaller than 2^53 in size, where doubles still hold every integer.
template <std::integral T>
class Knob<T> final : public KnobBase {
public:
    Knob(const KnobText& text, T default_value, T minimum, T maximum)
        : KnobBase(text, KnobKind::integer, static_cast<int64_t>(default_value),
                   static_cast<double>(minimum), static_cast<double>(maximum)) {}
    static KnobValue to_value(T value) { return static_cast<int64_t>(value); }
    static T from_value(const KnobValue& value) { return static_cast<T>(std::get<int64_t>(value)); }
};

/// Infinity is a value where `maximum` is infinite, and likewise below. NaN never is one.
template <>
class Knob<double> final : public KnobBase {
public:
    Knob(const KnobText& text, double default_value, double minimum, double maximum)
        : KnobBase(text, KnobKind::real, default_value, minimum, maximum) {}
    static KnobValue to_value(double value) { return value; }
    static double from_value(const KnobValue& value) { return std::get<double>(value); }
};

/// Any valid UTF-8.
template <>
class Knob<std::string> final : public KnobBase {
public:
    Knob(const KnobText& text, std::string default_value)
        : KnobBase(text, KnobKind::text, std::move(default_value)) {}
    static KnobValue to_value(std::string value) { return value; }
    static std::string from_value(const KnobValue& value) { return std::get<std::string>(value); }
};

/// `names`: one lower-case word for each enumerator, in their order 0, 1, 2, ...
template <class T>
requires std::is_enum_v<T>
class Knob<T> final : public KnobBase {
public:
    Knob(const KnobText& text, T default_value, std::initializer_list<std::string_view> names)
        : KnobBase(text, KnobKind::choice, choice_name(names, static_cast<int64_t>(default_value)),
                   0, 0, names) {}
    KnobValue to_value(T value) const {
        return choice_name(choices(), static_cast<int64_t>(value));
    }
    T from_value(const KnobValue& value) const {
        return static_cast<T>(choice_index(std::get<std::string>(value)));
    }
};

/// Shortest text that reads back to the same value: "0.1", "128", "inf", "true"; text as it is.
std::string to_text(const KnobValue& value);

/// "32 to 256", "at least 0", "at most 1", "any number", "snap | candidates", "true | false",
/// "any text". Without the unit.
std::string range_text(const KnobBase& knob);

} // namespace romascope
