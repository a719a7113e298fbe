// SPDX-License-Identifier: MIT
#include "renderer/scene/scene.h"

#include "renderer/base/error.h"

#include <fmt/format.h>

namespace romascope {

const Camera& Scene::camera(const std::string& wanted) const {
    std::string names;
    for (const Camera& candidate : cameras) {
        if (candidate.name == wanted)
            return candidate;
        names += (names.empty() ? "" : ", ") + candidate.name;
    }
    throw Error(fmt::format("scene '{}' has no camera '{}'; it has: {}", name, wanted, names),
                kBadInput);
}

} // namespace romascope
