// SPDX-License-Identifier: MIT
#include "renderer/frame/variants.h"

#include "renderer/frame/pipeline.h"
#include "renderer/passes/deform.h"
#include "renderer/passes/empty.h"
#include "renderer/tracers/occupancy/occupancy_map.h"
#include "renderer/tracers/ray_list.h"
#include "renderer/tracers/roma/roma_knobs.h"

#include <algorithm>

namespace romascope {
namespace {

/// Each choice of each knob in turn, every switch both ways, and every layout of aligned maps, from
/// the defaults.
std::vector<Settings> settings_to_try() {
    std::vector<Settings> all = {Settings(all_knobs())};
    for (const KnobBase* knob : all_knobs().all()) {
        Settings settings(all_knobs());
        for (const std::string_view choice : knob->choices()) {
            settings.set_value(*knob, std::string(choice));
            all.push_back(settings);
        }
        if (knob->kind() == KnobKind::boolean) {
            settings.set_value(*knob, !std::get<bool>(knob->default_value()));
            all.push_back(settings);
        }
        if (knob->kind() == KnobKind::integer || knob->kind() == KnobKind::real) {
            for (const double end : {knob->minimum(), knob->maximum()}) {
                settings.set_text(knob->key(), knob->kind() == KnobKind::integer
                                                   ? to_text(static_cast<int64_t>(end))
                                                   : to_text(end));
                all.push_back(settings);
            }
        }
    }
    Settings settings(all_knobs());
    for (const int resolution : {33, 64, 65, 100, 129}) {
        settings.set(kOccupancyResolution, resolution);
        all.push_back(settings);
    }
    // Each with every alignment, which decides what many of them mean.
    const size_t count = all.size();
    for (size_t i = 0; i < count; ++i) {
        for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
            all.push_back(all[i]);
            all.back().set(kRomaAlignment, alignment);
        }
    }
    return all;
}

} // namespace

std::vector<ShaderVariant> all_shader_variants() {
    std::vector<ShaderVariant> all;
    const auto add = [&](const ShaderVariant& variant) {
        if (std::find(all.begin(), all.end(), variant) == all.end())
            all.push_back(variant);
    };
    add(Deform::variant());
    add(EmptyPass::variant());
    for (const bool one : {false, true}) {
        for (const bool motion : {false, true}) {
            add(GBuffer::variant(one, false, motion));
            add(Taa::variant(one, motion));
        }
        add(GBuffer::variant(true, true, one));
        add(TemporalAccumulation::variant(one));
        add(TemporalAccumulation::clamp_variant(one));
    }
    add(AtrousFilter::variant());
    add(ScreenReuse::history_view_variant());
    add(Present::variant());
    add(RunningMean::variant(GL_R32F));
    add(RunningMean::variant(GL_RGBA32F));
    for (const Settings& settings : settings_to_try()) {
        if (is_composed(settings.get(kView)))
            add(Compose::variant(settings));
        for (const ShaderVariant& variant : SpatialHash::variants(settings))
            add(variant);
        for (const TracerEntry& entry : tracers()) {
            const std::unique_ptr<Tracer> tracer = entry.make();
            add(AmbientOcclusion::variant(settings, *tracer, SpatialHash::is_used(settings)));
            for (const RayQuestion question : {RayQuestion::any_hit, RayQuestion::distance})
                add(RayList::variant(settings, *tracer, question));
            for (const ShaderVariant& variant : tracer->build_variants(settings))
                add(variant);
        }
    }
    return all;
}

} // namespace romascope
