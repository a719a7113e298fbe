// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/message.h"

#include "renderer/base/error.h"

namespace romascope::gltf {

void refuse(const std::string& element, const std::string& reason) {
    throw Error(one_line(element + ": " + reason), kBadInput);
}

std::string one_line(const std::string& text) {
    constexpr size_t kLongest = 400;
    std::string line;
    for (const char c : text.substr(0, text.find_last_not_of(" \n\r") + 1))
        line += c == '\n' ? ';' : static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
    if (line.size() <= kLongest)
        return line;
    size_t end = kLongest; // not in the middle of a character of UTF-8
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80)
        --end;
    return line.substr(0, end) + " ...";
}

} // namespace romascope::gltf
