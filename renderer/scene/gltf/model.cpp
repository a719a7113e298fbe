// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/model.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace romascope::gltf {

using nlohmann::json;

namespace {

json take_list(json& file, const char* name) {
    const auto member = file.find(name);
    if (member == file.end())
        return json::array();
    json list = std::move(*member);
    file.erase(member);
    return list;
}

std::string take_text(json& object, const char* name) {
    const auto member = object.find(name);
    return member == object.end() ? std::string() : std::move(member->get_ref<std::string&>());
}

std::vector<BufferSource> take_buffers(json& file) {
    std::vector<BufferSource> buffers;
    for (json& each : take_list(file, "buffers")) {
        const json::json_pointer fallback("/extensions/EXT_meshopt_compression/fallback");
        buffers.push_back({take_text(each, "uri"), each["byteLength"].get<size_t>(),
                           each.contains(fallback) && each[fallback].get<bool>()});
    }
    return buffers;
}

/// tinygltf would open or decode them.
std::vector<tinygltf::Image> take_images(json& file) {
    std::vector<tinygltf::Image> images;
    for (json& each : take_list(file, "images")) {
        tinygltf::Image image;
        image.name = take_text(each, "name");
        image.uri = take_text(each, "uri");
        image.mimeType = take_text(each, "mimeType");
        image.bufferView = each.value("bufferView", -1);
        images.push_back(std::move(image));
    }
    return images;
}

/// tinygltf refuses kinds it does not know. Returns the kinds of all cameras.
std::vector<std::string> hide_unknown_cameras(json& file) {
    std::vector<std::string> types;
    const auto cameras = file.find("cameras");
    if (cameras == file.end())
        return types;
    for (json& camera : *cameras) {
        types.push_back(camera["type"].get<std::string>());
        if (types.back() != "perspective" && types.back() != "orthographic") {
            camera["type"] = "orthographic";
            camera["orthographic"] = {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}};
        }
    }
    return types;
}

/// tinygltf refuses indices whose accessor has no view, which with Draco is the rule. They get
/// view 0 for its eyes; returns which.
std::vector<size_t> give_indices_views(json& file) {
    std::vector<size_t> changed;
    const auto meshes = file.find("meshes");
    if (meshes == file.end())
        return changed;
    for (const json& mesh : *meshes)
        for (const json& primitive : mesh["primitives"]) {
            if (!primitive.contains("indices"))
                continue;
            const auto index = primitive["indices"].get<size_t>();
            json& accessor = file["accessors"][index];
            if (!accessor.contains("bufferView")) {
                accessor["bufferView"] = 0;
                changed.push_back(index);
            }
        }
    return changed;
}

bool no_file(const std::string&, void*) { return false; }
std::string same_path(const std::string& path, void*) { return path; }
bool read_nothing(std::vector<unsigned char>*, std::string*, const std::string&, void*) {
    return false;
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

tinygltf::Model parse(const std::string& text) {
    if (text.size() > std::numeric_limits<unsigned int>::max())
        refuse("JSON", "larger than 4 GiB");
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({no_file, same_path, read_nothing, write_nothing, nullptr});
    tinygltf::Model model;
    std::string error, warning;
    bool good = false;
    try {
        good = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                          static_cast<unsigned int>(text.size()), "");
    } catch (const std::exception& exception) {
        error += fmt::format("tinygltf gave up ({})", exception.what());
    }
    if (!good)
        refuse("glTF", error.empty() ? "cannot be parsed" : error);
    return model;
}

} // namespace

ParsedModel read_model(json file, Storage& storage) {
    ParsedModel parsed;
    parsed.buffers = take_buffers(file);
    auto images = take_images(file);
    const auto camera_types = hide_unknown_cameras(file);
    const auto viewless = give_indices_views(file);
    const bool no_views = !file.contains("bufferViews") || file["bufferViews"].empty();
    if (no_views && !viewless.empty())
        file["bufferViews"] = {{{"buffer", 0}, {"byteLength", 0}}};
    const auto materials = file.find("materials");
    if (materials != file.end())
        storage.take(materials->size(), 2 * sizeof(tinygltf::Material), "materials");

    parsed.model = parse(file.dump());
    tinygltf::Model& model = parsed.model;
    model.images = std::move(images);
    for (const size_t accessor : viewless)
        model.accessors[accessor].bufferView = -1;
    if (no_views)
        model.bufferViews.clear();
    for (size_t i = 0; i < camera_types.size(); ++i)
        model.cameras[i].type = camera_types[i];
    return parsed;
}

} // namespace romascope::gltf
