// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/roma/aligned_box.h"
#include "renderer/tracers/roma/column_layout.h"

#include <span>

namespace romascope {

/// Aligned maps by rotation (Zeng et al. 2023, Algorithm 1), in one texture array. The view box of
/// each map, which the paper leaves open, fits the scene at that turn; so its cells are smaller
/// than those of a cube that encloses the scene at any turn, in which the normal offset still
/// counts.
class Rotation {
public:
    /// `base`: the base occupancy map of this grid, around a scene within `bounds`.
    void build(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid,
               const Bounds& bounds, std::span<const glm::dvec3> candidates);

    /// For rotated_maps.glsl: texture unit 4 and storage block 4.
    void bind() const;
    static std::vector<ShaderDefine> defines(const Settings& settings);

    size_t bytes() const { return maps_.bytes() + direction_buffer_.bytes(); }
    static size_t bytes_needed(const Settings& settings);
    static std::vector<ShaderVariant> variants(const Settings& settings);

    const std::vector<gpu::RomaDirection>& directions() const { return directions_; }
    /// Words of map `index`, ordered as AlignedMap has them.
    std::vector<uint32_t> download_map(int index) const;

private:
    int side_ = 0;
    std::vector<gpu::RomaDirection> directions_;
    ProgramSlot program_;
    Buffer direction_buffer_; ///< std430 RomaDirection[]
    Texture maps_;
};

} // namespace romascope
