// SPDX-License-Identifier: MIT
#include "renderer/scene/pose.h"

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

/// One part in one pose.
class PosedPart {
public:
    PosedPart(const Motion& motion, const MovingPart& part, const Pose& pose,
              const std::vector<glm::dmat4>& matrices)
        : motion_(motion), part_(part), matrices_(matrices.data() + part.first_matrix),
          weights_(pose.weights.data() + motion.nodes[part.node].first_weight) {}

    void move(uint32_t vertex, glm::vec3& position, glm::vec3& normal) const {
        const size_t at = part_.first_vertex - motion_.first_vertex + vertex;
        glm::dvec3 moved(motion_.rest_positions[at]);
        glm::dvec3 direction(motion_.rest_normals[at]);
        const bool has_normal = direction != glm::dvec3(0.0);
        for (uint32_t target = 0; target < part_.target_count; ++target) {
            const MorphDelta& delta =
                motion_.deltas[part_.first_delta + size_t{target} * part_.vertex_count + vertex];
            moved += weights_[target] * glm::dvec3(delta.position);
            direction += weights_[target] * glm::dvec3(delta.normal);
        }
        const glm::dmat4 matrix = matrix_of(vertex);
        position = glm::vec3(matrix * glm::dvec4(moved, 1.0));
        normal = has_normal ? moved_normal(glm::dmat3(matrix), direction) : glm::vec3(0.0f);
    }

private:
    glm::dmat4 matrix_of(uint32_t vertex) const {
        if (part_.influence_sets == 0)
            return matrices_[0];
        glm::dmat4 matrix(0.0);
        const size_t first = part_.first_influence + size_t{vertex} * part_.influence_sets;
        for (size_t set = first; set < first + part_.influence_sets; ++set)
            for (int i = 0; i < 4; ++i)
                matrix += double{motion_.influences[set].weight[i]} *
                          matrices_[motion_.influences[set].joint[i]];
        return matrix;
    }

    const Motion& motion_;
    const MovingPart& part_;
    const glm::dmat4* matrices_;
    const double* weights_;
};

/// Where a node's frame puts a camera or light, which look along -z. Where the frame is squashed to
/// no direction, a camera (which has an `up`) stays as it is, a light keeps its direction.
void place(const glm::dmat4& frame, glm::vec3& position, glm::vec3& forward, glm::vec3* up) {
    const glm::dvec3 ahead = -glm::dvec3(frame[2]);
    const glm::dvec3 above = glm::cross(glm::cross(ahead, glm::dvec3(frame[1])), ahead);
    const bool squashed = !(glm::length(ahead) > 0.0) || (up && !(glm::length(above) > 0.0));
    if (squashed && up)
        return;
    position = glm::vec3(frame[3]);
    if (squashed)
        return;
    forward = glm::vec3(glm::normalize(ahead));
    if (up)
        *up = glm::vec3(glm::normalize(above));
}

} // namespace

glm::vec3 moved_normal(const glm::dmat3& matrix, glm::dvec3 normal) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            largest = std::max(largest, std::abs(matrix[column][row]));
    if (!(largest > 0.0))
        return glm::vec3(0.0f);
    const glm::dmat3 m = matrix / largest; // products of three must not underflow
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    const glm::dvec3 turned = cofactors * normal;
    const double length = glm::length(turned);
    if (!(length > 0.0))
        return glm::vec3(0.0f);
    return glm::vec3((glm::determinant(m) < 0.0 ? -turned : turned) / length);
}

Camera camera_at(const Scene& scene, size_t index, const Pose& pose) {
    Camera camera = scene.cameras[index];
    for (const Mount& mount : scene.motion.cameras)
        if (mount.index == index)
            place(pose.node_to_world[mount.node], camera.eye, camera.forward, &camera.up);
    return camera;
}

std::vector<Light> lights_at(const Scene& scene, const Pose& pose) {
    std::vector<Light> lights = scene.lights;
    for (const Mount& mount : scene.motion.lights) {
        Light& light = lights[mount.index];
        place(pose.node_to_world[mount.node], light.position, light.direction, nullptr);
    }
    return lights;
}

void apply_pose(Scene& scene, const Pose& pose) {
    for (size_t index = 0; index < scene.cameras.size(); ++index)
        scene.cameras[index] = camera_at(scene, index, pose);
    scene.lights = lights_at(scene, pose);
    const Motion& motion = scene.motion;
    if (motion.parts.empty())
        return;
    const std::vector<glm::dmat4> matrices = palette(motion, pose);
    for (const MovingPart& part : motion.parts) {
        const PosedPart posed(motion, part, pose, matrices);
        for (uint32_t vertex = 0; vertex < part.vertex_count; ++vertex)
            posed.move(vertex, scene.positions[part.first_vertex + vertex],
                       scene.normals[part.first_vertex + vertex]);
    }
    scene.bounds = MovingBounds(motion).at(motion, pose, matrices);
}

} // namespace romascope
