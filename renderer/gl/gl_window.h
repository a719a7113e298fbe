// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

struct GLFWwindow;

namespace romascope {

struct GlWindowRequest {
    glm::ivec2 size{64, 64}; ///< screen coordinates
    const char* title = "";
    bool scale_to_monitor = false; ///< larger where the screen's pixels are small
    bool debug = false;            ///< GL debug output
};

/// Starts GLFW and opens a window, still hidden, with an OpenGL core context that is made current;
/// loads the GL functions. Throws Error if there is no display, or no context at all; one that is
/// too old is for require_version() to refuse.
GLFWwindow* open_gl_window(const GlWindowRequest& request);

/// Closes it and ends GLFW.
void close_gl_window(GLFWwindow* window);

} // namespace romascope
