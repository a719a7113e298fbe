// SPDX-License-Identifier: MIT
#include "app/viewer/interface/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace romascope {
namespace {

using Kind = InputEvent::Kind;

bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }
bool is_modifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }
/// Whether the key's doing is the character that comes with it.
bool writes(const InputEvent& event) {
    const bool command = event.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER);
    return !command && event.code >= GLFW_KEY_SPACE && event.code < GLFW_KEY_ESCAPE;
}

/// Callbacks of GLFW carry nothing but the window, whose pointer is another's.
InputQueue* the_queue = nullptr;

struct Callbacks {
    GLFWkeyfun key;
    GLFWcharfun character;
    GLFWmousebuttonfun button;
    GLFWcursorposfun cursor;
    GLFWscrollfun wheel;
    GLFWcursorenterfun enter;
    GLFWwindowfocusfun focus;
};
Callbacks before{};

} // namespace

bool InputFrame::takes_key(const InputEvent& event) {
    if (event.action == GLFW_REPEAT)
        return true; // ImGui repeats by itself
    if (keys_.contains(event.code))
        return false;
    if (is_modifier(event.code)) {
        if (command_ || (text_ && !is_shift(event.code)))
            return false;
    } else if (event.action == GLFW_PRESS) {
        if (writes(event))
            return true; // however soon it is let go
        if (command_ || text_)
            return false;
        command_ = true;
    }
    keys_.insert(event.code);
    return true;
}

bool InputFrame::takes(const InputEvent& event) {
    if (button_)
        return false;
    switch (event.kind) {
    case Kind::key:
        return takes_key(event);
    case Kind::character:
        text_ = !command_;
        return text_;
    case Kind::button: // what is let go of must have been dragged there before
        button_ = !text_ && !command_ && (event.action == GLFW_PRESS || !moved_);
        return button_;
    case Kind::cursor:
        moved_ = true;
        break;
    case Kind::wheel:
        break;
    }
    return true;
}

struct InputCallbacks {
    static void key(GLFWwindow* window, int code, int scancode, int action, int mods) {
        if (before.key)
            before.key(window, code, scancode, action, mods);
        the_queue->events_.push_back({Kind::key, code, scancode, action, mods});
    }
    static void character(GLFWwindow* window, unsigned code) {
        if (before.character)
            before.character(window, code);
        the_queue->events_.push_back({Kind::character, static_cast<int>(code)});
    }
    static void button(GLFWwindow* window, int code, int action, int mods) {
        if (before.button)
            before.button(window, code, action, mods);
        the_queue->events_.push_back({Kind::button, code, 0, action, mods});
    }
    static void cursor(GLFWwindow* window, double x, double y) {
        if (before.cursor)
            before.cursor(window, x, y);
        the_queue->events_.push_back({Kind::cursor, 0, 0, 0, 0, x, y});
    }
    static void wheel(GLFWwindow* window, double x, double y) {
        if (before.wheel)
            before.wheel(window, x, y);
        the_queue->events_.push_back({Kind::wheel, 0, 0, 0, 0, x, y});
    }
    static void enter(GLFWwindow* window, int entered) {
        if (before.enter)
            before.enter(window, entered);
        ImGui_ImplGlfw_CursorEnterCallback(window, entered);
    }
    static void focus(GLFWwindow* window, int focused) {
        if (before.focus)
            before.focus(window, focused);
        ImGui_ImplGlfw_WindowFocusCallback(window, focused);
    }
};

InputQueue::InputQueue(GLFWwindow* window) : window_(window) {
    the_queue = this;
    glfwGetCursorPos(window, &x_, &y_);
    before = {glfwSetKeyCallback(window, InputCallbacks::key),
              glfwSetCharCallback(window, InputCallbacks::character),
              glfwSetMouseButtonCallback(window, InputCallbacks::button),
              glfwSetCursorPosCallback(window, InputCallbacks::cursor),
              glfwSetScrollCallback(window, InputCallbacks::wheel),
              glfwSetCursorEnterCallback(window, InputCallbacks::enter),
              glfwSetWindowFocusCallback(window, InputCallbacks::focus)};
}

InputQueue::~InputQueue() {
    glfwSetKeyCallback(window_, before.key);
    glfwSetCharCallback(window_, before.character);
    glfwSetMouseButtonCallback(window_, before.button);
    glfwSetCursorPosCallback(window_, before.cursor);
    glfwSetScrollCallback(window_, before.wheel);
    glfwSetCursorEnterCallback(window_, before.enter);
    glfwSetWindowFocusCallback(window_, before.focus);
    the_queue = nullptr;
}

std::vector<KeyPress> InputQueue::feed() {
    std::vector<KeyPress> keys;
    InputFrame frame;
    while (!events_.empty() && frame.takes(events_.front())) {
        const InputEvent event = events_.front();
        events_.pop_front();
        give(event);
        if (event.kind == Kind::key && event.action != GLFW_RELEASE)
            keys.push_back({event.code, event.mods, event.action == GLFW_REPEAT});
    }
    // The platform's frame has asked the window where these stand now, ahead of the queue.
    ImGuiIO& io = ImGui::GetIO();
    for (size_t i = 0; i < buttons_.size(); ++i)
        io.MouseDown[i] = buttons_[i];
    if (!events_.empty())
        io.MousePos = {static_cast<float>(x_), static_cast<float>(y_)};
    return keys;
}

void InputQueue::give(const InputEvent& event) {
    switch (event.kind) {
    case Kind::key:
        ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode, event.action, event.mods);
        break;
    case Kind::character:
        ImGui_ImplGlfw_CharCallback(window_, static_cast<unsigned>(event.code));
        break;
    case Kind::button:
        if (event.code < static_cast<int>(buttons_.size()))
            buttons_[static_cast<size_t>(event.code)] = event.action == GLFW_PRESS;
        break;
    case Kind::cursor:
        x_ = event.x;
        y_ = event.y;
        break;
    case Kind::wheel:
        ImGui_ImplGlfw_ScrollCallback(window_, event.x, event.y);
        break;
    }
}

} // namespace romascope
