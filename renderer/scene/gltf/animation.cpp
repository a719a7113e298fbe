// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/animation.h"

#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/numbers.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace romascope::gltf {
namespace {

const std::vector<int> kNumbers = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                   TINYGLTF_COMPONENT_TYPE_SHORT,
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

/// Many channels may share one sampler, whose keys each would read: no honest file comes near this.
constexpr size_t kMaxKeyNumbers = 100'000'000;

std::optional<MotionPath> path_of(const std::string& name) {
    constexpr std::array kNames = {"translation", "rotation", "scale", "weights"};
    for (size_t i = 0; i < kNames.size(); ++i)
        if (name == kNames[i])
            return static_cast<MotionPath>(i);
    return std::nullopt; // of an extension
}

Interpolation interpolation_of(const std::string& name) {
    return name == "STEP"          ? Interpolation::step
           : name == "CUBICSPLINE" ? Interpolation::cubic
                                   : Interpolation::linear;
}

std::vector<float> read_times(const Document& document, int accessor, const std::string& element,
                              MemoryBudget& budget) {
    const AccessorReader reader(document, accessor, {TINYGLTF_TYPE_SCALAR, kNumbers}, element);
    budget.take(reader.count(), sizeof(float), element);
    std::vector<float> times(reader.count());
    for (size_t i = 0; i < times.size(); ++i) {
        times[i] = reader.number(i);
        if (times[i] < 0.0f)
            refuse(element, fmt::format("key {} is before second 0", i));
        if (i > 0 && !(times[i] > times[i - 1]))
            refuse(element, fmt::format("key {} is not after the one before", i));
    }
    if (times.empty())
        refuse(element, "has no keys");
    return times;
}

/// As many numbers as keys, width and interpolation ask for.
std::vector<float> read_values(const Document& document, int accessor, MotionPath path,
                               size_t expected, const std::string& element, MemoryBudget& budget) {
    const int type = path == MotionPath::weights    ? TINYGLTF_TYPE_SCALAR
                     : path == MotionPath::rotation ? TINYGLTF_TYPE_VEC4
                                                    : TINYGLTF_TYPE_VEC3;
    const AccessorReader reader(document, accessor, {type, kNumbers}, element);
    const auto width = static_cast<size_t>(reader.components());
    if (reader.count() * width != expected)
        refuse(element,
               fmt::format("has {} elements, its keys need {}", reader.count(), expected / width));
    budget.take(expected, sizeof(float), element);
    std::vector<float> values(expected);
    for (size_t i = 0; i < expected; ++i) {
        values[i] = reader.number(i / width, static_cast<int>(i % width));
        if (std::abs(values[i]) > kMaxCoordinate)
            refuse(element, fmt::format("element {} is beyond {}", i / width, kMaxCoordinate));
    }
    return values;
}

/// A quaternion of no length turns nothing, and has no direction to interpolate to.
void check_rotations(const MotionChannel& channel, const std::string& element) {
    const size_t groups = channel.interpolation == Interpolation::cubic ? 3 : 1;
    for (size_t key = 0; key < channel.times.size(); ++key) {
        const float* q = &channel.values[4 * (groups * key + groups / 2)];
        const double length = glm::length(glm::dvec4(q[0], q[1], q[2], q[3]));
        if (!(length > 1e-6))
            refuse(element, fmt::format("rotation of key {} has no length", key));
    }
}

} // namespace

std::vector<Animation> read_animations(const Document& document, const Hierarchy& hierarchy,
                                       MemoryBudget& budget, Notices& notices) {
    const tinygltf::Model& model = document.model();
    std::vector<Animation> animations;
    size_t key_numbers = 0;
    for (size_t a = 0; a < model.animations.size(); ++a) {
        const tinygltf::Animation& source = model.animations[a];
        Animation animation;
        animation.name = source.name.empty() ? fmt::format("animation_{}", a) : source.name;
        std::set<std::pair<uint32_t, MotionPath>> seen;
        for (size_t c = 0; c < source.channels.size(); ++c) {
            const tinygltf::AnimationChannel& from = source.channels[c];
            const std::string element = fmt::format("animations[{}].channels[{}]", a, c);
            const std::optional<MotionPath> path = path_of(from.target_path);
            if (!path || from.target_node < 0)
                continue;
            MotionChannel channel;
            channel.node = hierarchy.place[static_cast<size_t>(from.target_node)];
            channel.path = *path;
            const MotionNode& node = hierarchy.nodes[channel.node];
            if (node.has_matrix && *path != MotionPath::weights) {
                notices.add(element, "moves a node that has a matrix, and is left out");
                continue;
            }
            if (!seen.emplace(channel.node, *path).second)
                refuse(element, fmt::format("a channel before it moves the same {} of node {}",
                                            from.target_path, from.target_node));
            const size_t width = *path == MotionPath::weights    ? node.weight_count
                                 : *path == MotionPath::rotation ? 4
                                                                 : 3;
            if (width == 0) {
                notices.add(element, "weighs morph targets that are not there, and is left out");
                continue;
            }
            const std::string sampler_name =
                fmt::format("animations[{}].samplers[{}]", a, from.sampler);
            const auto& sampler = source.samplers[static_cast<size_t>(from.sampler)];
            channel.interpolation = interpolation_of(sampler.interpolation);
            channel.times = read_times(document, sampler.input, sampler_name + ".input", budget);
            const size_t groups = channel.interpolation == Interpolation::cubic ? 3 : 1;
            const size_t expected = channel.times.size() * groups * width;
            key_numbers += expected;
            if (key_numbers > kMaxKeyNumbers)
                refuse(element,
                       fmt::format("the animations hold more than {} numbers", kMaxKeyNumbers));
            channel.values = read_values(document, sampler.output, *path, expected,
                                         sampler_name + ".output", budget);
            if (*path == MotionPath::rotation)
                check_rotations(channel, sampler_name + ".output");
            animation.duration =
                std::max(animation.duration, static_cast<double>(channel.times.back()));
            animation.channels.push_back(std::move(channel));
        }
        animations.push_back(std::move(animation));
    }
    return animations;
}

} // namespace romascope::gltf
