// SPDX-License-Identifier: MIT
#include "tests/fuzz/gltf_parts.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace romascope::fuzz {
namespace {

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view kDataUri = "data:application/octet-stream;base64,";
constexpr uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t u32(std::string_view bytes, size_t at) {
    uint32_t value;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return value;
}

void add_u32(std::string& out, size_t value) {
    const auto word = static_cast<uint32_t>(value);
    out.append(reinterpret_cast<const char*>(&word), sizeof(word));
}

/// Braces in strings count too, which only means that such a file is left alone.
bool too_deep(std::string_view text) {
    int depth = 0;
    for (const char c : text) {
        depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
        if (depth > kMaxDepth)
            return true;
    }
    return false;
}

nlohmann::json* first_buffer(nlohmann::json& json) {
    const auto buffers = json.find("buffers");
    if (buffers == json.end() || !buffers->is_array() || buffers->empty() ||
        !buffers->front().is_object())
        return nullptr;
    return &buffers->front();
}

std::string chunk(std::string bytes, uint32_t kind, char padding) {
    bytes.resize((bytes.size() + 3) / 4 * 4, padding);
    std::string out;
    add_u32(out, bytes.size());
    add_u32(out, kind);
    return out + bytes;
}

} // namespace

std::string to_base64(std::string_view bytes) {
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t word = 0;
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        for (size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += k <= count ? kAlphabet[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string from_base64(std::string_view text) {
    std::string bytes;
    uint32_t word = 0;
    int bits = 0;
    for (const char c : text) {
        const size_t digit = kAlphabet.find(c);
        if (digit == std::string_view::npos)
            break;
        word = word << 6 | static_cast<uint32_t>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(word >> bits & 255);
        }
    }
    return bytes;
}

std::optional<GltfParts> take_apart(std::string_view file) {
    GltfParts parts;
    std::string_view text = file;
    if (file.size() >= kHeader + kChunkHeader && u32(file, 0) == kMagic) {
        parts.glb = true;
        const size_t start = kHeader + kChunkHeader;
        text = file.substr(start, u32(file, kHeader));
        const size_t next = start + text.size();
        if (file.size() >= next + kChunkHeader && u32(file, next + 4) == kBinChunk) {
            parts.has_bin = true;
            parts.bin = file.substr(next + kChunkHeader, u32(file, next));
        }
    }
    if (too_deep(text))
        return {};
    parts.json = nlohmann::json::parse(text, nullptr, false);
    if (!parts.json.is_object())
        return {};
    nlohmann::json* buffer = first_buffer(parts.json);
    if (!parts.glb && buffer && buffer->contains("uri") && (*buffer)["uri"].is_string()) {
        const std::string uri = (*buffer)["uri"];
        if (uri.starts_with(kDataUri)) {
            parts.has_bin = true;
            parts.bin = from_base64(std::string_view(uri).substr(kDataUri.size()));
            buffer->erase("uri");
        }
    }
    return parts;
}

std::string put_together(GltfParts parts, bool fit_buffer) {
    if (nlohmann::json* buffer = first_buffer(parts.json); buffer && parts.has_bin) {
        if (fit_buffer)
            (*buffer)["byteLength"] = parts.bin.size();
        if (!parts.glb) {
            std::string uri(kDataUri);
            uri += to_base64(parts.bin);
            (*buffer)["uri"] = uri;
        }
    }
    std::string text = parts.json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (!parts.glb)
        return text;
    std::string chunks = chunk(std::move(text), kJsonChunk, ' ');
    if (parts.has_bin)
        chunks += chunk(std::move(parts.bin), kBinChunk, '\0');
    std::string file;
    add_u32(file, kMagic);
    add_u32(file, 2);
    add_u32(file, kHeader + chunks.size());
    return file + chunks;
}

} // namespace romascope::fuzz
