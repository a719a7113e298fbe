// SPDX-License-Identifier: MIT
#include "app/viewer/session.h"

#include "app/frame_run.h"
#include "app/scene_files.h"
#include "renderer/base/error.h"
#include "renderer/frame/jump.h"
#include "renderer/frame/notices.h"
#include "renderer/gl/context.h"
#include "renderer/scene/fit.h"
#include "renderer/scene/gltf/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace romascope {
namespace {

/// Times of a pass that its median is taken of.
constexpr size_t kTimesKept = 30;
/// What a camera is fitted for; see ViewFit.
constexpr double kFittedAspect = 16.0 / 9.0;

/// Whether other passes may run, or take another time: all but numbers, which are turned often and
/// change little from one frame to the next.
bool other_methods(const Settings& a, const Settings& b) {
    return std::ranges::any_of(a.table().all(), [&](const KnobBase* knob) {
        const bool number = knob->kind() == KnobKind::integer || knob->kind() == KnobKind::real;
        return !number && knob != &kCamera && a.value(*knob) != b.value(*knob);
    });
}

/// Whether frames leave behind what one from elsewhere or of another time finds again: cells of the
/// spatial hash or histories of pixels.
bool frames_remember(const Settings& settings) {
    return SpatialHash::is_used(settings) || ScreenReuse::looks_back(settings);
}

/// Whether nothing but the camera, the time or what is shown is another.
bool is_same_but_moved(const Settings& a, const Settings& b) {
    return std::ranges::all_of(a.table().all(), [&](const KnobBase* knob) {
        return a.value(*knob) == b.value(*knob) || knob == &kCamera || knob == &kTime ||
               chooses_view(*knob);
    });
}

} // namespace

Session::Session(Settings settings, std::filesystem::path shaders, SceneOptions memory,
                 Messages& messages)
    : settings_(std::move(settings)), shader_folder_(std::move(shaders)),
      memory_(std::move(memory)), messages_(messages) {
    playback_.play(settings_.get(kFps) > 0.0);
}

/// `held`: bytes of what the new frames take the place of, which is not free at present.
void Session::check_memory_for(const Scene& scene, const Settings& settings, size_t held) const {
    const bool given = memory_.max_memory.has_value(); // and counts no matter what is free
    if (is_software_context())
        check_memory(scene, settings, memory_.left_beside(scene) + (given ? 0 : held), given);
}

void Session::show(const std::filesystem::path& file, Scene scene) {
    Showing(scene, settings_);
    check_memory_for(scene, settings_, 0);
    auto loaded = std::make_shared<Loaded>(file, std::move(scene), shader_library());
    loaded->pipeline.timer().keep_latest(kTimesKept);
    loaded_ = std::move(loaded);
    for (const std::string& notice : loaded_->scene.notices)
        messages_.tell(Severity::notice, fmt::format("{}: {}", file.string(), notice));
    tell_notices();
    drawn_.reset();
    frames_ = 0;
    withdraw_faults(); // of the scene before
    playback_.play(playback_.playing() && is_animated());
}

/// Those that come and go with the settings.
void Session::tell_notices() {
    std::vector<std::string> now;
    for (const std::string& notice : notices_of(settings_, loaded_->scene))
        now.push_back(fmt::format("{}: {}", loaded_->file.string(), notice));
    messages_.replace(Severity::notice, notices_, std::move(now));
}

bool Session::open(const std::string& file_or_name) {
    const Settings before = settings_;
    try {
        const std::filesystem::path file = find_scene(file_or_name);
        Scene scene = load_gltf(file, memory_.limit());
        for (const KnobBase* knob :
             std::initializer_list<const KnobBase*>{&kCamera, &kTime, &kAnimation})
            settings_.reset(*knob);
        show(file, std::move(scene));
        messages_.tell(Severity::info, fmt::format("opened {}", file.string()));
        replace_error(open_error_, {});
        return true;
    } catch (const Error& error) {
        replace_error(open_error_, error.what());
    } catch (const std::bad_alloc&) {
        replace_error(open_error_, fmt::format("{}: out of memory", file_or_name));
    }
    settings_ = before;
    return false;
}

