// SPDX-License-Identifier: MIT
#include "renderer/frame/pipeline.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/frame/jump.h"
#include "renderer/tracers/structure_view.h"
#include "shaders/common/random.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {
namespace {

/// Below anything a camera is put close to; the far plane is infinite, so nothing is lost by it.
constexpr float kNearPlanePerDiagonal = 1e-5f;

/// Sub-pixel shift of a frame in [-0.5, 0.5)^2 pixels.
glm::vec2 picture_offset(const Settings& settings, uint32_t frame) {
    if (!is_antialiased(settings))
        return glm::vec2(0.0f);
    const glm::uvec2 place = gpu::r2_sequence(frame, glm::uvec2(0x80000000u));
    return glm::vec2(gpu::unit_float(place.x), gpu::unit_float(place.y)) - 0.5f;
}

} // namespace

std::unique_ptr<Tracer> make_tracer(const std::string& name) {
    std::vector<std::string> names;
    for (const TracerEntry& entry : tracers()) {
        if (entry.name == name)
            return entry.make();
        names.emplace_back(entry.name);
    }
    throw Error(fmt::format("technique.tracer: unknown tracer '{}'{} (there are {})", name,
                            did_you_mean(name, names), fmt::join(names, ", ")),
                kBadInput);
}

void check_tracer(const Settings& settings) {
    const std::unique_ptr<Tracer> tracer = make_tracer(settings.get(kTracer));
    if (settings.get(kView) == PictureKind::structure)
        chosen_structure_view(*tracer, settings);
}

Camera named_camera(const Scene& scene, const std::string& text, const Pose& pose) {
    if (text.empty())
        return camera_at(scene, 0, pose);
    const bool named = std::ranges::find(scene.cameras, text, &Camera::name) != scene.cameras.end();
    // Else numbers were meant, and the form is what is wrong: commas are rare in names.
    if (!named && text.find_first_of("/,") != std::string::npos)
        return parse_camera(text);
    const auto index = static_cast<size_t>(&scene.camera(text) - scene.cameras.data());
    return camera_at(scene, index, pose);
}

Camera chosen_camera(const Scene& scene, const Settings& settings, const Pose& pose) {
    return named_camera(scene, settings.get(kCamera), pose);
}

bool same_view(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.forward == b.forward && a.up == b.up &&
           a.vertical_fov == b.vertical_fov;
}

View view_of_frame(const Settings& settings, const Camera& camera, const Bounds& bounds,
                   uint32_t frame) {
    View view;
    view.camera = camera;
    view.size = {settings.get(kWidth), settings.get(kHeight)};
    view.near_plane = std::max(glm::length(bounds.extent()) * kNearPlanePerDiagonal, 1e-12f);
    view.offset = picture_offset(settings, frame);
    return view;
}

Pose pose_of_frame(const Scene& scene, const Settings& settings, int frame) {
    return pose_at(scene.motion, find_animation(scene, settings.get(kAnimation)),
                   time_of_frame(settings, frame));
}

Pipeline::Pipeline(const Scene& scene, ShaderLibrary shaders)
    : shaders_(std::move(shaders)), source_(scene), scene_(scene), deform_(scene.motion),
      spatial_hash_(scene.motion.parts.empty() ? std::nullopt
                                               : std::optional(scene.motion.first_vertex)),
      lights_(scene) {}

void Pipeline::set_pose(const Pose& pose) {
    if (source_.motion.empty() || pose == pose_)
        return;
    if (!source_.motion.parts.empty()) {
        deform_.run(shaders_, timer_, scene_, source_.motion, pose);
        moved_ = true;
        spatial_hash_.vertices_moved();
    }
    lights_.upload(lights_at(source_, pose));
    pose_ = pose;
    mean_.reset();
}

void Pipeline::restart_on_change(const Settings& settings, const Camera& camera) {
    if (last_settings_ != settings || !same_view(last_camera_, camera))
        mean_.reset();
    const Jump jump = last_settings_ ? jump_between(*last_settings_, settings) : Jump::everything;
    if (jump == Jump::everything)
        reuse_.reset();
    if (jump == Jump::picture)
        reuse_.reset_picture();
    last_settings_ = settings;
    last_camera_ = camera;
    const std::string name = settings.get(kTracer);
    if (tracer_name_ != name) {
        tracer_ = make_tracer(name);
        tracer_name_ = name;
        spatial_hash_.clear();
    }
}

void Pipeline::restart(uint32_t first_frame) {
    mean_.reset();
    reuse_.reset();
    spatial_hash_.clear();
    frame_ = first_frame;
}

