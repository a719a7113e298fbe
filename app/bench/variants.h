// SPDX-License-Identifier: MIT
// What a benchmark compares: tracers, and choices of their settings.
#pragma once

#include "app/settings_options.h"
#include "renderer/scene/scene.h"
#include "renderer/settings/settings.h"

#include <string>
#include <vector>

namespace romascope {

/// Several values of one setting, as people write them.
struct Variation {
    const KnobBase* knob;
    std::vector<std::string> values;
};

/// One thing to measure.
struct BenchVariant {
    std::string name; ///< the tracer and its own choices, like "roma roma.alignment=shear"
    Settings settings;
};

/// Refuses a technique by whose doing `base` has a stage after the tracers, as the spatial hash,
/// and names the one of its tracer alone, which is named like it. Empty: none was given. Throws
/// Error (kBadInput).
void check_technique(const Settings& base, const std::string& technique);

/// "key=a,b,c". Throws Error (kBadInput) for what is no setting, no value of it, given twice, or a
/// setting that all variants share (picture, camera, time, view).
Variation parse_variation(const Settings& base, const std::string& text);

/// Several of those, of different settings. Throws Error (kBadInput) as parse_variation does.
std::vector<Variation> parse_variations(const Settings& base,
                                        const std::vector<std::string>& texts);

/// What is compared where nothing else was asked for: the alignments of ROMA, the hierarchy on and
/// off; but for settings that the options decide, be it by their technique, or whose tracer `base`,
/// which is what the options make of a command's settings, does not name.
std::vector<Variation> default_variations(const Settings& base, const SettingsOptions& options);

inline constexpr size_t kMostBenchVariants = 64;

/// Every tracer (the one in `base`, if it names one, or those of a variation), with every
/// combination of the values of those variations that concern it. Settings that another one's value
/// makes meaningless, such as taps of a rotation, make no variants.
/// Throws Error (kBadInput) for an unknown tracer, a variation that concerns none, or more than
/// `most` variants.
std::vector<BenchVariant> expand_variants(const Settings& base,
                                          const std::vector<Variation>& variations,
                                          size_t most = kMostBenchVariants);

/// What does not come of what variants ask of a scene, see notices.h; each once.
std::vector<std::string> notices_of(const std::vector<BenchVariant>& variants, const Scene& scene);

/// The place of the variant with that name, or of the only one that has all its words.
/// Throws Error (kBadInput) if there is none or more than one.
size_t find_variant(const std::vector<BenchVariant>& variants, const std::string& name);

} // namespace romascope
