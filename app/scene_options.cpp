// SPDX-License-Identifier: MIT
#include "app/scene_options.h"

#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/scene/scene_bytes.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace romascope {

void tell_notice(const std::filesystem::path& file, const std::string& notice) {
    fmt::print(stderr, "notice: {}: {}\n", file.string(), notice);
}

void SceneOptions::add_to(CLI::App& command) {
    command
        .add_option("--max-memory", max_memory,
                    "refuse what would take more, like 4GiB; else nine tenths of what is free")
        ->type_name("SIZE");
}

size_t SceneOptions::limit() const {
    if (!max_memory)
        return default_memory_limit();
    try {
        return parse_bytes(*max_memory);
    } catch (const Error& error) {
        throw Error(fmt::format("--max-memory: {}", error.what()), kBadInput);
    }
}

Scene SceneOptions::load(const std::filesystem::path& file) const {
    Scene scene = load_gltf(file, limit());
    for (const std::string& notice : scene.notices)
        tell_notice(file, notice);
    return scene;
}

size_t SceneOptions::left_beside(const Scene& scene) const {
    if (!max_memory)
        return default_memory_limit(); // the scene is there: it is not free
    return limit() - std::min(limit(), scene_bytes(scene));
}

} // namespace romascope
