// SPDX-License-Identifier: MIT
#include "app/frame_run.h"

#include "app/progress.h"
#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/metrics/compare.h"
#include "renderer/reuse/changes/change_volume.h"
#include "renderer/scene/camera_path.h"
#include "renderer/scene/pose.h"
#include "renderer/scene/scene_bytes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// What a frame, the read-back and the encoder take per pixel on a software rasteriser. Measured at
/// 8000x4000: 43 bytes, with a composed view 78.
constexpr size_t kBytesPerPixel = 45, kComposedBytesPerPixel = 80;

} // namespace

void check_memory(const Scene& scene, const Settings& settings, size_t left, bool given,
                  size_t pipelines) {
    const int width = settings.get(kWidth), height = settings.get(kHeight);
    const bool composed = !is_visibility(settings.get(kView));
    const size_t pixels = size_t{1} * static_cast<size_t>(width) * static_cast<size_t>(height);
    const bool moves = !scene.motion.parts.empty();
    const size_t per_pixel = (composed ? kComposedBytesPerPixel : kBytesPerPixel) +
                             ScreenReuse::bytes_per_pixel(settings, moves);
    const size_t picture = pixels * per_pixel;
    const std::string tracer = settings.get(kTracer);
    const size_t structures =
        make_tracer(tracer)->bytes_needed(settings) + SpatialHash::bytes_needed(settings, pixels);
    size_t triangles = scene_bytes(scene); // once more, as GL's
    if (moves && ScreenReuse::looks_back(settings))
        triangles += scene.positions.size() * sizeof(glm::vec3); // where they were before
    if (moves && SpatialHash::is_used(settings))
        triangles += ChangeVolume::bytes_needed(scene.motion.rest_positions.size());
    const size_t needed = pipelines * (picture + structures + triangles);
    if (needed > left)
        throw Error(
            fmt::format("a picture of {}x{} ({}), the structures of '{}' ({}) and the scene ({}){} "
                        "need about {} on this software renderer, {} are {}: choose a smaller "
                        "--size, smaller structures or a larger --max-memory",
                        width, height, format_bytes(picture), tracer, format_bytes(structures),
                        format_bytes(triangles), pipelines > 1 ? ", all twice," : "",
                        format_bytes(needed), format_bytes(left),
                        given ? "left of --max-memory" : "free"),
            given ? kBadInput : 1);
}

Showing::Showing(const Scene& scene, const Settings& settings,
                 const std::vector<std::string>& stops)
    : scene_(scene), settings_(settings), stops_(stops), pose_(pose_of_frame(scene, settings, 0)) {
    if (stops_.size() > 1 && std::ranges::find(stops_, "all") != stops_.end())
        throw Error("--path all is the whole flight: give no other camera beside it", kBadInput);
    if (stops_ == std::vector<std::string>{"all"}) {
        stops_.clear();
        for (const Camera& camera : scene.cameras)
            stops_.push_back(camera.name);
    }
    if (!stops.empty() && stops_.size() < 2)
        throw Error(
            fmt::format("--path {}: a flight needs two cameras or more; {}", stops.front(),
                        stops.front() == "all"
                            ? "the scene has one: give --path for each, as eye/target/degrees"
                            : "give --path again for each further one"),
            kBadInput);
    const std::vector<Camera> cameras = cameras_of_stops();
    if (!time_goes_on() && !cameras.empty() &&
        std::ranges::all_of(cameras, [&](const Camera& c) { return same_view(c, cameras[0]); }))
        throw Error(fmt::format("--path {}: all cameras of the flight are the same one: give "
                                "another, or --camera to stand still",
                                stops.front()),
                    kBadInput);
    camera_ = camera_of_frame();
}

void Showing::go_to(int frame) {
    if (frame == frame_)
        return;
    frame_ = frame;
    if (!changed())
        return;
    if (time_goes_on())
        pose_ = pose_of_frame(scene_, settings_, frame);
    if (jump_ && frame == jump_->frame)
        pose_ = pose_after_jump();
    camera_ = camera_of_frame();
}

bool Showing::changed() const {
    return !stops_.empty() || time_goes_on() || (jump_ && frame_ == jump_->frame);
}

