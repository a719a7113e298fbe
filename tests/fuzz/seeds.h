// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace romascope::fuzz {

/// Each writes small valid files, one or a few features each.
void write_mesh_seeds(const std::filesystem::path& folder);
void write_surface_seeds(const std::filesystem::path& folder);
void write_motion_seeds(const std::filesystem::path& folder);
void write_compressed_seeds(const std::filesystem::path& folder);

} // namespace romascope::fuzz
