// SPDX-License-Identifier: MIT
// What commands that render have in common: frames of a scene become a picture, the picture is
// judged against the truth.
#pragma once

#include "app/report.h"
#include "renderer/frame/pipeline.h"
#include "renderer/reference/ao_reference.h"

#include <functional>
#include <optional>
#include <vector>

namespace romascope {

/// Refuses frames that would take more memory than is left: on a software renderer all of it is
/// this program's, and the system promises more than it has and ends who uses it. `given`: the
/// bound comes from the user, not from the machine. `pipelines`: that render the scene side by
/// side. Throws Error.
void check_memory(const Scene& scene, const Settings& settings, size_t left, bool given,
                  size_t pipelines = 1);

/// What the frames show: the pose and the camera of each in turn, made anew only as time goes on or
/// the camera flies.
class Showing {
public:
    /// Keeps references. `stops`: cameras that all frames together fly through, as the setting
    /// render.camera names one, or "all"; with none the camera of the settings stands. Throws Error
    /// (kBadInput) if the scene lacks what the settings or stops name, if there is one stop only,
    /// or if all of them see the same and time stands still.
    Showing(const Scene& scene, const Settings& settings,
            const std::vector<std::string>& stops = {});
    /// Time stands still until that frame and from it on.
    void jump(const TimeJump& jump) { jump_ = jump; }
    /// Whether the scene stands after the jump as before it.
    bool jumps_in_vain() const;
    void go_to(int frame); ///< counted from 0
    /// Whether the settings ask for a time or a course of time though the scene has no animation.
    bool is_asked_in_vain() const;
    /// Whether the frame that it stands at may show something else than the one before.
    bool changed() const;
    const std::vector<std::string>& stops() const { return stops_; }
    const Pose& pose() const { return pose_; }
    const Camera& camera() const { return camera_; }

private:
    bool time_goes_on() const;
    std::vector<Camera> cameras_of_stops() const;
    Camera camera_of_frame() const;
    Pose pose_after_jump() const;

    const Scene& scene_;
    const Settings& settings_;
    std::vector<std::string> stops_; ///< empty, or two and more
    std::optional<TimeJump> jump_;
    int frame_ = 0;
    Pose pose_;
    Camera camera_;
};

/// What `render.frames` frames gave.
struct FrameRun {
    Image picture; ///< their mean
    TimerClock clock = TimerClock::none;
    std::vector<PassTiming> timings; ///< without the first frame, which compiles, unless alone
    std::vector<StructureBytes> bytes;
    std::vector<NamedCount> counts; ///< of the last frame
};

/// What goes wrong on the way, from frame to frame.
class FlightWatch {
public:
    FlightWatch(const Showing& showing, const Settings& settings);
    /// Looks at the frame that was rendered last.
    void operator()(const Pipeline& pipeline);
    const FlightFacts& facts() const { return facts_; }

private:
    FlightFacts facts_;
};

/// Renders as many frames as the settings say, from the first on: a pipeline that has rendered
/// something else gives what a new one would. On a terminal it tells how far it is. `watch` is
/// called after each frame with its number, from 0.
FrameRun render_frames(Pipeline& pipeline, const Settings& settings, Showing& showing,
                       const std::function<void(int frame)>& watch = {});

/// The ambient occlusion that those frames should show, with `samples` rays per pixel.
AoReference truth_of(const Scene& scene, const Camera& camera, const Settings& settings,
                     int samples, bool use_cache);

/// Errors of a picture against it.
ReportErrors judge(const AoReference& truth, const Image& picture, int samples);

/// Refuses what truth_of cannot do. Throws Error (kBadInput).
void check_reference(const Settings& settings, int samples);

} // namespace romascope
