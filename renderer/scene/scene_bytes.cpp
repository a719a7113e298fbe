// SPDX-License-Identifier: MIT
#include "renderer/scene/scene_bytes.h"

namespace romascope {
namespace {

template <class... T>
size_t bytes_of(const std::vector<T>&... arrays) {
    return ((arrays.size() * sizeof(T)) + ...);
}

size_t motion_bytes(const Motion& motion) {
    size_t bytes = bytes_of(motion.nodes, motion.weights, motion.skins, motion.animations,
                            motion.parts, motion.rest_positions, motion.rest_normals,
                            motion.influences, motion.deltas, motion.cameras, motion.lights);
    for (const Skin& skin : motion.skins)
        bytes += bytes_of(skin.joints, skin.inverse_bind);
    for (const Animation& animation : motion.animations) {
        bytes += bytes_of(animation.channels);
        for (const MotionChannel& channel : animation.channels)
            bytes += bytes_of(channel.times, channel.values);
    }
    return bytes;
}

} // namespace

size_t scene_bytes(const Scene& scene) {
    size_t bytes = bytes_of(scene.positions, scene.normals, scene.texcoords, scene.colors,
                            scene.vertex_material, scene.indices, scene.materials, scene.textures,
                            scene.lights, scene.cameras);
    for (const SurfaceTexture& texture : scene.textures)
        bytes += bytes_of(texture.texels);
    return bytes + motion_bytes(scene.motion);
}

} // namespace romascope
