// SPDX-License-Identifier: MIT
#include "renderer/reuse/spatial_hash/hash_table.h"

#include "shaders/reuse/spatial_hash/search.h"

namespace romascope {

HashTable::HashTable(uint32_t capacity)
    : capacity_(capacity), checksums_("hash checksums", capacity * sizeof(uint32_t)),
      sums_("hash sums", capacity * sizeof(glm::uvec2)) {}

void HashTable::clear() {
    for (const Buffer* buffer : {&checksums_, &sums_})
        if (buffer->bytes() > 0)
            glClearNamedBufferData(buffer->id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
                                   nullptr);
}

void HashTable::bind(const Program& program, int search_count) const {
    checksums_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    sums_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    program.set("slot_mask", capacity_ - 1);
    program.set("search_count", search_count);
}

void HashTable::settle(const Program& program, uint32_t frame, uint32_t max_age) const {
    bind(program, 1);
    program.set("frame", frame);
    program.set("max_age", max_age);
    program.dispatch_covering({capacity_ / gpu::kSettledEach, 1, 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

std::vector<gpu::Cell> HashTable::download() const {
    const std::vector<uint32_t> checksums = checksums_.download<uint32_t>();
    const std::vector<glm::uvec2> sums = sums_.download<glm::uvec2>();
    std::vector<gpu::Cell> cells;
    cells.reserve(capacity_);
    for (size_t i = 0; i < capacity_; ++i)
        cells.push_back({checksums[i], sums[i].x, sums[i].y});
    return cells;
}

std::vector<ShaderDefine> HashTable::defines(HashProbing probing) {
    return {{"HASH_PROBING", std::to_string(static_cast<int>(probing))}};
}

ShaderVariant HashTable::settle_variant() {
    return {"hash settle",
            {{GL_COMPUTE_SHADER, "reuse/spatial_hash/settle.comp.glsl"}},
            defines(HashProbing::linear),
            {}};
}

} // namespace romascope
