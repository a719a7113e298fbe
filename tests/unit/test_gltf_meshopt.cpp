// SPDX-License-Identifier: MIT
#include "tests/support/gltf_builder.h"
#include "tests/support/opened_gltf.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace romascope::gltf {
namespace {

using nlohmann::json;

/// A file with one view, compressed; buffer 1 is the fallback that is not there.
GltfBuilder meshopt_file(const std::string& compressed, const char* mode, size_t count,
                         size_t stride, const char* filter = nullptr) {
    GltfBuilder file;
    const size_t source = file.add_view(compressed);
    json extension = file.root["bufferViews"][source];
    extension["byteStride"] = stride;
    extension["count"] = count;
    extension["mode"] = mode;
    if (filter)
        extension["filter"] = filter;
    file.root["bufferViews"] =
        json::array({{{"buffer", 1},
                      {"byteLength", count * stride},
                      {"extensions", {{"EXT_meshopt_compression", std::move(extension)}}}}});
    file.root["buffers"] =
        json::array({{{"byteLength", count * stride},
                      {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}});
    file.root["extensionsRequired"] = {"EXT_meshopt_compression"};
    return file;
}

std::string view_of(const OpenedGltf& opened, int view) {
    const auto bytes = opened.document.view(view);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string encode_vertices(const std::string& data, size_t count, size_t stride) {
    std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                          data.data(), count, stride));
    return out;
}

TEST(Meshopt, attributes_come_back_bit_for_bit) {
    std::mt19937 random(1);
    for (const size_t stride : {4u, 8u, 12u, 16u, 32u, 252u})
        for (const size_t count : {1u, 16u, 300u, 1000u}) {
            std::string data(count * stride, '\0');
            for (size_t i = 0; i < data.size(); ++i)
                data[i] = static_cast<char>(i / stride * 3 + random() % 5);
            const OpenedGltf opened(
                meshopt_file(encode_vertices(data, count, stride), "ATTRIBUTES", count, stride)
                    .glb());
            EXPECT_EQ(view_of(opened, 0), data) << stride << " " << count;
            EXPECT_TRUE(opened.document.model().bufferViews[0].extensions.empty());
        }
}

TEST(Meshopt, triangles_and_index_sequences) {
    std::mt19937 random(2);
    std::vector<unsigned int> indices;
    for (unsigned int row = 0; row < 20; ++row)
        for (unsigned int i = 0; i < 20; ++i) {
            const unsigned int a = row * 21 + i;
            for (const unsigned int each : {a, a + 1, a + 21, a + 1, a + 22, a + 21})
                indices.push_back(each);
        }
    std::string triangles(meshopt_encodeIndexBufferBound(indices.size(), 21 * 21), '\0');
    triangles.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(triangles.data()),
                                               triangles.size(), indices.data(), indices.size()));
    // The encoder may turn a triangle, so corners are compared from the least on.
    const auto turned = [](std::vector<uint32_t> list) {
        for (size_t i = 0; i < list.size(); i += 3)
            std::rotate(list.begin() + static_cast<long>(i),
                        std::min_element(list.begin() + static_cast<long>(i),
                                         list.begin() + static_cast<long>(i + 3)),
                        list.begin() + static_cast<long>(i + 3));
        return list;
    };
    std::vector<unsigned int> sequence(1001);
    for (unsigned int& each : sequence)
        each = random() % 60000;
    std::string lines(meshopt_encodeIndexSequenceBound(sequence.size(), 60000), '\0');
    lines.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(lines.data()),
                                             lines.size(), sequence.data(), sequence.size()));
    for (const size_t width : {2u, 4u}) {
        const auto read = [&](GltfBuilder file, size_t count) {
            file.add("accessors", {{"bufferView", 0},
                                   {"componentType", width == 2 ? 5123 : 5125},
                                   {"count", count},
                                   {"type", "SCALAR"}});
            const OpenedGltf opened(file.glb());
            return read_indices(opened.document, 0, 60000, "user");
        };
        EXPECT_EQ(turned(read(meshopt_file(triangles, "TRIANGLES", indices.size(), width),
                              indices.size())),
                  turned(indices));
        EXPECT_EQ(read(meshopt_file(lines, "INDICES", sequence.size(), width), sequence.size()),
                  sequence);
    }
}

