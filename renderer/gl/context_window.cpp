// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/gl/context_backends.h"
#include "renderer/gl/gl_window.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

namespace romascope {
namespace {

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

class WindowContext final : public Context {
public:
    explicit WindowContext(bool debug)
        : window_(open_gl_window({.title = "romascope", .debug = debug})) {}
    ~WindowContext() override { close_gl_window(window_); }

    Backend backend() const override { return Backend::window; }
    std::string description() const override { return "a hidden GLFW window"; }

private:
    GLFWwindow* window_;
};

} // namespace

GLFWwindow* open_gl_window(const GlWindowRequest& request) {
    if (!glfwInit())
        throw Error(last_glfw_error());
    GLFWwindow* window = nullptr;
    for (const auto& [major, minor] : kGlVersions) {
        glfwDefaultWindowHints();
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, request.scale_to_monitor);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, request.debug);
        window = glfwCreateWindow(request.size.x, request.size.y, request.title, nullptr, nullptr);
        if (window)
            break;
    }
    const auto fail = [](const std::string& why) {
        glfwTerminate();
        throw Error(why);
    };
    if (!window)
        fail(fmt::format("no OpenGL 4.5 core context: {}", last_glfw_error()));
    glfwMakeContextCurrent(window);
    if (!gladLoadGL(glfwGetProcAddress))
        fail("the OpenGL functions cannot be loaded");
    return window;
}

void close_gl_window(GLFWwindow* window) {
    glfwDestroyWindow(window);
    glfwTerminate();
}

std::unique_ptr<Context> create_window_context(bool debug) {
    return std::make_unique<WindowContext>(debug);
}

} // namespace romascope
