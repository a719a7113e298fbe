// SPDX-License-Identifier: MIT
// Rays of a list, traced with any tracer.
//
// In:   rays; "tracer.glsl", chosen by the host
// Out:  answers: 1 or 0, whether the ray met anything; or the distance in metres, negative for a miss
// Host: RAY_LIST_CANDIDATES 0 or 1: rays with a place are traced along the tracer's candidate there;
//       RAY_LIST_DISTANCES 0 or 1; ray_count
#include "tracer.glsl"

layout(local_size_x = 64) in;

struct ListedRay {
    vec3 point;
    float t_max;
    vec3 normal;
    int place; ///< negative: along the direction
    vec3 direction;
    float unused;
};
layout(std430, binding = 0) readonly buffer Rays { ListedRay rays[]; };
layout(std430, binding = 1) writeonly buffer Answers { float answers[]; };
uniform int ray_count;

#if RAY_LIST_DISTANCES
float along_direction(ListedRay ray) { return tracer_closest_hit(ray.point, ray.normal, ray.direction, ray.t_max); }
#else
float along_direction(ListedRay ray) { return tracer_any_hit(ray.point, ray.normal, ray.direction, ray.t_max) ? 1.0 : 0.0; }
#endif

#if !RAY_LIST_CANDIDATES
float along_candidate(ListedRay ray) { return along_direction(ray); }
#elif RAY_LIST_DISTANCES
float along_candidate(ListedRay ray) { return tracer_candidate_closest_hit(ray.place, ray.point, ray.normal, ray.t_max); }
#else
float along_candidate(ListedRay ray) {
    return tracer_candidate_any_hit(ray.place, ray.point, ray.normal, ray.t_max) ? 1.0 : 0.0;
}
#endif

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= ray_count)
        return;
    ListedRay ray = rays[i];
    answers[i] = ray.place >= 0 ? along_candidate(ray) : along_direction(ray);
}
