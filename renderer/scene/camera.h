// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <string>

namespace romascope {

/// A pinhole camera, right-handed, looking along -z of its own frame.
struct Camera {
    std::string name;
    glm::vec3 eye{0.0f, 0.0f, 1.0f};
    glm::vec3 forward{0.0f, 0.0f, -1.0f}; ///< unit length
    glm::vec3 up{0.0f, 1.0f, 0.0f};       ///< unit length, at right angles to `forward`
    float vertical_fov = 1.0f;            ///< radians, in (0, pi)

    glm::vec3 right() const { return glm::cross(forward, up); }

    /// Unit direction through the picture at (x, y) in pixels, (0, 0) the upper left corner of the
    /// picture; the centre of the first pixel is (0.5, 0.5).
    glm::vec3 direction_through(glm::vec2 pixel, glm::ivec2 size) const;

    /// World to camera space.
    glm::mat4 view() const;

    /// Camera space to clip space for glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE). Infinite far
    /// plane, reversed depth: near_plane / distance along `forward`, so 1 at `near_plane`, 0 at
    /// infinity (clear to 0, test with GL_GREATER). Clip y points down, so row 0 of the
    /// framebuffer is the top of the picture; this mirrors triangles: what is counter-clockwise in
    /// the world comes out clockwise (glFrontFace(GL_CW)).
    /// `offset`: pixel centre (x + 0.5, y + 0.5) shows what direction_through gives for
    /// (x + 0.5, y + 0.5) + offset; for sub-pixel jitter.
    glm::mat4 projection(glm::ivec2 size, float near_plane, glm::vec2 offset = {}) const;
};

/// A camera at `eye` that looks at `target`, with y as up direction (z where the view is along y).
/// `vertical_fov` in radians. Throws Error (kBadInput) if the two coincide, if anything is not
/// finite, or if the angle is not in (0, pi).
Camera look_at(const std::string& name, glm::vec3 eye, glm::vec3 target, float vertical_fov);

/// Parses "eye/target/fov", e.g. "1,2,3/0,0.5,0/60" (metres, metres, degrees in (0, 180)).
/// The camera is named by the text. Throws Error (kBadInput) that tells the form.
Camera parse_camera(const std::string& text);

} // namespace romascope