bool Session::set(const KnobBase& knob, const KnobValue& value) {
    if (settings_.value(knob) == value)
        return true;
    try {
        settings_.set_value(knob, value);
    } catch (const Error& error) {
        replace_error(value_error_, error.what());
        return false;
    }
    replace_error(value_error_, {});
    if (&knob == &kFrames && settings_.get(kFrames) < static_cast<int>(frames_))
        drawn_.reset(); // the picture has too many
    if (&knob == &kWidth || &knob == &kHeight)
        follows_window_ = false;
    return true;
}

KnobValue Session::reset_value(const KnobBase& knob) const {
    return &knob == &kFrames ? KnobValue(int64_t{kFramesToRest}) : knob.default_value();
}

void Session::reset(const KnobBase& knob) {
    if (&knob == &kWidth || &knob == &kHeight)
        follow_window(true);
    else
        settings_.set_value(knob, reset_value(knob));
}

void Session::reset_all() {
    for (const KnobBase* knob : settings_.table().all())
        if (knob != &kCamera && knob != &kTime && knob != &kWidth && knob != &kHeight)
            reset(*knob);
    technique_.clear();
}

void Session::choose_technique(const std::string& name) {
    try {
        change_technique(settings_, name);
        technique_ = name;
    } catch (const Error& error) {
        tell_error(error.what());
    }
}

Camera Session::camera() const {
    return chosen_camera(loaded_->scene, settings_, pose_of_frame(loaded_->scene, settings_, 0));
}

Viewpoint Session::viewpoint() const {
    if (!viewpoint_text_.empty() && settings_.get(kCamera) == viewpoint_text_)
        return viewpoint_;
    return Viewpoint::of(camera(), loaded_->scene.bounds);
}

void Session::set_viewpoint(const Viewpoint& viewpoint) {
    viewpoint_ = viewpoint;
    viewpoint_text_ = viewpoint.text();
    set(kCamera, viewpoint_text_);
}

void Session::choose_camera(size_t index) {
    if (index < loaded_->scene.cameras.size())
        set(kCamera, loaded_->scene.cameras[index].name);
}

void Session::fit_view() {
    try {
        Viewpoint fitted = Viewpoint::of(fit_camera(loaded_->scene), loaded_->scene.bounds);
        const double aspect = static_cast<double>(settings_.get(kWidth)) / settings_.get(kHeight);
        if (aspect < kFittedAspect)
            fitted.approach(aspect / kFittedAspect);
        set_viewpoint(fitted);
    } catch (const Error& error) {
        tell_error(error.what());
    }
}

bool Session::is_animated() const { return duration() > 0.0; }

double Session::duration() const {
    if (!loaded_ || loaded_->scene.motion.animations.empty())
        return 0.0;
    try {
        const int animation = find_animation(loaded_->scene, settings_.get(kAnimation));
        return animation < 0
                   ? 0.0
                   : loaded_->scene.motion.animations[static_cast<size_t>(animation)].duration;
    } catch (const Error&) {
        return 0.0; // drawing tells that there is none of that name
    }
}

void Session::advance(double elapsed) {
    set(kTime, playback_.advanced(settings_.get(kTime), elapsed, settings_.get(kFps), duration()));
}

void Session::set_window_size(glm::ivec2 pixels) {
    window_size_ = pixels;
    if (follows_window_)
        follow_window(true);
}

void Session::follow_window(bool on) {
    follows_window_ = on;
    if (!on || window_size_.x < 1 || window_size_.y < 1) // an icon has no size
        return;
    settings_.set(kWidth, std::min(window_size_.x, static_cast<int>(kWidth.maximum())));
    settings_.set(kHeight, std::min(window_size_.y, static_cast<int>(kHeight.maximum())));
}

/// What a frame depends on: how many there are and how time got where it is does not count.
Settings Session::frame_settings() const {
    Settings wanted = settings_;
    wanted.reset(kFrames);
    wanted.reset(kFps);
    return wanted;
}

