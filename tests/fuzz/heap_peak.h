// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace romascope::fuzz {

/// Counts what this process takes from the heap, in builds by clang with the address sanitizer.
class HeapPeak {
public:
    HeapPeak();
    /// Largest number of bytes in use at once since then, over those in use before; 0 in other
    /// builds.
    size_t bytes() const;

private:
    long long before_;
};

} // namespace romascope::fuzz
