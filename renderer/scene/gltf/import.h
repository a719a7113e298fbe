// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"
#include "renderer/scene/scene.h"

#include <filesystem>
#include <string>

namespace romascope {

/// Reads a glTF 2.0 file (.glb or .gltf, told apart by its first bytes) and writes every instance
/// out to world space; what moves is described in Scene::motion besides.
///
/// Taken: the default scene's triangles, strips and fans, base colour factors and textures, alpha
/// masks, emissive factors, vertex colours, perspective cameras, KHR_lights_punctual, skins, morph
/// targets and node animations; EXT_meshopt_compression, KHR_draco_mesh_compression,
/// KHR_mesh_quantization and KHR_texture_transform. Missing normals become flat ones. What else
/// the file holds is left out, with a line in Scene::notices where that changes the picture.
/// External buffers and pictures are read only below the folder of the file.
///
/// Throws Error (kBadInput), one line "FILE: ELEMENT: reason", for anything else: a required
/// extension that is not known, a broken reference, a span outside its buffer, a number that is not
/// finite, a scene without triangles, one that takes more than `max_memory` bytes.
Scene load_gltf(const std::filesystem::path& path, size_t max_memory = default_memory_limit());

/// The same from bytes in memory; `path` names the file in messages and the folder of what it
/// refers to.
Scene import_gltf(std::string content, const std::filesystem::path& path, size_t max_memory);

} // namespace romascope
