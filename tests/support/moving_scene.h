// SPDX-License-Identifier: MIT
// Moving scenes for tests, made in memory.
#pragma once

#include "renderer/scene/pose.h"

#include <random>
#include <vector>

namespace romascope {

/// Builds a scene that moves, piece by piece. What stands still comes first.
class MovingSceneBuilder {
public:
    MovingSceneBuilder();

    /// Three corners a triangle.
    void add_still(const std::vector<glm::vec3>& corners);
    uint32_t add_node(const MotionNode& node);
    /// Of the first animation.
    void add_channel(uint32_t node, MotionPath path, Interpolation interpolation,
                     std::vector<float> times, std::vector<float> values);
    int add_skin(const std::vector<uint32_t>& joints, const std::vector<glm::dmat4>& inverse_bind);

    /// A piece at rest: three corners a triangle, as many normals, and what moves them.
    struct Piece {
        std::vector<glm::vec3> corners, normals;
        uint32_t node = 0;
        int skin = -1;
        uint32_t influence_sets = 0;
        std::vector<Influence> influences;
        std::vector<MorphDelta> deltas; ///< target by target
    };
    void add_moving(const Piece& piece);

    /// The scene, at second 0.
    Scene build();
    Motion& motion() { return scene_.motion; }
    Scene& scene() { return scene_; }

private:
    void add_vertices(const std::vector<glm::vec3>& corners, const std::vector<glm::vec3>& normals);

    Scene scene_;
};

/// What random_moving_scene() holds.
struct MovingKinds {
    bool rigid = false, skinned = false, skinned_twice = false, morphing = false,
         morphing_skinned = false;
};

/// A few random pieces of each kind on a random tree of nodes, with mirrored and uneven scales, an
/// animation of every interpolation, a camera and a light on nodes. `triangles`: of each piece.
/// Size: some ten metres.
Scene random_moving_scene(std::mt19937& random, const MovingKinds& kinds, int triangles = 20);

inline constexpr MovingKinds kAllKinds{true, true, true, true, true};

/// Pieces whose vertices are sums and products of few binary digits in the poses at whole seconds
/// 0 to 4: quarter turns, shifts by eighths, halves of joints and targets. Single and double
/// precision then agree.
Scene exact_moving_scene();

} // namespace romascope
