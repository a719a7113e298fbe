// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/storage.h"

namespace romascope::gltf {

/// Decodes the primitives compressed by KHR_draco_mesh_compression: they get accessors and views
/// of their own, as if they never had been compressed, and lose the extension.
/// Throws Error (kBadInput) if the data is broken or is not what the accessors announce.
void decode_draco(tinygltf::Model& model, Storage& storage);

} // namespace romascope::gltf
