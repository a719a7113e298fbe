// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/shear_cpu.h"

namespace romascope {

std::span<const uint32_t> ShearedMap::column(glm::ivec2 unwrapped) const {
    const glm::ivec2 place = gpu::shear_wrapped_column(grid, map.slope.z, unwrapped);
    const auto count = static_cast<size_t>(words_per_column());
    const size_t index =
        static_cast<size_t>(place.y) * static_cast<size_t>(size.x) + static_cast<size_t>(place.x);
    return std::span(words).subspan(index * count, count);
}

gpu::RomaSpan ShearedMap::inside(gpu::RomaSpan span) const {
    return gpu::shear_inside(span, gpu::shear_place_along_p(grid, map, span.column.x),
                             gpu::shear_place_along_q(grid, map, span.column.y));
}

gpu::RomaRay ShearedMap::ray(bool forward, glm::vec3 point, glm::vec3 normal, float t_max) const {
    gpu::RomaRay ray = gpu::shear_ray(grid, map, forward, point, normal, t_max);
    ray.span = inside(ray.span);
    return ray;
}

std::vector<uint32_t> pack_on_cpu(const BitGrid& base, const ShearPackings& packings) {
    std::vector<uint32_t> words(shear_packing_words(packings));
    for (int axis = 0; axis < 3; ++axis) {
        const ShearAxes axes(axis);
        const ShearPacking& packing = packings[static_cast<size_t>(axis)];
        size_t word = packing.first_word;
        for (int q = 0; q < packing.columns.y; ++q) {
            for (int first = 0; first < 32 * packing.row_words; first += 32) {
                for (int slice = 0; slice < packing.slices; ++slice, ++word) {
                    for (int bit = 0; bit < 32; ++bit) {
                        glm::ivec3 cell;
                        cell[axes.p] = (first + bit) % packing.columns.x;
                        cell[axes.q] = q;
                        cell[axes.m] = slice;
                        if (base.get(cell)) // what is beyond the grid, its guard too, is empty
                            words[word] |= 1u << bit;
                    }
                }
            }
        }
    }
    return words;
}

ShearedMap shear_on_cpu(const BitGrid& base, const ShearFrame& frame, size_t map, int taps) {
    ShearedMap sheared{frame.grid, frame.maps[map], frame.size(map), {}};
    const ShearAxes axes(sheared.map.slope.z);
    const glm::ivec2 slope(sheared.map.slope);
    const glm::ivec3 size = sheared.size;
    const auto count = static_cast<size_t>(sheared.words_per_column());
    sheared.words.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y) * count);
    for (int slice = 0; slice < size.z; ++slice) {
        const uint32_t bit = 1u << slice % 32;
        for (int tap = 0; tap < taps; ++tap) {
            const glm::ivec2 moved = gpu::shear_tap(slope, slice, tap, taps);
            size_t word = static_cast<size_t>(slice / 32);
            for (int j = 0; j < size.y; ++j) {
                for (int i = 0; i < size.x; ++i, word += count) {
                    const glm::ivec2 place =
                        gpu::shear_wrapped_column(frame.grid, axes.m, glm::ivec2(i, j) + moved);
                    glm::ivec3 cell;
                    cell[axes.p] = place.x;
                    cell[axes.q] = place.y;
                    cell[axes.m] = slice;
                    if (base.get(cell))
                        sheared.words[word] |= bit;
                }
            }
        }
    }
    return sheared;
}

} // namespace romascope
