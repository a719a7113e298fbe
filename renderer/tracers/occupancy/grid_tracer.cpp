// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/grid_tracer.h"

namespace romascope {

void GridTracer::build(const FrameContext& frame) {
    occupancy_.build(frame);
    take(frame, occupancy_.texture(), occupancy_.grid());
}

void GridTracer::take(const FrameContext&, const Texture& base, const OccupancyGrid& grid) {
    base_ = &base;
    grid_ = grid;
}

void GridTracer::bind(const Program& program) const {
    base_->bind(4);
    program.set("grid_origin", grid_.origin);
    program.set("metres_per_cell", grid_.cell_size);
    program.set("grid_size", grid_.size);
}

std::vector<StructureBytes> GridTracer::bytes() const { return {occupancy_.bytes()}; }

size_t GridTracer::bytes_needed(const Settings& settings) const {
    return OccupancyMap::bytes_needed(settings);
}

std::vector<ShaderVariant> GridTracer::build_variants(const Settings&) const {
    std::vector<ShaderVariant> variants = OccupancyMap::variants();
    variants.push_back(OccupancySlice::variant());
    return variants;
}

void GridTracer::draw_view(const FrameContext& frame, std::string_view, const Texture& picture) {
    slice_.draw(frame, occupancy_, picture);
}

} // namespace romascope
