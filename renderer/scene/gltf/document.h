// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"
#include "renderer/scene/gltf/message.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace romascope::gltf {

/// A glTF file that has been checked: every property has the type and range of the specification,
/// every index names something, every buffer view lies in its buffer and every accessor in its
/// view, the nodes of each scene are a tree of sane depth, every required extension is known.
/// What the numbers in buffers mean is left to who reads them.
///
/// tinygltf, which parses but does not validate, sees the file only after that, and neither opens
/// files nor decodes anything. Compressed views (EXT_meshopt_compression), compressed primitives
/// (KHR_draco_mesh_compression) and sparse accessors are written out here: the model looks as if
/// they never had been.
class Document {
public:
    /// Takes the file's bytes (.glb or .gltf, told apart by the first ones). `path`: buffers and
    /// pictures are read only from the folder of this file and below. `budget`: what is read and
    /// decoded is taken from it before, `content` too, and given back with the document.
    /// Throws Error (kBadInput) without the file's name.
    Document(std::string content, const std::filesystem::path& path, MemoryBudget& budget);
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const tinygltf::Model& model() const;

    /// The bytes of a buffer view that the model names.
    std::span<const std::byte> view(int index) const;

    /// The bytes of images[index], still encoded; read and taken from the budget at each call, not
    /// given back. Throws Error (kBadInput) if it cannot be read.
    std::vector<std::byte> image(int index) const;

    /// What was left out or taken otherwise than the file says, one line each.
    const std::vector<std::string>& notices() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace romascope::gltf
