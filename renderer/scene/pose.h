// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <string>
#include <vector>

namespace romascope {

/// How a scene stands at one moment.
struct Pose {
    std::vector<glm::dmat4> node_to_world; ///< per Motion::nodes
    std::vector<double> weights;           ///< per Motion::weights

    bool operator==(const Pose&) const = default;
};

/// The index of an animation of the scene by its name or number; the first (-1: there is none) for
/// "", -1 for "none": all stands as without animation.
/// Throws Error (kBadInput) that names the nearest and lists them.
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
    explicit MovingBounds(const Motion& motion);
    /// Contains all vertices of the scene in that pose, be they computed in double or single
    /// precision. `matrices`: the palette of that pose. Throws Error (kBadInput) if they reach
    /// beyond kMaxCoordinate.
    Bounds at(const Motion& motion, const Pose& pose,
              const std::vector<glm::dmat4>& matrices) const;
    /// The same of moving vertices alone: empty if none move.
    Bounds moving_at(const Motion& motion, const Pose& pose,
                     const std::vector<glm::dmat4>& matrices) const;

private:
    struct Box {
        uint32_t part, matrix;
        Bounds rest;
    };
    std::vector<Box> boxes_;
    std::vector<Bounds> target_ranges_; ///< of the deltas of each part's targets in turn
    std::vector<size_t> first_range_;   ///< per part, into target_ranges_
};

/// A normal of a surface that goes through `matrix`, unit length: by the inverse transpose, taken
/// by way of the cofactors, which exist where a scale is 0. 0 if nothing of it is left.
glm::vec3 moved_normal(const glm::dmat3& matrix, glm::dvec3 normal);

/// Camera `index` of the scene in that pose. One whose node leaves it no direction keeps the one it
/// has.
Camera camera_at(const Scene& scene, size_t index, const Pose& pose);

/// The scene's lights in that pose; as for cameras.
std::vector<Light> lights_at(const Scene& scene, const Pose& pose);

/// Moves the vertices, cameras, lights and bounds of `scene` to the pose, in double precision.
/// Throws as MovingBounds::at does.
void apply_pose(Scene& scene, const Pose& pose);

} // namespace romascope
