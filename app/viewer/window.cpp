// SPDX-License-Identifier: MIT
#include "app/viewer/window.h"

#include "renderer/base/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/gl_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include <utility>

namespace romascope {
namespace {

GLFWwindow* open(glm::ivec2 size, bool exact, bool debug) {
    try {
        return open_gl_window({size, "romascope", !exact, debug});
    } catch (const Error& error) {
        throw Error(fmt::format("no window can be opened: {} ('romascope render' needs none)",
                                error.what()));
    }
}

Window& owner(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

} // namespace

struct WindowCallbacks {
    static void key(GLFWwindow* window, int key, int, int action, int mods) {
        if (action != GLFW_RELEASE)
            owner(window).input_.keys.push_back({key, mods});
    }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        for (int i = 0; i < count; ++i)
            owner(window).input_.dropped.emplace_back(paths[i]);
    }
    static void scroll(GLFWwindow* window, double, double y) { owner(window).input_.wheel += y; }
    static void cursor(GLFWwindow* window, double x, double y) {
        Window& self = owner(window);
        const glm::dvec2 at(x, y);
        if (self.cursor_known_)
            self.input_.mouse += at - self.cursor_;
        self.cursor_ = at;
        self.cursor_known_ = true;
    }
    static void enter(GLFWwindow* window, int entered) {
        if (!entered)
            owner(window).cursor_known_ = false; // it comes back somewhere else
    }
};

Window::Window(glm::ivec2 size, bool exact, bool debug) : window_(open(size, exact, debug)) {
    try {
        require_version();
    } catch (const Error&) {
        close_gl_window(window_);
        throw;
    }
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, WindowCallbacks::key);
    glfwSetDropCallback(window_, WindowCallbacks::drop);
    glfwSetScrollCallback(window_, WindowCallbacks::scroll);
    glfwSetCursorPosCallback(window_, WindowCallbacks::cursor);
    glfwSetCursorEnterCallback(window_, WindowCallbacks::enter);
    glfwSwapInterval(1);
}

Window::~Window() { close_gl_window(window_); }

void Window::show() { glfwShowWindow(window_); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

glm::ivec2 Window::pixels() const {
    glm::ivec2 pixels(0);
    glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
    return pixels;
}

glm::ivec2 Window::size() const {
    glm::ivec2 size(0);
    glfwGetWindowSize(window_, &size.x, &size.y);
    return size;
}

float Window::scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return x;
}

bool Window::wants_to_close() const { return glfwWindowShouldClose(window_); }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::poll(double wait_seconds) {
    if (wait_seconds > 0.0)
        glfwWaitEventsTimeout(wait_seconds);
    else
        glfwPollEvents();
}

WindowInput Window::take_input() { return std::exchange(input_, {}); }
bool Window::is_down(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }
bool Window::is_button_down(int button) const {
    return glfwGetMouseButton(window_, button) == GLFW_PRESS;
}
void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}
void Window::swap() { glfwSwapBuffers(window_); }

} // namespace romascope
