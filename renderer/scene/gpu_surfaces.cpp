// SPDX-License-Identifier: MIT
#include "renderer/scene/gpu_surfaces.h"

#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/scene/mip_chain.h"
#include "renderer/scene/surface_mask.h"
#include "shaders/common/surface_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace romascope {
namespace {

size_t texel_limit() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return std::min(static_cast<size_t>(bytes) / sizeof(uint32_t),
                    size_t{std::numeric_limits<uint32_t>::max()});
}

Buffer upload_texels(const Scene& scene, const std::vector<TexturePlace>& places) {
    size_t count = 0;
    for (size_t i = 0; i < places.size(); ++i)
        if (places[i].levels > 0)
            count += texels_from_level(scene.textures[i].size, places[i].first_level);
    Buffer buffer("texels", count * sizeof(uint32_t));
    for (size_t i = 0; i < places.size(); ++i) {
        const SurfaceTexture& texture = scene.textures[i];
        if (places[i].levels == 0)
            continue;
        std::vector<uint32_t> smaller =
            smaller_levels(texture.size, texture.texels, places[i].masks);
        const size_t at = places[i].first_texel * sizeof(uint32_t);
        if (places[i].first_level == 0) {
            buffer.upload(std::as_bytes(std::span(texture.texels)), at);
            buffer.upload(std::as_bytes(std::span(smaller)), at + texture.texels.size() * 4);
        } else {
            const size_t kept = texels_from_level(texture.size, places[i].first_level);
            buffer.upload(std::as_bytes(std::span(smaller).last(kept)), at);
        }
    }
    return buffer;
}

Buffer upload_materials(const Scene& scene, const std::vector<TexturePlace>& places) {
    std::vector<gpu::MaterialRecord> records;
    for (const Material& material : scene.materials) {
        gpu::MaterialRecord record{};
        record.base_color = glm::vec4(material.base_color, material.alpha);
        record.emissive = glm::vec4(material.emissive, material.alpha_cutoff);
        if (material.texture >= 0) {
            const auto index = static_cast<size_t>(material.texture);
            const SurfaceTexture& texture = scene.textures[index];
            const glm::ivec2 size = gpu::level_size(texture.size, places[index].first_level);
            record.first_texel = places[index].first_texel;
            record.texture_size = static_cast<uint32_t>(size.x) | static_cast<uint32_t>(size.y)
                                                                      << 16;
            record.texture_rules = texture_rules(texture, places[index].levels);
        }
        records.push_back(record);
    }
    return Buffer::from("materials", std::span<const gpu::MaterialRecord>(records));
}

} // namespace

std::vector<TexturePlace> place_textures(const Scene& scene, size_t limit) {
    std::vector<TexturePlace> places(scene.textures.size());
    for (const Material& material : scene.materials) {
        if (material.texture < 0)
            continue;
        const auto index = static_cast<size_t>(material.texture);
        places[index].levels = level_count(scene.textures[index].size);
        places[index].masks = places[index].masks || material.alpha_cutoff > 0.0f;
    }
    const auto texels_of = [&](size_t i) {
        return places[i].levels == 0
                   ? size_t{0}
                   : texels_from_level(scene.textures[i].size, places[i].first_level);
    };
    size_t sum = 0;
    for (size_t i = 0; i < places.size(); ++i)
        sum += texels_of(i);
    const size_t whole = sum;
    while (sum > limit) {
        size_t largest = places.size();
        for (size_t i = 0; i < places.size(); ++i)
            if (!places[i].masks && places[i].levels > 1 &&
                (largest == places.size() || texels_of(i) > texels_of(largest)))
                largest = i;
        if (largest == places.size())
            throw Error(fmt::format("the scene's textures take {}, this driver holds {} in one "
                                    "buffer; make them smaller",
                                    format_bytes(whole * 4), format_bytes(limit * 4)));
        sum -= texels_of(largest);
        ++places[largest].first_level;
        --places[largest].levels;
        sum += texels_of(largest);
    }
    size_t next = 0;
    for (size_t i = 0; i < places.size(); ++i) {
        places[i].first_texel = static_cast<uint32_t>(next);
        next += texels_of(i);
    }
    return places;
}

GpuSurfaces::GpuSurfaces(const Scene& scene) {
    const std::vector<TexturePlace> places = place_textures(scene, texel_limit());
    materials_ = upload_materials(scene, places);
    texels_ = upload_texels(scene, places);
}

void GpuSurfaces::bind() const {
    materials_.bind(GL_SHADER_STORAGE_BUFFER, 0);
    texels_.bind(GL_SHADER_STORAGE_BUFFER, 1);
}

} // namespace romascope
