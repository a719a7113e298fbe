// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/passes/gbuffer.h"
#include "renderer/passes/scene_lights.h"

namespace romascope {

/// What the picture shows.
enum class PictureKind { ambient_occlusion, lit, normal, base_color };

inline const Knob<PictureKind> kView{
    {.key = "frame.view",
     .unit = "",
     .help = "What the picture shows: ambient occlusion alone, the lit scene, or what the camera "
             "sees of normals and base colours.",
     .source = "the estimate itself is what is measured"},
    PictureKind::ambient_occlusion,
    {"ambient_occlusion", "lit", "normal", "base_color"}};

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
    return {&kView,        &kLights,     &kHighlights,  &kSunStrength,
            &kSkyStrength, &kSunAzimuth, &kSunElevation};
}

/// Makes the picture of a frame from the G-buffer and one frame's visibility. Not needed for
/// PictureKind::ambient_occlusion, where the visibility is the picture.
class Compose {
public:
    void run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
             const SceneLights& lights, const Texture& visibility);
    const Texture& picture() const { return picture_; } ///< RGBA32F, linear
    StructureBytes bytes() const { return {"picture", picture_.bytes()}; }

    static ShaderVariant variant(const Settings& settings);

private:
    ProgramSlot program_;
    Texture picture_;
};

} // namespace romascope
