// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"
#include "renderer/scene/scene.h"
#include "shaders/passes/light.h"

namespace romascope {

/// A light as shaders take it, its colour times `exposure`.
gpu::LightRecord light_record(const Light& light, float exposure);

/// The factor that makes the scene's lights as strong as an irradiance of 1: one over the mean
/// irradiance of its surfaces, over points spread evenly on them, each weighed by what it gets. So
/// it is the places where light falls that count, not how large the dark is around them. Nothing is
/// shadowed. Depends on the scene alone, as it is given; 1 if no light reaches anything.
float light_exposure(const Scene& scene);

/// The gpu::kMaxLights strongest lights of a scene on the GPU: directional ones first, then by
/// intensity.
class SceneLights {
public:
    explicit SceneLights(const Scene& scene);

    /// The lights as they stand in this frame, in the order of Scene::lights.
    void upload(const std::vector<Light>& lights);
    /// Storage block of LightRecord.
    void bind(GLuint slot) const { buffer_.bind(GL_SHADER_STORAGE_BUFFER, slot); }
    int count() const { return static_cast<int>(chosen_.size()); }

private:
    std::vector<size_t> chosen_; ///< into Scene::lights
    float exposure_ = 1.0f;
    Buffer buffer_;
};

} // namespace romascope
