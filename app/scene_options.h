// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace romascope {

/// A line on stderr about a file that is taken all the same.
void tell_notice(const std::filesystem::path& file, const std::string& notice);

/// --max-memory, for commands that load scenes.
struct SceneOptions {
    std::optional<std::string> max_memory; ///< none: most of what is free

    void add_to(CLI::App& command);

    /// Bytes that a scene may take. Throws Error (kBadInput) if --max-memory is no amount.
    size_t limit() const;

    /// Loads a scene within the limit and tells its notices on stderr, a line each.
    /// Throws Error (kBadInput) as load_gltf does.
    Scene load(const std::filesystem::path& file) const;

    /// Bytes that are left for rendering a scene that was loaded: of the limit, or of what is free.
    size_t left_beside(const Scene& scene) const;
};

} // namespace romascope
