// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace romascope {

/// One thing the driver can or cannot do, or one of its limits.
struct Capability {
    std::string name;
    std::string value; ///< "yes", "no" or a number with its unit
    std::string use;   ///< what it is for here
};

/// What the driver of the current context is and can do.
struct DriverFacts {
    std::string version;  ///< GL_VERSION
    std::string glsl;     ///< GL_SHADING_LANGUAGE_VERSION
    std::string vendor;   ///< GL_VENDOR
    std::string renderer; ///< GL_RENDERER
    bool software = false;
    std::vector<Capability> capabilities;
};

DriverFacts query_driver();

/// Largest 3D texture side, array layers, and so on are checked where they are needed; this is the
/// one limit that several structures share: bytes of one shader storage block.
int64_t max_storage_block_bytes();

} // namespace romascope
