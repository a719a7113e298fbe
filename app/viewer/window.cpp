// SPDX-License-Identifier: MIT
#include "app/viewer/window.h"

#include "renderer/base/error.h"
#include "renderer/gl/context.h"
#include "renderer/gl/gl_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include <algorithm>
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
    static void key(GLFWwindow* window, int key, int, int action, int) {
        Window& self = owner(window);
        if (action == GLFW_PRESS)
            self.down_since_[key] = glfwGetTime();
        if (action == GLFW_RELEASE)
            if (const auto down = self.down_since_.find(key); down != self.down_since_.end()) {
                self.input_.held[key] += glfwGetTime() - down->second;
                self.down_since_.erase(down);
            }
    }
    static void button(GLFWwindow* window, int button, int action, int) {
        if (button < 3)
            owner(window).buttons_[static_cast<size_t>(button)] = action == GLFW_PRESS;
    }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        for (int i = 0; i < count; ++i)
            owner(window).input_.dropped.emplace_back(paths[i]);
    }
    static void scroll(GLFWwindow* window, double, double y) { owner(window).input_.wheel += y; }
    static void cursor(GLFWwindow* window, double x, double y) {
        Window& self = owner(window);
        const glm::dvec2 at(x, y);
        if (self.cursor_known_ && std::ranges::count(self.buttons_, true) == 1)
            for (size_t i = 0; i < self.buttons_.size(); ++i)
                if (self.buttons_[i])
                    self.input_.drag[i] += at - self.cursor_;
        self.cursor_ = at;
        self.cursor_known_ = true;
    }
    /// What is let go over another window is not told here.
    static void focus(GLFWwindow* window, int focused) {
        Window& self = owner(window);
        if (!focused) {
            self.down_since_.clear();
            self.buttons_ = {};
        }
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
    glfwSetMouseButtonCallback(window_, WindowCallbacks::button);
    glfwSetCursorPosCallback(window_, WindowCallbacks::cursor);
    glfwSetWindowFocusCallback(window_, WindowCallbacks::focus);
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

WindowInput Window::take_input() {
    const double now = glfwGetTime();
    for (auto& [key, since] : down_since_)
        input_.held[key] += now - std::exchange(since, now);
    return std::exchange(input_, {});
}
bool Window::is_down(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }
void Window::set_clipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}
void Window::swap() { glfwSwapBuffers(window_); }

} // namespace romascope
