// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/gpu_surfaces.h"

namespace romascope {

/// The scene's triangles and surfaces on the GPU: one vertex array, one draw for all triangles that
/// are drawn alike.
class GpuScene {
public:
    explicit GpuScene(const Scene& scene);

    /// Vertex attributes: 0 position, 1 normal, 2 material index, 3 texture coordinates (0 if the
    /// scene has none), 4 colour and alpha (1 if the scene has none).
    void draw(const TriangleGroup& group) const;
    const std::vector<TriangleGroup>& groups() const { return groups_; }
    /// Whether attributes 3 and 4 say anything.
    bool has_detail() const { return texcoords_.bytes() + colors_.bytes() > 0; }
    const GpuSurfaces& surfaces() const { return surfaces_; }
    /// Three floats a vertex, for the pass that moves them.
    const Buffer& positions() const { return positions_; }
    const Buffer& normals() const { return normals_; }
    /// Keeps the positions as they are now, which take as many bytes again, as vertex attribute 5.
    void remember_positions();
    /// Whether attribute 5 is there: where the vertices were when remember_positions was called
    /// last.
    bool has_previous_positions() const { return previous_positions_.bytes() > 0; }
    /// A vertex's material, two floats, RGBA8; the latter two are empty where the scene has none.
    const Buffer& vertex_materials() const { return vertex_materials_; }
    const Buffer& texcoords() const { return texcoords_; }
    const Buffer& colors() const { return colors_; }
    /// Three a triangle.
    const Buffer& indices() const { return indices_; }
    /// The same as texels, which shaders fetch whole: RGB32F a vertex, RGB32UI a triangle.
    const TexelView& position_texels() const { return position_texels_; }
    const TexelView& index_texels() const { return index_texels_; }
    const Bounds& bounds() const { return bounds_; }
    /// For a scene that moves: of the vertices as they stand in this frame.
    void set_bounds(const Bounds& bounds) { bounds_ = bounds; }
    /// Of the bounds that the scene came with, metres: whatever moves, it stays.
    float rest_diagonal() const { return rest_diagonal_; }
    size_t bytes() const;

private:
    Buffer positions_, previous_positions_, normals_, vertex_materials_, texcoords_, colors_,
        indices_;
    TexelView position_texels_, index_texels_;
    GlHandle<delete_vertex_array> vertex_array_;
    std::vector<TriangleGroup> groups_;
    GpuSurfaces surfaces_;
    Bounds bounds_;
    float rest_diagonal_;
};

} // namespace romascope
