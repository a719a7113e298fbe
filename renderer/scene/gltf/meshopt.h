// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/storage.h"

namespace romascope::gltf {

/// Decodes the views compressed by EXT_meshopt_compression into bytes of their own and drops the
/// extension from them. `buffers`: the bytes of each buffer, none for those without.
/// Throws Error (kBadInput) if sizes, mode and filter do not fit each other, or the data is broken.
void decode_meshopt(tinygltf::Model& model,
                    const std::vector<std::optional<std::span<const std::byte>>>& buffers,
                    Storage& storage);

/// The buffer that view `index` really reads from: that of the extension, if it has one.
int source_buffer(const tinygltf::Model& model, size_t index);

} // namespace romascope::gltf
