// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/shear.h"

#include <algorithm>
#include <cmath>

namespace romascope {

int shear_guard(int taps) { return taps > 1 ? 1 : 0; }

ShearPackings shear_packings(glm::ivec3 grid_size, int guard) {
    ShearPackings packings;
    size_t first = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const ShearAxes axes(axis);
        ShearPacking& packing = packings[static_cast<size_t>(axis)];
        packing.columns = glm::ivec2(grid_size[axes.p], grid_size[axes.q]) + 2 * guard;
        packing.slices = grid_size[axes.m];
        packing.row_words = (packing.columns.x + 31) / 32 + 1;
        packing.first_word = first;
        first += packing.words();
    }
    return packings;
}

size_t shear_packing_words(const ShearPackings& packings) {
    return packings[2].first_word + packings[2].words();
}

int shear_table_places(glm::ivec3 grid_size, int guard) {
    int most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const ShearAxes axes(axis);
        const int columns = std::max(grid_size[axes.p], grid_size[axes.q]) + 2 * guard;
        most = std::max(most, columns + 2 * gpu::shear_farthest(grid_size[axes.m]) + 1);
    }
    return most;
}

int dominant_axis(glm::dvec3 direction) {
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.y > size.x ? 1 : 0;
    return size.z > size[axis] ? 2 : axis;
}

glm::dvec3 ShearFrame::along(size_t map) const {
    return glm::normalize(glm::dvec3(maps[map].along)); // its fractions are those of the slopes
}

ShearFrame shear_frame(std::span<const glm::dvec3> directions, const OccupancyGrid& grid, int taps,
                       int texels_per_column, double offset) {
    const int guard = shear_guard(taps);
    const ShearPackings packings = shear_packings(grid.size, guard);
    ShearFrame frame;
    gpu::ShearGrid& shared = frame.grid;
    shared.origin = glm::vec4(grid.origin, 1.0f / grid.cell_size);
    shared.columns = glm::ivec4(grid.size + 2 * guard, guard);
    shared.inverse =
        glm::vec4(1.0f / glm::vec3(glm::ivec3(shared.columns)), static_cast<float>(offset));
    shared.first_word = shared.row_words = glm::ivec4(0);
    for (int axis = 0; axis < 3; ++axis) {
        const ShearPacking& packing = packings[static_cast<size_t>(axis)];
        shared.first_word[axis] = static_cast<int>(packing.first_word);
        shared.row_words[axis] = packing.row_words;
    }
    shared.first_word.w = static_cast<int>(directions.size());
    shared.row_words.w = shear_table_places(grid.size, guard);
    constexpr double kOne = 1 << gpu::kShearFractionBits;
    const auto slices_per_cell = [](int steps) {
        return steps == 0 ? 1e9f : static_cast<float>(kOne / std::abs(steps));
    };
    for (const glm::dvec3& direction : directions) {
        const ShearAxes axes(dominant_axis(direction));
        const glm::dvec2 exact =
            glm::dvec2(direction[axes.p], direction[axes.q]) / direction[axes.m];
        const glm::ivec2 slope(glm::floor(exact * kOne + 0.5));
        const glm::dvec2 rounded = glm::dvec2(slope) / kOne;
        glm::dvec3 along;
        along[axes.p] = rounded.x;
        along[axes.q] = rounded.y;
        along[axes.m] = 1.0;
        const double metres = glm::length(along) * grid.cell_size;
        const glm::ivec3 size = gpu::shear_size(shared, axes.m);
        const int entry =
            gpu::shear_first_entry(shared, static_cast<int>(frame.maps.size()), size.z);
        frame.maps.push_back(
            {glm::ivec4(slope, axes.m, static_cast<int>(frame.texels)),
             glm::vec4(slices_per_cell(slope.x), slices_per_cell(slope.y), 1.0 / metres, metres),
             glm::vec4(along, 0.0f), glm::ivec4(entry, size.z, axes.m, 0)});
        frame.texels += static_cast<size_t>(size.x) * static_cast<size_t>(size.y) *
                        static_cast<size_t>(texels_per_column);
    }
    frame.places = 2 * frame.maps.size() * static_cast<size_t>(shared.row_words.w);
    return frame;
}

} // namespace romascope
