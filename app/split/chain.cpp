// SPDX-License-Identifier: MIT
#include "app/split/chain.h"

#include "app/split/directions.h"
#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/frame/pipeline.h"

namespace romascope {
namespace {

std::vector<ListedRay> rays_along(const SplitScene& scene, float t_max,
                                  const std::vector<glm::vec3>& directions) {
    std::vector<ListedRay> rays;
    rays.reserve(directions.size());
    for (size_t i = 0; i < directions.size(); ++i)
        rays.push_back({.point = scene.points()[i].position,
                        .t_max = t_max,
                        .normal = scene.points()[i].normal,
                        .direction = directions[i]});
    return rays;
}

} // namespace

Chain::Chain() = default;

Tracer& Chain::tracer_of(const Settings& settings) {
    const std::string name = settings.get(kTracer);
    if (name != tracer_name_) {
        tracer_ = make_tracer(name);
        tracer_name_ = name;
    }
    return *tracer_;
}

std::vector<bool> Chain::trace(const Settings& settings, const Tracer& tracer,
                               const std::vector<ListedRay>& rays) {
    const std::vector<float> answers =
        rays_.trace(shaders_, settings, tracer, RayQuestion::any_hit, rays);
    std::vector<bool> blocked;
    blocked.reserve(answers.size());
    for (const float answer : answers)
        blocked.push_back(answer != 0.0f);
    return blocked;
}

std::vector<ChainAnswers> Chain::ask(SplitScene& scene, const Settings& settings, uint32_t frame) {
    const auto seed = static_cast<uint32_t>(settings.get(kSeed));
    const FrameContext context{settings, shaders_, scene.gpu(), untimed_, seed, frame};
    Tracer& tracer = tracer_of(settings);
    tracer.build(context);
    cells_.leave_as(tracer.leaving());
    cells_.build(context); // the same map: it depends on nothing else

    const CandidateSet candidates = tracer.candidate_set();
    const std::vector<SplitDirection> drawn = draw_directions(
        scene.points(), candidates, tracer.sample_candidates(settings), seed, frame);
    std::vector<glm::vec3> own, traced;
    for (const SplitDirection& direction : drawn) {
        own.push_back(direction.drawn);
        traced.push_back(direction.traced);
    }
    const float t_max = ambient_occlusion_radius(settings);
    std::vector<ListedRay> rays = rays_along(scene, t_max, own);
    const std::vector<bool> drawn_cells = trace(settings, cells_, rays);
    for (size_t i = 0; i < rays.size(); ++i)
        rays[i].place = drawn[i].place;
    const std::vector<bool> method = trace(settings, tracer, rays);
    const std::vector<bool> traced_cells =
        candidates.empty() ? drawn_cells
                           : trace(settings, cells_, rays_along(scene, t_max, traced));
    const std::vector<bool>& truth = scene.blocked(own, t_max);
    const std::vector<bool>& traced_truth = scene.blocked(traced, t_max);

    std::vector<ChainAnswers> answers;
    answers.reserve(rays.size());
    for (size_t i = 0; i < rays.size(); ++i)
        answers.push_back({truth[i], drawn_cells[i], traced_cells[i], method[i], traced_truth[i]});
    return answers;
}

} // namespace romascope
