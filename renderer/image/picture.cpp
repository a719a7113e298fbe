// SPDX-License-Identifier: MIT
#include "renderer/image/picture.h"

#include "renderer/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cstring>
#include <memory>
#include <optional>

#include <stb/stb_image.h>

namespace romascope {
namespace {

struct FreePixels {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// Deflate codes 258 bytes in 2 bits at best.
constexpr size_t kLargestInflation = 1032;
/// Eight by eight pixels of a JPEG take at least one bit in some scan.
constexpr size_t kMostJpegPixelsPerByte = 512;
/// Progressive JPEGs have about ten; each is a pass over all pixels, however few bytes it has.
constexpr int kMostJpegScans = 100;

/// The data of a PNG's IDAT chunks, which are one compressed stream; none if a chunk is not whole.
std::optional<std::vector<std::string_view>> png_stream(std::string_view bytes) {
    std::vector<std::string_view> parts;
    for (size_t at = 8; bytes.size() - at >= 12;) { // length, name, data, checksum
        size_t length = 0;
        for (size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
        const std::string_view name = bytes.substr(at + 4, 4);
        if (length > bytes.size() - at - 12)
            return std::nullopt;
        if (name == "IDAT")
            parts.push_back(bytes.substr(at + 8, length));
        if (name == "IEND")
            return parts;
        at += 12 + length;
    }
    return std::nullopt;
}

/// Whether the stream inflates to `most` bytes or less.
bool inflates_to(const std::vector<std::string_view>& parts, size_t most) {
    if (most > INT_MAX)
        return false;
    std::string stream;
    for (const std::string_view part : parts)
        stream += part;
    const std::unique_ptr<char[]> room(new char[most]);
    return stbi_zlib_decode_buffer(room.get(), static_cast<int>(most), stream.data(),
                                   static_cast<int>(stream.size())) >= 0;
}

/// Start-of-scan markers. Within coded data 0xFF is followed by 0 or a restart marker.
int jpeg_scans(std::string_view bytes) {
    int count = 0;
    for (size_t at = bytes.find("\xff\xda"); at != bytes.npos; at = bytes.find("\xff\xda", at + 2))
        ++count;
    return count;
}

} // namespace

PictureFormat picture_format(std::string_view bytes) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n"))
        return PictureFormat::png;
    if (bytes.starts_with("\xff\xd8\xff"))
        return PictureFormat::jpeg;
    if (bytes.starts_with("#?RADIANCE\n") || bytes.starts_with("#?RGBE\n"))
        return PictureFormat::hdr;
    return PictureFormat::unknown;
}

bool jpeg_has_end(std::string_view bytes) { return bytes.rfind("\xff\xd9") != bytes.npos; }

Picture decode_picture(std::span<const std::byte> raw, const std::string& what,
                       MemoryBudget& budget) {
    const std::string_view bytes(reinterpret_cast<const char*>(raw.data()), raw.size());
    const auto fail = [&](const std::string& why) {
        return Error(fmt::format("{}: {}", what, why), kBadInput);
    };
    const auto damaged = [&](const std::string& why) {
        return fail(fmt::format("the picture is cut off or damaged ({})", why));
    };
    const PictureFormat format = picture_format(bytes);
    if (format != PictureFormat::png && format != PictureFormat::jpeg)
        throw fail(bytes.empty() ? "the picture is empty" : "not a PNG or JPEG picture");
    if (bytes.size() > INT_MAX)
        throw fail("the picture's file is larger than 2 GiB");

    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Picture picture;
    int channels = 0;
    if (!stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels))
        throw damaged(stbi_failure_reason());
    if (picture.width < 1 || picture.height < 1)
        throw damaged("no pixels");
    if (picture.width > kMaxPictureSide || picture.height > kMaxPictureSide)
        throw fail(fmt::format("a picture of {} x {} pixels, at most {} a side are possible",
                               picture.width, picture.height, kMaxPictureSide));
    const size_t pixels = static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height);

    size_t besides = 0; // bytes that decoding takes for a while
    if (format == PictureFormat::png) {
        const auto stream = png_stream(bytes);
        if (!stream)
            throw damaged("a chunk is not whole");
        size_t compressed = 0;
        for (const std::string_view part : *stream)
            compressed += part.size();
        if (pixels / 8 > compressed * kLargestInflation) // a pixel is at least one bit
            throw damaged("pixels are missing");
        // Filtered rows, the same without filters, and in four channels of 8 bits.
        const size_t wide = stbi_is_16_bit_from_memory(data, size) ? 2 : 1;
        const size_t plain = pixels * static_cast<size_t>(channels) * wide;
        const size_t rows = plain + 8 * static_cast<size_t>(picture.height) + 64;
        besides = compressed + rows + plain + pixels * 4;
        budget.take(1, besides, what);
        // stb_image inflates whatever comes. Where that could be more than there is, see first.
        const size_t most = std::min(compressed * kLargestInflation, size_t{UINT_MAX});
        if (most > budget.limit() - budget.taken() && !inflates_to(*stream, rows))
            throw damaged("its stream is not what its size says");
    } else {
        if (!jpeg_has_end(bytes))
            throw damaged("no end marker");
        if (pixels > bytes.size() * kMostJpegPixelsPerByte)
            throw damaged("pixels are missing");
        if (jpeg_scans(bytes) > kMostJpegScans)
            throw fail(fmt::format("a JPEG of more than {} scans", kMostJpegScans));
        // Coefficients in 16 bits and samples in 8 of up to four components, sides rounded up to
        // whole blocks, and the picture.
        const size_t padded =
            (static_cast<size_t>(picture.width) + 64) * (static_cast<size_t>(picture.height) + 64);
        besides = padded * 12 + pixels * 4;
        budget.take(1, besides, what);
    }
    budget.take(pixels, sizeof(uint32_t), what);

    int width = 0, height = 0;
    const std::unique_ptr<stbi_uc, FreePixels> decoded(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4));
    if (!decoded)
        throw damaged(stbi_failure_reason());
    if (width != picture.width || height != picture.height)
        throw damaged("two sizes");
    picture.texels.resize(pixels);
    std::memcpy(picture.texels.data(), decoded.get(), pixels * sizeof(uint32_t));
    budget.give(besides);
    return picture;
}

} // namespace romascope
