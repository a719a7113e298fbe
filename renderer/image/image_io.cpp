// SPDX-License-Identifier: MIT
#include "renderer/image/image_io.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/image/color.h"
#include "renderer/image/picture.h"

#include <algorithm>
#include <cctype>
#include <climits>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

namespace romascope {
namespace fs = std::filesystem;
namespace {

constexpr float kLargestRgbe = 0x1.FEp126f; // 255 * 2^119; stb's exponent byte wraps above it

std::string lower_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<size_t>(size));
}

std::string encode_png(const Image& image) {
    std::vector<uint8_t> pixels(image.data.size());
    std::transform(image.data.begin(), image.data.end(), pixels.begin(), encode_srgb8);
    std::string bytes;
    if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels,
                                pixels.data(), image.width * image.channels))
        bytes.clear();
    return bytes;
}

/// Rounds a pixel to what RGBE can hold. stb_image_write cuts off instead of rounding, which would
/// darken a picture by up to 1/128 and show up as bias; values that fit exactly pass unchanged.
void round_to_rgbe(float* rgb) {
    const auto step_below = [](float largest) {
        int exponent = 0;
        std::frexp(largest, &exponent);
        return std::ldexp(1.0f, std::max(exponent - 8, -126));
    };
    const auto round = [](float value, float step) {
        return std::min(std::floor(value / step + 0.5f) * step, kLargestRgbe);
    };
    const float largest = std::max({rgb[0], rgb[1], rgb[2]});
    // Rounding may bring the largest to the next power of two, where steps are twice as wide.
    const float step = step_below(round(largest, step_below(largest)));
    for (int c = 0; c < 3; ++c)
        rgb[c] = round(rgb[c], step);
}

std::string encode_hdr(const Image& image) {
    const size_t count = static_cast<size_t>(image.width) * image.height;
    std::vector<float> pixels(count * 3);
    for (size_t i = 0; i < count; ++i) {
        for (size_t c = 0; c < 3; ++c) {
            const float value = image.data[image.channels == 1 ? i : i * 3 + c];
            pixels[i * 3 + c] = value > 0 ? std::min(value, kLargestRgbe) : 0;
        }
        round_to_rgbe(&pixels[i * 3]);
    }
    std::string bytes;
    if (!stbi_write_hdr_to_func(append, &bytes, image.width, image.height, 3, pixels.data()))
        bytes.clear();
    return bytes;
}

/// Whether all pixels of a Radiance file are there. stb_image 2.27 never returns from a cut-off
/// run-length coded row, and takes missing plain pixels from uninitialised memory.
bool hdr_is_complete(std::string_view bytes, size_t width, size_t height) {
    const size_t header_end = bytes.find("\n\n");
    if (header_end == bytes.npos || bytes.find('\0') < header_end)
        return false;
    size_t at = bytes.find('\n', header_end + 2); // end of the line with the size
    if (at++ == bytes.npos)
        return false;
    const auto byte = [&](size_t i) {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u;
    };
    const auto run_length_coded = [&] {
        return byte(at) == 2 && byte(at + 1) == 2 && byte(at + 2) < 128;
    };
    if (width < 8 || width >= 32768 || !run_length_coded())
        return bytes.size() - at >= width * height * 4;
    for (size_t y = 0; y < height; ++y) {
        if (!run_length_coded())
            return false;
        at += 4;
        for (size_t filled = 0; filled < width * 4;) {
            const unsigned head = byte(at++);
            const unsigned count = head > 128 ? head - 128 : head;
            at += head > 128 ? 1 : count;
            filled += count;
            // A run of nothing (also: the end of the file), or one that leaves its channel.
            if (count == 0 || (filled - count) / width != (filled - 1) / width)
                return false;
        }
    }
    return at <= bytes.size();
}

struct FreePixels {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <class T>
using Pixels = std::unique_ptr<T, FreePixels>;

} // namespace

void check_image_extension(const fs::path& path) {
    const std::string extension = lower_extension(path);
    if (extension != ".png" && extension != ".hdr")
        throw Error("cannot write " + path.string() + ": its name must end in .png or .hdr",
                    kBadInput);
}

void write_image(const fs::path& path, const Image& image) {
    check_image_extension(path);
    if (image.width <= 0 || image.height <= 0 || (image.channels != 1 && image.channels != 3))
        throw Error("cannot write " + path.string() + ": an image of " +
                    std::to_string(image.width) + "x" + std::to_string(image.height) + " with " +
                    std::to_string(image.channels) + " channels");
    const std::string bytes =
        lower_extension(path) == ".png" ? encode_png(image) : encode_hdr(image);
    if (bytes.empty())
        throw Error("cannot write " + path.string() + ": the encoder ran out of memory");
    write_file_atomically(path, bytes);
}

Image read_image(const fs::path& path) {
    const std::string bytes = read_text_file(path);
    const auto fail = [&](const std::string& why) {
        return Error("cannot read " + path.string() + ": " + why, kBadInput);
    };
    const PictureFormat format = picture_format(bytes);
    if (format == PictureFormat::unknown)
        throw fail(bytes.empty() ? "the file is empty" : "not a .png, .jpg or .hdr picture");
    if (bytes.size() > INT_MAX)
        throw fail("the file is larger than 2 GiB");
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());

    int width = 0, height = 0, channels = 0;
    const auto damaged = [&] {
        return fail(std::string("cut off or damaged (") + stbi_failure_reason() + ")");
    };
    if (!stbi_info_from_memory(data, size, &width, &height, &channels))
        throw damaged();
    const int wanted = channels < 3 ? 1 : 3;
    Image image;
    const auto fill = [&](const auto* pixels, const auto& to_linear) {
        if (!pixels)
            throw damaged();
        image = Image(width, height, wanted);
        std::transform(pixels, pixels + image.data.size(), image.data.begin(), to_linear);
    };
    if (format == PictureFormat::hdr) {
        if (!hdr_is_complete(bytes, static_cast<size_t>(width), static_cast<size_t>(height)))
            throw fail("cut off or damaged (pixels are missing)");
        const Pixels<float> pixels(
            stbi_loadf_from_memory(data, size, &width, &height, &channels, wanted));
        fill(pixels.get(), [](float value) { return value; });
    } else if (stbi_is_16_bit_from_memory(data, size)) {
        const Pixels<stbi_us> pixels(
            stbi_load_16_from_memory(data, size, &width, &height, &channels, wanted));
        fill(pixels.get(), [](stbi_us value) { return decode_srgb(value / 65535.0f); });
    } else {
        if (format == PictureFormat::jpeg && !jpeg_has_end(bytes))
            throw fail("cut off or damaged (no end marker)");
        const Pixels<stbi_uc> pixels(
            stbi_load_from_memory(data, size, &width, &height, &channels, wanted));
        fill(pixels.get(), decode_srgb8);
    }
    return image;
}

} // namespace romascope
