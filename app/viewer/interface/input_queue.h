// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <set>
#include <vector>

struct GLFWwindow;

namespace romascope {

/// A key that went down, or repeats.
struct KeyPress {
    int key = 0;         ///< GLFW_KEY_...
    int mods = 0;        ///< GLFW_MOD_...
    bool repeat = false; ///< it was down already
};

struct InputEvent {
    enum class Kind { key, character, button, cursor, wheel };
    Kind kind = Kind::key;
    int code = 0; ///< of a key, a button; the character itself
    int scancode = 0, action = 0, mods = 0;
    double x = 0.0, y = 0.0;
};

/// Which events fit in one frame of Dear ImGui. It looks at where keys and buttons stand in a
/// frame, not at what happened between two: a key that goes down and up within one slow frame would
/// not be seen, and text that comes after Enter would come before it.
class InputFrame {
public:
    /// False if the event, and all after it, must wait for the next frame.
    bool takes(const InputEvent& event);

private:
    bool takes_key(const InputEvent& event);
    std::set<int> keys_;   ///< that changed
    bool button_ = false;  ///< one changed
    bool moved_ = false;   ///< the mouse
    bool text_ = false;    ///< characters came
    bool command_ = false; ///< a key that does something to the text, or elsewhere
};

/// What keys and mouse do to a window, in its order, for Dear ImGui.
class InputQueue {
public:
    /// The window's callbacks that were set before are still called. One queue at a time.
    explicit InputQueue(GLFWwindow* window);
    ~InputQueue();
    InputQueue(const InputQueue&) = delete;
    InputQueue& operator=(const InputQueue&) = delete;

    /// Gives ImGui what fits in this frame, between the beginning of its platform's frame and its
    /// own. Returns the keys among it.
    std::vector<KeyPress> feed();
    bool empty() const { return events_.empty(); }

private:
    friend struct InputCallbacks;
    void give(const InputEvent& event);

    GLFWwindow* window_;
    std::deque<InputEvent> events_;
    std::array<bool, 3> buttons_{}; ///< that are down, as ImGui has been told
    double x_ = 0.0, y_ = 0.0;      ///< where ImGui thinks that the mouse is
};

} // namespace romascope
