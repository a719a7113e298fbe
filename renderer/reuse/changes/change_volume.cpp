// SPDX-License-Identifier: MIT
#include "renderer/reuse/changes/change_volume.h"

#include "shaders/tracers/occupancy/work_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace romascope {
namespace {

/// Boxes, kMarks to a block: how far what moved lies is known to about one of them.
constexpr float kBoxesPerReach = 32.0f;
constexpr int kMostBoxes = 1 << 22;
/// How marked triangles are rounded asks for no more (triangle_cells.h).
constexpr int kLongestSide = 256 / gpu::kMarks;

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
ShaderVariant block_variant() {
    return variant_of("block distance", "reuse/changes/block_distance.comp.glsl");
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
    return glm::ivec3(glm::floor(extent / block)) + 2;
}

/// Of the buffers.
struct Words {
    size_t blocks, moved_boxes, row_distances, row_minima, plane_squares, changes;
};
Words words_of(glm::ivec3 size) {
    const auto x = static_cast<size_t>(size.x), y = static_cast<size_t>(size.y),
               z = static_cast<size_t>(size.z);
    const size_t rows = gpu::kMarks * y * gpu::kMarks * z, blocks = x * y * z;
    return {blocks,
            2 + rows * static_cast<size_t>(gpu::row_words(size)),
            x * rows,
            gpu::kMarks * blocks,
            gpu::kMarks * blocks,
            (1 + gpu::kReaches) * blocks + 1};
}

} // namespace

gpu::ChangeGrid change_grid(const Bounds& bounds, float reach) {
    const glm::vec3 extent = bounds.extent();
    const float longest = std::max({extent.x, extent.y, extent.z});
    float block = std::max(gpu::kMarks * reach / kBoxesPerReach,
                           longest / static_cast<float>(kLongestSide - 2));
    const auto boxes = [&] {
        const glm::dvec3 size(gpu::kMarks * grid_size(extent, block));
        return size.x * size.y * size.z;
    };
    while (boxes() > kMostBoxes)
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
    const Words words = words_of(grid.size);
    Buffer followed("followed vertices", scene.positions().bytes() - skipped);
    Buffer moved_boxes("moved boxes", words.moved_boxes * sizeof(uint32_t));
    Buffer row_distances("row distances", words.row_distances * sizeof(int32_t));
    Buffer row_minima("row minima", words.row_minima * sizeof(int32_t));
    Buffer plane_squares("plane squares", words.plane_squares * sizeof(int32_t));
    Buffer changes("changes", words.changes * sizeof(uint32_t));
    clear(changes, frame.frame);
    constexpr uint32_t kNear = 0;
    glClearNamedBufferSubData(changes.id(), GL_R32UI, 0,
                              static_cast<GLsizeiptr>(words.blocks * sizeof(uint32_t)),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, &kNear);
    glCopyNamedBufferSubData(scene.positions().id(), followed.id(), static_cast<GLintptr>(skipped),
                             0, static_cast<GLsizeiptr>(followed.bytes()));
    grid_ = grid;
    last_change_ = frame.frame;
    bounds_ = bounds;
    first_vertex_ = first_vertex;
    followed_ = std::move(followed);
    moved_boxes_ = std::move(moved_boxes);
    row_distances_ = std::move(row_distances);
    row_minima_ = std::move(row_minima);
    plane_squares_ = std::move(plane_squares);
    changes_ = std::move(changes);
}

void ChangeVolume::release() {
    bounds_ = {};
    for (const auto buffer : kBuffers)
        this->*buffer = {};
}

bool ChangeVolume::covers(const Bounds& bounds) const {
    return glm::all(glm::greaterThanEqual(bounds.min, bounds_.min)) &&
           glm::all(glm::lessThanEqual(bounds.max, bounds_.max));
}

void ChangeVolume::update(const FrameContext& frame, const Reaches& reaches, float tolerance) {
    auto pass = frame.timer.compute("changes");
    mark(frame, tolerance);
    follow(frame, tolerance);
    measure(frame, reaches);
    last_change_ = frame.frame;
}

