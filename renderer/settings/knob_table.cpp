// SPDX-License-Identifier: MIT
#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/settings/quote.h"
#include "renderer/settings/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>
#include <stdexcept>

namespace romascope {
namespace {

[[noreturn]] void mistake(const KnobBase& knob, std::string_view what) {
    throw std::logic_error(fmt::format("knob '{}': {}", knob.key(), what));
}

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Letters and digits with single separators between them.
bool is_word(std::string_view word, std::string_view separators) {
    bool after_separator = true;
    for (const char c : word) {
        const bool separator = separators.find(c) != std::string_view::npos;
        if ((!separator && !is_letter(c) && !is_digit(c)) || (separator && after_separator))
            return false;
        after_separator = separator;
    }
    return !after_separator;
}

/// At least two words, each starting with a letter: a bare key of TOML and a name in a shader.
bool is_key(std::string_view key) {
    int words = 0;
    for (size_t begin = 0; begin <= key.size(); ++words) {
        const size_t end = std::min(key.find('.', begin), key.size());
        const std::string_view word = key.substr(begin, end - begin);
        if (!is_word(word, "_") || !is_letter(word.front()))
            return false;
        begin = end + 1;
    }
    return words >= 2;
}

bool one_line(std::string_view text) {
    return std::none_of(text.begin(), text.end(),
                        [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

void check_range(const KnobBase& knob) {
    constexpr double kExact = 9007199254740992.0; // 2^53
    const double low = knob.minimum(), high = knob.maximum();
    if (!(low <= high)) // also if one of them is NaN
        mistake(knob, fmt::format("its range, {} to {}, is empty", low, high));
    if (knob.kind() == KnobKind::integer && !(std::abs(low) < kExact && std::abs(high) < kExact))
        mistake(knob, "a limit is not smaller than 2^53");
    const KnobValue& value = knob.default_value();
    const double number = knob.kind() == KnobKind::integer
                              ? static_cast<double>(std::get<int64_t>(value))
                              : std::get<double>(value);
    if (!(number >= low && number <= high))
        mistake(knob, fmt::format("its default, {}, is outside its range, {}", to_text(value),
                                  range_text(knob)));
}

void check_choices(const KnobBase& knob) {
    std::set<std::string_view> seen;
    for (const std::string_view name : knob.choices()) {
        if (!is_word(name, "_-"))
            mistake(knob, fmt::format("choice '{}' is not a lower-case word", name));
        if (!seen.insert(name).second)
            mistake(knob, fmt::format("choice '{}' is there twice", name));
    }
    if (knob.choice_index(std::get<std::string>(knob.default_value())) < 0)
        mistake(knob, "its default is none of its choices");
}

void check(const KnobBase& knob) {
    if (!is_key(knob.key()))
        mistake(knob, "a key is lower-case words with dots, like group.name");
    if (knob.help().empty())
        mistake(knob, "it has no help");
    if (!one_line(knob.help()) || !one_line(knob.unit()) || !one_line(knob.source()))
        mistake(knob, "help, unit and source are one line each");
    if (knob.kind() == KnobKind::integer || knob.kind() == KnobKind::real)
        check_range(knob);
    if (knob.kind() == KnobKind::choice)
        check_choices(knob);
    if (knob.kind() == KnobKind::text && !is_utf8(std::get<std::string>(knob.default_value())))
        mistake(knob, "its default is not valid UTF-8");
}

} // namespace

KnobTable::KnobTable(std::vector<const KnobBase*> knobs) : knobs_(std::move(knobs)) {
    for (size_t i = 0; i < knobs_.size(); ++i) {
        if (!knobs_[i])
            throw std::logic_error("a knob table holds a null pointer");
        check(*knobs_[i]);
        if (!by_key_.emplace(knobs_[i]->key(), i).second)
            mistake(*knobs_[i], "the key is taken");
    }
    for (const KnobBase* knob : knobs_) {
        const std::string_view key = knob->key();
        for (size_t dot = key.find('.'); dot != key.npos; dot = key.find('.', dot + 1)) {
            if (find(key.substr(0, dot)))
                mistake(*knob, fmt::format("its group, '{}', is a knob too", key.substr(0, dot)));
        }
    }
}

const KnobBase* KnobTable::find(std::string_view key) const {
    const auto found = by_key_.find(key);
    return found == by_key_.end() ? nullptr : knobs_[found->second];
}

const KnobBase& KnobTable::at(std::string_view key) const {
    if (const KnobBase* knob = find(key))
        return *knob;
    std::vector<std::string> keys;
    for (const KnobBase* knob : knobs_)
        keys.emplace_back(knob->key());
    const std::string meant = did_you_mean(key, keys);
    throw Error(fmt::format("unknown setting {}{}", quote(key),
                            meant.empty() ? ": 'romascope info --knobs' lists all" : meant),
                kBadInput);
}

size_t KnobTable::index_of(const KnobBase& knob) const {
    const auto found = by_key_.find(knob.key());
    if (found == by_key_.end() || knobs_[found->second] != &knob)
        mistake(knob, "it is not in the table of these settings");
    return found->second;
}

std::string knobs_as_text(const KnobTable& table) {
    constexpr size_t kColumns = 5;
    using Row = std::array<std::string, kColumns>;
    std::vector<Row> rows = {{"key", "type", "default", "range", "unit"}};
    for (const KnobBase* knob : table.all()) {
        const bool is_text = knob->kind() == KnobKind::text;
        const std::string value = to_text(knob->default_value());
        rows.push_back({std::string(knob->key()), std::string(kind_name(knob->kind())),
                        is_text ? quote(value) : value, range_text(*knob),
                        std::string(knob->unit())});
    }
    std::string text;
    std::array<size_t, kColumns> widths{};
    for (const Row& row : rows) {
        for (size_t c = 0; c < kColumns; ++c)
            widths[c] = std::max(widths[c], row[c].size());
    }
    for (size_t i = 0; i < rows.size(); ++i) {
        std::string line;
        for (size_t c = 0; c < kColumns; ++c)
            line += fmt::format("{:<{}}  ", rows[i][c], widths[c]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
        if (i == 0)
            continue;
        const KnobBase& knob = *table.all()[i - 1];
        text += fmt::format("    {}", knob.help());
        if (!knob.source().empty())
            text += fmt::format(" [default: {}]", knob.source());
        text += "\n";
    }
    return text;
}

} // namespace romascope
