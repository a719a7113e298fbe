// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/walk_cpu.h"

#include <algorithm>

namespace romascope {
namespace {

/// `bounded`: leaves the cells of a span that its column has; `column`: the words of one.
template <class Bounded, class Column>
WalkResult walk_columns(gpu::RomaWalk walk, int iterations, int escape, int count,
                        const Bounded& bounded, const Column& column) {
    const float stop = std::min(walk.leaves, walk.ends);
    for (int i = 0; i < iterations && walk.entered < stop; ++i) {
        const float border = gpu::roma_walk_border(walk);
        const bool snapped = i == iterations - 1 && border < stop;
        const gpu::RomaSpan way =
            gpu::roma_walk_span(walk, snapped ? walk.ends : std::min(border, stop), count);
        gpu::RomaSpan span = bounded(way);
        std::optional<int> cell;
        if (span.first <= span.last) {
            const std::span<const uint32_t> words = column(span.column);
            const int passed = span.last - span.first + 1;
            const bool stays = walk.forward ? span.last == way.last : span.first == way.first;
            span = escaped_on_cpu(words, span, walk.forward, std::min(escape, passed));
            escape = span.first > span.last && stays ? escape - passed : 0;
            cell = closest_hit_in_column(words, span, walk.forward);
        } else {
            escape = 0; // free, as it is beyond the grid
        }
        const float entry = gpu::roma_walk_entry(walk, cell.value_or(-1));
        const bool unfinished = snapped && !(cell && entry < border);
        if (cell)
            return {gpu::roma_walk_distance(walk, entry), unfinished};
        if (border >= stop || unfinished)
            return {-1.0f, unfinished};
        walk = gpu::roma_walk_on(walk);
    }
    return {};
}

} // namespace

WalkResult walk_on_cpu(const AlignedMap& map, const gpu::RomaWalk& walk, int iterations,
                       int escape) {
    return walk_columns(
        walk, iterations, escape, map.side,
        [&](gpu::RomaSpan span) { return gpu::roma_in_box(span, map.side); },
        [&](glm::ivec2 place) { return map.column(place); });
}

WalkResult walk_on_cpu(const ShearedMap& map, const gpu::RomaWalk& walk, int iterations,
                       int escape) {
    return walk_columns(
        walk, iterations, escape, map.size.z, [&](gpu::RomaSpan span) { return map.inside(span); },
        [&](glm::ivec2 place) { return map.column(place); });
}

} // namespace romascope
