// SPDX-License-Identifier: MIT
#include "renderer/scene/scene.h"

#include "renderer/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace romascope {

const Camera& Scene::camera(const std::string& wanted) const {
    std::vector<std::string> names;
    for (const Camera& candidate : cameras) {
        if (candidate.name == wanted)
            return candidate;
        names.push_back(candidate.name);
    }
    throw Error(fmt::format("scene '{}' has no camera '{}'; it has: {}", name, wanted,
                            fmt::join(names, ", ")),
                kBadInput);
}

} // namespace romascope
