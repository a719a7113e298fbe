// SPDX-License-Identifier: MIT
// What an import allocates, counted by this program's own operator new.
#include "renderer/scene/gltf/import.h"
#include "tests/support/gltf_builder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

namespace {

/// Bytes allocated and not yet freed, and the most there were since the last reset.
std::atomic<size_t> live{0}, most{0};

/// Room before each block for its size; keeps the alignment of malloc.
constexpr size_t kHeader = 16;

void* allocate(size_t size) {
    void* const block = std::malloc(size + kHeader);
    if (!block)
        throw std::bad_alloc();
    *static_cast<size_t*>(block) = size;
    const size_t now = live += size;
    for (size_t seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
    }
    return static_cast<char*>(block) + kHeader;
}

void release(void* pointer) {
    if (!pointer)
        return;
    void* const block = static_cast<char*>(pointer) - kHeader;
    live -= *static_cast<size_t*>(block);
    std::free(block);
}

} // namespace

void* operator new(size_t size) { return allocate(size); }
void* operator new[](size_t size) { return allocate(size); }
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete[](void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, size_t) noexcept { release(pointer); }
void operator delete[](void* pointer, size_t) noexcept { release(pointer); }

namespace romascope {
namespace {

/// A wavy sheet with the attributes that models usually bring, in `meshes` meshes.
std::string sheet(uint32_t side, int meshes) {
    GltfBuilder file;
    std::vector<float> positions, normals, tangents, texcoords;
    std::vector<uint32_t> indices;
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const auto u = static_cast<float>(x), v = static_cast<float>(y);
            positions.insert(positions.end(), {u, std::sin(u) + std::cos(v), v});
            normals.insert(normals.end(), {0, 1, 0});
            tangents.insert(tangents.end(), {1, 0, 0, 1});
            texcoords.insert(texcoords.end(), {u, v});
            const uint32_t i = y * side + x;
            if (x + 1 < side && y + 1 < side)
                indices.insert(indices.end(), {i, i + side, i + 1, i + 1, i + side, i + side + 1});
        }
    for (int mesh = 0; mesh < meshes; ++mesh) {
        const size_t index = file.add_accessor(indices, "SCALAR");
        const size_t added = file.add_mesh({{"POSITION", file.add_accessor(positions, "VEC3")},
                                            {"NORMAL", file.add_accessor(normals, "VEC3")},
                                            {"TANGENT", file.add_accessor(tangents, "VEC4")},
                                            {"TEXCOORD_0", file.add_accessor(texcoords, "VEC2")}});
        file.root["meshes"][added]["primitives"][0]["indices"] = index;
        file.add("materials", {{"doubleSided", mesh % 2 == 0}}); // so that triangles are sorted
        file.root["meshes"][added]["primitives"][0]["material"] = mesh;
        file.add("nodes", {{"mesh", added}});
    }
    return file.glb();
}

TEST(GltfMemory, import_takes_at_most_three_times_the_buffers) {
    for (const int meshes : {1, 4}) {
        std::string content = sheet(200, meshes);
        const size_t buffers = content.size();
        content.shrink_to_fit();
        const size_t before = live - buffers; // the file's bytes count
        most = live.load();
        const Scene scene = import_gltf(std::move(content), "sheet.glb", size_t{1} << 30);
        EXPECT_EQ(scene.triangle_count(), static_cast<size_t>(meshes) * 2 * 199 * 199);
        EXPECT_LE(static_cast<double>(most - before) / static_cast<double>(buffers), 3.0);
        EXPECT_GE(static_cast<double>(most - before) / static_cast<double>(buffers), 1.0);
    }
}

} // namespace
} // namespace romascope
