// SPDX-License-Identifier: MIT
// The only place that knows toml++, which takes long to compile.
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/settings/quote.h"
#include "renderer/settings/settings.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <toml++/toml.h>

namespace romascope {
namespace {

/// A key of the file that holds a value or an empty table.
struct Entry {
    std::string key;
    unsigned line;
    const toml::node* node;
};

/// Leaves of the tree of tables, in no useful order.
void collect(const toml::table& table, const std::string& group, std::vector<Entry>& entries) {
    for (const auto& [name, node] : table) {
        const std::string key =
            group.empty() ? std::string(name.str()) : fmt::format("{}.{}", group, name.str());
        const toml::table* inner = node.as_table();
        if (inner && !inner->empty())
            collect(*inner, key, entries);
        else
            entries.push_back({key, name.source().begin.line, &node});
    }
}

bool is_group(const KnobTable& table, const std::string& key) {
    const auto& knobs = table.all();
    return std::any_of(knobs.begin(), knobs.end(),
                       [&](const KnobBase* knob) { return knob->key().starts_with(key + "."); });
}

void apply(Settings& settings, const std::string& key, const toml::node& node) {
    if (node.is_table() && is_group(settings.table(), key))
        return; // a table with nothing in it
    const KnobBase& knob = settings.table().at(key);
    if (const auto* boolean = node.as_boolean())
        settings.set_value(knob, boolean->get());
    else if (const auto* integer = node.as_integer())
        settings.set_value(knob, integer->get());
    else if (const auto* real = node.as_floating_point())
        settings.set_value(knob, real->get());
    else if (const auto* text = node.as_string())
        settings.set_value(knob, text->get());
    else
        throw Error(fmt::format("setting '{}' cannot be {}: it takes a single value, {}", key,
                                node.is_table()   ? "a table"
                                : node.is_array() ? "a list"
                                                  : "a date or time",
                                range_text(knob)),
                    kBadInput);
}

std::string toml_string(const std::string& text) {
    std::ostringstream out;
    out << toml::toml_formatter(toml::value<std::string>(text),
                                toml::format_flags::allow_unicode_strings);
    return out.str();
}

std::string toml_value(const KnobValue& value) {
    if (const std::string* text = std::get_if<std::string>(&value))
        return toml_string(*text);
    std::string text = to_text(value);
    // A real looks like one: 128.0, so that its type can be seen in the file.
    if (std::holds_alternative<double>(value) && text.find_first_of(".ein") == text.npos)
        text += ".0";
    return text;
}

} // namespace

void Settings::load_toml(const std::filesystem::path& path) {
    load_toml_text(read_text_file(path), path.string());
}

void Settings::load_toml_text(std::string_view text, std::string_view source_name) {
    const auto fail = [&](unsigned line, std::string_view what) {
        throw Error(fmt::format("{}:{}: {}", source_name, line, what), kBadInput);
    };
    toml::table root;
    try {
        root = toml::parse(text, source_name);
    } catch (const toml::parse_error& error) {
        std::string what(error.description());
        std::replace(what.begin(), what.end(), '\n', ' ');
        fail(error.source().begin.line, what);
    }

    // In the order of the file, so that the first mistake is the one reported.
    std::vector<Entry> entries;
    collect(root, "", entries);
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.line < b.line; });
    Settings loaded = *this;
    std::set<std::string> seen;
    for (const Entry& entry : entries) {
        // toml++ finds keys given twice, but not "a.b" in quotes beside a.b.
        if (!seen.insert(entry.key).second)
            fail(entry.line, fmt::format("setting {} is given twice", quote(entry.key)));
        try {
            apply(loaded, entry.key, *entry.node);
        } catch (const Error& error) {
            fail(entry.line, error.what());
        }
    }
    *this = std::move(loaded);
}

std::string Settings::to_toml() const {
    const auto group_of = [](const KnobBase& knob) {
        return knob.key().substr(0, knob.key().rfind('.'));
    };
    std::vector<std::string_view> groups;
    for (const KnobBase* knob : table_->all()) {
        if (std::find(groups.begin(), groups.end(), group_of(*knob)) == groups.end())
            groups.push_back(group_of(*knob));
    }
    std::string text;
    for (const std::string_view group : groups) {
        text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", group);
        for (const KnobBase* knob : table_->all()) {
            if (group_of(*knob) != group)
                continue;
            const std::string unit = knob->unit().empty() ? "" : fmt::format(" {}", knob->unit());
            text += fmt::format("# {} ({}{}; default {})\n{} = {}\n", knob->help(),
                                range_text(*knob), unit, toml_value(knob->default_value()),
                                knob->key().substr(group.size() + 1), toml_value(value(*knob)));
        }
    }
    return text;
}

std::string Settings::changes_to_toml() const {
    std::string text;
    for (const KnobBase* knob : table_->all())
        if (!is_default(*knob))
            text += fmt::format("{} = {}\n", knob->key(), toml_value(value(*knob)));
    return text;
}

} // namespace romascope
