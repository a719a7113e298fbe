// SPDX-License-Identifier: MIT
#include "app/viewer/viewer.h"

#include "app/viewer/navigate.h"
#include "app/viewer/render_command.h"
#include "app/viewer/screenshot_files.h"
#include "app/viewer/start_settings.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/image/image_io.h"
#include "renderer/passes/present.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace romascope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kShaderWatch{250};
/// How long a picture at rest waits for something to happen before it looks around by itself.
constexpr double kIdleSeconds = 0.25;
constexpr double kAnimationStep = 1.0 / 30.0; ///< seconds

constexpr int kModifiers = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT | GLFW_MOD_SUPER;

glm::ivec2 size_of(const Settings& settings) {
    return {settings.get(kWidth), settings.get(kHeight)};
}

std::filesystem::path layout_file() { return state_directory() / "viewer-layout.ini"; }

} // namespace

Viewer::Viewer(const ViewerOptions& options, const Settings& settings,
               const std::filesystem::path& scene_file, Scene scene)
    : options_(options), window_(size_of(settings), options.exact_size, options.gl_debug),
      session_(settings, options.shaders, options.memory, messages_),
      interface_(window_.handle(), layout_file(), options.ui_map), last_step_(Clock::now()),
      shaders_watched_(Clock::now()) {
    if (options.gl_debug)
        gl_log_.emplace();
    state_.panel = options.panel;
    interface_.set_scale(window_.scale());
    session_.note_technique(options.technique);
    session_.show(scene_file, std::move(scene));
    window_.set_title("romascope - " + scene_file.filename().string());
}

void Viewer::run() {
    while (step()) {
    }
    if (capture_)
        messages_.tell(Severity::notice, "closed before the screenshot was done: it is not saved");
}

bool Viewer::step() {
    const bool idle = shown_ && session_.at_rest() && !capture_ && !session_.playback().playing();
    window_.poll(idle ? std::min(kIdleSeconds, interface_.seconds_to_change()) : 0.0);
    const Clock::time_point now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - last_step_).count();
    last_step_ = now;

    interface_.set_scale(window_.scale());
    interface_.begin_frame();
    session_.set_window_size(window_.pixels());
    const WindowInput input = window_.take_input();
    const bool was_playing = session_.playback().playing();
    for (const std::string& file : input.dropped)
        do_requests({.open = file});
    handle_keys();
    navigate(input);
    session_.advance(was_playing ? elapsed : 0.0);
    watch_shaders();
    if (!interface_.input_waits()) // which a slow frame would hold up
        session_.draw();
    step_capture();
    present();
    tell_gl_messages();
    return !window_.wants_to_close();
}

/// True if it went well; else what went wrong is told.
template <class Work>
bool Viewer::attempt(Work work) {
    try {
        work();
        return true;
    } catch (const Error& error) {
        messages_.tell(Severity::error, error.what());
    } catch (const std::bad_alloc&) {
        messages_.tell(Severity::error, "out of memory");
    }
    return false;
}

void Viewer::handle_keys() {
    for (const KeyPress& press : interface_.keys())
        for (const KeyBinding& binding : key_bindings()) {
            const int count = binding.action == KeyAction::scene_camera ? 9 : 1;
            if (press.key >= binding.key && press.key < binding.key + count &&
                (press.mods & kModifiers) == binding.mods && (binding.repeats || !press.repeat))
                act(binding.action, press.key - binding.key);
        }
}

void Viewer::act(KeyAction action, int nth) {
    const auto step_time = [&](double seconds) {
        session_.play(false);
        if (session_.is_animated())
            session_.set(
                kTime, wrapped_time(session_.settings().get(kTime) + seconds, session_.duration()));
    };
    switch (action) {
    case KeyAction::help:
        state_.help = !state_.help;
        break;
    case KeyAction::panel:
        state_.panel = !state_.panel;
        break;
    case KeyAction::play:
        session_.play(!session_.playback().playing());
        break;
    case KeyAction::step_back:
        step_time(-kAnimationStep);
        break;
    case KeyAction::step_on:
        step_time(kAnimationStep);
        break;
    case KeyAction::scene_camera:
        session_.choose_camera(static_cast<size_t>(nth));
        break;
    case KeyAction::fit:
        session_.fit_view();
        break;
    case KeyAction::begin_anew:
        session_.begin_anew();
        break;
    case KeyAction::reset_all:
        session_.reset_all();
        break;
    case KeyAction::screenshot:
        do_requests({.screenshot = true});
        break;
    case KeyAction::large_screenshot:
        do_requests({.large_screenshot = true});
        break;
    case KeyAction::copy_command:
        do_requests({.copy_command = true});
        break;
    case KeyAction::reload_shaders:
        do_requests({.reload_shaders = true});
        break;
    case KeyAction::quit:
        do_requests({.quit = true});
        break;
    }
}

