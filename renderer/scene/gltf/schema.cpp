// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/schema.h"

#include "renderer/scene/gltf/message.h"
#include "renderer/scene/gltf/rules.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace romascope::gltf {

using nlohmann::json;

namespace {

constexpr bool kRequired = true;
constexpr double kAny = 9007199254740991.0; ///< bytes: no limit but that sums stay exact
/// Elements of an accessor: so that 32-bit indices reach all of them and none means "restart".
constexpr double kMostElements = 4294967294.0;
constexpr double kInt32 = 2147483647.0; ///< tinygltf keeps some sizes in an int

Rule extensions(std::vector<Property> known) { return object(std::move(known)); }

Rule texture_info() {
    return object({{"index", index("textures"), kRequired},
                   {"texCoord", integer(0, kInt32)},
                   {"extensions", extensions({{"KHR_texture_transform",
                                               object({{"offset", list(number(), 2, 2)},
                                                       {"rotation", number()},
                                                       {"scale", list(number(), 2, 2)},
                                                       {"texCoord", integer(0, kInt32)}})}})}});
}

Rule accessor() {
    const Rule indices = object({{"bufferView", index("bufferViews"), kRequired},
                                 {"byteOffset", integer(0, kInt32)},
                                 {"componentType", code({5121, 5123, 5125}), kRequired}});
    const Rule values = object(
        {{"bufferView", index("bufferViews"), kRequired}, {"byteOffset", integer(0, kInt32)}});
    return object(
        {{"name", text()},
         {"bufferView", index("bufferViews")},
         {"byteOffset", integer(0, kAny)},
         {"componentType", code({5120, 5121, 5122, 5123, 5125, 5126}), kRequired},
         {"normalized", boolean()},
         {"count", integer(1, kMostElements), kRequired},
         {"type", text({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}), kRequired},
         {"sparse", object({{"count", integer(1, kInt32), kRequired},
                            {"indices", indices, kRequired},
                            {"values", values, kRequired}})}});
}

Rule buffer_view() {
    const Rule meshopt =
        object({{"buffer", index("buffers"), kRequired},
                {"byteOffset", integer(0, kInt32)},
                {"byteLength", integer(1, kInt32), kRequired},
                {"byteStride", integer(1, 256), kRequired},
                {"count", integer(1, kInt32), kRequired},
                {"mode", text({"ATTRIBUTES", "TRIANGLES", "INDICES"}), kRequired},
                {"filter", text({"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"})}});
    return object({{"name", text()},
                   {"buffer", index("buffers"), kRequired},
                   {"byteOffset", integer(0, kAny)},
                   {"byteLength", integer(0, kAny), kRequired},
                   {"byteStride", integer(4, 252, 4)},
                   {"extensions", extensions({{"EXT_meshopt_compression", meshopt}})}});
}

Rule buffer() {
    return object({{"name", text()},
                   {"uri", text()},
                   {"byteLength", integer(0, kAny), kRequired},
                   {"extensions",
                    extensions({{"EXT_meshopt_compression", object({{"fallback", boolean()}})}})}});
}

Rule mesh() {
    const Rule attributes = map_of(index("accessors"));
    const Rule draco = object({{"bufferView", index("bufferViews"), kRequired},
                               {"attributes", map_of(integer(0, kInt32)), kRequired}});
    const Rule primitive =
        object({{"attributes", attributes, kRequired},
                {"indices", index("accessors")},
                {"material", index("materials")},
                {"mode", code({0, 1, 2, 3, 4, 5, 6})},
                {"targets", list(attributes)},
                {"extensions", extensions({{"KHR_draco_mesh_compression", draco}})}});
    return object({{"name", text()},
                   {"primitives", list(primitive), kRequired},
                   {"weights", list(number())}});
}

Rule material() {
    const Rule pbr = object({{"baseColorFactor", list(number(), 4, 4)},
                             {"baseColorTexture", texture_info()},
                             {"metallicFactor", number()},
                             {"roughnessFactor", number()},
                             {"metallicRoughnessTexture", texture_info()}});
    return object({{"name", text()},
                   {"pbrMetallicRoughness", pbr},
                   {"normalTexture", texture_info()},
                   {"occlusionTexture", texture_info()},
                   {"emissiveTexture", texture_info()},
                   {"emissiveFactor", list(number(), 3, 3)},
                   {"alphaMode", text({"OPAQUE", "MASK", "BLEND"})},
                   {"alphaCutoff", number(0.0)},
                   {"doubleSided", boolean()},
                   {"extensions", extensions({{"KHR_materials_emissive_strength",
                                               object({{"emissiveStrength", number(0.0)}})},
                                              {"KHR_materials_unlit", object({})}})}});
}

Rule texture() {
    const Rule other_source = object({{"source", index("images")}});
    return object({{"name", text()},
                   {"sampler", index("samplers")},
                   {"source", index("images")},
                   {"extensions", extensions({{"KHR_texture_basisu", other_source},
                                              {"EXT_texture_webp", other_source}})}});
}

Rule sampler() {
    return object({{"name", text()},
                   {"magFilter", code({9728, 9729})},
                   {"minFilter", code({9728, 9729, 9984, 9985, 9986, 9987})},
                   {"wrapS", code({33071, 33648, 10497})},
                   {"wrapT", code({33071, 33648, 10497})}});
}

Rule image() {
    return object({{"name", text()},
                   {"uri", text()},
                   {"mimeType", text()},
                   {"bufferView", index("bufferViews")}});
}

Rule node() {
    return object(
        {{"name", text()},
         {"children", list(index("nodes"))},
         {"camera", index("cameras")},
         {"mesh", index("meshes")},
         {"skin", index("skins")},
         {"matrix", list(number(), 16, 16)},
         {"translation", list(number(), 3, 3)},
         {"rotation", list(number(), 4, 4)},
         {"scale", list(number(), 3, 3)},
         {"weights", list(number())},
         {"extensions",
          extensions({{"KHR_lights_punctual", object({{"light", index("lights"), kRequired}})}})}});
}

Rule skin() {
    return object({{"name", text()},
                   {"joints", list(index("nodes"), 1), kRequired},
                   {"skeleton", index("nodes")},
                   {"inverseBindMatrices", index("accessors")}});
}

Rule animation() {
    const Rule target = object({{"node", index("nodes")}, {"path", text(), kRequired}});
    const Rule channel =
        object({{"sampler", integer(0, kInt32), kRequired}, {"target", target, kRequired}});
    const Rule curve = object({{"input", index("accessors"), kRequired},
                               {"output", index("accessors"), kRequired},
                               {"interpolation", text({"LINEAR", "STEP", "CUBICSPLINE"})}});
    return object({{"name", text()},
                   {"channels", list(channel), kRequired},
                   {"samplers", list(curve), kRequired}});
}

Rule camera() {
    return object({{"name", text()},
                   {"type", text(), kRequired},
                   {"perspective", object({{"yfov", number_above(0.0), kRequired},
                                           {"znear", number(), kRequired},
                                           {"zfar", number()},
                                           {"aspectRatio", number()}})},
                   {"orthographic", object({{"xmag", number(), kRequired},
                                            {"ymag", number(), kRequired},
                                            {"znear", number(), kRequired},
                                            {"zfar", number(), kRequired}})}});
}

Rule light() {
    return object({{"name", text()},
                   {"type", text(), kRequired},
                   {"color", list(number(), 3, 3)},
                   {"intensity", number(0.0)},
                   {"range", number_above(0.0)},
                   {"spot", object({{"innerConeAngle", number(0.0)},
                                    {"outerConeAngle", number_above(0.0)}})}});
}

Rule root() {
    const Rule asset = object({{"version", text(), kRequired}, {"minVersion", text()}});
    const Rule scene = object({{"name", text()}, {"nodes", list(index("nodes"))}});
    const Rule lights = object({{"lights", list(light()), kRequired}});
    // What others build on comes first, so that the first message names the cause.
    return object({{"asset", asset, kRequired},
                   {"buffers", list(buffer())},
                   {"bufferViews", list(buffer_view())},
                   {"accessors", list(accessor())},
                   {"images", list(image())},
                   {"samplers", list(sampler())},
                   {"textures", list(texture())},
                   {"materials", list(material())},
                   {"meshes", list(mesh())},
                   {"cameras", list(camera())},
                   {"skins", list(skin())},
                   {"nodes", list(node())},
                   {"scenes", list(scene)},
                   {"scene", index("scenes")},
                   {"animations", list(animation())},
                   {"extensionsUsed", list(text())},
                   {"extensionsRequired", list(text())},
                   {"extensions", extensions({{"KHR_lights_punctual", lights}})}});
}

/// How many there are of all that an index can name.
std::map<std::string, size_t> counts_of(const json& file) {
    std::map<std::string, size_t> counts;
    if (file.is_object())
        for (const auto& [name, value] : file.items())
            if (value.is_array())
                counts[name] = value.size();
    const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    if (file.is_object() && file.contains(lights) && file[lights].is_array())
        counts["lights"] = file[lights].size();
    return counts;
}

/// What a table of properties cannot say: one property that asks for or excludes another.
void check_dependencies(const json& file) {
    static const json kNone = json::array();
    const auto all = [&](const char* name) -> const json& {
        return file.contains(name) ? file[name] : kNone;
    };
    for (size_t i = 0; i < all("cameras").size(); ++i) {
        const json& each = file["cameras"][i];
        for (const char* type : {"perspective", "orthographic"})
            if (each["type"] == type && !each.contains(type))
                refuse(fmt::format("cameras[{}].{}", i, type), "is missing");
    }
    for (size_t i = 0; i < all("images").size(); ++i)
        if (const json& each = file["images"][i];
            each.contains("uri") == each.contains("bufferView"))
            refuse(fmt::format("images[{}]", i), each.contains("uri")
                                                     ? "has both uri and bufferView"
                                                     : "has neither uri nor bufferView");
    for (size_t i = 0; i < all("animations").size(); ++i) {
        const json& each = file["animations"][i];
        const size_t samplers = each["samplers"].size();
        for (size_t c = 0; c < each["channels"].size(); ++c)
            if (const auto named = each["channels"][c]["sampler"].get<size_t>(); named >= samplers)
                refuse(fmt::format("animations[{}].channels[{}].sampler", i, c),
                       fmt::format("{} does not exist, there are {}", named, samplers));
    }
    const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    if (file.contains(lights))
        for (size_t i = 0; i < file[lights].size(); ++i)
            if (const json& each = file[lights][i];
                each["type"] == "spot" && !each.contains("spot"))
                refuse(fmt::format("extensions.KHR_lights_punctual.lights[{}].spot", i),
                       "is missing");
}

} // namespace

void check_schema(json& file) {
    static const Rule kRoot = root();
    check(file, kRoot, counts_of(file));
    check_dependencies(file);
}

} // namespace romascope::gltf
