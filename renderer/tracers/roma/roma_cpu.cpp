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

bool any_hit_on_cpu(const AlignedMap& map, const gpu::RomaRay& ray) {
    if (ray.span.first > ray.span.last)
        return false;
    const uint32_t* column = map.column(ray.span.column);
    uint32_t occupied = 0;
    for (int word = 0; word < map.words_per_column(); ++word)
        occupied |= column[word] & gpu::bits_in_range(word, ray.span.first, ray.span.last);
    return occupied != 0;
}

std::optional<float> closest_hit_on_cpu(const AlignedMap& map, const gpu::RomaRay& ray) {
    if (ray.span.first > ray.span.last)
        return std::nullopt;
    const uint32_t* column = map.column(ray.span.column);
    const int count = map.words_per_column();
    for (int i = 0; i < count; ++i) {
        const int word = ray.forward ? i : count - 1 - i;
        const uint32_t bits =
            column[word] & gpu::bits_in_range(word, ray.span.first, ray.span.last);
        if (bits == 0)
            continue;
        const int bit = ray.forward ? gpu::findLSB(bits) : gpu::findMSB(bits);
        return gpu::roma_hit_distance(32 * word + bit, ray.surface, ray.forward);
    }
    return std::nullopt;
}

} // namespace romascope
