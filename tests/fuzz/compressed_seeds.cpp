// SPDX-License-Identifier: MIT
// EXT_meshopt_compression in all modes and filters, KHR_draco_mesh_compression in both methods.
#include "tests/fuzz/seed.h"
#include "tests/fuzz/seeds.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <stdexcept>

namespace romascope::fuzz {
namespace {

constexpr int kSide = 4; // vertices along an edge of the grid

/// A grid of vertices over the unit square, a little curved.
std::vector<float> grid_positions() {
    std::vector<float> values;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float u = static_cast<float>(x) / (kSide - 1);
            const float v = static_cast<float>(y) / (kSide - 1);
            values.insert(values.end(), {u, v, 0.25f * u * v});
        }
    return values;
}

std::vector<uint32_t> grid_indices() {
    std::vector<uint32_t> indices;
    for (uint32_t y = 0; y + 1 < kSide; ++y)
        for (uint32_t x = 0; x + 1 < kSide; ++x) {
            const uint32_t a = y * kSide + x;
            indices.insert(indices.end(), {a, a + 1, a + kSide, a + kSide, a + 1, a + kSide + 1});
        }
    return indices;
}

constexpr size_t kVertices = kSide * kSide;

/// A view whose content is compressed: its own bytes are not there.
int packed_view(Seed& seed, const std::string& content, size_t count, size_t stride,
                const char* mode, const char* filter) {
    if (seed.root["buffers"].size() == 1)
        seed.root["buffers"].push_back(
            {{"byteLength", 4096},
             {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    const int packed = seed.view(content);
    json& view = seed.root["bufferViews"][static_cast<size_t>(packed)];
    json extension = {{"buffer", 0},     {"byteOffset", view["byteOffset"]},
                      {"mode", mode},    {"byteLength", content.size()},
                      {"count", count},  {"byteStride", stride},
                      {"filter", filter}};
    view = {{"buffer", 1},
            {"byteLength", count * stride},
            {"extensions", {{"EXT_meshopt_compression", extension}}}};
    if (std::string_view(mode) == "ATTRIBUTES")
        view["byteStride"] = stride;
    return packed;
}

std::string encode_vertices(const void* data, size_t count, size_t stride) {
    std::string out(meshopt_encodeVertexBufferBound(count, stride), '\0');
    out.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(out.data()), out.size(),
                                          data, count, stride));
    return out;
}

void write_meshopt(const std::filesystem::path& folder) {
    Seed seed;
    seed.use("EXT_meshopt_compression");
    seed.use("KHR_mesh_quantization");
    const auto positions = grid_positions();
    const auto indices = grid_indices();
    seed.attribute("POSITION",
                   seed.accessor(packed_view(seed, encode_vertices(positions.data(), kVertices, 12),
                                             kVertices, 12, "ATTRIBUTES", "NONE"),
                                 kF32, "VEC3", kVertices));
    std::string triangles(meshopt_encodeIndexBufferBound(indices.size(), kVertices), '\0');
    triangles.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(triangles.data()),
                                               triangles.size(), indices.data(), indices.size()));
    Seed plain = seed;
    plain.primitive()["indices"] =
        plain.accessor(packed_view(plain, triangles, indices.size(), 2, "TRIANGLES", "NONE"), kU16,
                       "SCALAR", indices.size());
    plain.write(folder, "meshopt_triangles", true);

    std::vector<float> up;
    for (size_t i = 0; i < kVertices; ++i)
        up.insert(up.end(), {0.0f, 0.6f, 0.8f, 0.0f});
    std::vector<int8_t> octahedral(4 * kVertices);
    meshopt_encodeFilterOct(octahedral.data(), kVertices, 4, 8, up.data());
    Seed normals = plain;
    normals.attribute(
        "NORMAL",
        normals.accessor(packed_view(normals, encode_vertices(octahedral.data(), kVertices, 4),
                                     kVertices, 4, "ATTRIBUTES", "OCTAHEDRAL"),
                         kS8, "VEC3", kVertices, true));
    normals.write(folder, "meshopt_octahedral", true);

