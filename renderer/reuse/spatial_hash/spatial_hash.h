// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/reuse/spatial_hash/cell_renewal.h"
#include "renderer/reuse/spatial_hash/hash_table.h"

#include <optional>

namespace romascope {

/// Ambient occlusion kept in world space, in cells that are found by a hash of position, normal and
/// size (Anagnostou, Spatial hashing for raytraced ambient occlusion). A frame claims a cell for
/// each pixel and shows what it has; where that is not enough yet it lists the pixel, traces, adds
/// what was found, and reads the listed pixels from their cells; then it frees those that were not
/// used for long. Each of these is a pass of its own,
/// so that nothing depends on the order in which a GPU runs pixels, as long as the table has room.
class SpatialHash {
public:
    /// `first_moving_vertex`: from that one on vertices of the scene may move; none do without.
    explicit SpatialHash(std::optional<uint32_t> first_moving_vertex = {})
        : renewal_(first_moving_vertex) {}

    /// A frame, in place of ambient_occlusion.run(): its visibility() is then what the cells have.
    /// Starts with an empty table where the settings say that cells mean something else.
    void run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
             const Tracer& tracer, AmbientOcclusion& ambient_occlusion);
    /// Forgets all cells: what they hold is no longer so.
    void clear() { stale_ = true; }
    /// Vertices may stand elsewhere than in the last frame: forgets the cells within reach of those
    /// that do, when they are seen again; with an unbounded radius all.
    void vertices_moved() { renewal_.vertices_moved(); }
    /// Forgets all cells and gives back their memory.
    void release();

    /// Where frame.view=hash: what run() drew; RGBA32F, linear.
    const Texture& picture() const { return picture_; }
    /// Empty where nothing is held.
    std::vector<StructureBytes> bytes() const;
    /// What the last frame counted. Waits for the GPU.
    std::vector<NamedCount> counts() const;
    /// The slots, for tests. Waits for the GPU.
    const HashTable& table() const { return table_; }

    /// Whether these settings ask for it, for a picture or to look at its cells.
    static bool is_used(const Settings& settings);
    /// What bytes() can come to at most under these settings, views aside; 0 where it is not used.
    static size_t bytes_needed(const Settings& settings, size_t pixels);
    static std::vector<ShaderVariant> variants(const Settings& settings);

private:
    void prepare(const FrameContext& frame, const View& view);
    void set_key_uniforms(const Program& program, const FrameContext& frame,
                          const View& view) const;
    void claim(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
               const Texture& visibility);
    void renew(const FrameContext& frame);
    void add(const FrameContext& frame, const Texture& visibility);
    void resolve(const FrameContext& frame, const Texture& visibility);
    void settle(const FrameContext& frame);
    void draw(const FrameContext& frame, const View& view, const GBuffer& gbuffer);

    ProgramSlot claim_program_, renewing_claim_program_, renew_program_, add_program_,
        resolve_program_, settle_program_, view_program_;
    HashTable table_;
    CellRenewal renewal_;
    PixelList list_; ///< pixels that trace
    Texture cells_;  ///< RG32UI, of these, see shaders/reuse/spatial_hash/pixel_cells.h
    Buffer counts_;  ///< gpu::kHashCounts words
    Texture picture_;
    bool stale_ = false;
    int rays_ = 0;                    ///< per traced pixel, in the last frame
    std::optional<Settings> meaning_; ///< what the cells stand for
};

} // namespace romascope
