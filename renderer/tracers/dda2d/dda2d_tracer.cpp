// SPDX-License-Identifier: MIT
#include "renderer/tracers/dda2d/dda2d_tracer.h"

namespace romascope {

std::vector<const KnobBase*> dda2d_knobs() {
    return {&kDda2dHierarchy, &kDda2dNormalOffset, &kDda2dEscape};
}

std::unique_ptr<Tracer> make_dda2d_tracer() { return std::make_unique<Dda2dTracer>(); }

void Dda2dTracer::take(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid) {
    GridTracer::take(frame, base, grid);
    if (frame.settings.get(kDda2dHierarchy))
        hierarchy_.build(frame, base);
    else
        hierarchy_ = {};
}

void Dda2dTracer::bind(const Program& program) const {
    GridTracer::bind(program);
    if (hierarchy_.texture().id())
        hierarchy_.texture().bind(5);
}

std::vector<StructureBytes> Dda2dTracer::bytes() const {
    std::vector<StructureBytes> all = GridTracer::bytes();
    if (hierarchy_.bytes() > 0)
        all.push_back({"occupancy hierarchy", hierarchy_.bytes()});
    return all;
}

size_t Dda2dTracer::bytes_needed(const Settings& settings) const {
    const int side = settings.get(kOccupancyResolution);
    const size_t levels = Hierarchy::bytes_for({side, side, (side + 31) / 32});
    return GridTracer::bytes_needed(settings) + (settings.get(kDda2dHierarchy) ? levels : 0);
}

std::vector<ShaderVariant> Dda2dTracer::build_variants(const Settings& settings) const {
    std::vector<ShaderVariant> variants = GridTracer::build_variants(settings);
    if (settings.get(kDda2dHierarchy))
        variants.push_back(Hierarchy::variant());
    return variants;
}

} // namespace romascope
