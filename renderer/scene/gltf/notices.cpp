// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/notices.h"

#include <fmt/format.h>

#include <algorithm>

namespace romascope::gltf {

void Notices::add(const std::string& element, const std::string& what) {
    const auto found = std::ranges::find(notices_, what, &Notice::what);
    if (found == notices_.end())
        notices_.push_back({element, what, 1});
    else
        ++found->count;
}

std::vector<std::string> Notices::lines() const {
    std::vector<std::string> lines;
    for (const Notice& notice : notices_)
        lines.push_back(notice.count == 1 ? fmt::format("{}: {}", notice.element, notice.what)
                                          : fmt::format("{} and {} more: {}", notice.element,
                                                        notice.count - 1, notice.what));
    return lines;
}

} // namespace romascope::gltf
