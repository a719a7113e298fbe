// SPDX-License-Identifier: MIT
#include "tests/fuzz/heap_peak.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HAS_ALLOCATOR_HOOKS
#endif
#endif

#ifdef HAS_ALLOCATOR_HOOKS
#include <sanitizer/allocator_interface.h>
#endif

#include <algorithm>
#include <atomic>

namespace romascope::fuzz {
namespace {

std::atomic<long long> in_use = 0, peak = 0;

#ifdef HAS_ALLOCATOR_HOOKS
void count_malloc(const volatile void* /*block*/, size_t size) {
    in_use += static_cast<long long>(size);
    peak = std::max(peak.load(), in_use.load()); // one thread allocates here
}

void count_free(const volatile void* block) {
    if (block)
        in_use -= static_cast<long long>(__sanitizer_get_allocated_size(block));
}

const bool installed = __sanitizer_install_malloc_and_free_hooks(count_malloc, count_free) != 0;
#else
const bool installed = false;
#endif

} // namespace

HeapPeak::HeapPeak() : before_(in_use) { peak = before_; }

size_t HeapPeak::bytes() const {
    return installed ? static_cast<size_t>(std::max(0LL, peak - before_)) : 0;
}

} // namespace romascope::fuzz
