// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/tracers/tracer.h"

#include <span>
#include <utility>

namespace romascope {

/// A ray as a tracer's GLSL takes it. Laid out for std430.
struct ListedRay {
    glm::vec3 point; ///< on the surface, metres
    float t_max;     ///< metres from the surface, infinity allowed
    glm::vec3 normal;
    int place = -1;      ///< of the candidate that it is traced along; negative: along `direction`
    glm::vec3 direction; ///< unit
    float unused = 0.0f;
};

enum class RayQuestion { any_hit, distance };

/// Traces rays that the CPU gives, with any tracer. Keeps the programs it needed so far, one for
/// each way in which tracers were compiled.
class RayList {
public:
    /// For each ray 1 or 0 (any_hit), or the distance in metres or a negative number for a miss.
    /// `tracer` has been built under these settings; unless they make estimators choose among its
    /// candidates, rays have no places.
    std::vector<float> trace(const ShaderLibrary& shaders, const Settings& settings,
                             const Tracer& tracer, RayQuestion question,
                             std::span<const ListedRay> rays);

    static ShaderVariant variant(const Settings& settings, const Tracer& tracer,
                                 RayQuestion question);

private:
    std::vector<std::pair<ShaderVariant, Program>> programs_;
};

} // namespace romascope