bool Session::at_rest() const {
    if (!loaded_)
        return true;
    if (drawn_ != frame_settings())
        return false;
    return failed_ ||
           (changes_in_a_row_ < 2 && frames_ >= static_cast<uint32_t>(settings_.get(kFrames)));
}

bool Session::draw() {
    if (at_rest()) {
        changes_in_a_row_ = 0;
        return false;
    }
    const Settings wanted = frame_settings();
    const bool changed = drawn_ != wanted;
    const bool structures_changed = !drawn_ || other_methods(*drawn_, wanted);
    const bool goes_on =
        changed && drawn_ && frames_remember(wanted) && is_same_but_moved(*drawn_, wanted);
    const bool begins_anew = changed && !goes_on;
    // The sequences begin anew with the first of many changes and after the last of them; between
    // the two they go on, so that what moves does not drag a still pattern along.
    if (begins_anew ? changes_in_a_row_ == 0 : changes_in_a_row_ >= 2) {
        loaded_->pipeline.restart();
        frames_ = 0;
    }
    changes_in_a_row_ = begins_anew ? changes_in_a_row_ + 1 : 0;
    drawn_ = wanted;
    if (changed)
        tell_notices();
    failed_ = !try_draw(wanted, changed, structures_changed);
    frames_ = failed_ ? 0 : changed ? 1 : frames_ + 1;
    return !failed_;
}

void Session::begin_anew() {
    drawn_.reset();
    changes_in_a_row_ = 0;
}

void Session::draw_if_changed() {
    if (drawn_ != frame_settings())
        draw();
}

/// Tells an error of which one holds at a time; empty: none.
void Session::replace_error(std::string& told, const std::string& text) {
    if (told == text)
        return;
    if (!told.empty())
        messages_.withdraw(told);
    told = text;
    if (!told.empty())
        tell_error(told);
}

bool Session::try_draw(const Settings& wanted, bool changed, bool structures_changed) {
    Pipeline& pipeline = loaded_->pipeline;
    std::string error_text;
    try {
        const Scene& scene = loaded_->scene;
        const Pose pose = pose_of_frame(scene, wanted, 0);
        const Camera camera = chosen_camera(scene, wanted, pose);
        if (changed) {
            size_t held = 0;
            for (const StructureBytes& structure : pipeline.bytes())
                held += structure.bytes;
            check_memory_for(scene, wanted, held);
        }
        pipeline.set_pose(pose);
        if (structures_changed)
            pipeline.timer().clear();
        pipeline.render(wanted, camera);
    } catch (const Error& error) {
        error_text = error.what();
    } catch (const std::bad_alloc&) {
        error_text = "out of memory: choose smaller structures or a smaller picture";
    }
    replace_error(draw_error_, error_text);
    return error_text.empty();
}

bool Session::prepare_picture() {
    if (!loaded_)
        return false;
    Pipeline& pipeline = loaded_->pipeline;
    std::string error_text;
    try {
        pipeline.shown();
    } catch (const Error& error) {
        error_text = error.what();
    }
    replace_error(picture_error_, error_text);
    for (const std::string& fault : pipeline.take_shader_faults()) {
        tell_error(fault);
        shader_faults_.push_back(fault);
    }
    if (reloaded_ && drawn_) {
        reloaded_ = false;
        if (shader_faults_.empty() && draw_error_.empty() && picture_error_.empty())
            messages_.tell(Severity::info, "shaders read again");
    }
    return error_text.empty();
}

void Session::withdraw_faults() {
    for (const std::string& fault : std::exchange(shader_faults_, {}))
        messages_.withdraw(fault);
    replace_error(draw_error_, {});
    replace_error(picture_error_, {});
}

bool Session::reload_shaders() {
    if (!loaded_ || !loaded_->pipeline.reload_shaders())
        return false;
    // What is still at fault comes up again with the next frame.
    loaded_->pipeline.take_shader_faults();
    withdraw_faults();
    drawn_.reset();
    reloaded_ = true;
    return true;
}

} // namespace romascope
