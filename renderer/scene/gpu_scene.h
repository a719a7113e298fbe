// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/objects.h"
#include "renderer/scene/scene.h"

namespace romascope {

/// The scene's triangles and materials on the GPU: one vertex array, one draw.
class GpuScene {
public:
    explicit GpuScene(const Scene& scene);

    /// Vertex attributes: 0 position, 1 normal, 2 material index.
    void draw() const;
    const Buffer& materials() const {
        return materials_;
    } ///< std430: vec4 base colour, vec4 emission
    /// Three floats a vertex, for the pass that moves them.
    const Buffer& positions() const { return positions_; }
    const Buffer& normals() const { return normals_; }
    const Bounds& bounds() const { return bounds_; }
    /// For a scene that moves: of the vertices as they stand in this frame.
    void set_bounds(const Bounds& bounds) { bounds_ = bounds; }
    size_t bytes() const;

private:
    Buffer positions_, normals_, vertex_materials_, indices_, materials_;
    GlHandle<delete_vertex_array> vertex_array_;
    GLsizei index_count_ = 0;
    Bounds bounds_;
};

} // namespace romascope
