// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

struct GLFWwindow;

namespace romascope {

/// A key that went down, or repeats.
struct KeyPress {
    int key = 0;  ///< GLFW_KEY_...
    int mods = 0; ///< GLFW_MOD_...
};

/// What a user did to the window since the last time.
struct WindowInput {
    std::vector<KeyPress> keys;
    std::vector<std::string> dropped; ///< files
    glm::dvec2 mouse{0.0};            ///< way of the mouse, in screen coordinates; y down
    double wheel = 0.0;               ///< notches; above 0: away from the user
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
    bool is_button_down(int button) const;
    void set_clipboard(const std::string& text);
    void swap();

private:
    friend struct WindowCallbacks;
    GLFWwindow* window_;
    WindowInput input_;
    glm::dvec2 cursor_{0.0};
    bool cursor_known_ = false;
};

} // namespace romascope
