// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>

namespace romascope {

class Lattice;

/// A Monte Carlo estimate of a fraction.
struct Estimate {
    float mean = 0.0f;
    /// Standard deviation of `mean` if the samples were independent. They are stratified, so the
    /// true one is smaller.
    float standard_error = 0.0f;
};

/// Where a ray meets the scene.
struct Hit {
    float distance = 0.0f; ///< along the ray, in lengths of its direction
    uint32_t triangle = 0; ///< index into Scene::indices / 3
    glm::vec3 position{};
    glm::vec3 geometric_normal{}; ///< unit length, on the side the ray came from
    glm::vec3 normal{};           ///< of the vertices, interpolated, on the side of the above
    /// `position` moved off the surface along `geometric_normal` by about 1e-6 of the triangle's
    /// largest coordinate: rays from here do not meet the surface they start on by rounding.
    glm::vec3 origin{};
};

/// Exact visibility in the triangles of a scene, by Embree. Both sides of a triangle count, and
/// what an alpha mask leaves out is not there. Const functions may be called from several threads
/// at once.
class AoTracer {
public:
    /// Copies what it needs from the scene. Throws Error if Embree cannot start or runs out of
    /// memory.
    explicit AoTracer(const Scene& scene);
    ~AoTracer();
    AoTracer(AoTracer&&) noexcept;
    AoTracer& operator=(AoTracer&&) noexcept;

    std::optional<Hit> closest(glm::vec3 origin, glm::vec3 direction) const;
    /// What the picture shows: as `closest`, but looking through the backs of materials that are
    /// not double-sided.
    std::optional<Hit> seen(glm::vec3 origin, glm::vec3 direction) const;

    /// True if the ray meets anything within (0, t_max]; t_max in lengths of `direction`, may be
    /// infinite.
    bool occluded(glm::vec3 origin, glm::vec3 direction, float t_max) const;

    /// Ambient occlusion (1 = open): the mean visibility of `samples` >= 1 cosine-distributed rays
    /// about the unit `normal`, (1/pi) * integral of V(w) max(0, n.w) dw, where V is 0 if anything
    /// lies within `radius` metres (may be infinite). `origin` is used as it is, see Hit::origin.
    /// The rays are stratified, depend on nothing but `samples` and `seed`, and are independent
    /// for different seeds.
    Estimate ambient_occlusion(glm::vec3 origin, glm::vec3 normal, float radius, int samples,
                               uint32_t seed) const;
    /// The same for many points: the lattice is made once.
    Estimate ambient_occlusion(glm::vec3 origin, glm::vec3 normal, float radius,
                               const Lattice& lattice, uint32_t seed) const;

private:
    struct State;

    std::unique_ptr<State> state_;
};

/// The estimate of `free` unoccluded rays out of `samples`.
Estimate estimate_of(int free, int samples);

} // namespace romascope
