// SPDX-License-Identifier: MIT
#pragma once

#include "app/scene_options.h"
#include "app/viewer/messages.h"
#include "app/viewer/playback.h"
#include "app/viewer/viewpoint.h"
#include "renderer/frame/pipeline.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace romascope {

/// A scene, the frames it is seen in, and all that a user can change about them. Knows neither
/// window nor widgets. All of its state that decides what is seen is Settings: `romascope render`
/// with the same ones gives the same picture.
///
/// Nothing here throws for what a user does: a scene that cannot be loaded, a value out of its
/// range or a shader that does not compile is told, and what was there before stays.
class Session {
public:
    /// `shaders`: a folder to read them from; empty: those in the program. Needs a current context.
    Session(Settings settings, std::filesystem::path shaders, SceneOptions memory,
            Messages& messages);

    // --- Scene.

    /// Shows a scene that was loaded from that file. Throws Error if it lacks what the settings
    /// name, or if there is no memory for its frames; then the old one stays.
    void show(const std::filesystem::path& file, Scene scene);
    /// Another scene: a file, or a built-in one by its name. False, and the old one stays, if it
    /// cannot be loaded. Camera and time start anew.
    bool open(const std::string& file_or_name);
    bool has_scene() const { return loaded_ != nullptr; }
    const Scene& scene() const { return loaded_->scene; }
    /// The same, which stays when another is opened.
    std::shared_ptr<const Scene> shared_scene() const { return {loaded_, &loaded_->scene}; }
    const std::filesystem::path& scene_file() const { return loaded_->file; }

    // --- Settings. They count from the next frame on.

    const Settings& settings() const { return settings_; }
    /// False, and nothing changes, for a value out of the knob's range, which is told.
    bool set(const KnobBase& knob, const KnobValue& value);
    template <class T>
    bool set(const Knob<T>& knob, std::type_identity_t<T> value) {
        return set(static_cast<const KnobBase&>(knob), knob.to_value(std::move(value)));
    }
    void reset(const KnobBase& knob);
    /// All but where one stands (camera, time) and the size of the picture.
    void reset_all();
    /// The value that reset() gives: the knob's default; for render.frames one that suits a window.
    KnobValue reset_value(const KnobBase& knob) const;
    /// A technique as `--technique` has it, whichever was chosen before; see change_technique.
    void choose_technique(const std::string& name);
    /// The technique that was chosen last; empty if none was.
    const std::string& technique() const { return technique_; }
    /// The settings are those of a technique already.
    void note_technique(const std::string& name) { technique_ = name; }

    // --- Camera.

    Camera camera() const;
    /// The camera as something to move; see set_viewpoint.
    Viewpoint viewpoint() const;
    void set_viewpoint(const Viewpoint& viewpoint);
    /// A camera of the scene, counted from 0; nothing happens if it has fewer.
    void choose_camera(size_t index);
    /// All of the scene, from in front.
    void fit_view();

    // --- Time.

    bool is_animated() const;
    /// Seconds of the animation that plays; 0 if none does.
    double duration() const;
    const Playback& playback() const { return playback_; }
    void play(bool on) { playback_.play(on && is_animated()); }
    /// Lets `elapsed` seconds pass.
    void advance(double elapsed);

    // --- Frames.

    /// The size of the window in pixels, which the picture follows unless a size was set by hand.
    void set_window_size(glm::ivec2 pixels);
    bool follows_window() const { return follows_window_; }
    void follow_window(bool on);

    /// Draws a frame, unless the picture is at rest. True if it drew one.
    ///
    /// A change starts the mean anew. Once nothing changes, the random sequences start at their
    /// beginning, so that the picture after n frames is what `romascope render --frames n` gives;
    /// it rests after `render.frames` of them.
    ///
    /// But where the spatial hash or a stage with a history is on, camera and time may change
    /// without that: cells and histories are kept, and the sequences go on. So the picture at rest
    /// has more behind it than its own frames, unless begin_anew() came after the last move.
    bool draw();
    /// The next frame is the first: as if nothing had been drawn before it.
    void begin_anew();
    /// A frame of what is wanted now, if the last one was of something else.
    void draw_if_changed();
    /// Makes the picture that Pipeline::shown() gives, and tells what programs are at fault. False
    /// if there is none.
    bool prepare_picture();
    /// Whether draw() has nothing to do.
    bool at_rest() const;
    /// Frames in the picture.
    uint32_t frame_count() const { return frames_; }
    /// Looks whether shaders on disk have changed. True if they have. A program that does not
    /// compile is told, and the one before it stays in use.
    bool reload_shaders();
    /// What was drawn last; null before the first frame.
    Pipeline* pipeline() { return loaded_ ? &loaded_->pipeline : nullptr; }
    /// Whether the last attempt to draw failed; why is among the messages.
    bool failed() const { return failed_; }
    Messages& messages() { return messages_; }

    /// Refuses frames that would take more memory than is left; see check_memory. Throws Error.
    void check_memory_for(const Settings& settings) const {
        check_memory_for(scene(), settings, 0);
    }
    /// The folder that shaders are read from; empty: the program itself.
    const std::filesystem::path& shader_folder() const { return shader_folder_; }
    ShaderLibrary shader_library() const {
        return shader_folder_.empty() ? ShaderLibrary() : ShaderLibrary(shader_folder_);
    }

private:
    struct Loaded {
        Loaded(std::filesystem::path from, Scene content, const ShaderLibrary& shaders)
            : file(std::move(from)), scene(std::move(content)), pipeline(scene, shaders) {}
        std::filesystem::path file;
        Scene scene;
        Pipeline pipeline;
    };
    void tell_error(const std::string& text) { messages_.tell(Severity::error, text); }
    void check_memory_for(const Scene& scene, const Settings& settings, size_t held) const;
    bool try_draw(const Settings& wanted, bool changed, bool structures_changed);
    void replace_error(std::string& told, const std::string& text);
    void withdraw_faults();
    void tell_notices();
    Settings frame_settings() const;

    Settings settings_;
    std::filesystem::path shader_folder_;
    SceneOptions memory_;
    Messages& messages_;
    std::string technique_;
    std::shared_ptr<Loaded> loaded_;
    Playback playback_;
    glm::ivec2 window_size_{0};
    bool follows_window_ = true;

    std::optional<Settings> drawn_; ///< of the last attempt to draw
    uint32_t frames_ = 0;           ///< in the picture
    int changes_in_a_row_ = 0;      ///< that begin the sequences anew
    bool failed_ = false;
    bool reloaded_ = false; ///< since the last frame
    // What was told and holds: of programs, the last frame, picture, value and scene.
    std::vector<std::string> shader_faults_;
    std::vector<std::string> notices_; ///< of scene and settings together
    std::string draw_error_, picture_error_, value_error_, open_error_;
    Viewpoint viewpoint_;        ///< what viewpoint_text_ was made of
    std::string viewpoint_text_; ///< what render.camera was set to; empty: nothing yet
};

/// Frames after which the picture rests, unless told otherwise.
inline constexpr int kFramesToRest = 1024;

} // namespace romascope
