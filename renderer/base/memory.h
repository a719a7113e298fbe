// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace romascope {

/// Bytes that this process can still get: what the system calls available, or less where a control
/// group allows less. The largest number if neither can be found out.
size_t free_memory();

/// Nine tenths of `free_memory()`: what a scene may take where nothing else is said.
size_t default_memory_limit();

/// "512MiB", "1.5GiB", "2000000": a number and B, KiB, MiB, GiB or TiB (KB, MB, GB, TB count in
/// thousands); none means bytes. Throws Error (kBadInput) that tells the form.
size_t parse_bytes(const std::string& text);

/// "1.5 GiB": for messages.
std::string format_bytes(size_t bytes);

/// Counts what is about to be allocated, so that too much is refused before it is.
class MemoryBudget {
public:
    explicit MemoryBudget(size_t limit) : limit_(limit) {}

    /// Throws Error (kBadInput) "WHAT: needs at least ... of memory, the limit is ...; raise
    /// --max-memory" if `count` times `size` more bytes exceed the limit; neither the product nor
    /// the sum can overflow.
    void take(size_t count, size_t size, const std::string& what);
    /// Gives back what was taken for something that is gone.
    void give(size_t bytes) { taken_ -= bytes < taken_ ? bytes : taken_; }

    size_t limit() const { return limit_; }
    size_t taken() const { return taken_; }

private:
    size_t limit_;
    size_t taken_ = 0;
};

} // namespace romascope
