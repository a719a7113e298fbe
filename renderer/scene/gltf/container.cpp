// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/container.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <limits>

namespace romascope::gltf {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr uint32_t kJson = 0x4e4f534a, kBin = 0x004e4942;

/// Little-endian, as every machine this program is built for.
uint32_t word(std::string_view bytes, size_t at) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

/// glTF 2.0, 4.4: a header of 12 bytes (magic, version, total length), then chunks of length, type
/// and bytes. All sums are of 32-bit numbers in size_t.
Container split_binary(std::string_view content) {
    if (content.size() < 20)
        refuse("GLB", fmt::format("ends after {} bytes, within its header", content.size()));
    if (word(content, 4) != 2)
        refuse("GLB", fmt::format("version {}, but 2 is needed", word(content, 4)));
    const size_t total = word(content, 8);
    if (total > content.size())
        refuse("GLB",
               fmt::format("says it has {} bytes, but the file has {}", total, content.size()));
    if (total < 20)
        refuse("GLB", fmt::format("says it has {} bytes, too few for a header", total));
    content = content.substr(0, total);
    Container parts;
    bool first = true;
    for (size_t at = 12; content.size() - at >= 8;) {
        const size_t length = word(content, at);
        const uint32_t type = word(content, at + 4);
        at += 8;
        if (length > content.size() - at)
            refuse("GLB", fmt::format("the chunk at byte {} says it has {} bytes, {} are left",
                                      at - 8, length, content.size() - at));
        const std::string_view bytes = content.substr(at, length);
        if (first != (type == kJson))
            refuse("GLB", first ? "its first chunk is not JSON" : "has more than one JSON chunk");
        if (type == kJson) {
            parts.json = bytes;
        } else if (type == kBin) {
            if (parts.binary)
                refuse("GLB", "has more than one BIN chunk");
            parts.binary = std::as_bytes(std::span(bytes));
        }
        first = false;
        at += length;
    }
    return parts;
}

} // namespace

Container split_container(std::string_view content) {
    if (content.size() > std::numeric_limits<uint32_t>::max())
        refuse("content", "larger than 4 GiB");
    if (content.starts_with("glTF"))
        return split_binary(content);
    if (content.starts_with(kByteOrderMark))
        content.remove_prefix(kByteOrderMark.size());
    const size_t start = content.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || content[start] != '{')
        refuse("content", "not a glTF 2.0 file (.glb or .gltf)");
    return {content, std::nullopt};
}

} // namespace romascope::gltf
