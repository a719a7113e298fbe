// SPDX-License-Identifier: MIT
// Containers, indices, kinds of primitives, accessors, hierarchies.
#include "tests/fuzz/seed.h"
#include "tests/fuzz/seeds.h"

namespace romascope::fuzz {
namespace {

/// Node 0, which has the mesh, below a chain of others.
void deepen(Seed& seed, int depth) {
    for (int i = 1; i <= depth; ++i)
        seed.root["nodes"].push_back({{"children", {i - 1}},
                                      {"translation", {0.01, 0, 0}},
                                      {"rotation", {0, 0, 0.6, 0.8}},
                                      {"scale", {1, 1, -1}}});
    seed.root["scenes"][0]["nodes"] = {depth};
}

void write_indices(const std::filesystem::path& folder) {
    Seed bytes = Seed().square();
    bytes.primitive()["indices"] = bytes.numbers<uint8_t>({0, 1, 2, 2, 1, 3}, kU8, "SCALAR", 1);
    bytes.write(folder, "indices_u8", true);
    Seed words = Seed().square();
    words.primitive()["indices"] = words.numbers<uint32_t>({0, 1, 2, 2, 1, 3}, kU32, "SCALAR", 1);
    words.write(folder, "indices_u32", true);
    Seed none = Seed().square();
    none.primitive().erase("indices");
    none.primitive()["mode"] = 5;
    none.write(folder, "strip_without_indices", true);
    Seed fan = Seed().square();
    fan.primitive()["mode"] = 6;
    fan.write(folder, "fan", true);
    Seed mixed = Seed().square();
    mixed.root["meshes"][0]["primitives"].push_back(mixed.primitive());
    mixed.root["meshes"][0]["primitives"].push_back(mixed.primitive());
    mixed.primitive()["mode"] = 0;
    mixed.root["meshes"][0]["primitives"][1]["mode"] = 3;
    mixed.write(folder, "points_and_lines_besides", true);
}

void write_accessors(const std::filesystem::path& folder) {
    Seed sparse = Seed().square();
    const int moved = sparse.view(Seed::bytes<uint16_t>({1, 3}));
    const int values = sparse.view(Seed::bytes<float>({2, 0, 0, 2, 2, 0}));
    sparse.root["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", moved}, {"componentType", kU16}}},
        {"values", {{"bufferView", values}}}};
    sparse.root["accessors"][0]["max"] = {2, 2, 0};
    sparse.write(folder, "sparse", true);
    sparse.root["accessors"][0].erase("bufferView");
    sparse.write(folder, "sparse_over_zeros", true);

    Seed strided;
    const int vertices = strided.view(
        Seed::bytes<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}), 24);
    const int positions = strided.accessor(vertices, kF32, "VEC3", 3);
    const int normals = strided.accessor(vertices, kF32, "VEC3", 3);
    strided.root["accessors"][static_cast<size_t>(normals)]["byteOffset"] = 12;
    strided.attribute("POSITION", positions).attribute("NORMAL", normals);
    strided.write(folder, "interleaved_with_normals", true);

    Seed quantised;
    quantised.use("KHR_mesh_quantization");
    quantised.attribute(
        "POSITION",
        quantised.accessor(
            quantised.view(Seed::bytes<int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}), 8),
            kS16, "VEC3", 3, true));
    quantised.attribute(
        "NORMAL",
        quantised.accessor(
            quantised.view(Seed::bytes<int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}), 4), kS8,
            "VEC3", 3, true));
    quantised.write(folder, "quantised", true);
}

void write_nodes(const std::filesystem::path& folder) {
    Seed shared = Seed().square();
    shared.root["nodes"] = {
        {{"mesh", 0}, {"children", {1, 2}}},
        {{"mesh", 0}, {"translation", {2, 0, 0}}, {"scale", {-1, 1, 1}}},
        {{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 3, 0, 1}}}};
    shared.write(folder, "shared_mesh", true);
    Seed deep = Seed().square();
    deepen(deep, 40);
    deep.write(folder, "deep", true);
    Seed no_scene = Seed().square();
    no_scene.root.erase("scene");
    no_scene.root.erase("scenes");
    no_scene.write(folder, "no_scene", true);

    Seed views = Seed().square();
    views.root["cameras"] = {
        {{"name", "view"},
         {"type", "perspective"},
         {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"zfar", 10}, {"aspectRatio", 1.5}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}};
    views.use("KHR_lights_punctual", false) = {
        {"lights",
         {{{"type", "directional"}, {"color", {1, 0.5, 0.25}}, {"intensity", 3}},
          {{"type", "point"}, {"range", 4}, {"name", "lamp"}},
          {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.5}}}}}}};
    views.root["nodes"] = json::array({{{"mesh", 0}, {"children", {1, 2, 3}}}});
    for (int light = 0; light < 3; ++light) {
        json node = {{"translation", {0, light, 2}},
                     {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}};
        if (light < 2)
            node["camera"] = light;
        views.root["nodes"].push_back(std::move(node));
    }
    views.write(folder, "cameras_and_lights", true);
    views.write(folder, "cameras_and_lights", false);
}

} // namespace

void write_mesh_seeds(const std::filesystem::path& folder) {
    Seed().square().write(folder, "square", true);
    Seed().square().write(folder, "square", false);
    write_indices(folder);
    write_accessors(folder);
    write_nodes(folder);
}

} // namespace romascope::fuzz
