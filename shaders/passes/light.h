// SPDX-License-Identifier: MIT
// Lights of a scene (glTF 2.0 extension KHR_lights_punctual), for the lit view and for the host
// that chooses its exposure.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const int kMaxLights = 64;

/// Laid out for std430.
struct LightRecord {
    vec3 position;
    float inverse_range; ///< 1 / metres; 0: no end
    vec3 direction;      ///< unit, the way the light travels
    float directional;   ///< 1: comes from everywhere along `direction`; 0: from `position`
    vec3 color;          ///< lux, or candela if from a position
    float unused;
    /// Share of the light that a spot lets through at cosine c from its axis:
    /// clamp(c * cone.x + cone.y, 0, 1) squared. Others: (0, 1).
    vec2 cone;
    vec2 unused_too;
};

/// Irradiance by one light on a surface with unit normal, lux.
SHARED_FN vec3 light_irradiance(LightRecord light, vec3 point, vec3 normal) {
    if (light.directional != 0.0f)
        return light.color * max(-dot(normal, light.direction), 0.0f);
    vec3 way = light.position - point;
    float distance_squared = max(dot(way, way), 1e-12f);
    vec3 towards = way * inversesqrt(distance_squared);
    float reach = distance_squared * light.inverse_range * light.inverse_range;
    float share = clamp(dot(-towards, light.direction) * light.cone.x + light.cone.y, 0.0f, 1.0f);
    float attenuation = max(1.0f - reach * reach, 0.0f) / distance_squared;
    return light.color * (attenuation * share * share * max(dot(normal, towards), 0.0f));
}

#ifdef __cplusplus
static_assert(sizeof(LightRecord) == 64 && offsetof(LightRecord, cone) == 48);
} // namespace romascope::gpu
#endif
