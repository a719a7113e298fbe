// SPDX-License-Identifier: MIT
#include "renderer/base/nearest_name.h"

#include <algorithm>
#include <limits>

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

} // namespace

std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names) {
    std::string best;
    size_t best_distance = std::numeric_limits<size_t>::max();
    for (const std::string& name : names) {
        // Doubled, so that a key's last word alone, "resolution" for "roma.resolution", counts like
        // a whole name but loses to one at the same distance.
        const size_t dot = name.rfind('.');
        size_t distance = edit_distance(wanted, name) * 2;
        if (dot != std::string::npos)
            distance = std::min(
                distance, edit_distance(wanted, std::string_view(name).substr(dot + 1)) * 2 + 1);
        if (distance < best_distance) {
            best_distance = distance;
            best = name;
        }
    }
    return best;
}

} // namespace romascope
