// SPDX-License-Identifier: MIT
// Hits in one column of an aligned map, on the CPU: what the tracing shaders do with its words,
// bit by bit the same.
#pragma once

#include "shaders/tracers/roma/span.h"

#include <cstdint>
#include <optional>
#include <span>

namespace romascope {

/// Without the occupied cells that follow each other at the start of the ray, at most `limit`.
gpu::RomaSpan escaped_on_cpu(std::span<const uint32_t> column, gpu::RomaSpan cells, bool forward,
                             int limit);

/// The slice of the first occupied cell on the way; nothing if there is none.
std::optional<int> closest_hit_in_column(std::span<const uint32_t> column,
                                         const gpu::RomaSpan& cells, bool forward);

/// Distance from the surface in cells along the map's direction; nothing for a miss. `Map`:
/// AlignedMap or ShearedMap. `escape`: occupied cells that are skipped at the start of the ray.
template <class Map>
std::optional<float> closest_hit_on_cpu(const Map& map, const gpu::RomaRay& ray, int escape = 0) {
    if (ray.span.first > ray.span.last)
        return std::nullopt; // its column may lie beyond the map
    const std::span<const uint32_t> column = map.column(ray.span.column);
    const gpu::RomaSpan cells = escaped_on_cpu(column, ray.span, ray.forward, escape);
    const std::optional<int> slice = closest_hit_in_column(column, cells, ray.forward);
    if (!slice)
        return std::nullopt;
    return gpu::roma_hit_distance(*slice, ray.surface, ray.forward);
}

template <class Map>
bool any_hit_on_cpu(const Map& map, const gpu::RomaRay& ray, int escape = 0) {
    return closest_hit_on_cpu(map, ray, escape).has_value();
}

} // namespace romascope