void Viewer::do_requests(const Requests& requests) {
    // What stands in the settings is what these three are about, be it drawn or not.
    if (requests.copy_command || requests.screenshot || requests.large_screenshot)
        session_.draw_if_changed();
    // A frame of a course of time cannot be told by a command; the one at rest can.
    if (requests.copy_command || requests.large_screenshot)
        session_.play(false);
    if (requests.copy_command) {
        window_.set_clipboard(command());
        messages_.tell(Severity::info, fmt::format("copied: {}", command()));
    }
    if (requests.screenshot)
        take_screenshot();
    if (requests.large_screenshot)
        start_capture();
    if (requests.cancel_screenshot && capture_) {
        capture_.reset();
        messages_.tell(Severity::info, "no screenshot was made");
    }
    if (requests.save_settings)
        attempt([&] {
            save_start_settings(session_.settings());
            messages_.tell(Severity::info,
                           fmt::format("the viewer will start with these settings: {}",
                                       start_settings_file().string()));
        });
    if (requests.forget_settings)
        attempt([&] {
            messages_.tell(Severity::info, forget_start_settings()
                                               ? "the viewer will start with the defaults"
                                               : "no settings of the start were kept");
        });
    if (requests.reload_shaders && !session_.reload_shaders())
        messages_.tell(Severity::info, session_.shader_folder().empty()
                                           ? "shaders are those in the program: start with "
                                             "--shaders FOLDER to change them"
                                           : "no shader has changed");
    if (requests.open) {
        if (session_.open(*requests.open))
            window_.set_title("romascope - " + session_.scene_file().filename().string());
    }
    if (requests.quit)
        window_.close();
}

void Viewer::navigate(const WindowInput& input) {
    const CameraMove move = camera_move(window_, input, !interface_.wants_mouse(),
                                        !interface_.wants_keyboard() && !interface_.input_waits());
    if (is_still(move))
        return;
    attempt([&] {
        session_.set_viewpoint(moved(session_.viewpoint(), move,
                                     glm::length(glm::dvec3(session_.scene().bounds.extent()))));
    });
}

void Viewer::watch_shaders() {
    if (session_.shader_folder().empty() || Clock::now() - shaders_watched_ < kShaderWatch)
        return;
    shaders_watched_ = Clock::now();
    session_.reload_shaders();
}

void Viewer::present() {
    const glm::ivec2 pixels = window_.pixels();
    if (session_.prepare_picture())
        romascope::show(session_.pipeline()->shown(), 0, pixels);
    Activity activity{.saved_settings = has_start_settings()};
    if (capture_)
        activity.screenshot = capture_->progress();
    const Requests requests = interface_.draw(session_, state_, activity);
    interface_.end_frame();
    if (!shown_)
        window_.show(); // not before there is a picture for it
    shown_ = true;
    window_.swap();
    do_requests(requests);
}

void Viewer::tell_gl_messages() {
    if (!gl_log_)
        return;
    for (const std::string& message : gl_log_->take())
        messages_.tell(Severity::error, message);
}

std::filesystem::path Viewer::new_file() const {
    return new_screenshot_file(options_.screenshots.empty() ? screenshot_folder()
                                                            : options_.screenshots,
                               session_.scene_file());
}

void Viewer::take_screenshot() {
    attempt([&] {
        if (session_.pipeline()->frame_count() == 0)
            throw Error("no screenshot: with these settings nothing has been drawn");
        const std::filesystem::path file = new_file();
        const Image picture = session_.pipeline()->picture();
        write_image(file, picture);
        messages_.tell(Severity::info,
                       fmt::format("saved {} ({}x{}, {} frames)", file.string(), picture.width,
                                   picture.height, session_.frame_count()));
    });
}

void Viewer::start_capture() {
    attempt([&] {
        Settings settings = session_.settings();
        settings.set(kWidth, state_.shot_size.x);
        settings.set(kHeight, state_.shot_size.y);
        settings.set(kFrames, std::max(static_cast<int>(session_.frame_count()), 1));
        settings.reset(kFps);
        capture_.reset();
        session_.check_memory_for(settings);
        messages_.tell(Severity::info,
                       fmt::format("rendering {}x{}, {} frames ...", state_.shot_size.x,
                                   state_.shot_size.y, settings.get(kFrames)));
        capture_.emplace(session_.shared_scene(), settings, session_.shader_library(), new_file());
    });
}

void Viewer::step_capture() {
    if (!capture_)
        return;
    bool done = false;
    const bool well = attempt([&] { done = capture_->step(); });
    if (done)
        messages_.tell(Severity::info, fmt::format("saved {} ({}x{})", capture_->file().string(),
                                                   capture_->size().x, capture_->size().y));
    if (done || !well)
        capture_.reset();
}

std::string Viewer::command() const {
    return render_command(session_.scene_file(), session_.settings(), session_.frame_count(),
                          session_.shader_folder());
}

} // namespace romascope