    std::vector<uint32_t> exponential(3 * kVertices);
    meshopt_encodeFilterExp(exponential.data(), kVertices, 12, 15, positions.data());
    Seed scaled = plain;
    scaled.attribute(
        "POSITION",
        scaled.accessor(packed_view(scaled, encode_vertices(exponential.data(), kVertices, 12),
                                    kVertices, 12, "ATTRIBUTES", "EXPONENTIAL"),
                        kF32, "VEC3", kVertices));
    std::string sequence(meshopt_encodeIndexSequenceBound(indices.size(), kVertices), '\0');
    sequence.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(sequence.data()),
                                                sequence.size(), indices.data(), indices.size()));
    scaled.primitive()["indices"] =
        scaled.accessor(packed_view(scaled, sequence, indices.size(), 4, "INDICES", "NONE"), kU32,
                        "SCALAR", indices.size());
    scaled.write(folder, "meshopt_exponential", true);

    const std::vector<float> turns = {0, 0, 0, 1, 0, 0.6f, 0, 0.8f};
    std::vector<int16_t> quaternions(8);
    meshopt_encodeFilterQuat(quaternions.data(), 2, 8, 16, turns.data());
    Seed turning = plain;
    turning.animate("rotation", "LINEAR", {0, 1}, turns, "VEC4", 4);
    turning.root["animations"][0]["samplers"][0]["output"] =
        turning.accessor(packed_view(turning, encode_vertices(quaternions.data(), 2, 8), 2, 8,
                                     "ATTRIBUTES", "QUATERNION"),
                         kS16, "VEC4", 2, true);
    turning.root["bufferViews"].back().erase("byteStride"); // not for views of animations
    turning.write(folder, "meshopt_quaternions", true);
}

std::string encode_draco(int method) {
    const auto positions = grid_positions();
    const auto indices = grid_indices();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(static_cast<int>(indices.size() / 3));
    const int position =
        builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const int texcoord =
        builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    for (size_t t = 0; t < indices.size() / 3; ++t) {
        const float* p[3];
        for (size_t i = 0; i < 3; ++i)
            p[i] = &positions[3 * indices[3 * t + i]];
        const draco::FaceIndex face(static_cast<uint32_t>(t));
        builder.SetAttributeValuesForFace(position, face, p[0], p[1], p[2]);
        builder.SetAttributeValuesForFace(texcoord, face, p[0], p[1], p[2]);
    }
    const auto mesh = builder.Finalize();
    if (!mesh)
        throw std::runtime_error("draco makes no mesh");
    draco::ExpertEncoder encoder(*mesh);
    encoder.SetAttributeQuantization(position, 11);
    encoder.SetAttributeQuantization(texcoord, 10);
    encoder.SetEncodingMethod(method);
    draco::EncoderBuffer out;
    if (const draco::Status status = encoder.EncodeToBuffer(&out); !status.ok())
        throw std::runtime_error(status.error_msg());
    return {out.data(), out.size()};
}

void write_draco(const std::filesystem::path& folder, const char* name, int method) {
    Seed seed;
    seed.use("KHR_draco_mesh_compression");
    seed.attribute("POSITION", seed.accessor(-1, kF32, "VEC3", kVertices));
    seed.attribute("TEXCOORD_0", seed.accessor(-1, kF32, "VEC2", kVertices));
    seed.primitive()["indices"] = seed.accessor(-1, kU16, "SCALAR", grid_indices().size());
    seed.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", seed.view(encode_draco(method))},
        {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}};
    seed.write(folder, name, true);
}

} // namespace

void write_compressed_seeds(const std::filesystem::path& folder) {
    write_meshopt(folder);
    write_draco(folder, "draco_sequential", draco::MESH_SEQUENTIAL_ENCODING);
    write_draco(folder, "draco_edgebreaker", draco::MESH_EDGEBREAKER_ENCODING);
}

} // namespace romascope::fuzz
