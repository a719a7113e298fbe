// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/roma/column_layout.h"
#include "renderer/tracers/roma/shear.h"

namespace romascope {

/// Aligned maps by shear, one after the other in one buffer of texels. See shear_shared.h.
class Shearing {
public:
    /// `base`: the base occupancy map of this grid.
    void build(const FrameContext& frame, const TexelBuffer& base, const OccupancyGrid& grid,
               std::span<const glm::dvec3> candidates);

    /// For sheared_maps.glsl: texture units 4 and 5, storage block 4 and uniform block 5.
    void bind() const;
    static std::vector<ShaderDefine> defines(const Settings& settings);

    size_t bytes() const {
        return texels_.bytes() + grid_buffer_.bytes() + map_buffer_.bytes() + packed_rows_.bytes() +
               places_.bytes();
    }
    /// For a scene like a cube, which needs the most.
    static size_t bytes_needed(const Settings& settings);
    static std::vector<ShaderVariant> variants(const Settings& settings);

    const ShearFrame& frame() const { return frame_; }
    /// Words of map `index`, ordered as ShearedMap has them.
    std::vector<uint32_t> download_map(int index) const;
    /// Of the base map, where there are any: after few invocations.
    std::vector<uint32_t> download_packings() const;

private:
    /// `size`: of the base map, cells. Everything that both ways need is bound.
    void shear_at_once(const FrameContext& frame, const Program& program, const TexelBuffer& base,
                       glm::ivec3 size);
    void shear_by_blocks(const FrameContext& frame, const Program& program, const TexelBuffer& base,
                         glm::ivec3 size);

    ShearFrame frame_;
    ColumnLayout layout_{};
    ProgramSlot pack_program_, shear_program_;
    TexelBuffer packed_rows_; ///< R32UI; a frame's may be longer than the next one's; none if many
    TexelBuffer places_;      ///< RG32UI, the table of places; likewise longer
    Buffer grid_buffer_;      ///< std140 ShearGrid
    Buffer map_buffer_;       ///< std430 ShearMap[]
    /// Grows to what the frames so far needed at most: which axes the candidates of a frame have,
    /// and so how many columns, is up to chance.
    TexelBuffer texels_;
};

} // namespace romascope
