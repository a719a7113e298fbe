// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"
#include "renderer/scene/scene.h"

#include <cstdint>
#include <functional>
#include <limits>

namespace romascope {

inline constexpr int kMaxReferenceSamples = 1 << 20;

/// What ambient occlusion is asked for. All of it is part of the cache's key.
struct AoQuery {
    Camera camera;
    glm::ivec2 size{0}; ///< pixels, 1 to 32768 each
    int samples = 64;   ///< rays per pixel, 1 to kMaxReferenceSamples
    float radius = std::numeric_limits<float>::infinity(); ///< metres from the surface, > 0
    uint32_t seed = 0;                                     ///< other rays, same expectation
    /// Primary rays spread over the pixel, one per sample, instead of one through its centre.
    bool pixel_jitter = false;
};

struct AoOptions {
    bool use_cache = true; ///< read and write the cache on disk
    int threads = 0;       ///< 0: one per core. Does not change the result
};

struct AoReference {
    Image visibility; ///< 1 channel: 1 open, 0 closed, background 1
    /// 1 channel: standard deviation of `visibility`, as if its samples were independent; they are
    /// stratified, so the true one is smaller.
    Image standard_error;
    double seconds = 0.0; ///< spent on computing it, now or when it was put into the cache
    bool from_cache = false;
};

/// Ground truth: (1/pi) * integral over the hemisphere about the shading normal of
/// V(w) max(0, n.w) dw at what each pixel shows, by cosine-distributed rays against the triangles.
/// V is 0 if any surface, from either side, lies within the radius; what an alpha mask leaves out
/// is no surface. The shading normal is that of the vertices, turned to the side of the triangle
/// that is seen; backs of materials that are not double-sided are not seen.
/// `progress` is called with fractions that never fall, last 1, by the calling thread only; if it
/// throws, the work is abandoned. Depends on nothing but scene and query. Throws Error (kBadInput)
/// if the query is out of range.
AoReference ambient_occlusion_reference(const Scene& scene, const AoQuery& query,
                                        const std::function<void(double)>& progress = {},
                                        const AoOptions& options = {});

} // namespace romascope
