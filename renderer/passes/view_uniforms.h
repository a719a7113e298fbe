// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/scene/camera.h"

namespace romascope {

/// A camera and a picture: how pixels become rays. The host's side of shaders/common/surface.glsl.
struct View {
    Camera camera;
    glm::ivec2 size{0};
    float near_plane = 0.01f; ///< metres
    glm::vec2 offset{0.0f};   ///< sub-pixel shift of the picture, pixels

    void set_uniforms(const Program& program) const;
};

} // namespace romascope
