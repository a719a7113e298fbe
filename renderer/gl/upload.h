// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"

#include <span>
#include <string>

namespace romascope {

/// Gives a buffer new contents, and a new size where that changes.
template <class T>
void upload_or_replace(Buffer& buffer, const std::string& label, std::span<const T> data) {
    if (buffer.bytes() != data.size_bytes())
        buffer = Buffer::from(label, data);
    else
        buffer.upload(std::as_bytes(data));
}

} // namespace romascope
