// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/knob.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace romascope {

/// The knobs of a program, in the order given. Build it after `main` has started: knobs are
/// initialised in no certain order before that.
class KnobTable {
public:
    /// Throws std::logic_error, naming the knob, for a mistake in a declaration: a key that is not
    /// lower-case words with dots ("group.name"), is taken, or is also the group of another key; no
    /// help; text of more than one line; an empty range, a default outside it; choices that are
    /// none, not lower-case words, or not distinct.
    explicit KnobTable(std::vector<const KnobBase*> knobs);

    /// Null if there is no such key.
    const KnobBase* find(std::string_view key) const;
    /// Throws Error (kBadInput): "unknown setting 'x': did you mean 'y'?".
    const KnobBase& at(std::string_view key) const;
    const std::vector<const KnobBase*>& all() const { return knobs_; }
    /// Place of the knob in `all()`. Throws std::logic_error if it is not in this table.
    size_t index_of(const KnobBase& knob) const;

private:
    std::vector<const KnobBase*> knobs_;
    std::unordered_map<std::string_view, size_t> by_key_;
};

/// A value for each knob of a table, always within its range. Copyable; equal if the knobs and all
/// values are. The table must outlive it. Using a knob that is not in the table is a
/// std::logic_error. Whatever fails leaves the settings as they were.
class Settings {
public:
    /// All defaults.
    explicit Settings(const KnobTable& table);
    explicit Settings(KnobTable&&) = delete;

    template <class T>
    T get(const Knob<T>& knob) const {
        return knob.from_value(values_[table_->index_of(knob)]);
    }
    /// Throws Error (kBadInput) naming key, value and range if the value is outside the range.
    template <class T>
    void set(const Knob<T>& knob, std::type_identity_t<T> value) {
        set_value(knob, knob.to_value(std::move(value)));
    }

    KnobValue value(const KnobBase& knob) const { return values_[table_->index_of(knob)]; }
    /// Like `set`, for code that does not know the type. An integer is taken for a real; any other
    /// type that is not the knob's is an Error.
    void set_value(const KnobBase& knob, KnobValue value);
    bool is_default(const KnobBase& knob) const { return value(knob) == knob.default_value(); }
    void reset(const KnobBase& knob) { values_[table_->index_of(knob)] = knob.default_value(); }

    /// A value as people write it on a command line: 64, 0.5, inf, true/false/on/off/1/0, the name
    /// of a choice, or any text. Throws Error (kBadInput) naming key, value, and what is allowed.
    void set_text(std::string_view key, std::string_view value_text);
    /// "key=value", as `--set` takes it.
    void set_assignment(std::string_view assignment);

    /// Sets what the file gives and leaves the rest as it is; all or nothing. Keys are nested
    /// tables or dotted. Throws Error (kBadInput) with file, line, key and what is allowed.
    void load_toml(const std::filesystem::path& path);
    /// `source_name` stands for the file in errors.
    void load_toml_text(std::string_view text, std::string_view source_name);
    /// Every knob with a comment, grouped in tables. Loaded into any settings of this table, it
    /// gives settings equal to these, to the last bit.
    std::string to_toml() const;
    /// The same of what is not default alone, without comments.
    std::string changes_to_toml() const;

    const KnobTable& table() const { return *table_; }

    friend bool operator==(const Settings& a, const Settings& b) {
        return a.table_->all() == b.table_->all() && a.values_ == b.values_;
    }

private:
    const KnobTable* table_;
    std::vector<KnobValue> values_; // in the order of table_->all()
};

/// For each knob a line with key, type, default, range and unit in columns, then help and source.
std::string knobs_as_text(const KnobTable& table);

} // namespace romascope