/// Unit vectors of four numbers.
std::vector<float> random_units(size_t count, int components) {
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    std::vector<float> units;
    for (size_t i = 0; i < count; ++i) {
        std::array<float, 4> each{};
        float square = 0.0f;
        for (int c = 0; c < components; ++c) {
            each[static_cast<size_t>(c)] = normal(random);
            square += each[static_cast<size_t>(c)] * each[static_cast<size_t>(c)];
        }
        for (const float number : each)
            units.push_back(number / std::sqrt(square));
    }
    return units;
}

TEST(Meshopt, octahedral_filter) {
    constexpr size_t kCount = 500;
    const std::vector<float> normals = random_units(kCount, 3);
    for (const size_t stride : {4u, 8u}) {
        const int bits = stride == 4 ? 8 : 16;
        std::string data(kCount * stride, '\0');
        meshopt_encodeFilterOct(data.data(), kCount, stride, bits, normals.data());
        GltfBuilder file = meshopt_file(encode_vertices(data, kCount, stride), "ATTRIBUTES", kCount,
                                        stride, "OCTAHEDRAL");
        file.root["bufferViews"][0]["byteStride"] = stride;
        file.add("accessors", {{"bufferView", 0},
                               {"componentType", bits == 8 ? 5120 : 5122},
                               {"normalized", true},
                               {"count", kCount},
                               {"type", "VEC3"}});
        const OpenedGltf opened(file.glb());
        const AccessorReader reader = opened.reader(0);
        for (size_t i = 0; i < kCount; ++i)
            // Half a step of the octahedron is magnified by at most sqrt(3); and the result's own.
            EXPECT_LT(glm::distance(reader.vec3(i), glm::vec3(normals[4 * i], normals[4 * i + 1],
                                                              normals[4 * i + 2])),
                      bits == 8 ? 0.025f : 1e-4f);
    }
}

TEST(Meshopt, quaternion_filter) {
    constexpr size_t kCount = 500;
    const std::vector<float> turns = random_units(kCount, 4);
    std::string data(kCount * 8, '\0');
    meshopt_encodeFilterQuat(data.data(), kCount, 8, 16, turns.data());
    GltfBuilder file =
        meshopt_file(encode_vertices(data, kCount, 8), "ATTRIBUTES", kCount, 8, "QUATERNION");
    file.add("accessors", {{"bufferView", 0},
                           {"componentType", 5122},
                           {"normalized", true},
                           {"count", kCount},
                           {"type", "VEC4"}});
    const OpenedGltf opened(file.glb());
    const AccessorReader reader = opened.reader(0);
    for (size_t i = 0; i < kCount; ++i) {
        const glm::vec4 turn(turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]);
        // A quaternion and its negative turn alike.
        EXPECT_GT(std::abs(glm::dot(reader.vec4(i), turn)), 1.0f - 1e-4f);
    }
}

TEST(Meshopt, exponential_filter) {
    constexpr size_t kCount = 300;
    std::mt19937 random(6);
    std::vector<float> numbers(3 * kCount);
    for (float& each : numbers)
        each = std::ldexp(static_cast<float>(random() % 20001) / 10000.0f - 1.0f,
                          static_cast<int>(random() % 20) - 10);
    std::string data(kCount * 12, '\0');
    meshopt_encodeFilterExp(data.data(), 3 * kCount, 4, 24, numbers.data());
    GltfBuilder file =
        meshopt_file(encode_vertices(data, kCount, 12), "ATTRIBUTES", kCount, 12, "EXPONENTIAL");
    file.add("accessors",
             {{"bufferView", 0}, {"componentType", 5126}, {"count", kCount}, {"type", "VEC3"}});
    const OpenedGltf opened(file.glb());
    const AccessorReader reader = opened.reader(0);
    for (size_t i = 0; i < numbers.size(); ++i)
        EXPECT_NEAR(reader.number(i / 3, static_cast<int>(i % 3)), numbers[i],
                    1e-6f * std::abs(numbers[i]));
}

TEST(Meshopt, an_uncompressed_view_of_a_fallback_without_data_is_refused) {
    GltfBuilder file =
        meshopt_file(encode_vertices(std::string(64, '1'), 16, 4), "ATTRIBUTES", 16, 4);
    file.add("bufferViews", {{"buffer", 1}, {"byteLength", 64}});
    EXPECT_EQ(refusal_of(file.glb()), "");
    file.add("accessors",
             {{"bufferView", 1}, {"componentType", 5126}, {"count", 16}, {"type", "SCALAR"}});
    EXPECT_CONTAINS(refusal_of(file.glb()),
                    "accessors[0].bufferView: reads buffers[1], which has no");
}

