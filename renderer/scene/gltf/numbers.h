// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/bounds.h"
#include "renderer/scene/gltf/document.h"

#include <fmt/format.h>
#include <glm/glm.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace romascope::gltf {

/// `values` as N finite numbers, or `fallback` if empty. Throws Error (kBadInput).
template <int N>
glm::vec<N, double> numbers(const std::vector<double>& values, glm::vec<N, double> fallback,
                            const std::string& element) {
    if (values.empty())
        return fallback;
    if (values.size() != N)
        refuse(element, fmt::format("has {} numbers instead of {}", values.size(), N));
    glm::vec<N, double> result;
    for (int i = 0; i < N; ++i) {
        result[i] = values[static_cast<size_t>(i)];
        if (!std::isfinite(result[i]))
            refuse(element, "is not finite");
    }
    return result;
}

} // namespace romascope::gltf
