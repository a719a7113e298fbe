// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "shaders/reuse/changes/change_grid.h"

#include <array>

namespace romascope {

/// Blocks that cover `bounds`: a 24th of `reach` on a side, in metres; larger where more than
/// 1,048,576 or more than 256 along a side would be needed.
gpu::ChangeGrid change_grid(const Bounds& bounds, float reach);

/// For each block of the scene the frame in which something within reach of any point of it last
/// moved: by the blocks that triangles touch, where they were and where they are. Nothing within
/// reach is missed. The same vertices give the same frames.
class ChangeVolume {
public:
    /// Metres from a block within which moves are told, from the shortest on.
    using Reaches = std::array<float, gpu::kReaches>;

    /// Begins anew: everything changed in `frame`. Vertices from `first_vertex` on may move.
    /// `reach`: the shortest of the reaches to come. Throws Error if there is no memory for it.
    void begin(const FrameContext& frame, uint32_t first_vertex, float reach);
    void release();
    bool has_begun() const { return followed_.bytes() > 0; }
    /// Whether the scene, as it stands, can be followed without beginning anew.
    bool covers(const Bounds& bounds) const;

    /// Looks for what moved since the last call, or since begin(): by more than `tolerance` metres
    /// along an axis. Smaller moves add up over calls.
    void update(const FrameContext& frame, const Reaches& reaches, float tolerance);

    /// For what includes change_grid.glsl and reads last_changes, as stale_cells.glsl does: binds a
    /// storage block and sets the uniforms of `program`, which is in use.
    void bind(const Program& program, GLuint slot) const;

    const gpu::ChangeGrid& grid() const { return grid_; }
    /// The frames of all blocks (gpu::block_index), for each reach in turn. Waits for the GPU.
    std::vector<uint32_t> download() const { return last_changes_.download<uint32_t>(); }
    size_t bytes() const;

    /// Whether a driver can read the scene as this does.
    static bool takes(const GpuScene& scene);
    /// What bytes() can come to, where so many vertices move.
    static size_t bytes_needed(size_t vertices);
    static std::vector<ShaderVariant> variants();

private:
    void mark(const FrameContext& frame, float tolerance);
    void follow(const FrameContext& frame, float tolerance);
    void spread(const FrameContext& frame, const Reaches& reaches);
    void set_grid(const Program& program) const;
    int blocks() const { return grid_.size.x * grid_.size.y * grid_.size.z; }

    ProgramSlot mark_program_, follow_program_, row_program_, plane_program_, stamp_program_;
    gpu::ChangeGrid grid_{};
    Bounds bounds_; ///< that the grid covers; empty: nothing begun
    uint32_t first_vertex_ = 0;
    Buffer followed_;      ///< three floats a moving vertex
    Buffer moved_blocks_;  ///< a word for all, a bit for each
    Buffer row_distances_; ///< a word a block
    Buffer plane_squares_; ///< likewise
    Buffer last_changes_;  ///< likewise, for each reach
};

} // namespace romascope
