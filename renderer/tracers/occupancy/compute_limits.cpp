// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/compute_limits.h"

#include "renderer/gl/objects.h"
#include "shaders/tracers/occupancy/work_list.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope {

ComputeLimits query_compute_limits() {
    GLint texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    GLint64 block = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &block);
    return {static_cast<size_t>(texels), static_cast<size_t>(block)};
}

std::string beyond_compute(size_t vertices, size_t triangles, const ComputeLimits& limits) {
    constexpr size_t kListedTriangles = (size_t{1} << (32 - gpu::kPieceBits)) - 1;
    // Texture coordinates are the largest that is read as a block.
    const size_t most_vertices = std::min(limits.texels, limits.block_bytes / sizeof(glm::vec2));
    const size_t most_triangles = std::min(limits.texels, kListedTriangles);
    if (vertices <= most_vertices && triangles <= most_triangles)
        return {};
    return fmt::format(
        "has {} vertices and {} triangles: with more than {} or {} the occupancy map "
        "is rasterised on this driver, though occupancy.builder is compute",
        vertices, triangles, most_vertices, most_triangles);
}

} // namespace romascope
