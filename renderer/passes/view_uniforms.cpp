// SPDX-License-Identifier: MIT
#include "renderer/passes/view_uniforms.h"

#include <cmath>

namespace romascope {

void View::set_uniforms(const Program& program) const {
    const float step = 2.0f * std::tan(0.5f * camera.vertical_fov) / static_cast<float>(size.y);
    const glm::vec3 step_x = step * camera.right();
    const glm::vec3 step_y = -step * camera.up;
    const glm::vec2 first = 0.5f + offset - 0.5f * glm::vec2(size);
    program.set("eye", camera.eye);
    program.set("view_corner", camera.forward + first.x * step_x + first.y * step_y);
    program.set("view_step_x", step_x);
    program.set("view_step_y", step_y);
    program.set("near_plane", near_plane);
    program.set("picture_size", size);
}

} // namespace romascope
