// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/texture.h"

#include "renderer/image/picture.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace romascope::gltf {
namespace {

TextureWrap wrap_of(int code) {
    return code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? TextureWrap::clamp
           : code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror
                                                           : TextureWrap::repeat;
}

} // namespace

std::optional<SurfaceTexture> read_texture(const Document& document, int index,
                                           MemoryBudget& budget) {
    const tinygltf::Model& model = document.model();
    const tinygltf::Texture& source = model.textures.at(static_cast<size_t>(index));
    if (source.source < 0)
        return std::nullopt;
    SurfaceTexture texture;
    if (source.sampler >= 0) {
        const tinygltf::Sampler& sampler = model.samplers.at(static_cast<size_t>(source.sampler));
        texture.wrap_u = wrap_of(sampler.wrapS);
        texture.wrap_v = wrap_of(sampler.wrapT);
        texture.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    const std::vector<std::byte> encoded = document.image(source.source);
    Picture picture = decode_picture(encoded, fmt::format("images[{}]", source.source), budget);
    budget.give(encoded.size());
    texture.size = {picture.width, picture.height};
    texture.texels = std::move(picture.texels);
    return texture;
}

} // namespace romascope::gltf