bool Pipeline::reload_shaders() {
    if (!shaders_.refresh())
        return false;
    mean_.reset();
    spatial_hash_.clear();
    reuse_.reset();
    pose_ = {}; // deformed anew
    shown_ = nullptr;
    return true;
}

void Pipeline::render(const Settings& settings, const Camera& camera) {
    restart_on_change(settings, camera);
    // A frame that fails has had its number: the hash may have noted it.
    const uint32_t number = frame_++;
    const FrameContext frame{
        settings, shaders_, scene_, timer_, static_cast<uint32_t>(settings.get(kSeed)), number};
    const View view = view_of_frame(settings, camera, scene_.bounds(), number);

    gbuffer_.draw(frame, view,
                  scene_.has_previous_positions() && ScreenReuse::looks_back(settings));
    tracer_->build(frame);
    estimate(frame, view);
    const Texture& visibility =
        reuse_.filter(frame, view, gbuffer_, ambient_occlusion_.visibility());
    const Texture& picture = draw_picture(frame, view, visibility);
    remember_frame(frame, view);
    shown_ = nullptr;
    if (is_of_last_frame(settings.get(kView)) || !settings.get(kMean))
        mean_.take(frame, picture);
    else
        mean_.add(frame, picture);
    timer_.collect();
    check_gl_error("the frame");
}

void Pipeline::estimate(const FrameContext& frame, const View& view) {
    if (SpatialHash::is_used(frame.settings)) {
        spatial_hash_.run(frame, view, gbuffer_, *tracer_, ambient_occlusion_);
    } else {
        spatial_hash_.release();
        ambient_occlusion_.run(frame, view, gbuffer_, *tracer_);
    }
}

const Texture& Pipeline::shown() {
    if (!shown_)
        shown_ = &present_.run(shaders_, timer_, mean_.mean());
    return *shown_;
}

const Texture& Pipeline::draw_picture(const FrameContext& frame, const View& view,
                                      const Texture& visibility) {
    const PictureKind kind = frame.settings.get(kView);
    if (kind == PictureKind::ambient_occlusion)
        return reuse_.antialias(frame, view, gbuffer_, visibility);
    if (kind == PictureKind::ambient_occlusion_raw)
        return ambient_occlusion_.visibility();
    if (kind == PictureKind::structure) {
        const Texture& picture = compose_.picture_of_size(view.size);
        tracer_->draw_view(frame, chosen_structure_view(*tracer_, frame.settings), picture);
        return picture;
    }
    if (kind == PictureKind::hash)
        return spatial_hash_.picture();
    if (kind == PictureKind::history) {
        const Texture& picture = compose_.picture_of_size(view.size);
        reuse_.draw_history(frame, view, gbuffer_, picture);
        return picture;
    }
    compose_.run(frame, view, gbuffer_, lights_, visibility);
    return reuse_.antialias(frame, view, gbuffer_, compose_.picture());
}

void Pipeline::remember_frame(const FrameContext& frame, const View& view) {
    reuse_.end_frame(frame, view, gbuffer_);
    if (source_.motion.parts.empty() || !ScreenReuse::looks_back(frame.settings))
        return;
    if (moved_ || !scene_.has_previous_positions())
        scene_.remember_positions();
    moved_ = false;
}

Image Pipeline::picture() const {
    const glm::ivec3 size = mean_.mean().size();
    Image image(size.x, size.y, mean_.mean().format() == GL_RGBA32F ? 3 : 1);
    image.data = mean_.mean().download_float(image.channels);
    return image;
}

std::vector<NamedCount> Pipeline::counts() const {
    std::vector<NamedCount> all = spatial_hash_.counts();
    if (tracer_)
        for (NamedCount& count : tracer_->counts())
            all.push_back(std::move(count));
    return all;
}

std::vector<StructureBytes> Pipeline::bytes() const {
    std::vector<StructureBytes> all = {{"scene", scene_.bytes()}};
    if (!source_.motion.parts.empty())
        all.push_back(deform_.bytes());
    all.push_back(gbuffer_.bytes());
    if (tracer_)
        for (const StructureBytes& structure : tracer_->bytes())
            all.push_back(structure);
    all.push_back(ambient_occlusion_.bytes());
    for (const StructureBytes& structure : spatial_hash_.bytes())
        all.push_back(structure);
    const auto add_if_any = [&all](const StructureBytes& structure) {
        if (structure.bytes > 0)
            all.push_back(structure);
    };
    for (const StructureBytes& structure : reuse_.bytes())
        add_if_any(structure);
    for (const StructureBytes& picture : {compose_.bytes(), mean_.bytes(), present_.bytes()})
        add_if_any(picture);
    return all;
}

} // namespace romascope
