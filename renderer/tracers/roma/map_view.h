// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/tracer.h"

namespace romascope {

/// Views of the aligned map view.map, looking along its rays: the slice at view.slice, or how full
/// each column is. For any tracer of aligned maps whose GLSL file gives
///     ivec3 aligned_map_size(int map)                          columns, columns, cells of a column
///     uint  aligned_map_word(int map, ivec2 column, int word)  bit b: cell 32 word + b of a column
/// with the bits beyond a column's last cell 0.
class MapView {
public:
    static constexpr std::string_view kSlice = "map_slice", kColumns = "map_columns";

    /// `name`: one of those above; `map_count`: how many the tracer has built; `picture`: RGBA32F.
    void draw(const FrameContext& frame, const Tracer& tracer, int map_count, std::string_view name,
              const Texture& picture);
    static ShaderVariant variant(const Settings& settings, const Tracer& tracer);

private:
    ProgramSlot program_;
};

} // namespace romascope
