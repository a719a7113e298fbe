// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/voxelize_cpu.h"

#include "renderer/scene/surface_mask.h"
#include "shaders/tracers/occupancy/triangle_cells.h"

#include <array>

namespace romascope {
namespace {

class Voxelizer {
public:
    Voxelizer(const Scene& scene, const OccupancyGrid& grid, OccupancyCoverage coverage)
        : scene_(scene), grid_(grid), conservative_(coverage == OccupancyCoverage::conservative),
          cells_(grid.size) {}

    void add(size_t triangle) {
        const uint32_t* vertices = &scene_.indices[3 * triangle];
        std::array<glm::vec3, 3> p;
        for (size_t i = 0; i < 3; ++i)
            p[i] = (scene_.positions[vertices[i]] - grid_.origin) * (1.0f / grid_.cell_size);
        const auto apex = static_cast<size_t>(gpu::apex_of(p[0], p[1], p[2]));
        for (size_t i = 0; i < 3; ++i)
            corner_[i] = vertices[(apex + i) % 3];
        const gpu::CellTriangle t = gpu::cell_triangle(
            p[apex], p[(apex + 1) % 3], p[(apex + 2) % 3], grid_.size, conservative_);
        if (t.kind == gpu::kCellsNone)
            return;
        for (int w = t.first.z; w <= t.last.z; ++w)
            for (int v = t.first.y; v <= t.last.y; ++v)
                for (int u = t.first.x; u <= t.last.x; ++u)
                    if (occupied(t, {u, v, w}))
                        cells_.set(gpu::cell_xyz({u, v, w}, t.axis));
    }

    BitGrid take() { return std::move(cells_); }

private:
    bool occupied(const gpu::CellTriangle& t, glm::ivec3 cell) const {
        const int lines =
            t.kind == gpu::kCellsBox ? 1 : gpu::occupancy_of_cell(t, cell, conservative_);
        if (lines == 0 || scene_.materials[scene_.vertex_material[corner_[0]]].alpha_cutoff <= 0.0f)
            return lines != 0;
        if (conservative_)
            return there(t, cell, 2);
        for (int axis = 0; axis < 3; ++axis)
            if ((lines >> axis & 1) && there(t, cell, axis))
                return true;
        return false;
    }

    bool there(const gpu::CellTriangle& t, glm::ivec3 cell, int axis) const {
        const Material& material = scene_.materials[scene_.vertex_material[corner_[0]]];
        const glm::vec3 point = gpu::blend_corners(mask_point(0), mask_point(1), mask_point(2),
                                                   gpu::corner_weights(t, cell, axis));
        const SurfaceTexture* texture =
            material.texture < 0 ? nullptr
                                 : &scene_.textures[static_cast<size_t>(material.texture)];
        return surface_is_there(material, texture, glm::vec2(point), point.z);
    }

    /// (u, v, alpha) of a corner.
    glm::vec3 mask_point(size_t corner) const {
        const uint32_t vertex = corner_[corner];
        glm::vec3 point(0.0f, 0.0f, 1.0f);
        if (!scene_.texcoords.empty())
            point = glm::vec3(scene_.texcoords[vertex], 1.0f);
        if (!scene_.colors.empty())
            point.z = static_cast<float>(scene_.colors[vertex] >> 24) * (1.0f / 255.0f);
        return point;
    }

    const Scene& scene_;
    const OccupancyGrid& grid_;
    bool conservative_;
    BitGrid cells_;
    std::array<uint32_t, 3> corner_{}; ///< vertices of the triangle, in the order of its corners
};

} // namespace

BitGrid voxelize_on_cpu(const Scene& scene, const OccupancyGrid& grid, OccupancyCoverage coverage) {
    Voxelizer voxelizer(scene, grid, coverage);
    for (size_t triangle = 0; triangle < scene.triangle_count(); ++triangle)
        voxelizer.add(triangle);
    return voxelizer.take();
}

} // namespace romascope
