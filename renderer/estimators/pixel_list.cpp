// SPDX-License-Identifier: MIT
#include "renderer/estimators/pixel_list.h"

#include "shaders/estimators/pixel_list.h"

namespace romascope {

void PixelList::begin(glm::ivec2 size) {
    const glm::ivec3 extent(size, 1);
    if (pixels_.size() != extent)
        pixels_ = Texture("list of pixels", GL_TEXTURE_2D, GL_R32UI, extent);
    constexpr gpu::PixelListHead kEmpty{gpu::kListGroupsInX, 0, 1, 0};
    const std::span head(&kEmpty, 1);
    if (head_.bytes() == 0)
        head_ = Buffer::from("head of the list of pixels", head);
    else
        head_.upload(std::as_bytes(head));
}

void PixelList::bind_to_fill() const {
    head_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    pixels_.bind_image(2, GL_WRITE_ONLY);
}

void PixelList::dispatch() const {
    head_.bind(GL_SHADER_STORAGE_BUFFER, 2);
    pixels_.bind(2);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, head_.id());
    glDispatchComputeIndirect(0);
}

} // namespace romascope
