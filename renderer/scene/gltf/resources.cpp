// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/resources.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <span>

namespace romascope::gltf {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kData = "data:";

int hex_digit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    const int letter = std::tolower(static_cast<unsigned char>(c));
    return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

constexpr std::array<signed char, 256> base64_values() {
    std::array<signed char, 256> values{};
    values.fill(-1);
    const std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < digits.size(); ++i)
        values[static_cast<unsigned char>(digits[i])] = static_cast<signed char>(i);
    return values;
}

/// RFC 4648, 4; the padding may be missing.
std::vector<std::byte> decode_base64(std::string_view text, const std::string& element) {
    static constexpr auto kValues = base64_values();
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding)
        text.remove_suffix(1);
    if (text.size() % 4 == 1)
        refuse(element, "its base64 data is cut off");
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    uint32_t bits = 0;
    int count = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        const signed char value = kValues[static_cast<unsigned char>(text[i])];
        if (value < 0)
            refuse(element, fmt::format("character {} of its data is no base64", i));
        bits = bits << 6 | static_cast<uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> count & 0xff));
        }
    }
    return bytes;
}

/// RFC 2397: data:[type][;parameters][;base64],data
std::vector<std::byte> decode_data_uri(std::string_view uri, MemoryBudget& budget,
                                       const std::string& element) {
    const size_t comma = uri.find(',');
    if (comma == std::string_view::npos)
        refuse(element, "a data URI without a comma");
    const bool base64 = uri.substr(0, comma).ends_with(";base64");
    std::string_view data = uri.substr(comma + 1);
    std::string decoded;
    if (!base64 || data.find('%') != std::string_view::npos) {
        budget.take(data.size(), 1, element);
        decoded = percent_decoded(data);
        data = decoded;
        budget.give(data.size());
    }
    budget.take(base64 ? data.size() / 4 * 3 + 2 : data.size(), 1, element);
    if (base64)
        return decode_base64(data, element);
    const auto bytes = std::as_bytes(std::span(data));
    return {bytes.begin(), bytes.end()};
}

/// RFC 3986, 3.1: a scheme is a letter and then letters, digits, "+", "-" or ".", and a colon.
bool has_scheme(std::string_view uri) {
    const size_t end = uri.find_first_of(":/?#");
    return end != std::string_view::npos && end > 0 && uri[end] == ':' &&
           std::isalpha(static_cast<unsigned char>(uri[0])) &&
           std::ranges::all_of(uri.substr(0, end), [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' ||
                      c == '.';
           });
}

bool inside(const fs::path& folder, const fs::path& file) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

} // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with(kData); }

std::string percent_decoded(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        const bool coded = text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 &&
                           hex_digit(text[i + 2]) >= 0;
        decoded += coded ? static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2]))
                         : text[i];
        i += coded ? 2 : 0;
    }
    return decoded;
}

Resources::Resources(const fs::path& asset)
    : folder_(fs::weakly_canonical(asset.has_parent_path() ? asset.parent_path() : fs::path("."))) {
}

/// The file that `uri` names. Names that were not encoded as they ought to are tried as they are.
fs::path Resources::file(const std::string& uri, const std::string& element) const {
    if (has_scheme(uri))
        refuse(element, fmt::format("'{}' is no relative path; only files in the folder of the "
                                    "asset are read",
                                    uri));
    std::string missing;
    for (const std::string& name : {percent_decoded(uri), uri}) {
        if (name.empty() || name.find('\0') != std::string::npos)
            refuse(element, fmt::format("'{}' is no path", uri));
        if (fs::path(name).is_absolute())
            refuse(element, fmt::format("'{}' is an absolute path; only files in the folder of the "
                                        "asset are read",
                                        name));
        std::error_code code;
        const fs::path real = fs::weakly_canonical(folder_ / name, code);
        if (code)
            refuse(element, fmt::format("'{}' cannot be read: {}", name, code.message()));
        if (!inside(folder_, real))
            refuse(element, fmt::format("'{}' lies outside the folder of the asset", name));
        if (fs::is_regular_file(real, code))
            return real;
        if (fs::exists(real, code))
            refuse(element, fmt::format("'{}' is not a plain file", name));
    }
    refuse(element, fmt::format("there is no file '{}' beside the asset", percent_decoded(uri)));
}

std::vector<std::byte> Resources::read(const std::string& uri, std::optional<size_t> size,
                                       MemoryBudget& budget, const std::string& element) const {
    if (is_data_uri(uri)) {
        auto bytes = decode_data_uri(uri, budget, element);
        if (size && bytes.size() < *size)
            refuse(element, fmt::format("holds {} bytes instead of {}", bytes.size(), *size));
        return bytes;
    }
    const fs::path path = file(uri, element);
    std::error_code code;
    const auto there = fs::file_size(path, code);
    if (code)
        refuse(element, fmt::format("'{}' cannot be read: {}", uri, code.message()));
    if (size && there < *size)
        refuse(element, fmt::format("'{}' has {} bytes instead of {}", uri, there, *size));
    const size_t count = size.value_or(there);
    budget.take(count, 1, element);
    std::vector<std::byte> bytes(count);
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    if (!in || static_cast<size_t>(in.gcount()) != count)
        refuse(element, fmt::format("'{}' cannot be read", uri));
    return bytes;
}

} // namespace romascope::gltf
