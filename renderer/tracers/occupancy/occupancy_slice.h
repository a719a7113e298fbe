// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/occupancy_map.h"

#include <string_view>

namespace romascope {

/// A view of the base occupancy map: a slice across view.axis at view.slice; the cells are squares,
/// white where occupied, black where empty.
class OccupancySlice {
public:
    static constexpr std::string_view kName = "occupancy_slice";

    /// `picture`: RGBA32F.
    void draw(const FrameContext& frame, const OccupancyMap& map, const Texture& picture);
    static ShaderVariant variant(BaseStore store);

private:
    ProgramSlot program_;
};

} // namespace romascope
