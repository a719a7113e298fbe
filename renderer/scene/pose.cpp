// SPDX-License-Identifier: MIT
#include "renderer/scene/pose.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/base/listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <span>

namespace romascope {
namespace {

/// Four numbers as a file has them to a rotation of unit length; no rotation if they have none.
glm::dquat rotation_of(glm::dvec4 xyzw) {
    const double length = glm::length(xyzw);
    if (!(length > 0.0))
        return {1.0, 0.0, 0.0, 0.0};
    xyzw /= length;
    return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

/// Along the shorter of the two arcs between the rotations (glTF 2.0, appendix C.4).
glm::dquat slerp(const glm::dquat& from, glm::dquat to, double fraction) {
    double cosine = glm::dot(from, to);
    if (cosine < 0.0) {
        to = -to;
        cosine = -cosine;
    }
    // From here on the arc is its chord to the last bit, and the sines below are 0 / 0.
    if (cosine > 1.0 - 1e-15)
        return glm::normalize(from * (1.0 - fraction) + to * fraction);
    const double angle = std::acos(cosine);
    return glm::normalize(
        (from * std::sin((1.0 - fraction) * angle) + to * std::sin(fraction * angle)) /
        std::sin(angle));
}

/// Where a time falls among the keys of a channel.
struct KeyPlace {
    size_t key = 0;        ///< the last one not after the time; the first if all are
    double fraction = 0.0; ///< of the way to the next, in [0, 1); 0 where the key's value holds
    double interval = 0.0; ///< seconds to the next
};

KeyPlace find_key(const std::vector<float>& times, double seconds) {
    const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                        [](double t, float key) { return t < double{key}; });
    if (after == times.begin())
        return {};
    KeyPlace place;
    place.key = static_cast<size_t>(after - times.begin()) - 1;
    if (after != times.end()) {
        const double start = times[place.key];
        place.interval = *after - start;
        place.fraction = (seconds - start) / place.interval;
    }
    return place;
}

/// The numbers of a channel at a time, `count` of them.
class Sampler {
public:
    Sampler(const MotionChannel& channel, size_t count, double seconds)
        : channel_(channel), count_(count), place_(find_key(channel.times, seconds)) {
        assert(channel.values.size() ==
               channel.times.size() * count *
                   (channel.interpolation == Interpolation::cubic ? 3 : 1));
        if (channel.interpolation == Interpolation::step)
            place_.fraction = 0.0;
    }

    double number(size_t i) const {
        if (place_.fraction == 0.0)
            return value(place_.key, i);
        return channel_.interpolation == Interpolation::cubic ? cubic(i) : linear(i);
    }
    glm::dvec3 vector() const { return {number(0), number(1), number(2)}; }
    glm::dquat rotation() const {
        if (place_.fraction == 0.0 || channel_.interpolation == Interpolation::cubic)
            return rotation_of({number(0), number(1), number(2), number(3)});
        return slerp(rotation_at(place_.key), rotation_at(place_.key + 1), place_.fraction);
    }

private:
    enum Group { in_tangent, middle, out_tangent };

    double at(size_t key, Group group, size_t i) const {
        return channel_.interpolation == Interpolation::cubic
                   ? channel_.values[(3 * key + group) * count_ + i]
                   : channel_.values[key * count_ + i];
    }
    double value(size_t key, size_t i) const { return at(key, middle, i); }
    glm::dquat rotation_at(size_t key) const {
        return rotation_of({value(key, 0), value(key, 1), value(key, 2), value(key, 3)});
    }
    double linear(size_t i) const {
        return value(place_.key, i) * (1.0 - place_.fraction) +
               value(place_.key + 1, i) * place_.fraction;
    }
    /// Hermite spline; tangents are per second (glTF 2.0, appendix C.5).
    double cubic(size_t i) const {
        const double t = place_.fraction;
        const double t2 = t * t;
        const double t3 = t2 * t;
        return (2.0 * t3 - 3.0 * t2 + 1.0) * value(place_.key, i) +
               place_.interval * (t3 - 2.0 * t2 + t) * at(place_.key, out_tangent, i) +
               (3.0 * t2 - 2.0 * t3) * value(place_.key + 1, i) +
               place_.interval * (t3 - t2) * at(place_.key + 1, in_tangent, i);
    }

