// SPDX-License-Identifier: MIT
#include "renderer/passes/view_uniforms.h"

#include <cmath>

namespace romascope {

void View::set_uniforms(const Program& program) const {
    const float half_height = std::tan(0.5f * camera.vertical_fov);
    const float half_width =
        half_height * static_cast<float>(size.x) / static_cast<float>(size.y);
    program.set("eye", camera.eye);
    program.set("view_forward", camera.forward);
    program.set("view_right", camera.right() * half_width);
    program.set("view_down", -camera.up * half_height);
    program.set("near_plane", near_plane);
    program.set("picture_offset", offset);
    program.set("picture_size", size);
}

} // namespace romascope
