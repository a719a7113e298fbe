// SPDX-License-Identifier: MIT
#include "renderer/tracers/occupancy/compute_builder.h"

#include "renderer/tracers/occupancy/compute_limits.h"
#include "shaders/tracers/occupancy/work_list.h"

#include <algorithm>

namespace romascope {
namespace {

/// Columns of cells that a small triangle spans at most. A GPU waits for its slowest invocation;
/// software pays for each one that sets a triangle up.
int columns_in_place(bool many) { return many ? 8 : 256; }

/// A GPU takes so few triangles for large ones without asking: to find that out takes longer.
constexpr size_t kFewTriangles = 48;

ShaderVariant variant(const char* name, const char* file, OccupancyCoverage coverage, bool masked,
                      BaseStore store) {
    return {name,
            {{GL_COMPUTE_SHADER, file}},
            {{"CONSERVATIVE", coverage == OccupancyCoverage::conservative ? "1" : "0"},
             {"ALPHA_MASK", masked ? "1" : "0"},
             BaseMap::define(store)},
            {}};
}

ShaderVariant small_variant(OccupancyCoverage coverage, bool masked, bool many, BaseStore store) {
    return variant("occupy small",
                   many ? "tracers/occupancy/occupy_group.comp.glsl"
                        : "tracers/occupancy/occupy_small.comp.glsl",
                   coverage, masked, store);
}

ShaderVariant large_variant(OccupancyCoverage coverage, bool masked, bool many, BaseStore store) {
    return variant("occupy large",
                   many ? "tracers/occupancy/occupy_large_group.comp.glsl"
                        : "tracers/occupancy/occupy_large.comp.glsl",
                   coverage, masked, store);
}

void set_grid(const Program& program, const OccupancyGrid& grid, const GpuScene& scene) {
    program.use();
    program.set("grid_origin", grid.origin);
    program.set("cells_per_metre", 1.0f / grid.cell_size);
    program.set("grid_size", grid.size);
    program.set("has_texcoords", static_cast<int>(scene.texcoords().bytes() > 0));
    program.set("has_colors", static_cast<int>(scene.colors().bytes() > 0));
}

} // namespace

bool ComputeBuilder::takes(const GpuScene& scene) {
    return beyond_compute(scene.positions().bytes() / sizeof(glm::vec3),
                          scene.indices().bytes() / (3 * sizeof(uint32_t)), query_compute_limits())
        .empty();
}

void ComputeBuilder::build(const FrameContext& frame, const OccupancyGrid& grid,
                           const BaseMap& map) {
    if (work_list_.bytes() == 0) {
        constexpr gpu::WorkListHead kEmpty[2] = {{0, 1, 1, 0}, {0, 1, 1, 0}};
        work_list_ = Buffer("work list", bytes_needed());
        work_list_.upload(std::as_bytes(std::span(kEmpty)));
    }
    const GpuScene& scene = frame.scene;
    map.bind_image(0, GL_READ_WRITE);
    scene.position_texels().bind(0);
    scene.index_texels().bind(1);
    work_list_.bind(GL_SHADER_STORAGE_BUFFER, 4);
    // Groups differ by their sides too, which do not matter here.
    const std::vector<TriangleGroup>& groups = scene.groups();
    for (size_t i = 0; i < groups.size();) {
        size_t end = i, count = 0;
        for (; end < groups.size() && groups[end].masked == groups[i].masked; ++end)
            count += groups[end].count;
        run(frame, grid, map.store(), groups[i].masked, groups[i].first, count);
        i = end;
    }
}

void ComputeBuilder::run(const FrameContext& frame, const OccupancyGrid& grid, BaseStore store,
                         bool masked, size_t first, size_t count) {
    const OccupancyCoverage coverage = frame.settings.get(kOccupancyCoverage);
    const bool many = wants_many(frame.settings.get(kOccupancyInvocations));
    Programs& programs = masked ? masked_ : plain_;
    const Program& small =
        programs.small.get(frame.shaders, small_variant(coverage, masked, many, store));
    const Program& large =
        programs.large.get(frame.shaders, large_variant(coverage, masked, many, store));
    if (masked) {
        frame.scene.surfaces().bind();
        // A block must have a buffer even where it is not read.
        const auto bind = [&](const Buffer& buffer, GLuint slot) {
            (buffer.bytes() > 0 ? buffer : frame.scene.positions())
                .bind(GL_SHADER_STORAGE_BUFFER, slot);
        };
        bind(frame.scene.texcoords(), 5);
        bind(frame.scene.colors(), 6);
        bind(frame.scene.vertex_materials(), 7);
    }
    set_grid(large, grid, frame.scene);
    if (many) {
        const bool few_triangles = count <= kFewTriangles;
        large.set("every_piece", static_cast<int>(few_triangles));
        large.set("first_triangle", static_cast<GLuint>(first));
        if (few_triangles) {
            glDispatchCompute(gpu::kMostPieces, static_cast<GLuint>(count), 1);
            return;
        }
    }
    // The head in use was emptied by the run before, which also has read the entries.
    head_ = 1 - head_;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    set_grid(small, grid, frame.scene);
    small.set("head", static_cast<GLuint>(head_));
    small.set("first_triangle", static_cast<GLuint>(first));
    small.set("triangle_count", static_cast<GLuint>(count));
    small.set("columns_in_place", columns_in_place(many));
    const auto row = static_cast<size_t>(gpu::kTriangleRow);
    small.dispatch_covering(
        {static_cast<int>(std::min(count, row)), static_cast<int>((count + row - 1) / row), 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    large.use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, work_list_.id());
    glDispatchComputeIndirect(static_cast<GLintptr>(head_ * sizeof(gpu::WorkListHead)));
}

size_t ComputeBuilder::bytes_needed() {
    return 2 * sizeof(gpu::WorkListHead) + gpu::kWorkListLength * sizeof(uint32_t);
}

std::vector<ShaderVariant> ComputeBuilder::variants() {
    std::vector<ShaderVariant> all;
    for (const OccupancyCoverage coverage :
         {OccupancyCoverage::thin, OccupancyCoverage::conservative})
        for (const bool masked : {false, true})
            for (const bool many : {false, true})
                for (const BaseStore store : {BaseStore::texture, BaseStore::buffer}) {
                    all.push_back(small_variant(coverage, masked, many, store));
                    all.push_back(large_variant(coverage, masked, many, store));
                }
    return all;
}

} // namespace romascope
