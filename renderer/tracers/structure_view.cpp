// SPDX-License-Identifier: MIT
#include "renderer/tracers/structure_view.h"

#include "renderer/base/error.h"
#include "renderer/tracers/tracer.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {

std::vector<const KnobBase*> structure_view_knobs() {
    return {&kViewStructure, &kViewAxis, &kViewSlice, &kViewMap};
}

std::string chosen_structure_view(const Tracer& tracer, const Settings& settings) {
    const std::vector<std::string_view> views = tracer.views();
    const std::string wanted = settings.get(kViewStructure);
    if (wanted.empty() && !views.empty())
        return std::string(views.front());
    if (std::ranges::find(views, wanted) != views.end())
        return wanted;
    if (views.empty())
        throw Error("frame.view=structure: the chosen tracer has no views of its structure",
                    kBadInput);
    throw Error(fmt::format("view.structure: the chosen tracer has no view '{}': it has {}", wanted,
                            fmt::join(views, ", ")),
                kBadInput);
}

void set_cell_view_uniforms(const Program& program, const Settings& settings,
                            const Texture& picture) {
    program.set("picture_size", glm::ivec2(picture.size()));
    program.set("slice", static_cast<float>(settings.get(kViewSlice)));
}

} // namespace romascope
