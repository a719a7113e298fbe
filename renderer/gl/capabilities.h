// SPDX-License-Identifier: MIT
#pragma once

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

} // namespace romascope
