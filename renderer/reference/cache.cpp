// SPDX-License-Identifier: MIT
#include "renderer/reference/cache.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <cstring>
#include <new>

namespace romascope {
namespace fs = std::filesystem;
namespace {

/// First bytes of a file; the values and the checksum of all before it follow.
struct Header {
    char magic[8] = {'R', 'S', 'C', 'P', 'R', 'E', 'F', '1'};
    uint64_t count = 0;
    double seconds = 0.0;
};
using Checksum = XXH64_hash_t;

size_t file_size(size_t count) { return sizeof(Header) + count * sizeof(float) + sizeof(Checksum); }

} // namespace

CacheKey::CacheKey() : state_(XXH3_createState()) {
    if (!state_)
        throw std::bad_alloc();
    XXH3_128bits_reset(state_);
}

CacheKey::~CacheKey() { XXH3_freeState(state_); }

void CacheKey::add_bytes(const void* data, size_t size) {
    if (size > 0)
        XXH3_128bits_update(state_, data, size);
}

std::string CacheKey::name() const {
    const XXH128_hash_t digest = XXH3_128bits_digest(state_);
    return fmt::format("{:016x}{:016x}", digest.high64, digest.low64);
}

fs::path cache_path(const std::string& name) {
    return cache_directory() / "reference" / (name + ".bin");
}

std::optional<CachedResult> read_cached(const std::string& name, size_t count) try {
    const fs::path path = cache_path(name);
    std::error_code code;
    if (!fs::is_regular_file(path, code) || fs::file_size(path, code) != file_size(count) || code)
        return std::nullopt;
    const std::string bytes = read_text_file(path);
    if (bytes.size() != file_size(count))
        return std::nullopt;
    const size_t checked = bytes.size() - sizeof(Checksum);
    Checksum stored;
    std::memcpy(&stored, bytes.data() + checked, sizeof(stored));
    Header header;
    std::memcpy(&header, bytes.data(), sizeof(header));
    if (stored != XXH3_64bits(bytes.data(), checked) || header.count != count ||
        std::memcmp(header.magic, Header().magic, sizeof(header.magic)) != 0)
        return std::nullopt;
    CachedResult result;
    result.seconds = header.seconds;
    result.values.resize(count);
    std::memcpy(result.values.data(), bytes.data() + sizeof(header), count * sizeof(float));
    return result;
} catch (const Error&) {
    return std::nullopt;
}

void write_cached(const std::string& name, const CachedResult& result) try {
    std::string bytes(file_size(result.values.size()), '\0');
    Header header;
    header.count = result.values.size();
    header.seconds = result.seconds;
    std::memcpy(bytes.data(), &header, sizeof(header));
    std::memcpy(bytes.data() + sizeof(header), result.values.data(),
                result.values.size() * sizeof(float));
    const size_t checked = bytes.size() - sizeof(Checksum);
    const Checksum checksum = XXH3_64bits(bytes.data(), checked);
    std::memcpy(bytes.data() + checked, &checksum, sizeof(checksum));
    write_file_atomically(cache_path(name), bytes);
} catch (const Error&) {
    // Not writable, or full: the result is there all the same.
}

} // namespace romascope
