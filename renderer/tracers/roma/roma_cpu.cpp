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

} // namespace romascope
