// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/column_cpu.h"

namespace romascope {

gpu::RomaSpan escaped_on_cpu(std::span<const uint32_t> column, gpu::RomaSpan cells, bool forward,
                             int limit) {
    const int count = static_cast<int>(column.size());
    const auto word = [&](int index) {
        return index < 0 || index >= count ? 0u : column[static_cast<size_t>(index)];
    };
    const int at = cells.start >> 5;
    const int run =
        gpu::roma_run(word(at), word(forward ? at + 1 : at - 1), cells.start, forward, limit);
    return gpu::roma_escaped(cells, run, forward);
}

std::optional<int> closest_hit_in_column(std::span<const uint32_t> column,
                                         const gpu::RomaSpan& cells, bool forward) {
    const int count = static_cast<int>(column.size());
    for (int i = 0; i < count; ++i) {
        const int word = forward ? i : count - 1 - i;
        const uint32_t bits =
            column[static_cast<size_t>(word)] & gpu::bits_in_range(word, cells.first, cells.last);
        if (bits != 0)
            return 32 * word + (forward ? gpu::findLSB(bits) : gpu::findMSB(bits));
    }
    return std::nullopt;
}

} // namespace romascope
