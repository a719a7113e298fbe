// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/frame/technique.h"
#include "renderer/image/image.h"
#include "renderer/passes/compose.h"
#include "renderer/passes/deform.h"
#include "renderer/passes/present.h"
#include "renderer/reuse/running_mean.h"
#include "renderer/reuse/screen_reuse.h"
#include "renderer/reuse/spatial_hash/spatial_hash.h"

namespace romascope {

/// Renders frames of a scene: what is shown in a window and what goes to a file is this.
class Pipeline {
public:
    /// Needs a current context. `shaders`: where programs come from. Keeps a reference to the
    /// scene.
    Pipeline(const Scene& scene, ShaderLibrary shaders);
    Pipeline(const Scene&&, ShaderLibrary) = delete;

    /// How the scene stands from the next frame on; before the first call, as its vertices are
    /// given. A change starts the mean anew.
    /// Throws Error (kBadInput), with nothing changed, if that is too far away, see MovingBounds.
    void set_pose(const Pose& pose);

    /// One frame, added to the mean of the frames before it. A change of settings or camera starts
    /// the mean anew, and histories where what they hold is no longer asked for; the random
    /// sequences go on, so that a moving camera sees new directions.
    void render(const Settings& settings, const Camera& camera);
    /// Starts mean, histories and random sequences anew, and forgets the spatial hash: what follows
    /// is what a new pipeline would render. `first_frame`: where the count of frames begins, which
    /// goes on modulo 2^32.
    void restart(uint32_t first_frame = 0);
    /// Frames in the mean.
    uint32_t frame_count() const { return mean_.count(); }

    /// The mean as it stands, of one frame for is_of_last_frame: 1 channel for ambient occlusion, 3
    /// for other views; linear.
    Image picture() const;

    /// picture() as a screen shows it, see Present: RGBA8, row 0 at the top, without texels before
    /// the first frame. Made anew after each frame; show() brings it to a window. Throws Error if
    /// its shader does not compile, or if there is no memory for it.
    const Texture& shown();

    /// Follows the files of a shader folder: if any changed, the mean starts anew, and true. What
    /// no longer compiles goes on as it was; see take_shader_faults() after the next frame.
    bool reload_shaders();
    /// Why programs could not follow their files, since the last call. Each change of the files
    /// brings up again what is still at fault, so older messages can be forgotten then. A message
    /// has as many lines as the driver gave.
    std::vector<std::string> take_shader_faults() { return shaders_.take_faults(); }

    PassTimer& timer() { return timer_; }
    std::vector<StructureBytes> bytes() const;
    /// What the last frame counted, such as rays that were given up. Waits for the GPU.
    std::vector<NamedCount> counts() const;
    /// Empty unless the settings use it. For tests.
    const SpatialHash& spatial_hash() const { return spatial_hash_; }

private:
    void restart_on_change(const Settings& settings, const Camera& camera);
    void estimate(const FrameContext& frame, const View& view);
    const Texture& draw_picture(const FrameContext& frame, const View& view,
                                const Texture& visibility);
    void remember_frame(const FrameContext& frame, const View& view);

    ShaderLibrary shaders_;
    const Scene& source_;
    GpuScene scene_;
    PassTimer timer_;
    Deform deform_;
    Pose pose_;
    GBuffer gbuffer_;
    std::string tracer_name_;
    std::unique_ptr<Tracer> tracer_;
    AmbientOcclusion ambient_occlusion_;
    SpatialHash spatial_hash_;
    SceneLights lights_;
    Compose compose_;
    ScreenReuse reuse_;
    bool moved_ = false; ///< since previous positions were remembered
    RunningMean mean_;
    Present present_;
    const Texture* shown_ = nullptr; ///< of present_; null: older than the mean
    std::optional<Settings> last_settings_;
    Camera last_camera_;
    uint32_t frame_ = 0; ///< in the random sequences
};

/// The camera of that name, of the scene as it stands in that pose; or spelled out as in
/// parse_camera; for no text the scene's first. Throws Error (kBadInput) for a name that the scene
/// does not have.
Camera named_camera(const Scene& scene, const std::string& text, const Pose& pose);

/// The one that the settings name.
Camera chosen_camera(const Scene& scene, const Settings& settings, const Pose& pose);

/// Whether both see the same, whatever they are called.
bool same_view(const Camera& a, const Camera& b);

/// Camera and picture of frame `frame` of a scene with these bounds.
View view_of_frame(const Settings& settings, const Camera& camera, const Bounds& bounds,
                   uint32_t frame);

/// How the scene stands in frame `frame`, counted from 0, by the settings of animation and time.
/// Throws Error (kBadInput) for an animation the scene does not have.
Pose pose_of_frame(const Scene& scene, const Settings& settings, int frame);

/// A new tracer by its name. Throws Error (kBadInput) with the nearest name.
std::unique_ptr<Tracer> make_tracer(const std::string& name);

/// What the settings name of tracers: refuses one there is not, or a view it does not have. Throws
/// Error (kBadInput).
void check_tracer(const Settings& settings);

} // namespace romascope
