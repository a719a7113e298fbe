// SPDX-License-Identifier: MIT
#include "renderer/scene/scene.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/base/listing.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {
namespace {

struct Kind {
    bool masked = false, double_sided = false;
    bool operator==(const Kind&) const = default;
    int order() const { return 2 * masked + double_sided; }
};

Kind kind_of(const Scene& scene, size_t triangle) {
    const Material& material = scene.materials[scene.vertex_material[scene.indices[3 * triangle]]];
    return {material.alpha_cutoff > 0.0f, material.double_sided};
}

} // namespace

void sort_by_group(Scene& scene) {
    const size_t count = scene.triangle_count();
    const auto before = [&](size_t a, size_t b) {
        return kind_of(scene, a).order() < kind_of(scene, b).order();
    };
    bool sorted = true;
    for (size_t i = 1; i < count && sorted; ++i)
        sorted = !before(i, i - 1);
    if (sorted)
        return; // the usual case needs no second copy of the indices
    std::vector<uint32_t> indices;
    indices.reserve(scene.indices.size());
    for (int kind = 0; kind < 4; ++kind)
        for (size_t i = 0; i < count; ++i)
            if (kind_of(scene, i).order() == kind)
                for (size_t corner = 3 * i; corner < 3 * i + 3; ++corner)
                    indices.push_back(scene.indices[corner]);
    scene.indices = std::move(indices);
}

std::vector<TriangleGroup> triangle_groups(const Scene& scene) {
    std::vector<TriangleGroup> groups;
    for (size_t i = 0; i < scene.triangle_count(); ++i) {
        const Kind kind = kind_of(scene, i);
        if (groups.empty() || kind != Kind{groups.back().masked, groups.back().double_sided})
            groups.push_back({i, 0, kind.masked, kind.double_sided});
        ++groups.back().count;
    }
    return groups;
}

const Camera& Scene::camera(const std::string& wanted) const {
    std::vector<std::string> names;
    for (const Camera& candidate : cameras) {
        if (candidate.name == wanted)
            return candidate;
        names.push_back(candidate.name);
    }
    throw Error(fmt::format("scene '{}' has no camera '{}'{} (it has {})", name, wanted,
                            did_you_mean(wanted, names), listing(names)),
                kBadInput);
}

} // namespace romascope
