// SPDX-License-Identifier: MIT
#include "app/viewer/interface/known_names.h"

#include "app/viewer/session.h"
#include "renderer/frame/technique.h"
#include "renderer/tracers/structure_view.h"
#include "renderer/tracers/tracer.h"

#include <fmt/format.h>

namespace romascope {
namespace {

KnownNames tracer_names() {
    KnownNames known{.names = {}, .only_these = true, .empty = {}};
    for (const TracerEntry& tracer : tracers())
        known.names.push_back(
            {std::string(tracer.name), std::string(tracer.name), std::string(tracer.description)});
    return known;
}

KnownNames camera_names(const Scene& scene) {
    KnownNames known{.names = {}, .empty = "the first"};
    for (const Camera& camera : scene.cameras)
        known.names.push_back({camera.name, camera.name, {}});
    return known;
}

KnownNames animation_names(const Scene& scene) {
    KnownNames known{.names = {{"", "the first", {}}, {"none", "none", {}}}, .empty = "the first"};
    for (size_t i = 0; i < scene.motion.animations.size(); ++i) {
        const Animation& animation = scene.motion.animations[i];
        known.names.push_back({fmt::format("{}", i), fmt::format("{} {}", i, animation.name),
                               fmt::format("{:.4g} s", animation.duration)});
    }
    return known;
}

KnownNames view_names(const Settings& settings) {
    KnownNames known{.names = {{"", "the first", {}}}, .only_these = true, .empty = "the first"};
    const std::string chosen = settings.get(kTracer);
    for (const TracerEntry& tracer : tracers())
        if (tracer.name == chosen)
            for (const std::string_view view : tracer.make()->views())
                known.names.push_back({std::string(view), std::string(view), {}});
    return known;
}

} // namespace

KnownNames known_names(const KnobBase& knob, const Session& session) {
    if (&knob == &kTracer)
        return tracer_names();
    if (&knob == &kViewStructure)
        return view_names(session.settings());
    if (&knob == &kCamera && session.has_scene())
        return camera_names(session.scene());
    if (&knob == &kAnimation && session.has_scene())
        return animation_names(session.scene());
    return {};
}

} // namespace romascope
