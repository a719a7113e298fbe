// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/occupancy_slice.h"
#include "renderer/tracers/roma/directions.h"
#include "renderer/tracers/roma/map_view.h"
#include "renderer/tracers/tracer.h"

namespace romascope {

enum class RomaSampling { snap, candidates };
enum class RomaRotateBy { device, texel, word };

inline const Knob<int> kRomaAngularResolution{
    {.key = "roma.angular_resolution",
     .unit = "strata per side",
     .help = "Candidate directions per frame, as the square root of their number.",
     .source = "Zeng et al. 2023, section 6"},
    4,
    2,
    16};
inline const Knob<bool> kRomaDirectionJitter{
    {.key = "roma.direction_jitter",
     .unit = "",
     .help = "New candidate directions every frame, each at random in its stratum; else the middle "
             "of each stratum.",
     .source = "Zeng et al. 2023, section 4.3"},
    true};
inline const Knob<double> kRomaNormalOffset{
    {.key = "roma.normal_offset",
     .unit = "cells",
     .help =
         "How far a ray starts off its surface, along the normal, in cells of a map that encloses "
         "the scene at any turn.",
     .source = "Zeng et al. 2023, section 6"},
    1.5,
    0.0,
    8.0};
inline const Knob<RomaSampling> kRomaSampling{
    {.key = "roma.sampling",
     .unit = "",
     .help = "How rays become candidates: snapped to the candidate of their stratum, as published, "
             "or chosen among the candidates by cosine, which leaves an open plane fully open.",
     .source = "candidates: no ray falls below its surface"},
    RomaSampling::candidates,
    {"snap", "candidates"}};

inline const Knob<RomaRotateBy> kRomaRotateBy{
    {.key = "roma.rotate_by",
     .unit = "",
     .help =
         "What one invocation of the rotation makes, with the same result: a texel of up to four "
         "words, a word, or whichever suits the device.",
     .source = "measured: a GPU wants many small invocations, a CPU few without barriers"},
    RomaRotateBy::device,
    {"device", "texel", "word"}};

std::vector<const KnobBase*> roma_knobs();

/// Ray-aligned occupancy map array: the base occupancy map rotated to each of a few candidate
/// directions, so that a ray along one of them is a range of bits (Zeng et al. 2023). The view box
/// of each map, which the paper leaves open, fits the scene at that turn; so its cells are smaller
/// than those of a cube that encloses the scene at any turn, in which the normal offset still
/// counts.
class RomaTracer final : public Tracer {
public:
    void build(const FrameContext& frame) override;
    std::string shader_file() const override { return "tracers/roma/roma_tracer.glsl"; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
    bool sample_candidates(const Settings& settings) const override;
    void bind(const Program& program) const override;
    std::vector<StructureBytes> bytes() const override;
    size_t bytes_needed(const Settings& settings) const override;
    std::vector<ShaderVariant> build_variants(const Settings& settings) const override;
    std::vector<std::string_view> views() const override;
    void draw_view(const FrameContext& frame, std::string_view view,
                   const Texture& picture) override;

    // What was built, for tests and for views.
    const std::vector<glm::dvec3>& candidates() const { return candidates_; }
    const std::vector<gpu::RomaDirection>& maps() const { return directions_; }
    /// Words of map `index`, ordered as AlignedMap has them.
    std::vector<uint32_t> download_map(int index) const;

    /// Rotates a given base map: build() without the rasterising.
    void rotate(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid,
                const Bounds& bounds);

private:
    void aim(const FrameContext& frame, const OccupancyGrid& grid, const Bounds& bounds);
    void resize_maps();

    OccupancyMap occupancy_;
    int side_ = 0;
    std::vector<glm::dvec3> candidates_;
    std::vector<gpu::RomaDirection> directions_;
    ProgramSlot rotate_;
    Buffer direction_buffer_; ///< std430 RomaDirection[]
    Buffer candidate_buffer_; ///< std140 RomaCandidates of roma_tracer.glsl
    Texture map_texture_;
    OccupancySlice occupancy_slice_;
    MapView map_view_;
};

std::unique_ptr<Tracer> make_roma_tracer();

} // namespace romascope
