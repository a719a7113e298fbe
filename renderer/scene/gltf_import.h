// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <filesystem>

namespace romascope {

/// Reads a glTF 2.0 file (.glb or .gltf, told apart by its first bytes) and writes every instance
/// out to world space.
///
/// Taken: the default scene's triangles, strips and fans; float positions and normals; the factors
/// of materials; perspective cameras. Missing normals become flat ones. Not decoded: images.
/// Left out: points, lines, orthographic cameras, skins, morph targets, animations.
/// External buffers are read only below the folder of the file.
///
/// Throws Error (kBadInput), one line "FILE: ELEMENT: reason", for anything else: a required
/// extension, a broken reference, a span outside its buffer, a number that is not finite, a scene
/// without triangles.
Scene load_gltf(const std::filesystem::path& path);

} // namespace romascope
