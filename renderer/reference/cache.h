// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

struct XXH3_state_s;

namespace romascope {

/// Collects everything a result depends on into a name for it: 128 bits by XXH3.
class CacheKey {
public:
    CacheKey();
    ~CacheKey();
    CacheKey(const CacheKey&) = delete;
    CacheKey& operator=(const CacheKey&) = delete;

    template <class T>
    void add(const T& value) {
        static_assert(std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>,
                      "padding bytes are not values");
        add_bytes(&value, sizeof(T));
    }
    /// Length and contents, so that what ends one array and begins the next is never confused.
    template <class T>
    void add(const std::vector<T>& values) {
        add(values.size());
        add_bytes(values.data(), values.size() * sizeof(T));
    }
    /// 32 hexadecimal digits.
    std::string name() const;

private:
    void add_bytes(const void* data, size_t size);

    XXH3_state_s* state_;
};

/// A result on disk: some numbers, and how long they took to compute.
struct CachedResult {
    std::vector<float> values;
    double seconds = 0.0;
};

/// cache_directory()/reference/NAME.bin
std::filesystem::path cache_path(const std::string& name);

/// The result stored under `name`. Nothing if there is none, or if the file is not whole: it must
/// have the length of `count` values and its checksum must agree.
std::optional<CachedResult> read_cached(const std::string& name, size_t count);

/// Stores a result; does nothing if that is impossible, as a cache only saves time.
void write_cached(const std::string& name, const CachedResult& result);

} // namespace romascope
