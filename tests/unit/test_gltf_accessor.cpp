// SPDX-License-Identifier: MIT
#include "tests/support/gltf_builder.h"
#include "tests/support/opened_gltf.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace romascope::gltf {
namespace {

using nlohmann::json;

std::string refusal(const GltfBuilder& file) { return refusal_of(file.glb()); }

template <class T>
void expect_numbers(const std::vector<T>& values, bool normalized,
                    const std::vector<float>& expected) {
    GltfBuilder file;
    const size_t accessor = file.add_accessor(values, "SCALAR", normalized);
    const OpenedGltf opened(file.glb());
    const AccessorReader reader = opened.reader(accessor);
    ASSERT_EQ(reader.count(), expected.size());
    EXPECT_EQ(reader.components(), 1);
    for (size_t i = 0; i < expected.size(); ++i)
        EXPECT_FLOAT_EQ(reader.number(i), expected[i]) << i;
}

TEST(GltfAccessor, integers_keep_their_value_or_are_normalised) {
    expect_numbers<int8_t>({-128, -127, 0, 64, 127}, false, {-128, -127, 0, 64, 127});
    expect_numbers<int8_t>({-128, -127, 0, 64, 127}, true, {-1, -1, 0, 64.0f / 127, 1});
    expect_numbers<uint8_t>({0, 51, 255}, false, {0, 51, 255});
    expect_numbers<uint8_t>({0, 51, 255}, true, {0, 0.2f, 1});
    expect_numbers<int16_t>({-32768, -32767, 0, 32767}, false, {-32768, -32767, 0, 32767});
    expect_numbers<int16_t>({-32768, -32767, 0, 32767}, true, {-1, -1, 0, 1});
    expect_numbers<uint16_t>({0, 13107, 65535}, false, {0, 13107, 65535});
    expect_numbers<uint16_t>({0, 13107, 65535}, true, {0, 0.2f, 1});
    expect_numbers<uint32_t>({0, 16777216, UINT32_MAX}, false, {0, 16777216, 4294967296.0f});
    expect_numbers<uint32_t>({0, 858993459, UINT32_MAX}, true, {0, 0.2f, 1});
    expect_numbers<float>({-1.5f, 0.0f, 3e38f, 1e-40f}, false, {-1.5f, 0.0f, 3e38f, 1e-40f});
    expect_numbers<float>({-1.5f, 7.0f}, true, {-1.5f, 7.0f}); // has no meaning for floats
}

TEST(GltfAccessor, vectors_interleaved_and_not_aligned) {
    // Elements of 20 bytes: three floats, two u16, four u8; all from byte 1 of the view.
    constexpr size_t kCount = 5;
    std::string data(1, '?');
    for (size_t i = 0; i < kCount; ++i) {
        const auto f = static_cast<float>(i);
        data += bytes_of(std::vector<float>{f, f + 0.25f, f + 0.5f});
        data += bytes_of(std::vector<uint16_t>{static_cast<uint16_t>(1000 * i), 7});
        data += bytes_of(std::vector<uint8_t>{1, 2, 3, static_cast<uint8_t>(i)});
    }
    GltfBuilder file;
    const size_t view = file.add_view(data);
    file.root["bufferViews"][view]["byteStride"] = 20;
    const auto add = [&](const char* type, int component, size_t offset) {
        return file.add("accessors", {{"bufferView", view},
                                      {"byteOffset", offset},
                                      {"componentType", component},
                                      {"count", kCount},
                                      {"type", type}});
    };
    const size_t triples = add("VEC3", 5126, 1), pairs = add("VEC2", 5123, 13),
                 fours = add("VEC4", 5121, 17);
    const OpenedGltf opened(file.glb());
    for (size_t i = 0; i < kCount; ++i) {
        const auto f = static_cast<float>(i);
        EXPECT_EQ(opened.reader(triples).vec3(i), glm::vec3(f, f + 0.25f, f + 0.5f));
        EXPECT_EQ(opened.reader(pairs).vec2(i), glm::vec2(1000.0f * f, 7.0f));
        EXPECT_EQ(opened.reader(fours).vec4(i), glm::vec4(1.0f, 2.0f, 3.0f, f));
        EXPECT_EQ(opened.reader(pairs).integer(i, 0), 1000 * i);
        EXPECT_EQ(opened.reader(fours).integer(i, 3), i);
    }
    EXPECT_EQ(opened.reader(triples).components(), 3);
    // One byte more and the last element leaves the view.
    file.root["accessors"][fours]["byteOffset"] = 18;
    EXPECT_CONTAINS(refusal(file), "accessors[2]: 5 elements from byte 18 reach beyond");
}

TEST(GltfAccessor, matrices_are_stored_by_columns_that_start_at_multiples_of_four) {
    GltfBuilder file;
    const auto add = [&](const char* type, int component, const std::string& data) {
        return file.add("accessors", {{"bufferView", file.add_view(data)},
                                      {"componentType", component},
                                      {"count", 2},
                                      {"type", type}});
    };
    std::vector<float> numbers(32);
    for (size_t i = 0; i < 32; ++i)
        numbers[i] = static_cast<float>(i);
    const size_t four = add("MAT4", 5126, bytes_of(numbers));
    // The last column of the last matrix may lack its padding.
    const size_t two = add("MAT2", 5121, std::string("\1\2..\3\4..\5\6..\7\10", 14));
    const size_t three = add(
        "MAT3", 5123, bytes_of(std::vector<uint16_t>{1,  2,  3,  99, 4,  5,  6,  99, 7,  8,  9, 99,
                                                     11, 12, 13, 99, 14, 15, 16, 99, 17, 18, 19}));
    const OpenedGltf opened(file.glb());
    for (int c = 0; c < 16; ++c) {
        EXPECT_EQ(opened.reader(four).mat4(1)[c / 4][c % 4], static_cast<float>(16 + c));
        EXPECT_EQ(opened.reader(four).number(0, c), static_cast<float>(c));
    }
    for (int c = 0; c < 4; ++c)
        EXPECT_EQ(opened.reader(two).number(1, c), static_cast<float>(5 + c));
    for (int c = 0; c < 9; ++c)
        EXPECT_EQ(opened.reader(three).number(1, c), static_cast<float>(11 + c));
    EXPECT_EQ(opened.reader(three).components(), 9);
}

TEST(GltfAccessor, without_a_view_all_is_zero) {
    GltfBuilder file;
    // So many that nothing may be allocated for them.
    file.add("accessors", {{"componentType", 5126}, {"count", 4294967294}, {"type", "VEC4"}});
    file.add("accessors", {{"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}});
    const OpenedGltf opened(file.glb(), 100000);
    EXPECT_EQ(opened.reader(0).vec4(4294967293), glm::vec4(0.0f));
    EXPECT_EQ(opened.reader(1).integer(2), 0u);
}

TEST(GltfAccessor, numbers_that_are_not_finite_are_refused_with_their_place) {
    for (const float bad : {std::numeric_limits<float>::infinity(), -INFINITY, std::nanf("")}) {
        GltfBuilder file;
        const size_t accessor = file.add_accessor<float>({0, 1, 2, 3, bad, 5}, "VEC3");
        const OpenedGltf opened(file.glb());
        const AccessorReader reader = opened.reader(accessor);
        EXPECT_EQ(reader.vec3(0), glm::vec3(0.0f, 1.0f, 2.0f));
        EXPECT_EQ(reader.number(1, 2), 5.0f);
        EXPECT_CONTAINS(error_of([&] { reader.vec3(1); }), "user: element 1 is not finite");
        EXPECT_CONTAINS(error_of([&] { reader.number(1, 1); }), "element 1 is not finite");
    }
}

TEST(GltfAccessor, of_another_kind_are_refused) {
    GltfBuilder file;
    const size_t accessor = file.add_accessor<uint16_t>({0, 1, 2, 3}, "VEC2");
    const OpenedGltf opened(file.glb());
    const auto read = [&](int index, int type, std::vector<int> components) {
        return error_of([&] {
            AccessorReader(opened.document, index, {type, std::move(components)}, "nodes[3].thing");
        });
    };
    const auto at = static_cast<int>(accessor);
    EXPECT_CONTAINS(read(at, TINYGLTF_TYPE_VEC3, {5123}),
                    "nodes[3].thing: accessors[0]: is VEC2, but VEC3 is needed");
    EXPECT_CONTAINS(read(at, TINYGLTF_TYPE_VEC2, {5126, 5121}),
                    "nodes[3].thing: accessors[0]: component type 5123");
    EXPECT_EQ(read(at, TINYGLTF_TYPE_VEC2, {5126, 5123}), "");
    EXPECT_CONTAINS(read(-1, TINYGLTF_TYPE_VEC2, {5123}), "nodes[3].thing: has no accessor");
    EXPECT_CONTAINS(read(1, TINYGLTF_TYPE_VEC2, {5123}), "nodes[3].thing: has no accessor");
}

TEST(GltfAccessor, indices_stay_below_the_number_of_vertices) {
    GltfBuilder file;
    const size_t bytes = file.add_accessor<uint8_t>({0, 5, 255}, "SCALAR");
    const size_t words = file.add_accessor<uint32_t>({7, UINT32_MAX, 0}, "SCALAR");
    const size_t floats = file.add_accessor<float>({0, 1, 2}, "SCALAR");
    const OpenedGltf opened(file.glb());
    const auto read = [&](size_t accessor, size_t count) {
        return read_indices(opened.document, static_cast<int>(accessor), count, "here");
    };
    EXPECT_EQ(read(bytes, 256), (std::vector<uint32_t>{0, 5, 255}));
    EXPECT_CONTAINS(error_of([&] { read(bytes, 255); }), "here: index 2 names vertex 255");
    EXPECT_CONTAINS(error_of([&] { read(words, 100); }), "here: index 1 names vertex 4294967295");
    EXPECT_CONTAINS(error_of([&] { read(floats, 100); }),
                    "here: accessors[2]: component type 5126");
}

/// Spans are let in exactly where they fit, computed here without any limit of width.
TEST(GltfAccessor, random_spans) {
    std::mt19937_64 random(5);
    const int components[] = {5120, 5121, 5122, 5123, 5125, 5126};
    const std::pair<const char*, size_t> types[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    int fitting = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        GltfBuilder file;
        const std::string data(random() % 400, '\0');
        const size_t view = file.add_view(data + "x"); // no empty buffer
        const auto [type, numbers] = types[random() % 5];
        const int component = components[random() % 6];
        const size_t width = component >= 5125 ? 4 : component >= 5122 ? 2 : 1;
        const size_t size = width * numbers;
        size_t stride = std::max<size_t>(4, size + 3) / 4 * 4;
        if (random() % 2)
            file.root["bufferViews"][view]["byteStride"] = stride = stride + 4 * (random() % 3);
        else
            stride = size;
        const auto anything = [&](uint64_t usual) {
            return random() % 8 ? random() % usual : (random() >> 11) >> random() % 53;
        };
        const uint64_t offset = anything(200), count = 1 + anything(40) % 4294967293u;
        file.add("accessors", {{"bufferView", view},
                               {"byteOffset", offset},
                               {"componentType", component},
                               {"count", count},
                               {"type", type}});
        __extension__ using Wide = unsigned __int128;
        const bool fits = Wide{offset} + Wide{count - 1} * stride + size <= data.size() + 1;
        const std::string text = refusal(file);
        EXPECT_EQ(text.empty(), fits) << text << file.root.dump();
        fitting += fits;
        if (fits) { // the sanitizers watch
            const OpenedGltf opened(file.glb());
            opened.reader(0).number(count - 1, static_cast<int>(numbers) - 1);
        }
    }
    EXPECT_GT(fitting, 500);
    EXPECT_LT(fitting, 2500);
}

// --- sparse ----------------------------------------------------------------------------------

/// An accessor of `count` VEC2 of floats, some of them replaced.
size_t add_sparse(GltfBuilder& file, size_t count, const std::vector<float>& base,
                  const std::vector<uint32_t>& indices, int index_type,
                  const std::vector<float>& values) {
    std::string packed;
    for (const uint32_t index : indices)
        packed.append(reinterpret_cast<const char*>(&index), index_type == 5121   ? 1
                                                             : index_type == 5123 ? 2
                                                                                  : 4);
    json accessor = {{"componentType", 5126}, {"count", count}, {"type", "VEC2"}};
    if (!base.empty())
        accessor["bufferView"] = file.add_view(bytes_of(base));
    accessor["sparse"] = {
        {"count", indices.size()},
        {"indices", {{"bufferView", file.add_view(packed)}, {"componentType", index_type}}},
        {"values", {{"bufferView", file.add_view(bytes_of(values))}}}};
    return file.add("accessors", std::move(accessor));
}

TEST(GltfSparse, elements_are_in_their_place) {
    std::mt19937 random(3);
    for (const int index_type : {5121, 5123, 5125})
        for (const bool with_base : {true, false}) {
            const size_t count = index_type == 5121 ? 256 : 700;
            std::vector<float> expected(2 * count, 0.0f), base;
            if (with_base) {
                for (float& each : expected)
                    each = static_cast<float>(random() % 1000);
                base = expected;
            }
            std::vector<uint32_t> indices;
            std::vector<float> values;
            for (uint32_t i = 0; i < count; ++i)
                if (random() % 3 == 0 || i == 0 || i + 1 == count) {
                    indices.push_back(i);
                    for (size_t c = 0; c < 2; ++c)
                        values.push_back(expected[2 * i + c] =
                                             -static_cast<float>(random() % 1000));
                }
            GltfBuilder file;
            const size_t accessor = add_sparse(file, count, base, indices, index_type, values);
            const OpenedGltf opened(file.glb());
            EXPECT_FALSE(opened.document.model().accessors[accessor].sparse.isSparse);
            const AccessorReader reader = opened.reader(accessor);
            for (size_t i = 0; i < count; ++i)
                ASSERT_EQ(reader.vec2(i), glm::vec2(expected[2 * i], expected[2 * i + 1])) << i;
        }
}

TEST(GltfSparse, over_interleaved_data) {
    GltfBuilder file;
    const size_t accessor =
        add_sparse(file, 3, {0, 1, -1, 2, 3, -1, 4, 5, -1}, {1}, 5121, {20, 30});
    file.root["bufferViews"][0]["byteStride"] = 12;
    const OpenedGltf opened(file.glb());
    const AccessorReader reader = opened.reader(accessor);
    EXPECT_EQ(reader.vec2(0), glm::vec2(0, 1));
    EXPECT_EQ(reader.vec2(1), glm::vec2(20, 30));
    EXPECT_EQ(reader.vec2(2), glm::vec2(4, 5));
}

TEST(GltfSparse, faults_are_refused) {
    const auto with = [](const std::vector<uint32_t>& indices,
                         const std::function<void(json&, json&)>& change = {}) {
        GltfBuilder file;
        add_sparse(file, 4, {}, indices, 5123, std::vector<float>(2 * indices.size()));
        if (change)
            change(file.root["accessors"][0]["sparse"], file.root["bufferViews"]);
        return refusal(file);
    };
    EXPECT_EQ(with({0, 1, 3}), "");
    EXPECT_CONTAINS(with({0, 4}), "accessors[0].sparse.indices: number 1 names element 4");
    EXPECT_CONTAINS(with({0, 65535}), "accessors[0].sparse.indices: number 1 names element 65535");
    EXPECT_CONTAINS(with({1, 1}), "accessors[0].sparse.indices: number 1 does not increase");
    EXPECT_CONTAINS(with({2, 1}), "accessors[0].sparse.indices: number 1 does not increase");
    EXPECT_CONTAINS(with({0, 1, 2, 3, 3}), "accessors[0].sparse.count: 5, more than the 4");
    EXPECT_CONTAINS(with({0, 1}, [](json& sparse, json&) { sparse["count"] = 3; }),
                    "accessors[0].sparse.indices: 3 elements from byte 0 reach beyond");
    EXPECT_CONTAINS(with({0, 1}, [](json& sparse, json&) { sparse["values"]["byteOffset"] = 4; }),
                    "accessors[0].sparse.values: 2 elements from byte 4 reach beyond");
    EXPECT_CONTAINS(
        with({0, 1}, [](json& sparse, json&) { sparse["indices"]["byteOffset"] = 4294967295; }),
        "accessors[0].sparse.indices.byteOffset: 4294967295 is not from 0");
    EXPECT_CONTAINS(with({0, 1}, [](json& sparse, json&) { sparse["indices"]["bufferView"] = 2; }),
                    "accessors[0].sparse.indices.bufferView: 2 does not exist");
    EXPECT_CONTAINS(with({0, 1}, [](json& sparse, json&) { sparse.erase("values"); }),
                    "accessors[0].sparse.values: is missing");
    EXPECT_CONTAINS(
        with({0, 1}, [](json& sparse, json&) { sparse["indices"]["componentType"] = 5126; }),
        "accessors[0].sparse.indices.componentType: 5126 is not one of");
    EXPECT_CONTAINS(with({0, 1}, [](json&, json& views) { views[1]["byteStride"] = 8; }),
                    "accessors[0].sparse.values: bufferViews[1] must not have a byteStride");
}

TEST(GltfSparse, memory_is_counted_before) {
    GltfBuilder file;
    add_sparse(file, 4294967294, {}, {4294967293}, 5125, {1, 2});
    EXPECT_CONTAINS(refusal(file), "accessors[0]: needs");
}

} // namespace
} // namespace romascope::gltf
