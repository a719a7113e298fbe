// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/reach.h"

#include <algorithm>
#include <cmath>

namespace romascope::gltf {
namespace {

/// Largest |value| that each of a channel's `width` numbers can take. A cubic segment stays within
/// its two values plus the products of its tangents and its length (4/27 of each at most).
double largest_value(const MotionChannel& channel, size_t width) {
    const bool cubic = channel.interpolation == Interpolation::cubic;
    const double span = cubic ? channel.times.back() - channel.times.front() : 0.0;
    double largest = 0.0;
    for (size_t i = 0; i < channel.values.size(); ++i) {
        const bool tangent = cubic && i / width % 3 != 1;
        largest = std::max(largest, std::abs(static_cast<double>(channel.values[i])) *
                                        (tangent ? span : 1.0));
    }
    return (cubic ? 3.0 : 1.0) * largest;
}

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Not std::max, which would hide what is not a number.
void raise(double& largest, double value) {
    if (!(value <= largest))
        largest = value;
}

/// Factor by which a matrix lengthens at most, and by how much it moves the origin, both a little
/// too large.
struct Stretch {
    double factor = 1.0, offset = 0.0;
};

Stretch stretch_of(const glm::dmat4& matrix) {
    double sum = 0.0;
    for (int column = 0; column < 3; ++column)
        sum += 3.0 * largest(glm::dvec3(matrix[column]));
    return {sum, 2.0 * largest(glm::dvec3(matrix[3]))};
}

} // namespace

double reach(const Motion& motion) {
    std::vector<double> translation(motion.nodes.size()), scale(motion.nodes.size());
    std::vector<double> weights(motion.nodes.size(), 0.0);
    for (size_t n = 0; n < motion.nodes.size(); ++n) {
        const MotionNode& node = motion.nodes[n];
        translation[n] = largest(node.translation);
        scale[n] = largest(node.scale);
        for (uint32_t w = 0; w < node.weight_count; ++w)
            weights[n] = std::max(
                weights[n], std::abs(static_cast<double>(motion.weights[node.first_weight + w])));
    }
    for (const Animation& animation : motion.animations)
        for (const MotionChannel& channel : animation.channels) {
            const auto widen = [&](std::vector<double>& values, size_t width) {
                raise(values[channel.node], largest_value(channel, width));
            };
            if (channel.path == MotionPath::translation)
                widen(translation, 3);
            else if (channel.path == MotionPath::scale)
                widen(scale, 3);
            else if (channel.path == MotionPath::weights)
                widen(weights, motion.nodes[channel.node].weight_count);
        }

    std::vector<Stretch> world(motion.nodes.size());
    for (size_t n = 0; n < motion.nodes.size(); ++n) {
        const MotionNode& node = motion.nodes[n];
        const Stretch own =
            node.has_matrix ? stretch_of(node.matrix) : Stretch{scale[n], 2.0 * translation[n]};
        const Stretch above = node.parent < 0 ? Stretch{} : world[static_cast<size_t>(node.parent)];
        world[n] = {above.factor * own.factor, above.offset + above.factor * own.offset};
    }

    // Per skin: a vertex `radius` from its mesh's origin comes no further than offset + factor
    // radius.
    std::vector<Stretch> skins;
    for (const Skin& skin : motion.skins) {
        Stretch whole{0.0, 0.0};
        for (size_t j = 0; j < skin.joints.size(); ++j) {
            const Stretch bind = stretch_of(skin.inverse_bind[j]);
            const Stretch& joint = world[skin.joints[j]];
            raise(whole.factor, joint.factor * bind.factor);
            raise(whole.offset, joint.offset + joint.factor * bind.offset);
        }
        skins.push_back(whole);
    }

    double furthest = 0.0;
    const auto consider = [&](const Stretch& place, double radius) {
        raise(furthest, place.offset + place.factor * radius);
    };
    for (const Mount& mount : motion.cameras)
        consider(world[mount.node], 0.0);
    for (const Mount& mount : motion.lights)
        consider(world[mount.node], 0.0);
    for (const MovingPart& part : motion.parts) {
        double radius = 0.0, delta = 0.0;
        for (uint32_t v = 0; v < part.vertex_count; ++v)
            radius = std::max(
                radius,
                largest(motion.rest_positions[part.first_vertex - motion.first_vertex + v]));
        for (size_t d = 0; d < size_t{part.target_count} * part.vertex_count; ++d)
            delta = std::max(delta, largest(motion.deltas[part.first_delta + d].position));
        radius = 2.0 * (radius + delta * weights[part.node] * part.target_count);
        consider(part.skin < 0 ? world[part.node] : skins[static_cast<size_t>(part.skin)], radius);
    }
    return furthest;
}

} // namespace romascope::gltf
