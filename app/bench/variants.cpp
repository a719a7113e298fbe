// SPDX-License-Identifier: MIT
#include "app/bench/variants.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/frame/idle_knobs.h"
#include "renderer/frame/notices.h"
#include "renderer/frame/pipeline.h"
#include "renderer/reuse/running_mean.h"
#include "renderer/settings/quote.h"
#include "renderer/tracers/dda2d/dda2d_tracer.h"
#include "renderer/tracers/roma/roma_knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>
#include <sstream>

namespace romascope {
namespace {

/// Groups of settings that make the picture which all variants share.
constexpr std::string_view kShared[] = {"render.", "frame.", "view.", "lit."};
/// Groups of settings of stages that come after the tracers, which are looked at by themselves.
constexpr std::string_view kLater[] = {"hash.",   "history.", "temporal.",
                                       "atrous.", "taa.",     "mean."};

constexpr std::string_view kByThemselves =
    "tracers are looked at by themselves, without the stages that reuse what they found";

bool is_of(std::string_view key, std::span<const std::string_view> groups) {
    return std::ranges::any_of(groups,
                               [&](std::string_view group) { return key.starts_with(group); });
}

/// A switch of a stage that would be told with the results and has no part in them; null: none is
/// on.
const KnobBase* stage_in_use(const Settings& settings) {
    for (const KnobBase* knob : settings.table().all())
        if (is_of(knob->key(), kLater) && knob->key().ends_with(".enabled") && knob != &kMean &&
            !settings.is_default(*knob))
            return knob;
    return nullptr;
}

void check_stages(const Settings& settings) {
    if (const KnobBase* stage = stage_in_use(settings))
        throw Error(fmt::format("{}: {}; leave it at {}", stage->key(), kByThemselves,
                                to_text(stage->default_value())),
                    kBadInput);
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);)
        parts.push_back(part);
    return parts;
}

std::vector<std::string> tracer_names(const Settings& base,
                                      const std::vector<Variation>& variations) {
    for (const Variation& variation : variations)
        if (variation.knob == &kTracer)
            return variation.values;
    if (!base.get(kTracer).empty())
        return {base.get(kTracer)};
    std::vector<std::string> names;
    for (const TracerEntry& entry : tracers())
        names.emplace_back(entry.name);
    return names;
}

bool concerns(const Variation& variation, const std::string& tracer) {
    return variation.knob != &kTracer && !is_of_other_tracer(*variation.knob, tracer);
}

/// Those that differ in more than idle settings, which are left out of their names. `used` gets the
/// knobs that count in any.
std::vector<BenchVariant> without_idle(const std::vector<BenchVariant>& variants,
                                       const std::vector<Variation>& variations,
                                       std::set<const KnobBase*>& used) {
    std::vector<BenchVariant> kept;
    for (const BenchVariant& variant : variants) {
        const std::string tracer = variant.settings.get(kTracer);
        BenchVariant own{tracer, variant.settings};
        for (const Variation& variation : variations) {
            const KnobBase& knob = *variation.knob;
            if (!concerns(variation, tracer))
                continue;
            if (setting_that_wakes(knob, variant.settings).empty()) {
                used.insert(&knob);
                own.name +=
                    fmt::format(" {}={}", knob.key(), to_text(variant.settings.value(knob)));
            } else {
                own.settings.reset(knob);
            }
        }
        if (std::ranges::find(kept, own.name, &BenchVariant::name) == kept.end())
            kept.push_back(own);
    }
    return kept;
}

/// Refuses a variation that decides nothing in any variant.
void check_used(const std::vector<Variation>& variations, const std::set<const KnobBase*>& used,
                const std::vector<BenchVariant>& variants) {
    for (const Variation& variation : variations) {
        if (used.contains(variation.knob))
            continue;
        for (const BenchVariant& variant : variants)
            if (concerns(variation, variant.settings.get(kTracer)))
                throw Error(fmt::format("--vary {}: it decides nothing without {}",
                                        variation.knob->key(),
                                        setting_that_wakes(*variation.knob, variant.settings)),
                            kBadInput);
        throw Error(
            fmt::format("--vary {}: it concerns none of these tracers", variation.knob->key()),
            kBadInput);
    }
}

constexpr size_t kMostCombinations = size_t{1} << 16;

void check_count(size_t count, size_t allowed, size_t most) {
    if (count > allowed)
        throw Error(fmt::format("--vary: these are more than {} variants", most), kBadInput);
}

} // namespace

void check_technique(const Settings& base, const std::string& technique) {
    if (technique.empty())
        return;
    Settings alone(all_knobs());
    apply_technique(alone, technique);
    const KnobBase* stage = stage_in_use(alone);
    if (!stage || !stage_in_use(base))
        return;
    throw Error(fmt::format("--technique {}: it has {}={}, but {}; take --technique {}", technique,
                            stage->key(), to_text(alone.value(*stage)), kByThemselves,
                            alone.get(kTracer)),
                kBadInput);
}

