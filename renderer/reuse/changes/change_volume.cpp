// SPDX-License-Identifier: MIT
#include "renderer/reuse/changes/change_volume.h"

#include "shaders/tracers/occupancy/work_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace romascope {
namespace {

/// What is within reach is known to about one of these.
constexpr float kBlocksPerReach = 24.0f;
constexpr int kMostBlocks = 1 << 20;
/// How marked triangles are rounded asks for no more (triangle_cells.h).
constexpr int kLongestSide = 256;

ShaderVariant variant_of(const char* name, const char* file) {
    return {name, {{GL_COMPUTE_SHADER, file}}, {}, {}};
}

ShaderVariant mark_variant() {
    return variant_of("mark moved", "reuse/changes/mark_moved.comp.glsl");
}
ShaderVariant follow_variant() {
    return variant_of("follow vertices", "reuse/changes/follow_vertices.comp.glsl");
}
ShaderVariant row_variant() {
    return variant_of("row distance", "reuse/changes/row_distance.comp.glsl");
}
ShaderVariant plane_variant() {
    return variant_of("plane distance", "reuse/changes/plane_distance.comp.glsl");
}
ShaderVariant stamp_variant() {
    return variant_of("stamp blocks", "reuse/changes/stamp_blocks.comp.glsl");
}

void wait_for_stores() { glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); }

void clear(const Buffer& buffer, uint32_t value) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
}

/// Runs over so many triangles or vertices.
void dispatch_rows(const Program& program, size_t count) {
    const auto row = static_cast<size_t>(gpu::kTriangleRow);
    program.dispatch_covering(
        {static_cast<int>(std::min(count, row)), static_cast<int>((count + row - 1) / row), 1});
}

/// A block more than needed, so that rounding puts nothing beyond the last.
glm::ivec3 grid_size(glm::vec3 extent, float block) {
    return glm::ivec3(glm::min(glm::floor(extent / block), glm::vec3(1e4f))) + 2;
}

} // namespace

gpu::ChangeGrid change_grid(const Bounds& bounds, float reach) {
    const glm::vec3 extent = bounds.extent();
    const float longest = std::max({extent.x, extent.y, extent.z});
    float block = std::max(reach / kBlocksPerReach, longest / static_cast<float>(kLongestSide - 2));
    const auto blocks = [&] {
        const glm::dvec3 size(grid_size(extent, block));
        return size.x * size.y * size.z;
    };
    while (blocks() > kMostBlocks)
        block *= 1.05f;
    return {bounds.min, 1.0f / block, grid_size(extent, block)};
}

void ChangeVolume::begin(const FrameContext& frame, uint32_t first_vertex, float reach) {
    const GpuScene& scene = frame.scene;
    Bounds bounds = scene.bounds();
    glm::vec3 margin(0.25f * reach);
    if (has_begun() && !covers(bounds)) {
        // What goes beyond its bounds once goes on to do so.
        bounds.add(bounds_);
        margin = glm::max(margin, 0.25f * bounds.extent());
    }
    bounds.min -= margin;
    bounds.max += margin;
    release(); // so that nothing is held twice, and nothing has begun if memory runs out
    const gpu::ChangeGrid grid = change_grid(bounds, reach);
    const size_t skipped = first_vertex * sizeof(glm::vec3);
    const size_t rows = static_cast<size_t>(grid.size.y) * grid.size.z;
    const size_t words = rows * grid.size.x;
    Buffer followed("followed vertices", scene.positions().bytes() - skipped);
    Buffer moved_blocks("moved blocks", (1 + rows * gpu::row_words(grid.size)) * sizeof(uint32_t));
    Buffer row_distances("row distances", words * sizeof(int32_t));
    Buffer plane_squares("plane squares", words * sizeof(int32_t));
    Buffer last_changes("last changes", gpu::kReaches * words * sizeof(uint32_t));
    clear(last_changes, frame.frame);
    glCopyNamedBufferSubData(scene.positions().id(), followed.id(), static_cast<GLintptr>(skipped),
                             0, static_cast<GLsizeiptr>(followed.bytes()));
    grid_ = grid;
    bounds_ = bounds;
    first_vertex_ = first_vertex;
    followed_ = std::move(followed);
    moved_blocks_ = std::move(moved_blocks);
    row_distances_ = std::move(row_distances);
    plane_squares_ = std::move(plane_squares);
    last_changes_ = std::move(last_changes);
}

void ChangeVolume::release() {
    bounds_ = {};
    for (Buffer* buffer :
         {&followed_, &moved_blocks_, &row_distances_, &plane_squares_, &last_changes_})
        *buffer = {};
}

