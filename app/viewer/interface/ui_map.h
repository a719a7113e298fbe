// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace romascope {

class Session;
struct InterfaceState;

/// An aid for tests that use the window as a user does: a file that says where on the window each
/// widget is, and what the window tells. Does nothing without a file.
///
/// JSON: `frame` counts the interface's frames; `size` is the window's in pixels; `widgets` has
/// rectangles [left, top, right, bottom] in pixels, as far as they are seen, by name: the key of a
/// knob, "reset:KEY", "inf:KEY", "group:GROUP", "technique", "screenshot", ...; `panel`, `help`;
/// `settings` that are not the defaults, `messages` with `severity`, `text`, `times`;
/// `frames_in_picture`, `at_rest`, `scene`.
class UiMap {
public:
    /// Empty: none.
    explicit UiMap(std::filesystem::path file);
    ~UiMap();

    /// Between ImGui's begin and end of a frame.
    void begin_frame();
    /// The widget that was laid out last goes by that name.
    void note(std::string_view name);
    /// The window that is being laid out goes by that name.
    void note_window(std::string_view name);
    /// Writes the file whole, if anything but the frame's number changed, at most ten times a
    /// second. A folder that cannot be written to ends it, which is told.
    void finish_frame(Session& session, const InterfaceState& state);
    /// Whether there is something to write that came too soon.
    bool is_behind() const { return behind_; }

private:
    void write(Session& session);

    std::filesystem::path file_;
    std::unique_ptr<nlohmann::ordered_json> seen_;
    std::string written_; ///< what the file holds, less the frame's number
    std::chrono::steady_clock::time_point last_write_;
    bool behind_ = false;
};

} // namespace romascope