TEST(Meshopt, faults_are_refused) {
    const std::string data(16 * 12, 'x');
    const std::string good = encode_vertices(data, 16, 12);
    const std::string element = "bufferViews[0].extensions.EXT_meshopt_compression";
    const auto with = [&](const std::function<void(json&)>& change) {
        GltfBuilder file = meshopt_file(good, "ATTRIBUTES", 16, 12);
        change(file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]);
        return refusal_of(file.glb());
    };
    EXPECT_EQ(with([](json&) {}), "");
    EXPECT_CONTAINS(with([](json& e) { e["byteStride"] = 10; }),
                    element + ".byteStride: 10 does not");
    EXPECT_CONTAINS(with([](json& e) { e["byteStride"] = 260; }),
                    element + ".byteStride: 260 is not");
    EXPECT_CONTAINS(with([](json& e) { e["byteStride"] = 0; }), element + ".byteStride: 0 is not");
    EXPECT_CONTAINS(with([](json& e) { e["filter"] = "OCTAHEDRAL"; }), element + ".byteStride: 12");
    EXPECT_CONTAINS(with([](json& e) { e["filter"] = "QUATERNION"; }), element + ".byteStride: 12");
    EXPECT_CONTAINS(with([](json& e) { e["filter"] = "COLOR"; }), element + ".filter: 'COLOR'");
    EXPECT_CONTAINS(with([](json& e) { e["mode"] = "POINTS"; }), element + ".mode: 'POINTS'");
    EXPECT_CONTAINS(with([](json& e) { e["mode"] = "TRIANGLES"; }), element + ".byteStride: 12");
    EXPECT_CONTAINS(with([](json& e) { e["count"] = 17; }), element + ": 17 elements of 12 bytes");
    EXPECT_CONTAINS(with([](json& e) { e["count"] = 2147483647; }), element + ": 2147483647");
    EXPECT_CONTAINS(with([](json& e) { e["count"] = 4294967295; }), element + ".count: 4294967295");
    EXPECT_CONTAINS(with([](json& e) { e["buffer"] = 2; }), element + ".buffer: 2 does not exist");
    EXPECT_CONTAINS(with([](json& e) { e["buffer"] = 1; }), element + ".buffer: buffers[1] has no");
    EXPECT_CONTAINS(with([](json& e) { e["byteLength"] = 10000; }), "reach beyond buffers[0]");
    EXPECT_CONTAINS(with([](json& e) { e["byteOffset"] = 2147483647; }), "reach beyond buffers[0]");
    EXPECT_CONTAINS(with([](json& e) { e["byteLength"] = 3; }), element + ": its data is broken");
    EXPECT_CONTAINS(with([](json& e) { e.erase("mode"); }), element + ".mode: is missing");
    EXPECT_CONTAINS(refusal_of(meshopt_file(good, "TRIANGLES", 16, 2).glb()),
                    element + ".count: 16");
    EXPECT_CONTAINS(refusal_of(meshopt_file(good, "TRIANGLES", 18, 2).glb()), "its data is broken");
    EXPECT_CONTAINS(refusal_of(meshopt_file(good, "INDICES", 16, 4, "OCTAHEDRAL").glb()),
                    element + ".filter: OCTAHEDRAL does not go with mode INDICES");
    GltfBuilder other_stride = meshopt_file(good, "ATTRIBUTES", 16, 12);
    other_stride.root["bufferViews"][0]["byteStride"] = 16;
    EXPECT_CONTAINS(refusal_of(other_stride.glb()),
                    element + ".byteStride: 12, but the view's is 16");
}

TEST(Meshopt, memory_is_counted_before) {
    // As much as the fallback buffer, which is not there, says it has.
    GltfBuilder file = meshopt_file("x", "ATTRIBUTES", 2147483647, 256);
    EXPECT_CONTAINS(refusal_of(file.glb()),
                    "bufferViews[0].extensions.EXT_meshopt_compression: needs");
}

TEST(Meshopt, damaged_data_is_refused_or_harmless) {
    std::mt19937 random(8);
    const std::string good = encode_vertices(std::string(300 * 16, 'x'), 300, 16);
    for (int trial = 0; trial < 1000; ++trial) {
        std::string damaged = good;
        for (int change = 0; change < 3; ++change)
            damaged[random() % damaged.size()] = static_cast<char>(random());
        damaged.resize(1 + random() % damaged.size());
        for (const char* mode : {"ATTRIBUTES", "TRIANGLES", "INDICES"})
            refusal_of(meshopt_file(damaged, mode, 300, *mode == 'A' ? 16 : 4).glb());
    }
}

} // namespace
} // namespace romascope::gltf
