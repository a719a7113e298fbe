// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/reuse/spatial_hash/hash_knobs.h"
#include "shaders/reuse/spatial_hash/cell_state.h"

#include <cstdint>
#include <vector>

namespace romascope {

/// The table of the spatial hash on the GPU: slots of 12 bytes, in two buffers. The host's side
/// of shaders/reuse/spatial_hash/table.glsl.
class HashTable {
public:
    /// Without slots.
    HashTable() = default;
    /// `capacity`: slots, a power of two from 16 to 2^24; all free. Throws Error if there is no
    /// memory for them.
    explicit HashTable(uint32_t capacity);

    uint32_t capacity() const { return capacity_; }
    /// Frees all slots.
    void clear();
    /// Binds storage blocks 0 and 1 and sets the uniforms of `program`, which is in use.
    void bind(const Program& program, int search_count) const;
    /// Ends a frame: a dispatch of `program`, a variant of settle_variant() that is in use.
    /// `max_age`: frames without use before a slot is freed; gpu::kMaxAge: never. Counts what the
    /// table holds in the words that are bound to storage block 3.
    void settle(const Program& program, uint32_t frame, uint32_t max_age) const;
    /// All slots. Waits for the GPU.
    std::vector<gpu::Cell> download() const;
    size_t bytes() const { return checksums_.bytes() + sums_.bytes(); }

    /// What table.glsl needs.
    static std::vector<ShaderDefine> defines(HashProbing probing);
    static ShaderVariant settle_variant();

private:
    uint32_t capacity_ = 0;
    Buffer checksums_;
    Buffer sums_; ///< hits and samples
};

} // namespace romascope
