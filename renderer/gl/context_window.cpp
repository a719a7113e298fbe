// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/gl/context_backends.h"

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
    explicit WindowContext(bool debug) {
        if (!glfwInit())
            throw Error(last_glfw_error());
        for (const auto& [major, minor] : kGlVersions) {
            glfwDefaultWindowHints();
            glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
            glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
            glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug);
            window_ = glfwCreateWindow(64, 64, "romascope", nullptr, nullptr);
            if (window_)
                break;
        }
        if (!window_) {
            const std::string why = last_glfw_error();
            glfwTerminate();
            throw Error(fmt::format("no OpenGL 4.5 core context: {}", why));
        }
        glfwMakeContextCurrent(window_);
        if (!gladLoadGL(glfwGetProcAddress)) {
            glfwTerminate();
            throw Error("the OpenGL functions cannot be loaded");
        }
    }
    ~WindowContext() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }

    Backend backend() const override { return Backend::window; }
    std::string description() const override { return "a hidden GLFW window"; }

private:
    GLFWwindow* window_ = nullptr;
};

} // namespace

std::unique_ptr<Context> create_window_context(bool debug) {
    return std::make_unique<WindowContext>(debug);
}

} // namespace romascope
