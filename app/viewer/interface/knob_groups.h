// SPDX-License-Identifier: MIT
// The order in which people meet the knobs.
#pragma once

#include "renderer/settings/settings.h"

#include <string>
#include <string_view>
#include <vector>

namespace romascope {

/// Knobs whose keys begin alike.
struct KnobGroup {
    std::string_view key; ///< "roma" of "roma.sampling"
    std::string title;
    std::vector<const KnobBase*> knobs; ///< in the table's order
};

/// All knobs of the table, each once, in the order in which a frame meets them. Groups that no
/// title was written for come last, under their key.
std::vector<KnobGroup> knob_groups(const KnobTable& table);

/// The part of the key before the last dot.
std::string_view group_key(const KnobBase& knob);

/// The part after it, as people read it: "angular resolution".
std::string knob_label(const KnobBase& knob);

/// Whether each word of `filter` is somewhere in key, label or help; case does not count.
bool matches(const KnobBase& knob, std::string_view filter);

/// The setting with which the picture would depend on the knob, like "frame.view=lit"; where
/// several values do, "technique.tracer=dda or dda2d". Empty if it does as the settings are. Of two
/// settings that are needed, the one that comes first.
std::string what_wakes(const KnobBase& knob, const Settings& settings);

/// False for knobs that these settings make no use of: those of other tracers than the chosen one,
/// and those of views that are not shown.
inline bool is_in_use(const KnobBase& knob, const Settings& settings) {
    return what_wakes(knob, settings).empty();
}

} // namespace romascope
