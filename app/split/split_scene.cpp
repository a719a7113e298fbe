// SPDX-License-Identifier: MIT
#include "app/split/split_scene.h"

#include "renderer/base/error.h"
#include "renderer/passes/deform.h"
#include "renderer/reference/cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace romascope {
namespace {

GpuScene upload(const Scene& scene, const Pose& pose) {
    GpuScene gpu(scene);
    if (!scene.motion.parts.empty()) {
        PassTimer untimed(TimerClock::none);
        Deform(scene.motion).run(ShaderLibrary(), untimed, gpu, scene.motion, pose);
    }
    return gpu;
}

Scene posed(Scene scene, const Pose& pose) {
    if (!scene.motion.empty())
        apply_pose(scene, pose);
    return scene;
}

std::vector<SplitPoint> visible_points(const AoTracer& truth, const std::vector<Camera>& cameras,
                                       glm::ivec2 size) {
    std::vector<SplitPoint> points;
    for (size_t camera = 0; camera < cameras.size(); ++camera)
        for (int pixel = 0; pixel < size.x * size.y; ++pixel) {
            const glm::vec2 centre(static_cast<float>(pixel % size.x) + 0.5f,
                                   static_cast<float>(pixel / size.x) + 0.5f);
            if (const auto hit = truth.seen(cameras[camera].eye,
                                            cameras[camera].direction_through(centre, size)))
                points.push_back(
                    {hit->position, hit->normal, hit->origin, static_cast<int>(camera), pixel});
        }
    return points;
}

} // namespace

SplitScene::SplitScene(Scene scene, const Pose& pose, std::vector<Camera> cameras, glm::ivec2 size)
    : name_(scene.name), triangles_(scene.triangle_count()), cameras_(std::move(cameras)),
      gpu_(upload(scene, pose)), truth_(posed(std::move(scene), pose)) {
    points_ = visible_points(truth_, cameras_, size);
    if (points_.empty())
        throw Error(fmt::format("{}: no camera sees any of the scene", name_), kBadInput);
}

const std::vector<bool>& SplitScene::blocked(const std::vector<glm::vec3>& directions,
                                             float t_max) {
    CacheKey key;
    key.add(t_max);
    key.add(directions);
    const auto [entry, is_new] = known_.try_emplace(key.name());
    if (!is_new)
        return entry->second;
    std::vector<char> answers(points_.size()); // bits cannot be written by several threads
    const size_t workers =
        std::clamp<size_t>(std::thread::hardware_concurrency(), 1, points_.size());
    {
        std::vector<std::jthread> threads;
        for (size_t worker = 0; worker < workers; ++worker)
            threads.emplace_back([&, worker] {
                for (size_t i = worker; i < points_.size(); i += workers)
                    answers[i] = truth_.occluded(points_[i].origin, directions[i], t_max);
            });
    }
    return entry->second = std::vector<bool>(answers.begin(), answers.end());
}

} // namespace romascope
