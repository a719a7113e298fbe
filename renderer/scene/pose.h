// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <string>

namespace romascope {

/// How a scene stands at one moment.
struct Pose {
    std::vector<glm::dmat4> node_to_world; ///< per Motion::nodes
    std::vector<double> weights;           ///< per Motion::weights
};

/// The index of an animation of the scene by its name or number; the first (-1: there is none) for
/// "", -1 for "none": all stands as without animation.
/// Throws Error (kBadInput) that names the nearest.
int find_animation(const Scene& scene, const std::string& wanted);

/// The pose at a time in seconds >= 0. Animations start over at their end. `animation`: -1 for
/// none. Keys are interpolated as glTF 2.0, appendix C says; before the first and after the last a
/// channel keeps that key's value.
Pose pose_at(const Motion& motion, int animation, double seconds);

/// The matrices that moving parts' vertices go through, from their mesh's space to the world, each
/// part's from MovingPart::first_matrix on.
std::vector<glm::dmat4> palette(const Motion& motion, const Pose& pose);

/// Boxes around what each matrix of the palette moves, made once, so that a frame's bounds cost as
/// little as its matrices.
class MovingBounds {
public:
    explicit MovingBounds(const Scene& scene);
    /// Contains all vertices of the scene in that pose.
    Bounds at(const Motion& motion, const Pose& pose,
              const std::vector<glm::dmat4>& matrices) const;

private:
    struct Box {
        uint32_t part, matrix;
        Bounds rest;
    };
    std::vector<Box> boxes_;
    std::vector<Bounds> target_ranges_; ///< of the deltas of each part's targets in turn
};

/// Moves the vertices, cameras, lights and bounds of `scene` to the pose, in double precision.
void apply_pose(Scene& scene, const Pose& pose);

} // namespace romascope
