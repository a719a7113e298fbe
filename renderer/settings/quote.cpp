// SPDX-License-Identifier: MIT
#include "renderer/settings/quote.h"

#include <algorithm>
#include <cstdint>

namespace romascope {

std::string quote(std::string_view text) {
    constexpr size_t kLongest = 80;
    std::string quoted(text.substr(0, kLongest));
    if (quoted.size() < text.size()) {
        // Do not cut a character of several bytes in two.
        while (!quoted.empty() && (static_cast<unsigned char>(text[quoted.size()]) & 0xC0) == 0x80)
            quoted.pop_back();
        quoted += "...";
    }
    std::replace_if(
        quoted.begin(), quoted.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return "'" + quoted + "'";
}

bool is_utf8(std::string_view text) {
    for (size_t i = 0; i < text.size();) {
        const auto byte = [&](size_t k) -> uint32_t {
            return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
        };
        const uint32_t first = byte(0);
        const size_t length = first < 0x80            ? 1
                              : (first >> 5) == 0x06u ? 2
                              : (first >> 4) == 0x0Eu ? 3
                              : (first >> 3) == 0x1Eu ? 4
                                                      : 0;
        if (length == 0)
            return false;
        uint32_t code = length == 1 ? first : first & (0x7Fu >> length);
        for (size_t k = 1; k < length; ++k) {
            if ((byte(k) & 0xC0u) != 0x80u)
                return false;
            code = code << 6 | (byte(k) & 0x3Fu);
        }
        constexpr uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
        if (code < kSmallest[length] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF))
            return false;
        i += length;
    }
    return true;
}

} // namespace romascope
