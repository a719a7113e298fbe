// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gltf/accessor.h"
#include "tests/support/expect_error.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <string>

namespace romascope::gltf {

/// A document with the budget it counts in.
struct OpenedGltf {
    explicit OpenedGltf(const std::string& content, size_t limit = size_t{1} << 28)
        : budget(limit), document(content, "thing.glb", budget) {}

    /// Reads the accessor as what it is.
    AccessorReader reader(size_t accessor) const {
        const auto& source = document.model().accessors.at(accessor);
        return AccessorReader(document, static_cast<int>(accessor),
                              {source.type, {source.componentType}}, "user");
    }

    MemoryBudget budget;
    Document document;
};

/// Text of the Error that the document throws, empty if it throws none.
inline std::string refusal_of(const std::string& content, size_t limit = size_t{1} << 28) {
    return error_of([&] { OpenedGltf opened(content, limit); });
}

} // namespace romascope::gltf
