// SPDX-License-Identifier: MIT
#include "renderer/reuse/surface_history.h"

#include <cmath>

namespace romascope {
namespace {

void copy(const Texture& from, Texture& to, const std::string& label) {
    const glm::ivec3 size = from.size();
    if (to.size() != size)
        to = Texture(label, GL_TEXTURE_2D, from.format(), size);
    glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       size.x, size.y, 1);
}

} // namespace

float pixels_at_unit_depth(const View& view, double pixels) {
    const double pixel = 2.0 * std::tan(0.5 * static_cast<double>(view.camera.vertical_fov)) /
                         static_cast<double>(view.size.y);
    return static_cast<float>(pixels * pixel);
}

void set_edge_uniforms(const Program& program, const View& view, double plane_distance,
                       double normal_angle) {
    program.set("plane_limit", pixels_at_unit_depth(view, plane_distance));
    program.set("normal_limit", static_cast<float>(std::cos(glm::radians(normal_angle))));
}

void SurfaceHistory::remember(const GBuffer& gbuffer, const View& view) {
    copy(gbuffer.depth(), depth_, "previous depth");
    copy(gbuffer.normal(), normal_, "previous normal");
    view_ = view;
    remembered_ = true;
}

void SurfaceHistory::bind(const Program& program, const FrameContext& frame, const View& view,
                          const GBuffer& gbuffer) const {
    view.set_uniforms(program);
    gbuffer.bind_surface();
    const bool known = is_of(view.size);
    (known ? depth_ : gbuffer.depth()).bind(2);
    (known ? normal_ : gbuffer.normal()).bind(3);
    if (gbuffer.motion().id() != 0)
        gbuffer.motion().bind(4);

    const Camera& camera = view_.camera;
    const glm::vec2 size(view.size);
    const float step = pixels_at_unit_depth(view_, 1.0);
    const glm::vec3 right = camera.right();
    const glm::vec2 first = 0.5f + view_.offset - 0.5f * size;
    // The place in that view's own pixels, moved by how much the two views are shifted differently:
    // where both cameras are the same a pixel is its own predecessor, shifted or not.
    const glm::vec2 shifted = 0.5f + view.offset - 0.5f * size;
    program.set("previous_eye", camera.eye - view.camera.eye);
    program.set("previous_corner", camera.forward + step * (first.x * right - first.y * camera.up));
    program.set("previous_step_x", step * right);
    program.set("previous_step_y", -step * camera.up);
    program.set("previous_near", view_.near_plane);
    program.set("previous_x", right / step - shifted.x * camera.forward);
    program.set("previous_y", -camera.up / step - shifted.y * camera.forward);
    program.set("previous_forward", camera.forward);
    set_edge_uniforms(program, view_, frame.settings.get(kHistoryPlaneDistance),
                      frame.settings.get(kHistoryNormalAngle));
}

} // namespace romascope