bool ChangeVolume::covers(const Bounds& bounds) const {
    return glm::all(glm::greaterThanEqual(bounds.min, bounds_.min)) &&
           glm::all(glm::lessThanEqual(bounds.max, bounds_.max));
}

void ChangeVolume::update(const FrameContext& frame, const Reaches& reaches, float tolerance) {
    auto pass = frame.timer.compute("changes");
    mark(frame, tolerance);
    follow(frame, tolerance);
    spread(frame, reaches);
}

void ChangeVolume::mark(const FrameContext& frame, float tolerance) {
    const Program& program = mark_program_.get(frame.shaders, mark_variant());
    const size_t triangles = frame.scene.indices().bytes() / (3 * sizeof(uint32_t));
    clear(moved_blocks_, 0);
    program.use();
    set_grid(program);
    program.set("first_vertex", first_vertex_);
    program.set("triangle_count", static_cast<GLuint>(triangles));
    program.set("tolerance", tolerance);
    frame.scene.positions().bind(GL_SHADER_STORAGE_BUFFER, 0);
    followed_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    frame.scene.indices().bind(GL_SHADER_STORAGE_BUFFER, 2);
    moved_blocks_.bind(GL_SHADER_STORAGE_BUFFER, 3);
    dispatch_rows(program, triangles);
    wait_for_stores();
}

void ChangeVolume::follow(const FrameContext& frame, float tolerance) {
    const Program& program = follow_program_.get(frame.shaders, follow_variant());
    const size_t vertices = followed_.bytes() / sizeof(glm::vec3);
    program.use();
    program.set("first_vertex", first_vertex_);
    program.set("vertex_count", static_cast<GLuint>(vertices));
    program.set("tolerance", tolerance);
    frame.scene.positions().bind(GL_SHADER_STORAGE_BUFFER, 0);
    followed_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    dispatch_rows(program, vertices);
    wait_for_stores();
}

void ChangeVolume::spread(const FrameContext& frame, const Reaches& reaches) {
    const Program& rows = row_program_.get(frame.shaders, row_variant());
    rows.use();
    set_grid(rows);
    moved_blocks_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    row_distances_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    rows.dispatch_covering({blocks(), 1, 1});
    wait_for_stores();

    const auto in_blocks = [&](float reach) {
        return std::min(static_cast<double>(reach) * double{grid_.blocks_per_metre},
                        double{kLongestSide});
    };
    // Of blocks so far apart one less lies between.
    const int farthest = 1 + static_cast<int>(in_blocks(reaches.back()));
    const Program& planes = plane_program_.get(frame.shaders, plane_variant());
    planes.use();
    set_grid(planes);
    planes.set("farthest", farthest);
    row_distances_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    plane_squares_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    planes.dispatch_covering({blocks(), 1, 1});
    wait_for_stores();

    const Program& stamp = stamp_program_.get(frame.shaders, stamp_variant());
    stamp.use();
    set_grid(stamp);
    stamp.set("farthest", farthest);
    for (size_t i = 0; i < reaches.size(); ++i) {
        const double reach = in_blocks(reaches[i]);
        stamp.set(fmt::format("squares[{}]", i).c_str(), static_cast<int>(reach * reach));
    }
    stamp.set("frame", frame.frame);
    plane_squares_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    last_changes_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    moved_blocks_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    stamp.dispatch_covering({blocks(), 1, 1});
    wait_for_stores();
}

void ChangeVolume::set_grid(const Program& program) const {
    program.set("grid_origin", grid_.origin);
    program.set("blocks_per_metre", grid_.blocks_per_metre);
    program.set("grid_size", grid_.size);
}

void ChangeVolume::bind(const Program& program, GLuint slot) const {
    set_grid(program);
    last_changes_.bind(GL_SHADER_STORAGE_BUFFER, slot);
}

size_t ChangeVolume::bytes() const {
    size_t all = 0;
    for (const Buffer* buffer :
         {&followed_, &moved_blocks_, &row_distances_, &plane_squares_, &last_changes_})
        all += buffer->bytes();
    return all;
}

bool ChangeVolume::takes(const GpuScene& scene) {
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    return std::max(scene.positions().bytes(), scene.indices().bytes()) <=
           static_cast<size_t>(limit);
}

size_t ChangeVolume::bytes_needed(size_t vertices) {
    // Rows of bits take up to a word for each block.
    return vertices * sizeof(glm::vec3) + (3 + gpu::kReaches) * kMostBlocks * sizeof(uint32_t);
}

std::vector<ShaderVariant> ChangeVolume::variants() {
    return {mark_variant(), follow_variant(), row_variant(), plane_variant(), stamp_variant()};
}

} // namespace romascope
