// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/storage.h"

#include <nlohmann/json_fwd.hpp>
#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace romascope::gltf {

/// What stands in buffers[i].
struct BufferSource {
    std::string uri;       ///< empty: the BIN chunk, or none
    size_t size = 0;       ///< bytes
    bool fallback = false; ///< EXT_meshopt_compression: for programs that cannot decode
};

/// The file as tinygltf understands it, without buffers: those are kept by us.
struct ParsedModel {
    tinygltf::Model model;
    std::vector<BufferSource> buffers;
};

/// Has tinygltf read a file that has passed check_schema. It sees neither pictures nor buffers and
/// opens no files; what it refuses though it is valid is kept from it.
ParsedModel read_model(nlohmann::json file, Storage& storage);

} // namespace romascope::gltf
