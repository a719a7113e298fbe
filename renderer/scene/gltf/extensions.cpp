// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/extensions.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <string_view>

namespace romascope::gltf {

using nlohmann::json;

namespace {

/// Taken fully, or without any bearing on what is drawn.
constexpr std::string_view kDrawn[] = {
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_materials_emissive_strength",
    "KHR_texture_transform",
    "KHR_materials_variants",
    "KHR_xmp",
    "KHR_xmp_json_ld",
};

/// Change how a surface looks, not where it is: left out with a notice.
constexpr std::string_view kLook[] = {
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_diffuse_transmission",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "EXT_lights_image_based",
    "EXT_lights_ies",
};

/// Other encodings of pictures. Used beside a plain picture they do no harm.
constexpr std::string_view kPictures[] = {"KHR_texture_basisu", "EXT_texture_webp",
                                          "EXT_texture_avif", "MSFT_texture_dds"};

constexpr size_t kMostNotices = 16;

bool among(const auto& names, const std::string& name) {
    return std::ranges::find(names, name) != std::end(names);
}

/// The texts in an array of the file; what has another type is left for the schema to refuse.
std::vector<std::string> texts(const json& file, const char* name) {
    std::vector<std::string> found;
    if (const auto member = file.find(name); member != file.end() && member->is_array())
        for (const json& each : *member)
            found.push_back(each.is_string() ? each.get<std::string>() : std::string());
    return found;
}

void check_asset(const json& file) {
    const auto asset = file.find("asset");
    if (asset == file.end() || !asset->is_object())
        return; // the schema says what is wrong
    const auto text = [&](const char* name) {
        const auto member = asset->find(name);
        return member != asset->end() && member->is_string() ? member->get<std::string>() : "";
    };
    const std::string version = text("version");
    if (!version.empty() && version != "2" && !version.starts_with("2."))
        refuse("asset.version", fmt::format("'{}', but glTF 2.0 is needed", version));
    const std::string least = text("minVersion");
    if (!least.empty() && least != "2.0")
        refuse("asset.minVersion", fmt::format("'{}', but only glTF 2.0 is read", least));
}

} // namespace

void check_versions(const json& file, std::vector<std::string>& notices) {
    if (!file.is_object())
        return;
    check_asset(file);
    const std::vector<std::string> required = texts(file, "extensionsRequired");
    for (size_t i = 0; i < required.size(); ++i) {
        const std::string element = fmt::format("extensionsRequired[{}]", i);
        if (among(kPictures, required[i]))
            refuse(element, fmt::format("needs {}, pictures that are not decoded here; export with "
                                        "PNG or JPEG",
                                        required[i]));
        if (!required[i].empty() && !among(kDrawn, required[i]) && !among(kLook, required[i]))
            refuse(element,
                   fmt::format("needs {}, which is not supported; export without it", required[i]));
    }
    std::set<std::string> in_use(required.begin(), required.end());
    in_use.merge([&] {
        const auto used = texts(file, "extensionsUsed");
        return std::set<std::string>(used.begin(), used.end());
    }());
    size_t left_out = 0;
    for (const std::string& name : in_use)
        if (!name.empty() && !among(kDrawn, name) && !among(kPictures, name) &&
            ++left_out <= kMostNotices)
            notices.push_back(one_line("left out: what " + name + " adds"));
    if (left_out > kMostNotices)
        notices.push_back(
            fmt::format("left out: what {} more extensions add", left_out - kMostNotices));
}

} // namespace romascope::gltf
