// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

struct GLFWwindow;

namespace romascope {

/// What a user did to the window since the last time.
struct WindowInput {
    std::vector<std::string> dropped; ///< files
    /// Way of the mouse while only the left, right, middle button was down, in screen coordinates;
    /// y down.
    std::array<glm::dvec2, 3> drag{};
    double wheel = 0.0; ///< notches; above 0: away from the user
    /// Seconds that a key (GLFW_KEY_...) was down. However long a frame takes, no touch is lost.
    std::map<int, double> held;
    double held_seconds(int key) const {
        const auto found = held.find(key);
        return found == held.end() ? 0.0 : found->second;
    }
};

/// The window on the screen, with the OpenGL context that everything is drawn in.
class Window {
public:
    /// Still hidden. `size`: in pixels of the picture if `exact`, else in screen coordinates,
    /// larger where the screen's pixels are small. Throws Error without a display or OpenGL 4.5.
    Window(glm::ivec2 size, bool exact, bool debug);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    void show();
    void set_title(const std::string& title);

    /// Pixels; 0 while it is an icon.
    glm::ivec2 pixels() const;
    /// Screen coordinates.
    glm::ivec2 size() const;
    /// How much larger text must be for this screen than for one of 96 pixels per inch.
    float scale() const;

    bool wants_to_close() const;
    void close();

    /// Takes in what happened; waits up to so many seconds for it to happen.
    void poll(double wait_seconds);
    WindowInput take_input();
    bool is_down(int key) const;
    void set_clipboard(const std::string& text);
    void swap();

private:
    friend struct WindowCallbacks;
    GLFWwindow* window_;
    WindowInput input_;
    glm::dvec2 cursor_{0.0};
    bool cursor_known_ = false;
    std::array<bool, 3> buttons_{};
    std::map<int, double> down_since_; ///< keys; seconds on the clock of GLFW
};

} // namespace romascope
