// SPDX-License-Identifier: MIT
#include "renderer/reference/surfaces.h"

#include "renderer/scene/surface_mask.h"

namespace romascope {
namespace {

constexpr uint32_t kNoMask = ~0u;

} // namespace

ReferenceSurfaces::ReferenceSurfaces(const Scene& scene) : materials_(scene.materials) {
    textures_.resize(scene.textures.size());
    for (const Material& material : materials_)
        if (material.alpha_cutoff > 0.0f && material.texture >= 0) {
            const auto index = static_cast<size_t>(material.texture);
            textures_[index] = scene.textures[index];
        }
    double_sided_.resize(scene.triangle_count());
    for (const TriangleGroup& group : triangle_groups(scene)) {
        all_double_sided_ = all_double_sided_ && group.double_sided;
        for (size_t triangle = group.first; triangle < group.first + group.count; ++triangle) {
            double_sided_[triangle] = group.double_sided;
            if (!group.masked)
                continue;
            slot_.resize(scene.triangle_count(), kNoMask);
            slot_[triangle] = static_cast<uint32_t>(masked_.size());
            Masked& masked = masked_.emplace_back();
            for (size_t corner = 0; corner < 3; ++corner) {
                const uint32_t vertex = scene.indices[3 * triangle + corner];
                masked.material = scene.vertex_material[vertex];
                if (!scene.texcoords.empty())
                    masked.texcoords[corner] = scene.texcoords[vertex];
                if (!scene.colors.empty())
                    masked.alphas[corner] = static_cast<float>(scene.colors[vertex] >> 24) / 255.0f;
            }
        }
    }
}

bool ReferenceSurfaces::is_there(uint32_t triangle, float u, float v) const {
    if (slot_.empty() || slot_[triangle] == kNoMask)
        return true;
    const Masked& masked = masked_[slot_[triangle]];
    const Material& material = materials_[masked.material];
    const float w = 1.0f - u - v;
    const auto& at = masked.texcoords;
    return surface_is_there(
        material,
        material.texture < 0 ? nullptr : &textures_[static_cast<size_t>(material.texture)],
        w * at[0] + u * at[1] + v * at[2],
        w * masked.alphas[0] + u * masked.alphas[1] + v * masked.alphas[2]);
}

} // namespace romascope
