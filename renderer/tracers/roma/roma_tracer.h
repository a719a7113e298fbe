// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/occupancy_slice.h"
#include "renderer/tracers/roma/map_view.h"
#include "renderer/tracers/roma/roma_knobs.h"
#include "renderer/tracers/roma/rotation.h"
#include "renderer/tracers/roma/shearing.h"
#include "renderer/tracers/tracer.h"

namespace romascope {

std::vector<const KnobBase*> roma_knobs();

/// Ray-aligned occupancy map array: the base occupancy map aligned with each of a few candidate
/// directions, so that a ray along one of them is a range of bits (Zeng et al. 2023). Aligned by
/// rotation, as published, or by shear.
class RomaTracer final : public Tracer {
public:
    void build(const FrameContext& frame) override;
    std::string shader_file() const override { return "tracers/roma/roma_tracer.glsl"; }
    std::vector<ShaderDefine> shader_defines(const Settings& settings) const override;
    bool sample_candidates(const Settings& settings) const override;
    Leaving leaving() const override { return leaving_; }
    CandidateSet candidate_set() const override;
    void bind(const Program& program) const override;
    std::vector<StructureBytes> bytes() const override;
    size_t bytes_needed(const Settings& settings) const override;
    std::vector<NamedCount> counts() const override;
    std::vector<ShaderVariant> build_variants(const Settings& settings) const override;
    std::vector<std::string_view> views() const override;
    void draw_view(const FrameContext& frame, std::string_view view,
                   const Texture& picture) override;

    /// What the base map is wanted in.
    static BaseStore store_for(const Settings& settings);
    /// Aligns a given base map, stored so: build() without the rasterising.
    void align(const FrameContext& frame, const BaseMap& base, const OccupancyGrid& grid,
               const Bounds& bounds);

    // What was built, for tests and for views.
    const std::vector<glm::dvec3>& candidates() const { return candidates_; }
    const Rotation& rotation() const { return rotation_; }
    const Shearing& shearing() const { return shearing_; }

private:
    void clear_counts(const Settings& settings);
    void upload_candidates(const Settings& settings, glm::vec3 centre);

    OccupancyMap occupancy_;
    RomaAlignment alignment_ = RomaAlignment::rotate;
    std::vector<glm::dvec3> candidates_;
    bool snaps_ = true;
    Leaving leaving_;
    Rotation rotation_;       ///< empty unless that is the alignment
    Shearing shearing_;       ///< likewise
    Buffer candidate_buffer_; ///< std140 RomaCandidates of roma_tracer.glsl
    Buffer count_buffer_;     ///< std430 RomaCounts of unsnapped.glsl; empty while rays are snapped
    OccupancySlice occupancy_slice_;
    MapView map_view_;
};

std::unique_ptr<Tracer> make_roma_tracer();

} // namespace romascope
