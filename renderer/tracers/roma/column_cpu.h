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

bool any_hit_in_column(std::span<const uint32_t> column, const gpu::RomaSpan& cells);

/// The slice of the first occupied cell on the way; nothing if there is none.
std::optional<int> closest_hit_in_column(std::span<const uint32_t> column,
                                         const gpu::RomaSpan& cells, bool forward);

} // namespace romascope
