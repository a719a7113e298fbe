// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/capture.h"
#include "app/viewer/interface/interface.h"
#include "app/viewer/interface/interface_state.h"
#include "app/viewer/keys.h"
#include "app/viewer/session.h"
#include "app/viewer/window.h"

#include <chrono>
#include <optional>

namespace romascope {

struct ViewerOptions {
    std::string technique;             ///< that the settings are of; may be empty
    std::filesystem::path shaders;     ///< empty: those in the program
    std::filesystem::path screenshots; ///< empty: screenshot_folder()
    std::filesystem::path ui_map;      ///< where to tell of widgets, for tests; empty: nowhere
    SceneOptions memory;
    bool panel = true;
    bool exact_size = false; ///< the settings' size was asked for: pixels, not screen coordinates
    bool gl_debug = false;
};

/// The window, what it shows and what is done in it.
class Viewer {
public:
    /// Opens the window, still hidden. Throws Error without a display, or if the scene lacks what
    /// the settings name.
    Viewer(const ViewerOptions& options, const Settings& settings,
           const std::filesystem::path& scene_file, Scene scene);

    /// Until the window is closed.
    void run();
    /// Input, one frame, widgets. False once the window is to be closed.
    bool step();

    Session& session() { return session_; }
    Messages& messages() { return messages_; }

private:
    void handle_keys();
    void act(KeyAction action, int nth);
    void do_requests(const Requests& requests);
    void navigate(const WindowInput& input);
    void watch_shaders();
    void present();
    void tell_gl_messages();
    template <class Work>
    bool attempt(Work work);

    void take_screenshot();
    void start_capture();
    void step_capture();
    std::filesystem::path new_file() const;
    std::string command() const;

    ViewerOptions options_;
    Messages messages_;
    Window window_;
    std::optional<DebugLog> gl_log_;
    Session session_;
    Interface interface_;
    InterfaceState state_;
    std::optional<Capture> capture_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_step_, shaders_watched_;
};

} // namespace romascope
