// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/import.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/scene/fit.h"
#include "renderer/scene/gltf/animation.h"
#include "renderer/scene/gltf/instances.h"
#include "renderer/scene/gltf/mounted.h"
#include "renderer/scene/gltf/numbers.h"
#include "renderer/scene/gltf/reach.h"
#include "renderer/scene/gltf/skin.h"
#include "renderer/scene/pose.h"

#include <algorithm>

namespace romascope {
namespace gltf {
namespace {

/// Beyond this, products of the edges of moving triangles would not be floats.
constexpr double kMaxReach = 1e12;

/// Like apply_pose, at the moment that every scene is read at.
void place_first(Scene& scene, const Pose& start) {
    try {
        apply_pose(scene, start);
    } catch (const Error&) { // whose advice, another time, helps only once a scene is there
        const bool moves = !scene.motion.animations.empty();
        refuse(moves ? "animations[0]" : "nodes",
               fmt::format("{} a vertex beyond {} m",
                           moves ? "moves, at second 0," : "skin or morph", kMaxCoordinate));
    }
}

Scene build(const Document& document, MemoryBudget& budget) {
    Notices notices;
    for (const std::string& line : document.notices())
        notices.add("file", line);
    Scene scene;
    Hierarchy hierarchy = read_hierarchy(document, budget);
    scene.motion.nodes = hierarchy.nodes;
    scene.motion.weights = hierarchy.weights;
    scene.motion.animations = read_animations(document, hierarchy, budget, notices);
    scene.motion.skins = read_skins(document, hierarchy, budget);
    mark_moving(hierarchy, scene.motion.animations);
    const int animation = scene.motion.animations.empty() ? -1 : 0;
    const Pose start = pose_at(scene.motion, animation, 0.0);

    add_instances(document, hierarchy, start.node_to_world, scene, budget, notices);
    add_mounted(document, hierarchy, start.node_to_world, scene, notices);
    if (scene.motion.empty()) {
        scene.motion = {};
    } else {
        if (!(reach(scene.motion) <= kMaxReach))
            refuse("animations", fmt::format("may move something further than {} m", kMaxReach));
        place_first(scene, start);
    }
    sort_by_group(scene);
    if (scene.cameras.empty())
        scene.cameras.push_back(fit_camera(scene));
    scene.notices = notices.lines();
    return scene;
}

} // namespace
} // namespace gltf

Scene load_gltf(const std::filesystem::path& path, size_t max_memory) {
    std::error_code code;
    if (std::filesystem::exists(path, code) && !std::filesystem::is_directory(path, code)) {
        if (!std::filesystem::is_regular_file(path, code))
            throw Error(path.string() + ": is not a plain file", kBadInput);
        const auto size = std::filesystem::file_size(path, code);
        if (!code) // before any of it is read
            MemoryBudget(max_memory).take(size, 1, path.string() + ": the file");
    }
    return import_gltf(read_text_file(path), path, max_memory);
}

Scene import_gltf(std::string content, const std::filesystem::path& path, size_t max_memory) {
    try {
        MemoryBudget budget(max_memory);
        const gltf::Document document(std::move(content), path, budget);
        Scene scene = gltf::build(document, budget);
        scene.name = path.stem().string();
        return scene;
    } catch (const std::bad_alloc&) {
        throw Error(path.string() + ": there is not enough memory for it", kBadInput);
    } catch (const Error& error) {
        throw Error(path.string() + ": " + gltf::one_line(error.what()), error.exit_status());
    }
}

} // namespace romascope
