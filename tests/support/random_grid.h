// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/occupancy/bit_grid.h"

#include <random>

namespace romascope {

/// Every cell set with this probability.
inline BitGrid random_grid(glm::ivec3 size, double probability, std::mt19937& random) {
    BitGrid grid(size);
    std::bernoulli_distribution occupied(probability);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (occupied(random))
                    grid.set({x, y, z});
    return grid;
}

} // namespace romascope
