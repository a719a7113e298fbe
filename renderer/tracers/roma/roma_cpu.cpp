// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/roma_cpu.h"

namespace romascope {

AlignedMap rotate_on_cpu(const BitGrid& base, const gpu::RomaDirection& direction, int side) {
    AlignedMap map{direction, side, {}};
    map.words.resize(static_cast<size_t>(side) * side * map.words_per_column());
    size_t word = 0;
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            for (int first = 0; first < side; first += 32, ++word) {
                glm::ivec3 position = gpu::roma_base_position(direction, {i, j, first});
                for (int k = 0; k < std::min(side - first, 32); ++k) {
                    if (base.get(position >> gpu::kRomaFractionBits))
                        map.words[word] |= 1u << k;
                    position += glm::ivec3(direction.base_step_w);
                }
            }
        }
    }
    return map;
}

bool any_hit_on_cpu(const AlignedMap& map, const gpu::RomaRay& ray, int escape) {
    return closest_hit_on_cpu(map, ray, escape).has_value();
}

std::optional<float> closest_hit_on_cpu(const AlignedMap& map, const gpu::RomaRay& ray,
                                        int escape) {
    if (ray.span.first > ray.span.last)
        return std::nullopt;
    const std::span<const uint32_t> column(map.column(ray.span.column),
                                           static_cast<size_t>(map.words_per_column()));
    const gpu::RomaSpan cells = escaped_on_cpu(column, ray.span, ray.forward, escape);
    const std::optional<int> slice = closest_hit_in_column(column, cells, ray.forward);
    if (!slice)
        return std::nullopt;
    return gpu::roma_hit_distance(*slice, ray.surface, ray.forward);
}

} // namespace romascope
