// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/document.h"

#include "renderer/base/error.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <string_view>

namespace romascope::gltf {
namespace {

namespace fs = std::filesystem;

/// tinygltf walks JSON recursively and overflows the stack on 100,000 nested arrays. No honest
/// file comes near this.
constexpr int kMaxJsonDepth = 128;

/// The folder that external files must lie in, and the first file that did not.
struct Sandbox {
    fs::path folder;
    std::string refused;
};

bool inside(const fs::path& folder, const fs::path& file) {
    std::error_code code;
    const fs::path real = fs::weakly_canonical(file, code);
    const fs::path relative = real.lexically_relative(folder);
    return !code && !relative.empty() && *relative.begin() != "..";
}

/// Pictures are never decoded, so reading them would only cost time.
bool is_picture(const fs::path& file) {
    const std::string extension = file.extension().string();
    for (const char* known : {".png", ".jpg", ".jpeg", ".webp", ".ktx2", ".dds", ".PNG", ".JPG"})
        if (extension == known)
            return true;
    return false;
}

bool file_exists(const std::string& name, void* user) {
    auto& sandbox = *static_cast<Sandbox*>(user);
    std::error_code code;
    if (is_picture(name) || !fs::is_regular_file(name, code))
        return false;
    if (inside(sandbox.folder, name))
        return true;
    if (sandbox.refused.empty())
        sandbox.refused = name;
    return false;
}

/// Names are taken as they are: no "~", no environment variables, no shell (CVE-2022-3008).
std::string keep_path(const std::string& name, void*) { return name; }

bool read_file(std::vector<unsigned char>* out, std::string* error, const std::string& name,
               void* user) {
    std::ifstream in(name, std::ios::binary | std::ios::ate);
    const auto size = in ? static_cast<std::streamoff>(in.tellg()) : -1;
    if (size < 0 || !file_exists(name, user)) {
        *error = "cannot be read";
        return false;
    }
    out->resize(static_cast<size_t>(size));
    in.seekg(0);
    in.read(reinterpret_cast<char*>(out->data()), size);
    return in.good();
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                int, void*) {
    return true;
}

void check_depth(std::string_view json) {
    int depth = 0;
    bool in_string = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxJsonDepth)
                refuse("JSON", fmt::format("nested deeper than {} levels", kMaxJsonDepth));
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

/// The JSON in a .glb (header of 12 bytes, chunk header of 8) or in a .gltf; lengths that lie are
/// left for tinygltf to refuse.
std::string_view json_part(std::string_view content, bool binary) {
    if (!binary)
        return content;
    uint32_t length = 0;
    if (content.size() < 20)
        return {};
    std::memcpy(&length, content.data() + 12, sizeof(length));
    return content.substr(20, length);
}

void check_versions(const tinygltf::Model& model) {
    std::string needed;
    for (const std::string& extension : model.extensionsRequired)
        needed += (needed.empty() ? "" : ", ") + extension;
    if (!model.extensionsRequired.empty())
        refuse("extensionsRequired",
               fmt::format("needs {}, which is not supported; export without it", needed));
    const std::string& version = model.asset.version;
    if (version != "2" && version.rfind("2.", 0) != 0)
        refuse("asset.version", fmt::format("'{}', but glTF 2.0 is needed", version));
    if (!model.asset.minVersion.empty() && model.asset.minVersion != "2.0")
        refuse("asset.minVersion",
               fmt::format("'{}', but only glTF 2.0 is read", model.asset.minVersion));
}

/// tinygltf itself follows the indices of primitives and refuses bad ones without saying where.
void check_indices(const tinygltf::Model& model) {
    const auto known = [](int index, size_t count) {
        return index >= 0 && static_cast<size_t>(index) < count;
    };
    for (size_t m = 0; m < model.meshes.size(); ++m) {
        const auto& primitives = model.meshes[m].primitives;
        for (size_t p = 0; p < primitives.size(); ++p) {
            const int accessor = primitives[p].indices;
            const std::string element = fmt::format("meshes[{}].primitives[{}].indices", m, p);
            if (accessor < 0)
                continue;
            if (!known(accessor, model.accessors.size()))
                refuse(element, fmt::format("accessor {} does not exist, there are {}", accessor,
                                            model.accessors.size()));
            const int view = model.accessors[static_cast<size_t>(accessor)].bufferView;
            if (!known(view, model.bufferViews.size()))
                refuse(element,
                       fmt::format("accessors[{}]: has no bufferView that exists", accessor));
        }
    }
}

} // namespace

void parse(const std::string& content, const fs::path& path, tinygltf::Model& model) {
    const bool binary = content.starts_with("glTF");
    const size_t first = content.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    if (!binary && (first == std::string::npos || content[first] != '{'))
        refuse("content", "not a glTF 2.0 file (.glb or .gltf)");
    if (content.size() > std::numeric_limits<uint32_t>::max())
        refuse("content", "larger than 4 GiB");
    check_depth(json_part(content, binary));

    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    Sandbox sandbox{fs::weakly_canonical(folder), {}};
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(skip_image, nullptr);
    loader.SetFsCallbacks({file_exists, keep_path, read_file, write_nothing, &sandbox});
    std::string error;
    std::string warning;
    bool good = false;
    const auto size = static_cast<unsigned int>(content.size());
    try {
        good = binary ? loader.LoadBinaryFromMemory(
                            &model, &error, &warning,
                            reinterpret_cast<const unsigned char*>(content.data()), size,
                            folder.string())
                      : loader.LoadASCIIFromString(&model, &error, &warning, content.data(), size,
                                                   folder.string());
    } catch (const std::exception& exception) { // e.g. bad_alloc, or JSON of the wrong type
        error += fmt::format("tinygltf gave up ({})", exception.what());
    }
    check_versions(model);
    if (good)
        return;
    if (!sandbox.refused.empty() && model.bufferViews.empty()) // stopped at the buffers
        refuse("buffers", fmt::format("'{}' lies outside the folder of the file", sandbox.refused));
    check_indices(model);
    refuse("glTF", error.empty() ? "cannot be parsed" : error);
}

} // namespace romascope::gltf
