// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/json_text.h"

#include "renderer/scene/gltf/message.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace romascope::gltf {
namespace {

/// glTF's own objects nest less than 16 deep; extras may go further.
constexpr int kMaxDepth = 128;

/// Upper bounds of what nlohmann::json needs, in bytes, with the spare room of growing vectors.
constexpr size_t kPerElement = 48, kPerMember = 128, kPerContainer = 96;

} // namespace

JsonSize measure_json(std::string_view text) {
    JsonSize size;
    size.bytes = text.size(); // strings
    int depth = 0;
    bool in_string = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
            continue;
        }
        switch (c) {
        case '"':
            in_string = true;
            break;
        case '{':
        case '[':
            if (++depth > kMaxDepth)
                refuse("JSON", fmt::format("nested deeper than {} levels", kMaxDepth));
            size.objects += c == '{';
            size.bytes += kPerContainer;
            break;
        case '}':
        case ']':
            --depth;
            break;
        case ',':
            size.bytes += kPerElement;
            break;
        case ':':
            size.bytes += kPerMember;
            break;
        default:
            break;
        }
    }
    return size;
}

nlohmann::json parse_json(std::string_view text) {
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& exception) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
        const std::string_view what = exception.what();
        const size_t tag = what.find("] ");
        refuse("JSON", std::string(tag == std::string_view::npos ? what : what.substr(tag + 2)));
    }
}

} // namespace romascope::gltf
