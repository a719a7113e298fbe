// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace romascope::gltf {

/// What is not drawn as the file says. The same thing said of many elements becomes one line.
class Notices {
public:
    void add(const std::string& element, const std::string& what);
    /// "ELEMENT: WHAT", "ELEMENT and 3 more: WHAT".
    std::vector<std::string> lines() const;

private:
    struct Notice {
        std::string element, what;
        size_t count = 0;
    };
    std::vector<Notice> notices_;
};

} // namespace romascope::gltf
