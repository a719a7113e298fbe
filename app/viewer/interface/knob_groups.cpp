// SPDX-License-Identifier: MIT
#include "app/viewer/interface/knob_groups.h"

#include "renderer/frame/idle_knobs.h"
#include "renderer/frame/technique.h"
#include "renderer/passes/compose.h"
#include "renderer/reuse/spatial_hash/spatial_hash.h"
#include "renderer/tracers/tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>
#include <utility>

namespace romascope {
namespace {

constexpr std::pair<std::string_view, std::string_view> kTitles[] = {
    {"technique", "Technique"},
    {"render", "Picture and camera"},
    {"frame", "View"},
    {"view", "Depth and structures"},
    {"lit", "Lit view"},
    {"occupancy", "Occupancy map"},
    {"roma", "ROMA"},
    {"dda", "3D DDA"},
    {"dda2d", "2D DDA"},
    {"samples", "Samples along a ray"},
    {"ao", "Ambient occlusion"},
    {"hash", "Spatial hash"},
    {"history", "What was before"},
    {"temporal", "Temporal accumulation"},
    {"atrous", "A-trous filter"},
    {"taa", "Temporal antialiasing"},
    {"mean", "Mean of frames"},
};

size_t place_of(std::string_view group) {
    const auto found =
        std::ranges::find(kTitles, group, [](const auto& pair) { return pair.first; });
    return static_cast<size_t>(found - std::begin(kTitles));
}

std::string as_words(std::string_view text) {
    std::string words(text);
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string title_of(std::string_view group) {
    const size_t place = place_of(group);
    if (place < std::size(kTitles))
        return std::string(kTitles[place].second);
    std::string title = as_words(group);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

std::string lower(std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return out;
}

/// What a knob of views is for.
PictureKind view_of(const KnobBase& knob) {
    if (&knob == &kHashView)
        return PictureKind::hash;
    return &knob == &kDepthRange ? PictureKind::depth : PictureKind::structure;
}

/// The knob "enabled" of the same group, if it switches the stage of this one on; else null.
const KnobBase* switch_of(const KnobBase& knob, const KnobTable& table) {
    std::string key(group_key(knob));
    key += ".enabled";
    const KnobBase* const enabled = table.find(key);
    return enabled == &knob ? nullptr : enabled;
}

} // namespace

std::string_view group_key(const KnobBase& knob) {
    return knob.key().substr(0, knob.key().rfind('.'));
}

std::string knob_label(const KnobBase& knob) {
    return as_words(knob.key().substr(knob.key().rfind('.') + 1));
}

std::vector<KnobGroup> knob_groups(const KnobTable& table) {
    std::vector<KnobGroup> groups;
    for (const KnobBase* knob : table.all()) {
        const std::string_view key = group_key(*knob);
        auto group = std::ranges::find(groups, key, &KnobGroup::key);
        if (group == groups.end())
            group = groups.insert(groups.end(), {key, title_of(key), {}});
        group->knobs.push_back(knob);
    }
    std::ranges::stable_sort(groups, {},
                             [](const KnobGroup& group) { return place_of(group.key); });
    return groups;
}

bool matches(const KnobBase& knob, std::string_view filter) {
    const std::string text = lower(std::string(knob.key())
                                       .append(" ")
                                       .append(knob_label(knob))
                                       .append(" ")
                                       .append(knob.help()));
    std::istringstream words(lower(filter));
    return std::all_of(
        std::istream_iterator<std::string>(words), std::istream_iterator<std::string>(),
        [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

std::string what_wakes(const KnobBase& knob, const Settings& settings) {
    const std::string_view group = group_key(knob);
    if (group == "lit" || group == "view") {
        const PictureKind wanted = group == "lit" ? PictureKind::lit : view_of(knob);
        if (settings.get(kView) != wanted)
            return fmt::format("{}={}", kView.key(), to_text(kView.to_value(wanted)));
    }
    if (group == "hash" && &knob != &kHashEnabled && !SpatialHash::is_used(settings))
        return fmt::format("{}=true", kHashEnabled.key());
    if (group == "history" && !ScreenReuse::looks_back(settings))
        return fmt::format("{}=true or {}=true", kTemporal.key(), kTaa.key());
    const KnobBase* enabled = switch_of(knob, settings.table());
    // The hash is also used by its own view.
    if (enabled && enabled != &kHashEnabled && !std::get<bool>(settings.value(*enabled)))
        return fmt::format("{}=true", enabled->key());
    if (!is_of_other_tracer(knob, settings.get(kTracer)))
        return setting_that_wakes(knob, settings);
    std::vector<std::string_view> names;
    for (const TracerEntry& tracer : tracers())
        if (!is_of_other_tracer(knob, tracer.name))
            names.push_back(tracer.name);
    return fmt::format("{}={}", kTracer.key(), fmt::join(names, " or "));
}

} // namespace romascope
