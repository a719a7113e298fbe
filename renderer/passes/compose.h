// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/gbuffer.h"
#include "renderer/passes/scene_lights.h"

namespace romascope {

/// What the picture shows.
enum class PictureKind {
    ambient_occlusion,
    ambient_occlusion_raw,
    lit,
    depth,
    normal,
    base_color,
    structure,
    hash,
    history
};

inline const Knob<PictureKind> kView{
    {.key = "frame.view",
     .unit = "",
     .help =
         "What the picture shows: ambient occlusion alone, the lit scene, or what the camera "
         "sees of depth, normals and base colours; ambient_occlusion_raw: of the last frame "
         "alone, before any filter; structure: a view of the visibility structure, see "
         "view.structure; hash: of the spatial hash, see view.hash; history: how many frames each "
         "pixel of temporal accumulation has.",
     .source = "the estimate itself is what is measured"},
    PictureKind::ambient_occlusion,
    {"ambient_occlusion", "ambient_occlusion_raw", "lit", "depth", "normal", "base_color",
     "structure", "hash", "history"}};
inline const Knob<double> kDepthRange{
    {.key = "view.depth_range",
     .unit = "scene diagonals",
     .help = "The distance along the view at which the depth view, white at the camera, has become "
             "black; the steps of a .png are equal lengths. Blue: nothing is there.",
     .source = "the scene from end to end"},
    1.0,
    0.001,
    1000.0};

/// Whether the picture is one channel, what ambient occlusion estimated.
inline bool is_visibility(PictureKind kind) {
    return kind == PictureKind::ambient_occlusion || kind == PictureKind::ambient_occlusion_raw;
}
/// Whether the picture is the last frame alone, as what the frames have in it does not add up.
inline bool is_of_last_frame(PictureKind kind) {
    return kind == PictureKind::ambient_occlusion_raw || kind == PictureKind::structure ||
           kind == PictureKind::hash || kind == PictureKind::history;
}
/// Whether Compose::run draws the picture.
inline bool is_composed(PictureKind kind) {
    return !is_visibility(kind) && !is_of_last_frame(kind);
}

/// What lights the lit view.
enum class LightSource { automatic, sun, scene };

inline const Knob<LightSource> kLights{
    {.key = "lit.lights",
     .unit = "",
     .help = "Whether the sun lights the lit view, or the scene's own lights; auto: its own, if it "
             "has any. The sky shines in any case.",
     .source = "a scene with lights is meant to be seen in them"},
    LightSource::automatic,
    {"auto", "sun", "scene"}};
/// What becomes of radiance above what a picture shows.
enum class Highlights { soft, clip };

inline const Knob<Highlights> kHighlights{
    {.key = "lit.highlights",
     .unit = "",
     .help = "Whether the lit view bends radiance above 0.3 so that it stays below 1, or leaves it "
             "as it is: a .png then clips at 1, an .hdr does not.",
     .source = "bright walls keep their form"},
    Highlights::soft,
    {"soft", "clip"}};
inline const Knob<double> kSunStrength{{.key = "lit.sun_strength",
                                        .unit = "",
                                        .help = "Irradiance of the sun over pi in the lit view, or "
                                                "that of the scene's lights where they shine.",
                                        .source = "chosen by eye on the hall"},
                                       1.1,
                                       0.0,
                                       100.0};
inline const Knob<double> kSkyStrength{{.key = "lit.sky_strength",
                                        .unit = "",
                                        .help = "Radiance of the sky in the lit view.",
                                        .source = "chosen by eye on the hall"},
                                       0.9,
                                       0.0,
                                       100.0};
inline const Knob<double> kSunAzimuth{
    {.key = "lit.sun_azimuth",
     .unit = "degrees",
     .help = "Where the sun stands around the vertical, from +x towards +z.",
     .source = "chosen by eye on the hall"},
    50.0,
    -360.0,
    360.0};
inline const Knob<double> kSunElevation{{.key = "lit.sun_elevation",
                                         .unit = "degrees",
                                         .help = "How high the sun stands above the horizon.",
                                         .source = "chosen by eye on the hall"},
                                        50.0,
                                        -90.0,
                                        90.0};

/// Every knob of this folder.
inline std::vector<const KnobBase*> compose_knobs() {
    return {&kView,        &kLights,     &kHighlights,   &kSunStrength,
            &kSkyStrength, &kSunAzimuth, &kSunElevation, &kDepthRange};
}

/// Makes the picture of a frame from the G-buffer and one frame's visibility, for the kinds that
/// is_composed names.
class Compose {
public:
    void run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
             const SceneLights& lights, const Texture& visibility);
    /// The picture to be drawn by who knows it better, with what it held; RGBA32F, linear.
    const Texture& picture_of_size(glm::ivec2 size);
    const Texture& picture() const { return picture_; } ///< RGBA32F, linear
    StructureBytes bytes() const { return {"picture", picture_.bytes()}; }

    static ShaderVariant variant(const Settings& settings);

private:
    ProgramSlot program_;
    Texture picture_;
};

} // namespace romascope
