// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/grid_tracer.h"

namespace romascope {

void GridTracer::build(const FrameContext& frame) {
    occupancy_.build(frame, BaseStore::texture);
    take(frame, occupancy_.map().texture(), occupancy_.grid());
}

std::vector<ShaderDefine> GridTracer::shader_defines(const Settings& settings) const {
    if (!given_leaving_)
        return romascope::shader_defines(settings, knobs_);
    Settings given = settings;
    given.set(escape_, given_leaving_->escape);
    return romascope::shader_defines(given, knobs_);
}

void GridTracer::take(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid) {
    base_ = &base;
    grid_ = grid;
    leaving_ = given_leaving_.value_or(Leaving{
        frame.settings.get(normal_offset_) * double(grid.cell_size), frame.settings.get(escape_)});
}

void GridTracer::bind(const Program& program) const {
    base_->bind(4);
    program.set("grid_origin", grid_.origin);
    program.set("metres_per_cell", grid_.cell_size);
    program.set("grid_size", grid_.size);
    program.set("grid_offset", static_cast<float>(leaving_.offset / double(grid_.cell_size)));
}

std::vector<StructureBytes> GridTracer::bytes() const { return {occupancy_.bytes()}; }

size_t GridTracer::bytes_needed(const Settings& settings) const {
    return OccupancyMap::bytes_needed(settings);
}

std::vector<ShaderVariant> GridTracer::build_variants(const Settings&) const {
    std::vector<ShaderVariant> variants = OccupancyMap::variants();
    variants.push_back(OccupancySlice::variant(BaseStore::texture));
    return variants;
}

void GridTracer::draw_view(const FrameContext& frame, std::string_view, const Texture& picture) {
    slice_.draw(frame, occupancy_, picture);
}

} // namespace romascope
