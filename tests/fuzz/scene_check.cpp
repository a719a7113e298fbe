// SPDX-License-Identifier: MIT
#include "tests/fuzz/scene_check.h"

#include "renderer/base/error.h"
#include "renderer/scene/pose.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace romascope::fuzz {
namespace {

struct Broken : std::logic_error {
    using std::logic_error::logic_error;
};

template <class... Values>
void demand(bool kept, fmt::format_string<const Values&...> promise, const Values&... values) {
    if (!kept)
        throw Broken(fmt::format(promise, values...));
}

template <int N, class T>
bool finite(const glm::vec<N, T>& v) {
    for (int i = 0; i < N; ++i)
        if (!std::isfinite(v[i]))
            return false;
    return true;
}

bool finite(const glm::dmat4& m) {
    return finite(m[0]) && finite(m[1]) && finite(m[2]) && finite(m[3]);
}

bool finite(const std::vector<float>& values) {
    return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

template <class Vector>
bool unit(const Vector& v) {
    return std::abs(glm::length(v) - 1) < 1e-3f;
}

bool within(float value, float low, float high) { return value >= low && value <= high; }

void check_bounds(const Scene& scene, const Bounds& bounds, const char* whose) {
    demand(finite(bounds.min) && finite(bounds.max), "bounds {} are finite", whose);
    // Sums of single precision, in another order than those of the vertices.
    const glm::vec3 slack =
        1e-4f * (glm::abs(bounds.min) + glm::abs(bounds.max) + bounds.extent()) + 1e-30f;
    for (const uint32_t index : scene.indices) {
        const glm::vec3& p = scene.positions[index];
        demand(finite(p), "position {} is finite {}", index, whose);
        demand(glm::all(glm::greaterThanEqual(p, bounds.min - slack)) &&
                   glm::all(glm::lessThanEqual(p, bounds.max + slack)),
               "bounds contain vertex {} {}", index, whose);
    }
}

void check_vertices(const Scene& scene) {
    const size_t count = scene.positions.size();
    demand(!scene.indices.empty() && scene.indices.size() % 3 == 0, "there are whole triangles");
    demand(scene.normals.size() == count, "a normal per vertex");
    demand(scene.vertex_material.size() == count, "a material per vertex");
    demand(scene.texcoords.empty() || scene.texcoords.size() == count, "a texcoord per vertex");
    demand(scene.colors.empty() || scene.colors.size() == count, "a colour per vertex");
    for (const uint32_t index : scene.indices)
        demand(index < count, "index {} names one of {} vertices", index, count);
    for (size_t i = 0; i < count; ++i) {
        demand(finite(scene.positions[i]), "position {} is finite", i);
        demand(scene.normals[i] == glm::vec3(0.0f) || unit(scene.normals[i]),
               "normal {} is of unit length or zero", i);
        demand(scene.vertex_material[i] < scene.materials.size(), "material of vertex {}", i);
    }
    for (const glm::vec2& texcoord : scene.texcoords)
        demand(finite(texcoord), "texcoords are finite");
}

void check_surfaces(const Scene& scene) {
    for (const Material& material : scene.materials) {
        for (int i = 0; i < 3; ++i) {
            demand(within(material.base_color[i], 0.0f, 1.0f), "base colours are in [0, 1]");
            demand(material.emissive[i] >= 0.0f && std::isfinite(material.emissive[i]),
                   "emission is finite and not negative");
        }
        demand(within(material.alpha, 0.0f, 1.0f) && within(material.alpha_cutoff, 0.0f, 1.0f),
               "alpha and its cutoff are in [0, 1]");
        demand(material.texture >= -1 && material.texture < static_cast<int>(scene.textures.size()),
               "texture {} is one of {}", material.texture, scene.textures.size());
        demand(material.texture < 0 || !scene.texcoords.empty(), "textures have texcoords");
    }
    for (const SurfaceTexture& texture : scene.textures) {
        demand(texture.size.x > 0 && texture.size.y > 0, "textures have a size");
        demand(texture.texels.size() ==
                   static_cast<size_t>(texture.size.x) * static_cast<size_t>(texture.size.y),
               "textures have all their texels");
    }
}

void check_views(const Scene& scene) {
    demand(!scene.cameras.empty(), "there is a camera");
    std::set<std::string> names;
    for (const Camera& camera : scene.cameras) {
        demand(names.insert(camera.name).second, "camera names differ");
        demand(finite(camera.eye), "cameras stand somewhere");
        demand(unit(camera.forward) && unit(camera.up) &&
                   std::abs(glm::dot(camera.forward, camera.up)) < 1e-3f,
               "cameras have axes of unit length at right angles");
        demand(camera.vertical_fov > 0.0f && camera.vertical_fov < glm::pi<float>(),
               "field of view {} is between 0 and pi", camera.vertical_fov);
    }
    for (const Light& light : scene.lights) {
        demand(finite(light.position) && unit(light.direction), "lights stand somewhere");
        for (int i = 0; i < 3; ++i)
            demand(light.color[i] >= 0.0f && std::isfinite(light.color[i]), "light is finite");
        demand(light.range > 0.0f, "lights reach somewhere");
        demand(light.inner_cone >= 0.0f && light.inner_cone <= light.outer_cone &&
                   light.outer_cone <= 1.001f * glm::half_pi<float>(),
               "cones of lights: 0 <= {} <= {} <= pi/2", light.inner_cone, light.outer_cone);
    }
}

void check_nodes(const Motion& motion) {
    for (size_t i = 0; i < motion.nodes.size(); ++i) {
        const MotionNode& node = motion.nodes[i];
        demand(node.parent >= -1 && node.parent < static_cast<int>(i), "parents come first");
        demand(finite(node.translation) && finite(node.scale) && finite(node.matrix),
               "nodes' transforms are finite");
        demand(std::abs(glm::length(node.rotation) - 1.0) < 1e-3, "rotations have unit length");
        demand(size_t{node.first_weight} + node.weight_count <= motion.weights.size(),
               "weights of node {} exist", i);
    }
    demand(finite(motion.weights), "weights of targets are finite");
    for (const Skin& skin : motion.skins) {
        demand(!skin.joints.empty() && skin.joints.size() == skin.inverse_bind.size(),
               "a matrix per joint");
        for (const uint32_t joint : skin.joints)
            demand(joint < motion.nodes.size(), "joints are nodes");
        for (const glm::dmat4& matrix : skin.inverse_bind)
            demand(finite(matrix), "inverse bind matrices are finite");
    }
}

void check_channel(const Motion& motion, const MotionChannel& channel) {
    demand(channel.node < motion.nodes.size(), "channels move nodes");
    const MotionNode& node = motion.nodes[channel.node];
    size_t components = channel.path == MotionPath::rotation ? 4 : 3;
    if (channel.path == MotionPath::weights)
        components = node.weight_count;
    else
        demand(!node.has_matrix, "nodes with a matrix are not animated");
    demand(components > 0, "channels of weights have targets");
    demand(!channel.times.empty() && channel.times.front() >= 0.0f, "keys start at 0 or later");
    demand(finite(channel.times) && finite(channel.values), "keys are finite");
    demand(std::ranges::adjacent_find(channel.times, std::greater_equal<>()) == channel.times.end(),
           "times increase");
    const size_t groups = channel.interpolation == Interpolation::cubic ? 3 : 1;
    demand(channel.values.size() == channel.times.size() * components * groups,
           "{} numbers for {} keys of {} times {}", channel.values.size(), channel.times.size(),
           groups, components);
}

void check_part(const Motion& motion, const MovingPart& part) {
    demand(part.node < motion.nodes.size(), "parts follow nodes");
    demand(part.skin >= -1 && part.skin < static_cast<int>(motion.skins.size()), "skins exist");
    const size_t joints =
        part.skin < 0 ? 0 : motion.skins[static_cast<size_t>(part.skin)].joints.size();
    demand(size_t{part.first_matrix} + std::max<size_t>(joints, 1) <= motion.matrix_count,
           "the palette has room for each part");
    demand(part.skin < 0 || part.influence_sets > 0, "skinned parts have influences");
    const size_t sets = part.influence_sets;
    demand(part.first_influence + sets * part.vertex_count <= motion.influences.size(),
           "influences of a part exist");
    demand(part.first_delta + size_t{part.target_count} * part.vertex_count <= motion.deltas.size(),
           "deltas of a part exist");
    demand(part.target_count <= motion.nodes[part.node].weight_count, "a weight per target");
    for (size_t v = 0; v < part.vertex_count && sets > 0; ++v) {
        float sum = 0.0f;
        for (size_t s = 0; s < sets; ++s) {
            const Influence& influence = motion.influences[part.first_influence + v * sets + s];
            for (int i = 0; i < 4; ++i) {
                demand(influence.joint[i] < joints, "joint {} is one of {}", influence.joint[i],
                       joints);
                demand(influence.weight[i] >= 0.0f, "influences are not negative");
                sum += influence.weight[i];
            }
        }
        demand(std::abs(sum - 1.0f) < 1e-3f, "influences sum to 1, not {}", sum);
    }
}

void check_motion(const Scene& scene) {
    const Motion& motion = scene.motion;
    check_nodes(motion);
    for (const Animation& animation : motion.animations) {
        demand(animation.duration >= 0.0 && std::isfinite(animation.duration),
               "animations last a while");
        for (const MotionChannel& channel : animation.channels) {
            check_channel(motion, channel);
            demand(channel.times.back() <= animation.duration, "keys lie in their animation");
        }
    }
    size_t vertex = motion.first_vertex;
    for (const MovingPart& part : motion.parts) {
        demand(part.first_vertex == vertex, "parts follow each other");
        vertex += part.vertex_count;
        check_part(motion, part);
    }
    const size_t moving = motion.parts.empty() ? 0 : scene.positions.size() - motion.first_vertex;
    demand(motion.parts.empty() || vertex == scene.positions.size(), "parts are the last vertices");
    demand(motion.rest_positions.size() == moving && motion.rest_normals.size() == moving,
           "{} vertices move, {} are at rest", moving, motion.rest_positions.size());
    for (const glm::vec3& position : motion.rest_positions)
        demand(finite(position), "positions at rest are finite");
    for (const glm::vec3& normal : motion.rest_normals)
        demand(normal == glm::vec3(0.0f) || unit(normal), "normals at rest are unit or zero");
    for (const MorphDelta& delta : motion.deltas)
        demand(finite(delta.position) && finite(delta.normal), "deltas are finite");
    for (const Mount& mount : motion.cameras)
        demand(mount.index < scene.cameras.size() && mount.node < motion.nodes.size(),
               "cameras ride on nodes");
    for (const Mount& mount : motion.lights)
        demand(mount.index < scene.lights.size() && mount.node < motion.nodes.size(),
               "lights ride on nodes");
}

/// At rest, and at and between the keys of each animation, far beyond its end too.
void check_poses(const Scene& scene) {
    const auto count = static_cast<int>(scene.motion.animations.size());
    for (int animation = -1; animation < std::min(count, 4); ++animation) {
        const double duration =
            animation < 0 ? 0.0 : scene.motion.animations[static_cast<size_t>(animation)].duration;
        for (const double seconds : {0.0, 0.37 * duration, duration, 1e6 + 0.81 * duration}) {
            if (animation < 0 && seconds > 0.0)
                continue;
            Scene posed = scene;
            try {
                apply_pose(posed, pose_at(scene.motion, animation, seconds));
            } catch (const Error& error) {
                demand(error.exit_status() == kBadInput, "a pose is refused as bad input");
                continue;
            }
            check_vertices(posed);
            check_views(posed);
            check_bounds(posed, posed.bounds, "in a pose");
        }
    }
}

} // namespace

std::string broken_promise(const Scene& scene) {
    try {
        check_vertices(scene);
        check_surfaces(scene);
        check_views(scene);
        check_motion(scene);
        check_bounds(scene, scene.bounds, "at rest");
        if (!scene.motion.empty())
            check_poses(scene);
    } catch (const Broken& broken) {
        return broken.what();
    }
    return {};
}

} // namespace romascope::fuzz
