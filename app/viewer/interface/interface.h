// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/interface/input_queue.h"
#include "app/viewer/interface/interface_state.h"
#include "app/viewer/interface/overlay.h"
#include "app/viewer/interface/panel.h"
#include "app/viewer/interface/ui_map.h"

#include <filesystem>
#include <optional>
#include <vector>

struct GLFWwindow;
struct ImGuiContext;

namespace romascope {

class Session;

/// All widgets over the picture, by Dear ImGui. Its calls in a frame: begin_frame, with which input
/// comes in; draw; end_frame.
class Interface {
public:
    /// Needs the window's context to be current. The window's callbacks that were set before are
    /// still called. `layout_file` keeps the panel's width from one start to the next; empty, or
    /// unreadable: it has its default. `ui_map`: see UiMap.
    Interface(GLFWwindow* window, std::filesystem::path layout_file, std::filesystem::path ui_map);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// How large text and widgets are: 1 on a screen of 96 pixels per inch. Not within a frame.
    void set_scale(float scale);

    void begin_frame();
    /// Keys of this frame that no widget takes.
    const std::vector<KeyPress>& keys() const { return keys_; }
    /// Whether more was done than fits in this frame.
    bool input_waits() const { return input_ && !input_->empty(); }
    /// Does what the user asks of the session; the rest is returned.
    Requests draw(Session& session, InterfaceState& state, const Activity& activity);
    /// Draws into framebuffer 0, in pixels as the widgets have them (sRGB is not encoded again).
    /// Leaves the GL state as it was.
    void end_frame();

    /// Whether what the mouse does, or what is typed in this frame, is meant for the widgets.
    bool wants_mouse() const;
    bool wants_keyboard() const;

    /// Seconds until something of the interface changes without anyone doing anything: draw it
    /// again by then.
    double seconds_to_change() const;

private:
    void add_layout_of_panel();
    void save_layout(); ///< Throws Error.

    GLFWwindow* window_;
    ImGuiContext* context_;
    std::optional<InputQueue> input_; ///< while ImGui's platform is there
    std::vector<KeyPress> keys_;
    std::filesystem::path layout_file_;
    UiMap map_;
    Panel panel_;
    Overlay overlay_;
    float scale_ = 0.0f;
    float pixels_per_unit_ = 1.0f; ///< of the window's coordinates
    float style_scale_ = 0.0f;
    size_t fingerprint_ = 0;  ///< of what was drawn last
    bool is_settled_ = false; ///< it was the same as the time before
};

} // namespace romascope