bool Showing::time_goes_on() const { return settings_.get(kFps) != 0.0 && !scene_.motion.empty(); }

Pose Showing::pose_after_jump() const {
    return pose_at(scene_.motion, find_animation(scene_, settings_.get(kAnimation)),
                   jump_->seconds);
}

bool Showing::jumps_in_vain() const { return jump_ && pose_after_jump() == pose_; }

std::vector<Camera> Showing::cameras_of_stops() const {
    std::vector<Camera> cameras;
    for (const std::string& stop : stops_)
        cameras.push_back(named_camera(scene_, stop, pose_));
    return cameras;
}

Camera Showing::camera_of_frame() const {
    if (stops_.empty())
        return chosen_camera(scene_, settings_, pose_);
    const std::vector<Camera> cameras = cameras_of_stops();
    const int last = std::max(settings_.get(kFrames) - 1, 1);
    return camera_along(cameras, static_cast<double>(frame_) / last);
}

bool Showing::is_asked_in_vain() const {
    return scene_.motion.animations.empty() &&
           !(settings_.is_default(kTime) && settings_.is_default(kFps));
}

FrameRun render_frames(Pipeline& pipeline, const Settings& settings, Showing& showing,
                       const std::function<void(int frame)>& watch) {
    const int frames = settings.get(kFrames);
    pipeline.restart();
    pipeline.timer().clear();
    Progress progress("frames");
    for (int frame = 0; frame < frames; ++frame) {
        if (frame == 1)
            pipeline.timer().clear(); // the first frame compiled the shaders
        showing.go_to(frame);
        pipeline.set_pose(showing.pose());
        pipeline.render(settings, showing.camera());
        if (watch)
            watch(frame);
        progress.done(static_cast<double>(frame + 1) / frames);
    }
    pipeline.timer().finish();
    FrameRun run{pipeline.picture(), pipeline.timer().clock(), pipeline.timer().timings(),
                 pipeline.bytes(), pipeline.counts()};
    check_gl_error("reading the picture");
    return run;
}

void check_reference(const Settings& settings, int samples) {
    if (samples < 1 || samples > kMaxReferenceSamples)
        throw Error(
            fmt::format("--reference takes 1 to {} samples per pixel", kMaxReferenceSamples),
            kBadInput);
    if (settings.get(kView) != PictureKind::ambient_occlusion)
        throw Error("--reference is ambient occlusion: it needs frame.view=ambient_occlusion",
                    kBadInput);
}

AoReference truth_of(const Scene& scene, const Camera& camera, const Settings& settings,
                     int samples, bool use_cache) {
    AoQuery query;
    query.camera = camera;
    query.size = {settings.get(kWidth), settings.get(kHeight)};
    query.samples = samples;
    query.radius = ambient_occlusion_radius(settings);
    query.pixel_jitter = is_antialiased(settings);
    // The truth does not follow the seed of what it judges.
    return ambient_occlusion_reference(scene, query, reference_progress(),
                                       {.use_cache = use_cache});
}

FlightWatch::FlightWatch(const Showing& showing, const Settings& settings) {
    facts_.stops = showing.stops();
    if (is_visibility(settings.get(kView)))
        facts_.black_pixels = 0;
}

void FlightWatch::operator()(const Pipeline& pipeline) {
    if (facts_.black_pixels)
        for (const float value : pipeline.picture().data)
            *facts_.black_pixels += std::isfinite(value) && value > 0.0f ? 0 : 1;
    for (const NamedCount& count : pipeline.counts()) {
        const auto known = std::ranges::find(facts_.most, count.name, &NamedCount::name);
        if (known == facts_.most.end())
            facts_.most.push_back(count);
        else if (known->count < count.count)
            *known = count;
    }
}

ReportErrors judge(const AoReference& truth, const Image& picture, int samples) {
    ReportErrors errors{samples, truth.seconds, truth.from_cache};
    errors.flip = metric_value(Metric::flip, truth.visibility, picture);
    errors.rmse = metric_value(Metric::rmse, truth.visibility, picture);
    errors.mae = metric_value(Metric::mae, truth.visibility, picture);
    errors.bias = metric_value(Metric::bias, truth.visibility, picture);
    return errors;
}

} // namespace romascope