void ChangeVolume::mark(const FrameContext& frame, float tolerance) {
    const Program& program = mark_program_.get(frame.shaders, mark_variant());
    const size_t triangles = frame.scene.indices().bytes() / (3 * sizeof(uint32_t));
    clear(moved_boxes_, 0);
    program.use();
    set_grid(program);
    program.set("first_vertex", first_vertex_);
    program.set("triangle_count", static_cast<GLuint>(triangles));
    program.set("tolerance", tolerance);
    frame.scene.positions().bind(GL_SHADER_STORAGE_BUFFER, 0);
    followed_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    frame.scene.indices().bind(GL_SHADER_STORAGE_BUFFER, 2);
    moved_boxes_.bind(GL_SHADER_STORAGE_BUFFER, 3);
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

void ChangeVolume::measure(const FrameContext& frame, const Reaches& reaches) {
    const Words words = words_of(grid_.size);
    const Program& rows = row_program_.get(frame.shaders, row_variant());
    rows.use();
    set_grid(rows);
    moved_boxes_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    row_distances_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    row_minima_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    rows.dispatch_covering({static_cast<int>(words.row_minima), 1, 1});
    wait_for_stores();

    const auto in_boxes = [&](float metres) {
        return std::min(static_cast<double>(metres) * double{grid_.blocks_per_metre},
                        2.0 * kLongestSide) * // more than a diagonal
               gpu::kMarks;
    };
    // As far as the blocks lie around one that is within reach.
    const int farthest = static_cast<int>(in_boxes(reaches.back())) + 3 * gpu::kMarks;
    const Program& planes = plane_program_.get(frame.shaders, plane_variant());
    planes.use();
    set_grid(planes);
    planes.set("farthest", farthest);
    row_distances_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    row_minima_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    plane_squares_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    planes.dispatch_covering({static_cast<int>(words.plane_squares), 1, 1});
    wait_for_stores();

    const Program& blocks = block_program_.get(frame.shaders, block_variant());
    blocks.use();
    set_grid(blocks);
    blocks.set("farthest", farthest);
    for (size_t i = 0; i < reaches.size(); ++i) {
        const double reach = in_boxes(reaches[i]) + 0.5 * std::sqrt(3.0) * gpu::kMarks;
        blocks.set(fmt::format("block_squares[{}]", i).c_str(), static_cast<int>(reach * reach));
    }
    blocks.set("frame_before", last_change_);
    blocks.set("frame", frame.frame);
    plane_squares_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    changes_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    moved_boxes_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    blocks.dispatch_covering({static_cast<int>(words.blocks), 1, 1});
    wait_for_stores();
}

void ChangeVolume::set_grid(const Program& program) const {
    program.set("grid_origin", grid_.origin);
    program.set("blocks_per_metre", grid_.blocks_per_metre);
    program.set("grid_size", grid_.size);
}

void ChangeVolume::bind(const Program& program) const {
    set_grid(program);
    program.set("last_change", last_change_);
    changes_.bind(GL_SHADER_STORAGE_BUFFER, 4);
}

size_t ChangeVolume::bytes() const {
    size_t all = 0;
    for (const auto buffer : kBuffers)
        all += (this->*buffer).bytes();
    return all;
}

bool ChangeVolume::takes(const GpuScene& scene) {
    GLint64 limit = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &limit);
    return std::max(scene.positions().bytes(), scene.indices().bytes()) <=
           static_cast<size_t>(limit);
}

size_t ChangeVolume::bytes_needed(size_t vertices) {
    // Rows of bits take up to a word for each block along x.
    constexpr size_t kRows = kMostBoxes / gpu::kMarks, kPlanes = kRows / gpu::kMarks,
                     kBlocks = kPlanes / gpu::kMarks;
    return vertices * sizeof(glm::vec3) +
           (3 + 2 * kRows + 2 * kPlanes + (1 + gpu::kReaches) * kBlocks) * sizeof(uint32_t);
}

std::vector<ShaderVariant> ChangeVolume::variants() {
    return {mark_variant(), follow_variant(), row_variant(), plane_variant(), block_variant()};
}

} // namespace romascope
