// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/material.h"

#include "renderer/scene/gltf/numbers.h"
#include "renderer/scene/gltf/texture.h"

#include <tiny_gltf.h>

#include <algorithm>

namespace romascope::gltf {
namespace {

double number(const tinygltf::Value& object, const char* name, double fallback) {
    return object.Has(name) ? object.Get(name).GetNumberAsDouble() : fallback;
}

glm::dvec2 pair(const tinygltf::Value& object, const char* name, glm::dvec2 fallback) {
    if (!object.Has(name) || object.Get(name).ArrayLen() != 2)
        return fallback;
    return {object.Get(name).Get(0).GetNumberAsDouble(),
            object.Get(name).Get(1).GetNumberAsDouble()};
}

const tinygltf::Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

/// translation * rotation * scale of KHR_texture_transform; the rotation is counter-clockwise where
/// v points down.
glm::dmat3 texture_transform(const tinygltf::Value& transform) {
    const glm::dvec2 offset = pair(transform, "offset", glm::dvec2(0.0));
    const glm::dvec2 scale = pair(transform, "scale", glm::dvec2(1.0));
    const double angle = number(transform, "rotation", 0.0);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {glm::dvec3(c * scale.x, -s * scale.x, 0.0), glm::dvec3(s * scale.y, c * scale.y, 0.0),
            glm::dvec3(offset, 1.0)};
}

/// Whether some of a texture is more than half transparent.
bool has_holes(const SurfaceTexture& texture) {
    return std::ranges::any_of(texture.texels, [](uint32_t texel) { return texel >> 24 < 128; });
}

} // namespace

uint32_t Materials::use(int material) {
    const auto [found, fresh] =
        used_.try_emplace(material, static_cast<uint32_t>(scene_.materials.size()));
    if (fresh) {
        if (material < 0)
            scene_.materials.push_back({"default"});
        else
            scene_.materials.push_back(read(static_cast<size_t>(material)));
    }
    return found->second;
}

Materials::TextureKey Materials::key_of(int texture) const {
    const tinygltf::Model& model = document_.model();
    const tinygltf::Texture& source = model.textures[static_cast<size_t>(texture)];
    if (source.sampler < 0)
        return {source.source, TINYGLTF_TEXTURE_WRAP_REPEAT, TINYGLTF_TEXTURE_WRAP_REPEAT, -1};
    const tinygltf::Sampler& sampler = model.samplers[static_cast<size_t>(source.sampler)];
    return {source.source, sampler.wrapS, sampler.wrapT, sampler.magFilter};
}

int Materials::use_texture(int texture) {
    const auto [found, fresh] = textures_.try_emplace(key_of(texture), -1);
    if (!fresh)
        return found->second;
    auto read = read_texture(document_, texture, budget_);
    if (!read) {
        notices_.add(fmt::format("textures[{}]", texture),
                     "has no picture that can be read, and is left out");
        return -1;
    }
    found->second = static_cast<int>(scene_.textures.size());
    // Drawing makes smaller levels of it, and works on them as floats.
    budget_.take(read->texels.size(), 8, fmt::format("textures[{}]", texture));
    holes_.push_back(has_holes(*read));
    scene_.textures.push_back(std::move(*read));
    return found->second;
}

Material Materials::read(size_t index) {
    const tinygltf::Material& source = document_.model().materials[index];
    const auto& surface = source.pbrMetallicRoughness;
    const std::string element = fmt::format("materials[{}]", index);
    const glm::dvec4 base = numbers<4>(surface.baseColorFactor, glm::dvec4(1.0),
                                       element + ".pbrMetallicRoughness.baseColorFactor");
    glm::dvec3 emissive =
        numbers<3>(source.emissiveFactor, glm::dvec3(0.0), element + ".emissiveFactor");
    if (const auto* strength = extension(source.extensions, "KHR_materials_emissive_strength"))
        emissive *= number(*strength, "emissiveStrength", 1.0);
    Material material;
    material.name = source.name;
    material.base_color = glm::vec3(glm::clamp(glm::dvec3(base), 0.0, 1.0));
    material.alpha = static_cast<float>(std::clamp(base.w, 0.0, 1.0));
    material.emissive = glm::vec3(glm::clamp(emissive, 0.0, 1e30));
    material.double_sided = source.doubleSided;
    if (surface.baseColorTexture.index >= 0)
        material.texture = use_texture(surface.baseColorTexture.index);
    if (source.alphaMode == "MASK") {
        // No alpha is above 1, nor a threshold that takes everything below 0.
        material.alpha_cutoff = static_cast<float>(std::clamp(source.alphaCutoff, 0.0, 1.0));
        if (source.alphaCutoff > 1.0)
            material.alpha = 0.0f;
    } else if (source.alphaMode == "BLEND") {
        const bool holes = material.texture >= 0 && holes_[static_cast<size_t>(material.texture)];
        material.alpha = 1.0f; // glass with a picture on it is drawn, not left out
        if (holes)
            material.alpha_cutoff = 0.5f;
        notices_.add(element, holes ? "alphaMode BLEND is drawn as a mask at one half"
                                    : "alphaMode BLEND is drawn opaque");
    }
    return material;
}

TexcoordSource Materials::texcoords(int material) const {
    TexcoordSource source;
    if (material < 0)
        return source;
    const auto& texture = document_.model()
                              .materials[static_cast<size_t>(material)]
                              .pbrMetallicRoughness.baseColorTexture;
    if (texture.index < 0)
        return source;
    source.set = texture.texCoord;
    if (const auto* transform = extension(texture.extensions, "KHR_texture_transform")) {
        source.transform = texture_transform(*transform);
        source.set = static_cast<int>(number(*transform, "texCoord", source.set));
    }
    return source;
}

} // namespace romascope::gltf
