// SPDX-License-Identifier: MIT
#include "renderer/base/error.h"
#include "renderer/scene/pose.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <span>

namespace romascope {
namespace {

/// A vertex computed in single precision, with weights whose sum is 1 but for rounding, lies off by
/// a few units in the last place (2^-24) of the largest of its terms for each sum it goes through:
/// up to 3 of a matrix and 4 or 8 of joints. 64 leave room, and are 0.1 mm at 30 m.
constexpr double kRounding = 64.0 * 0x1p-24;

/// A box around vertices and what morph targets add to them.
struct GrownBox {
    glm::dvec3 min, max;
    glm::dvec3 terms; ///< no sum that leads to a vertex has larger terms: targets may cancel

    explicit GrownBox(const Bounds& bounds)
        : min(bounds.min), max(bounds.max), terms(glm::max(glm::abs(min), glm::abs(max))) {}
    void grow(const Bounds& range, double weight) {
        const glm::dvec3 a = weight * glm::dvec3(range.min);
        const glm::dvec3 b = weight * glm::dvec3(range.max);
        min += glm::min(a, b);
        max += glm::max(a, b);
        terms += glm::max(glm::abs(a), glm::abs(b));
    }
};

/// A double as a float that is not above it.
float below(double x) {
    const auto rounded = static_cast<float>(x);
    return rounded <= x ? rounded
                        : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

Bounds rounded_outwards(glm::dvec3 min, glm::dvec3 max) {
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        bounds.min[axis] = below(min[axis]);
        bounds.max[axis] = -below(-max[axis]);
    }
    return bounds;
}

/// Around the image of a box, with room for rounding.
Bounds image(const glm::dmat4& matrix, const GrownBox& box) {
    glm::dvec3 min(matrix[3]);
    glm::dvec3 max(matrix[3]);
    glm::dvec3 largest = glm::abs(glm::dvec3(matrix[3]));
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 a = glm::dvec3(matrix[axis]) * box.min[axis];
        const glm::dvec3 b = glm::dvec3(matrix[axis]) * box.max[axis];
        min += glm::min(a, b);
        max += glm::max(a, b);
        largest += glm::abs(glm::dvec3(matrix[axis])) * box.terms[axis];
    }
    return rounded_outwards(min - kRounding * largest, max + kRounding * largest);
}

void check_size(const Bounds& bounds) {
    const glm::vec3 largest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    for (int axis = 0; axis < 3; ++axis)
        if (!(largest[axis] <= kMaxCoordinate)) // nor what is no number
            throw Error(fmt::format("at this time the animation moves a vertex beyond {} m: choose "
                                    "another render.time or render.animation",
                                    kMaxCoordinate),
                        kBadInput);
}

/// Around the rest positions of what each matrix of a part moves, by its place among the part's:
/// of the joints in use, or of the one.
std::map<uint32_t, Bounds> boxes_of(const Motion& motion, const MovingPart& part) {
    const auto rest = std::span(motion.rest_positions)
                          .subspan(part.first_vertex - motion.first_vertex, part.vertex_count);
    if (part.influence_sets == 0) {
        Bounds all;
        for (const glm::vec3& position : rest)
            all.add(position);
        return {{0, all}};
    }
    std::map<uint32_t, Bounds> boxes; // a part may use few of very many joints
    const Influence* influence = motion.influences.data() + part.first_influence;
    for (const glm::vec3& position : rest)
        for (uint32_t set = 0; set < part.influence_sets; ++set, ++influence)
            for (int i = 0; i < 4; ++i)
                if (influence->weight[i] > 0.0f)
                    boxes[influence->joint[i]].add(position);
    return boxes;
}

/// Around how far each target of a part moves its vertices at a weight of 1.
std::vector<Bounds> ranges_of(const Motion& motion, const MovingPart& part) {
    std::vector<Bounds> ranges(part.target_count);
    const MorphDelta* delta = motion.deltas.data() + part.first_delta;
    for (Bounds& range : ranges)
        for (uint32_t vertex = 0; vertex < part.vertex_count; ++vertex, ++delta)
            range.add(delta->position);
    return ranges;
}

} // namespace

MovingBounds::MovingBounds(const Motion& motion) {
    for (uint32_t index = 0; index < motion.parts.size(); ++index) {
        const MovingPart& part = motion.parts[index];
        for (const auto& [matrix, box] : boxes_of(motion, part))
            if (!box.empty())
                boxes_.push_back({index, part.first_matrix + matrix, box});
        first_range_.push_back(target_ranges_.size());
        for (const Bounds& range : ranges_of(motion, part))
            target_ranges_.push_back(range);
    }
}

Bounds MovingBounds::at(const Motion& motion, const Pose& pose,
                        const std::vector<glm::dmat4>& matrices) const {
    Bounds bounds = moving_at(motion, pose, matrices);
    bounds.add(motion.still);
    return bounds;
}

Bounds MovingBounds::moving_at(const Motion& motion, const Pose& pose,
                               const std::vector<glm::dmat4>& matrices) const {
    Bounds bounds;
    // A vertex is a mean, with weights that are not negative, of its images by its joints' matrices
    // (glTF 2.0, 3.7.3.3): a box around the images is one around the vertex.
    for (const Box& box : boxes_) {
        const MovingPart& part = motion.parts[box.part];
        GrownBox grown(box.rest);
        for (uint32_t target = 0; target < part.target_count; ++target)
            grown.grow(target_ranges_[first_range_[box.part] + target],
                       pose.weights[motion.nodes[part.node].first_weight + target]);
        const Bounds moved = image(matrices[box.matrix], grown);
        check_size(moved);
        bounds.add(moved);
    }
    return bounds;
}

} // namespace romascope
