// SPDX-License-Identifier: MIT
#include "renderer/frame/technique.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/embedded_text.h"
#include "renderer/base/error.h"
#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/passes/compose.h"
#include "renderer/reuse/running_mean.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "renderer/tracers/structure_view.h"
#include "renderer/tracers/tracer.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {
namespace {

constexpr std::string_view kExtension = ".toml";

std::string first_comment(std::string_view text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const size_t begin = line.find_first_not_of("# ");
    return begin == std::string_view::npos ? std::string{} : std::string(line.substr(begin));
}

/// The tracer, all that tracers can be told, what is shown of them, as each has other views, and
/// all else that some technique sets.
std::vector<const KnobBase*> technique_knobs() {
    std::vector<const KnobBase*> knobs = tracer_knobs();
    for (const KnobBase* knob : structure_view_knobs())
        knobs.push_back(knob);
    knobs.push_back(&kTracer);
    for (const Technique& technique : techniques()) {
        Settings settings(all_knobs());
        apply_technique(settings, technique.name);
        for (const KnobBase* knob : all_knobs().all())
            if (!settings.is_default(*knob) && std::ranges::find(knobs, knob) == knobs.end())
                knobs.push_back(knob);
    }
    return knobs;
}

} // namespace

double time_of_frame(const Settings& settings, int frame) {
    const double fps = settings.get(kFps);
    return settings.get(kTime) + (fps > 0.0 ? frame / fps : 0.0);
}

const KnobTable& all_knobs() {
    static const KnobTable table = [] {
        std::vector<const KnobBase*> knobs = {&kWidth,  &kHeight,   &kFrames, &kSeed,
                                              &kCamera, &kTime,     &kFps,    &kAnimation,
                                              &kTracer, &kAntialias};
        for (const auto& more :
             {compose_knobs(), ambient_occlusion_knobs(), spatial_hash_knobs(), tracer_knobs(),
              structure_view_knobs(), screen_reuse_knobs(), std::vector<const KnobBase*>{&kMean}})
            knobs.insert(knobs.end(), more.begin(), more.end());
        return KnobTable(knobs);
    }();
    return table;
}

const std::vector<Technique>& techniques() {
    static const std::vector<Technique> list = [] {
        std::vector<Technique> found;
        for (const auto& [file, text] : embedded_config())
            found.push_back({std::string(file.substr(0, file.size() - kExtension.size())),
                             first_comment(text)});
        std::ranges::sort(found, {}, &Technique::name); // as names, not as files with an extension
        return found;
    }();
    return list;
}

void apply_technique(Settings& settings, const std::string& name) {
    const auto found = embedded_config().find(name + std::string(kExtension));
    if (found == embedded_config().end()) {
        std::vector<std::string> names;
        for (const Technique& technique : techniques())
            names.push_back(technique.name);
        throw Error(fmt::format("unknown technique '{}'{} (there are {})", name,
                                did_you_mean(name, names), fmt::join(names, ", ")),
                    kBadInput);
    }
    settings.load_toml_text(found->second, fmt::format("config/{}", found->first));
}

void change_technique(Settings& settings, const std::string& name) {
    static const std::vector<const KnobBase*> knobs = technique_knobs();
    Settings changed = settings;
    for (const KnobBase* knob : knobs)
        changed.reset(*knob);
    apply_technique(changed, name);
    settings = std::move(changed);
}

} // namespace romascope
