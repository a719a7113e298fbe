// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"

namespace romascope {

/// Pixels for estimators to trace at, listed on the GPU. The host's side of
/// shaders/estimators/pixel_list.h and of the two files that fill the list and go over it.
class PixelList {
public:
    /// Empty, with room for all pixels of a picture.
    void begin(glm::ivec2 size);
    /// Binds what list_pixels.glsl needs: storage block 2, image unit 2. Whoever filled the list
    /// waits for texture fetches, storage and commands before it is gone over.
    void bind_to_fill() const;
    /// Runs the program in use, which includes listed_pixels.glsl, over the list: binds storage
    /// block 2 and texture unit 2.
    void dispatch() const;

    static constexpr size_t kBytesPerPixel = 4;
    size_t bytes() const { return head_.bytes() + pixels_.bytes(); }

private:
    Buffer head_;    ///< gpu::PixelListHead
    Texture pixels_; ///< R32UI
};

} // namespace romascope