    const MotionChannel& channel_;
    size_t count_;
    KeyPlace place_;
};

/// Within one run of the animation: from its start to its very end.
double time_within(const Animation& animation, double seconds) {
    if (seconds <= animation.duration)
        return seconds;
    return animation.duration > 0.0 ? std::fmod(seconds, animation.duration) : 0.0;
}

void animate(const Animation& animation, double seconds, std::vector<MotionNode>& nodes,
             std::vector<double>& weights) {
    for (const MotionChannel& channel : animation.channels) {
        MotionNode& node = nodes[channel.node];
        switch (channel.path) {
        case MotionPath::translation:
            node.translation = Sampler(channel, 3, seconds).vector();
            break;
        case MotionPath::rotation:
            node.rotation = Sampler(channel, 4, seconds).rotation();
            break;
        case MotionPath::scale:
            node.scale = Sampler(channel, 3, seconds).vector();
            break;
        case MotionPath::weights: {
            const Sampler sampler(channel, node.weight_count, seconds);
            for (uint32_t i = 0; i < node.weight_count; ++i)
                weights[node.first_weight + i] = sampler.number(i);
            break;
        }
        }
    }
}

glm::dmat4 local_matrix(const MotionNode& node) {
    if (node.has_matrix)
        return node.matrix;
    const glm::dmat3 turned = glm::mat3_cast(node.rotation);
    return {glm::dvec4(turned[0] * node.scale.x, 0.0), glm::dvec4(turned[1] * node.scale.y, 0.0),
            glm::dvec4(turned[2] * node.scale.z, 0.0), glm::dvec4(node.translation, 1.0)};
}

} // namespace

int find_animation(const Scene& scene, const std::string& wanted) {
    const std::vector<Animation>& animations = scene.motion.animations;
    if (wanted.empty())
        return animations.empty() ? -1 : 0;
    std::vector<std::string> names;
    for (const Animation& animation : animations) {
        if (animation.name == wanted)
            return static_cast<int>(names.size());
        names.push_back(animation.name);
    }
    if (wanted == "none")
        return -1;
    size_t number = 0;
    const auto [end, code] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (code == std::errc() && end == wanted.data() + wanted.size() && number < animations.size())
        return static_cast<int>(number);
    if (animations.empty())
        throw Error(
            fmt::format("scene '{}' has no animation '{}': it has none at all", scene.name, wanted),
            kBadInput);
    throw Error(fmt::format("scene '{}' has no animation '{}'{} (it has {}; numbers go from "
                            "0 to {})",
                            scene.name, wanted, did_you_mean(wanted, names), listing(names),
                            animations.size() - 1),
                kBadInput);
}

Pose pose_at(const Motion& motion, int animation, double seconds) {
    std::vector<MotionNode> nodes = motion.nodes;
    Pose pose;
    pose.weights.assign(motion.weights.begin(), motion.weights.end());
    if (animation >= 0) {
        const Animation& chosen = motion.animations[static_cast<size_t>(animation)];
        animate(chosen, time_within(chosen, seconds), nodes, pose.weights);
    }
    pose.node_to_world.reserve(nodes.size());
    for (const MotionNode& node : nodes) {
        const glm::dmat4 local = local_matrix(node);
        pose.node_to_world.push_back(
            node.parent < 0 ? local : pose.node_to_world[static_cast<size_t>(node.parent)] * local);
    }
    return pose;
}

std::vector<glm::dmat4> palette(const Motion& motion, const Pose& pose) {
    std::vector<glm::dmat4> matrices(motion.matrix_count, glm::dmat4(1.0));
    std::vector<bool> written(motion.matrix_count, false); // parts of one skin share its matrices
    for (const MovingPart& part : motion.parts) {
        if (written[part.first_matrix])
            continue;
        written[part.first_matrix] = true;
        const std::span<glm::dmat4> own = std::span(matrices).subspan(part.first_matrix);
        if (part.skin < 0) {
            own[0] = pose.node_to_world[part.node];
            continue;
        }
        const Skin& skin = motion.skins[static_cast<size_t>(part.skin)];
        for (size_t joint = 0; joint < skin.joints.size(); ++joint)
            own[joint] = pose.node_to_world[skin.joints[joint]] * skin.inverse_bind[joint];
    }
    return matrices;
}

} // namespace romascope
