// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace romascope {

/// What a driver allows.
struct ComputeLimits {
    size_t texels;      ///< of a buffer texture
    size_t block_bytes; ///< of a storage block
};

/// Those of the current context.
ComputeLimits query_compute_limits();

/// Why the occupancy map of a scene of this size cannot be built in compute, in words that go on
/// after its name; empty if it can.
std::string beyond_compute(size_t vertices, size_t triangles, const ComputeLimits& limits);

} // namespace romascope