Variation parse_variation(const Settings& base, const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw Error(fmt::format("--vary {} is not of the form KEY=VALUE,VALUE", quote(text)),
                    kBadInput);
    const std::string key = text.substr(0, equals);
    Variation variation{&base.table().at(key), split(text.substr(equals + 1), ',')};
    if (is_of(key, kLater))
        throw Error(fmt::format("--vary {}: {}", key, kByThemselves), kBadInput);
    if (is_of(key, kShared))
        throw Error(fmt::format("--vary {}: all variants share one picture; give one value with "
                                "--set",
                                key),
                    kBadInput);
    if (variation.values.empty())
        throw Error(fmt::format("--vary {}: no value is given", key), kBadInput);
    std::set<std::string> seen;
    for (std::string& value : variation.values) {
        Settings settings = base;
        settings.set_text(key, value);
        value = to_text(settings.value(*variation.knob)); // on and 1 are true
        if (variation.knob == &kTracer)
            make_tracer(value);
        if (!seen.insert(value).second)
            throw Error(fmt::format("--vary {}: {} is given twice", key, quote(value)), kBadInput);
    }
    return variation;
}

std::vector<Variation> parse_variations(const Settings& base,
                                        const std::vector<std::string>& texts) {
    std::vector<Variation> variations;
    for (const std::string& text : texts) {
        const Variation variation = parse_variation(base, text);
        if (std::ranges::find(variations, variation.knob, &Variation::knob) != variations.end())
            throw Error(fmt::format("--vary {}: it is varied twice", variation.knob->key()),
                        kBadInput);
        variations.push_back(variation);
    }
    return variations;
}

std::vector<Variation> default_variations(const Settings& base, const SettingsOptions& options) {
    std::vector<Variation> variations;
    const std::string only = base.get(kTracer);
    for (const Variation& variation : {Variation{&kRomaAlignment, {"rotate", "shear"}},
                                       Variation{&kDda2dHierarchy, {"true", "false"}}})
        if (!options.decide(*variation.knob, variation.values) &&
            (only.empty() || concerns(variation, only)))
            variations.push_back(variation);
    return variations;
}

std::vector<BenchVariant> expand_variants(const Settings& base,
                                          const std::vector<Variation>& variations, size_t most) {
    check_stages(base);
    std::vector<BenchVariant> all;
    std::set<const KnobBase*> used = {&kTracer};
    for (const std::string& tracer : tracer_names(base, variations)) {
        make_tracer(tracer); // or there is none of this name
        std::vector<BenchVariant> of_tracer = {{tracer, base}};
        of_tracer.front().settings.set(kTracer, tracer);
        for (const Variation& variation : variations) {
            if (!concerns(variation, tracer))
                continue;
            std::vector<BenchVariant> more;
            for (const BenchVariant& variant : of_tracer) {
                for (const std::string& value : variation.values) {
                    more.push_back(variant);
                    more.back().settings.set_text(variation.knob->key(), value);
                }
            }
            of_tracer = std::move(more);
            // Many may be alike, as far as they count, but there is an end to it.
            check_count(of_tracer.size(), kMostCombinations, most);
        }
        of_tracer = without_idle(of_tracer, variations, used);
        all.insert(all.end(), of_tracer.begin(), of_tracer.end());
        check_count(all.size(), most, most);
    }
    check_used(variations, used, all);
    return all;
}

std::vector<std::string> notices_of(const std::vector<BenchVariant>& variants, const Scene& scene) {
    std::vector<std::string> all;
    for (const BenchVariant& variant : variants)
        for (std::string& notice : notices_of(variant.settings, scene))
            if (std::ranges::find(all, notice) == all.end())
                all.push_back(std::move(notice));
    return all;
}

size_t find_variant(const std::vector<BenchVariant>& variants, const std::string& name) {
    const std::vector<std::string> wanted = split(name, ' ');
    std::vector<std::string> names;
    std::vector<size_t> found;
    for (size_t i = 0; i < variants.size(); ++i) {
        names.push_back(variants[i].name);
        if (names.back() == name)
            return i;
        if (std::ranges::all_of(wanted, [&](const std::string& part) {
                return names.back().find(part) != std::string::npos;
            }))
            found.push_back(i);
    }
    if (found.size() == 1)
        return found.front();
    if (found.empty())
        throw Error(fmt::format("--baseline {}: no variant is that{} (the first is '{}')",
                                quote(name), did_you_mean(name, names), names.front()),
                    kBadInput);
    throw Error(fmt::format("--baseline {}: it could be '{}' or '{}'", quote(name), names[found[0]],
                            names[found[1]]),
                kBadInput);
}

} // namespace romascope
