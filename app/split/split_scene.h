// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reference/ao_tracer.h"
#include "renderer/scene/gpu_scene.h"
#include "renderer/scene/pose.h"

#include <map>
#include <string>
#include <vector>

namespace romascope {

/// What a camera sees at the centre of a pixel.
struct SplitPoint {
    glm::vec3 position{};
    glm::vec3 normal{}; ///< the shading normal, unit, on the side that is seen
    glm::vec3 origin{}; ///< where rays of the truth start, see Hit::origin
    int camera = 0;     ///< index into SplitScene::cameras()
    int pixel = 0;      ///< row by row
};

/// A scene as it stands in one pose: its visible surfaces, its triangles for the truth, and all
/// that tracers need of it.
class SplitScene {
public:
    /// Needs a current context; keeps nothing of `scene`. `size`: pixels of each camera.
    /// Throws Error (kBadInput) if nothing of the scene is seen.
    SplitScene(Scene scene, const Pose& pose, std::vector<Camera> cameras, glm::ivec2 size);

    const std::string& name() const { return name_; }
    size_t triangles() const { return triangles_; }
    const GpuScene& gpu() const { return gpu_; }
    const std::vector<Camera>& cameras() const { return cameras_; }
    const std::vector<SplitPoint>& points() const { return points_; }

    /// The truth: for each point whether its ray meets a triangle within `t_max` metres. The same
    /// directions are asked for once. A direction for each point.
    const std::vector<bool>& blocked(const std::vector<glm::vec3>& directions, float t_max);

private:
    std::string name_;
    size_t triangles_ = 0;
    std::vector<Camera> cameras_;
    GpuScene gpu_;
    std::vector<SplitPoint> points_;
    AoTracer truth_;
    std::map<std::string, std::vector<bool>> known_; ///< by a hash of t_max and directions
};

} // namespace romascope
