// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/draco_header.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace romascope::gltf {
namespace {

class Reader {
public:
    Reader(std::span<const std::byte> bytes, const std::string& element)
        : bytes_(bytes), element_(element) {}

    std::span<const std::byte> take(size_t count) {
        if (count > bytes_.size())
            refuse(element_, "its Draco data is cut off");
        const auto taken = bytes_.first(count);
        bytes_ = bytes_.subspan(count);
        return taken;
    }

    template <class T>
    T number() {
        T value;
        std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
        return value;
    }

    /// Seven bits a byte, least significant first, as long as the highest bit is set.
    uint32_t varint() {
        uint64_t value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            const auto byte = number<uint8_t>();
            value |= uint64_t{byte & 0x7fu} << shift;
            if (!(byte & 0x80))
                break;
        }
        if (value > UINT32_MAX)
            refuse(element_, "a number in its Draco data is too large");
        return static_cast<uint32_t>(value);
    }

    void skip_name() { take(number<uint8_t>()); }

private:
    std::span<const std::byte> bytes_;
    const std::string& element_;
};

/// A tree of named entries for each attribute that has some, and one for the mesh. Sub-trees
/// follow their parent, so that counting those to come is enough.
void skip_metadata(Reader& reader) {
    const uint32_t attributes = reader.varint();
    for (uint64_t i = 0; i <= attributes; ++i) {
        if (i < attributes)
            reader.varint(); // the attribute's number
        bool named = false;
        for (uint64_t trees = 1; trees > 0; --trees) {
            if (named)
                reader.skip_name();
            named = true;
            for (uint32_t entries = reader.varint(); entries > 0; --entries) {
                reader.skip_name();
                reader.take(reader.varint());
            }
            trees += reader.varint();
        }
    }
}

} // namespace

DracoHeader read_draco_header(std::span<const std::byte> bytes, const std::string& element) {
    constexpr uint16_t kHasMetadata = 0x8000;
    constexpr uint8_t kTriangleMesh = 1, kSequential = 0, kEdgebreaker = 1;

    Reader reader(bytes, element);
    const auto magic = reader.take(5);
    if (std::memcmp(magic.data(), "DRACO", 5) != 0)
        refuse(element, "is not Draco data");
    const auto major = reader.number<uint8_t>();
    const auto minor = reader.number<uint8_t>();
    const int version = 256 * major + minor;
    if (major < 1 || major > 2)
        refuse(element, fmt::format("Draco bitstream {}.{} is not supported", major, minor));
    const auto type = reader.number<uint8_t>();
    const auto method = reader.number<uint8_t>();
    if (type != kTriangleMesh || method > kEdgebreaker)
        refuse(element, "its Draco data is not a triangle mesh");
    if (reader.number<uint16_t>() & kHasMetadata && version >= 0x103)
        skip_metadata(reader);

    DracoHeader header;
    if (method == kSequential) {
        const bool fixed = version < 0x202;
        header.faces = fixed ? reader.number<uint32_t>() : reader.varint();
        header.vertices = fixed ? reader.number<uint32_t>() : reader.varint();
        return header;
    }
    const bool fixed = version < 0x200;
    const auto count = [&] { return fixed ? reader.number<uint32_t>() : reader.varint(); };
    reader.number<uint8_t>(); // kind of traversal
    if (version < 0x202)
        count(); // vertices that the decoder adds
    header.vertices = count();
    header.faces = count();
    header.seamed = reader.number<uint8_t>();
    const size_t symbols = count();
    const size_t splits = count();
    if (symbols > header.faces || splits > symbols || header.vertices > 3 * header.faces)
        refuse(element, "the counts in its Draco data contradict each other");
    return header;
}

} // namespace romascope::gltf
