// SPDX-License-Identifier: MIT
#include "renderer/base/did_you_mean.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace romascope {
namespace {

/// ASCII only, whatever the locale.
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance.
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i)
        d[i][0] = i;
    for (size_t j = 0; j <= b.size(); ++j)
        d[0][j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        for (size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            d[i][j] =
                std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

/// The distance if `wanted` may be `name` misspelt.
std::optional<size_t> distance_if_near(std::string_view wanted, std::string_view name) {
    const size_t longer = std::max(wanted.size(), name.size());
    const size_t distance = edit_distance(wanted, name);
    const bool near = distance <= std::max<size_t>(longer * 3 / 8, 1) && distance < longer;
    return near || distance == 0 ? std::optional(distance) : std::nullopt;
}

struct DottedName {
    std::string_view group, word;
    bool has_group;

    explicit DottedName(std::string_view name) {
        const size_t dot = name.rfind('.');
        has_group = dot != name.npos;
        group = has_group ? name.substr(0, dot) : std::string_view();
        word = has_group ? name.substr(dot + 1) : name;
    }
};

/// Twice the distance from `text` to `candidate`, and 1 more if a group is left out, so that a word
/// alone counts like a whole name but loses to one at the same distance.
std::optional<size_t> misspelling(std::string_view text, std::string_view candidate) {
    const DottedName wanted(text), name(candidate);
    const std::optional<size_t> word = distance_if_near(wanted.word, name.word);
    if (wanted.has_group && name.has_group) {
        const bool near = distance_if_near(wanted.group, name.group).has_value();
        if (!word || (!near && *word > 0))
            return std::nullopt;
        return 2 * (*word + edit_distance(wanted.group, name.group));
    }
    std::optional<size_t> found;
    if (const std::optional<size_t> whole = distance_if_near(text, candidate))
        found = 2 * *whole;
    if (word && !wanted.has_group)
        found = std::min(found.value_or(2 * *word + 1), 2 * *word + 1);
    return found;
}

} // namespace

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
    std::string best;
    size_t fewest = std::numeric_limits<size_t>::max();
    for (const std::string& name : names) {
        const std::optional<size_t> found = misspelling(wanted, name);
        if (found && *found < fewest) {
            fewest = *found;
            best = name;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names,
                         std::string_view before) {
    const std::string name = nearest_name(wanted, names);
    if (name.empty())
        return name;
    std::string text(before);
    return text.append("did you mean '").append(name).append("'?");
}

} // namespace romascope
