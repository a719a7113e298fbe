// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "shaders/reuse/changes/change_grid.h"

#include <array>

namespace romascope {

/// Blocks that cover `bounds`: an eighth of `reach` on a side, in metres; larger where more than
/// 65,536 or more than 64 along a side would be needed.
gpu::ChangeGrid change_grid(const Bounds& bounds, float reach);

/// How far what moved last lies from each block of the scene, and in which frame something moved
/// before within reach of any point of it: by the boxes that triangles touch, where they were and
/// where they are. Distances beyond all reaches are not told apart. Nothing within reach is missed.
/// The same vertices give the same distances.
class ChangeVolume {
public:
    /// Metres from a point within which moves are told, from the shortest on.
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

    /// For what includes changed.glsl: binds its storage block and sets the uniforms of `program`,
    /// which is in use.
    void bind(const Program& program) const;

    const gpu::ChangeGrid& grid() const { return grid_; }
    /// What the blocks cover, metres.
    const Bounds& bounds() const { return bounds_; }
    /// The frame of the last update, whether anything moved or not, or of begin().
    uint32_t last_change() const { return last_change_; }
    /// Of all blocks (gpu::block_index), see block_distance.comp.glsl. Waits for the GPU.
    std::vector<uint32_t> download() const { return changes_.download<uint32_t>(); }
    size_t bytes() const;

    /// Whether a driver can read the scene as this does.
    static bool takes(const GpuScene& scene);
    /// What bytes() can come to, where so many vertices move.
    static size_t bytes_needed(size_t vertices);
    static std::vector<ShaderVariant> variants();

private:
    void mark(const FrameContext& frame, float tolerance);
    void follow(const FrameContext& frame, float tolerance);
    void measure(const FrameContext& frame, const Reaches& reaches);
    void set_grid(const Program& program) const;

    ProgramSlot mark_program_, follow_program_, row_program_, plane_program_, block_program_;
    gpu::ChangeGrid grid_{};
    Bounds bounds_; ///< that the grid covers; empty: nothing begun
    uint32_t first_vertex_ = 0;
    uint32_t last_change_ = 0;
    Buffer followed_;      ///< three floats a moving vertex
    Buffer moved_boxes_;   ///< a word for all, a bit for each
    Buffer row_distances_; ///< this and the following: see the shaders that write them
    Buffer row_minima_;
    Buffer plane_squares_;
    Buffer changes_;
    static constexpr std::array kBuffers = {
        &ChangeVolume::followed_,   &ChangeVolume::moved_boxes_,   &ChangeVolume::row_distances_,
        &ChangeVolume::row_minima_, &ChangeVolume::plane_squares_, &ChangeVolume::changes_};
};

} // namespace romascope
