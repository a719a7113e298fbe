// SPDX-License-Identifier: MIT
#include "tests/fuzz/seed.h"

#include <fstream>
#include <stdexcept>

namespace romascope::fuzz {

Seed::Seed() {
    root = {{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", json::object()}}}}}}},
            {"buffers", {{{"byteLength", 0}}}},
            {"bufferViews", json::array()},
            {"accessors", json::array()}};
}

int Seed::view(std::string_view content, int stride) {
    bin.resize((bin.size() + 3) / 4 * 4);
    json entry = {{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", content.size()}};
    if (stride > 0)
        entry["byteStride"] = stride;
    bin += content;
    root["bufferViews"].push_back(std::move(entry));
    return static_cast<int>(root["bufferViews"].size()) - 1;
}

int Seed::accessor(int view, int component, const char* type, size_t count, bool normalized) {
    json entry = {{"componentType", component}, {"type", type}, {"count", count}};
    if (view >= 0)
        entry["bufferView"] = view;
    if (normalized)
        entry["normalized"] = true;
    root["accessors"].push_back(std::move(entry));
    return static_cast<int>(root["accessors"].size()) - 1;
}

Seed& Seed::attribute(const char* name, int accessor) {
    primitive()["attributes"][name] = accessor;
    return *this;
}

Seed& Seed::square() {
    const int corners = numbers<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, kF32, "VEC3", 3);
    root["accessors"][static_cast<size_t>(corners)]["min"] = {0, 0, 0};
    root["accessors"][static_cast<size_t>(corners)]["max"] = {1, 1, 0};
    attribute("POSITION", corners);
    primitive()["indices"] = numbers<uint16_t>({0, 1, 2, 2, 1, 3}, kU16, "SCALAR", 1);
    return *this;
}

json& Seed::material() {
    primitive()["material"] = 0;
    json& materials = root["materials"];
    if (materials.is_null())
        materials = {{{"name", "surface"}}};
    return materials[0];
}

json& Seed::use(const char* extension, bool required) {
    root["extensionsUsed"].push_back(extension);
    if (required)
        root["extensionsRequired"].push_back(extension);
    return root["extensions"][extension];
}

Seed& Seed::animate(const char* path, const char* interpolation, const std::vector<float>& times,
                    const std::vector<float>& values, const char* type, size_t per_element) {
    const int input = numbers(times, kF32, "SCALAR", 1);
    root["accessors"][static_cast<size_t>(input)]["min"] = {times.front()};
    root["accessors"][static_cast<size_t>(input)]["max"] = {times.back()};
    const int output = numbers(values, kF32, type, per_element);
    root["animations"].push_back(
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
         {"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}}});
    return *this;
}

void Seed::write(const std::filesystem::path& folder, const char* name, bool glb) const {
    GltfParts parts{glb, root, true, bin};
    if (parts.json.contains("extensions"))
        std::erase_if(parts.json["extensions"].get_ref<json::object_t&>(),
                      [](const auto& member) { return member.second.is_null(); });
    const std::filesystem::path path = folder / (std::string(name) + (glb ? ".glb" : ".gltf"));
    std::ofstream out(path, std::ios::binary);
    const std::string file = put_together(std::move(parts), true);
    out.write(file.data(), static_cast<std::streamsize>(file.size()));
    if (!out.flush())
        throw std::runtime_error("cannot write " + path.string());
}

} // namespace romascope::fuzz
