// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/bounds.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace romascope {

/// A node of the scene's hierarchy, without animation.
struct MotionNode {
    int parent = -1; ///< stands before this one in Motion::nodes; -1: none
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
    /// Instead of the three above, for nodes given by a matrix; those are never animated.
    bool has_matrix = false;
    glm::dmat4 matrix{1.0};
    uint32_t first_weight = 0, weight_count = 0; ///< into Motion::weights: of its mesh's targets
};

enum class Interpolation { step, linear, cubic };
enum class MotionPath { translation, rotation, scale, weights };

/// What one property of one node does over time.
struct MotionChannel {
    uint32_t node = 0;
    MotionPath path = MotionPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times; ///< seconds, strictly increasing, at least one, at least 0
    /// Per key: 3, 4 (x, y, z, w) or weight_count numbers; cubic: three such groups (in-tangent,
    /// value, out-tangent).
    std::vector<float> values;
};

struct Animation {
    std::string name;
    double duration = 0.0; ///< seconds: the last key's time
    std::vector<MotionChannel> channels;
};

struct Skin {
    std::vector<uint32_t> joints;         ///< nodes
    std::vector<glm::dmat4> inverse_bind; ///< as many
};

/// Four joints of a skin that move a vertex. A vertex' weights are not negative and their sum is 1.
struct Influence {
    uint16_t joint[4] = {0, 0, 0, 0}; ///< into Skin::joints
    float weight[4] = {0.0f, 0.0f, 0.0f, 0.0f};
};

/// How far one morph target moves a vertex.
struct MorphDelta {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

/// A piece of a moving instance: consecutive vertices of the scene that move by the same rule.
/// A vertex at rest, plus its deltas times the weights of `node`, goes through the matrix of
/// `node`, or, with a skin, through the mean of its joints' matrices (glTF 2.0, 3.7.3).
struct MovingPart {
    uint32_t first_vertex = 0, vertex_count = 0; ///< in Scene::positions
    uint32_t node = 0;
    int skin = -1; ///< -1: rigid
    /// Into the palette of `palette()`: one, or one per joint; parts of one skin may share theirs.
    uint32_t first_matrix = 0;
    /// Into Motion::influences: `influence_sets` for each vertex in turn. 0 sets: rigid.
    uint32_t first_influence = 0, influence_sets = 0;
    /// Into Motion::deltas: for each target in turn, one for each vertex.
    uint32_t first_delta = 0, target_count = 0;
};

/// What follows a node: a camera or a light.
struct Mount {
    uint32_t index = 0; ///< into Scene::cameras or Scene::lights
    uint32_t node = 0;
};

/// Everything in a scene that can move; empty if nothing does.
struct Motion {
    std::vector<MotionNode> nodes; ///< parents before children
    std::vector<float> weights;    ///< of morph targets, without animation
    std::vector<Skin> skins;
    std::vector<Animation> animations;

    /// In the order of their vertices, which are the scene's last: from `first_vertex` on all move.
    std::vector<MovingPart> parts;
    uint32_t first_vertex = 0;
    uint32_t matrix_count = 0;             ///< matrices in the palette
    std::vector<glm::vec3> rest_positions; ///< per moving vertex: in the space of its mesh
    std::vector<glm::vec3> rest_normals;   ///< unit length, or 0: the triangle's own
    std::vector<Influence> influences;
    std::vector<MorphDelta> deltas;
    std::vector<Mount> cameras, lights;

    Bounds still; ///< of what does not move
    bool empty() const { return parts.empty() && cameras.empty() && lights.empty(); }
};

} // namespace romascope
