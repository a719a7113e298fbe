// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/instances.h"

#include "renderer/scene/gltf/numbers.h"
#include "renderer/scene/gltf/plan.h"
#include "renderer/scene/gltf/skin.h"
#include "renderer/scene/pose.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <optional>

namespace romascope::gltf {
namespace {

/// A node that shows a mesh.
struct Instance {
    uint32_t node = 0; ///< in the hierarchy
    size_t mesh = 0;
    int skin = -1;
    bool moves = false;
};

class Writer {
public:
    Writer(const Document& document, const Hierarchy& hierarchy,
           const std::vector<glm::dmat4>& node_to_world, Scene& scene, MemoryBudget& budget,
           Notices& notices)
        : document_(document), model_(document.model()), hierarchy_(hierarchy),
          node_to_world_(node_to_world), scene_(scene), budget_(budget), notices_(notices),
          rest_(pose_at(scene.motion, -1, 0.0)), materials_(document, scene, budget, notices) {}

    void write() {
        find_instances();
        reserve(make_plan());
        pieces_.resize(model_.meshes.size());
        for (const Instance& instance : instances_)
            if (!instance.moves)
                add(instance);
        scene_.motion.first_vertex = static_cast<uint32_t>(scene_.positions.size());
        scene_.motion.still = scene_.bounds;
        for (const Instance& instance : instances_)
            if (instance.moves)
                add(instance);
        if (scene_.indices.empty()) {
            const std::vector<std::string> lines = notices_.lines();
            refuse("scene", lines.empty() ? "has no triangles"
                                          : fmt::format("has no triangles ({})", lines.front()));
        }
    }

private:
    void find_instances();
    Plan make_plan() const;
    void reserve(const Plan& plan);
    void add(const Instance& instance);
    void add_still(const Piece& piece, const Instance& instance);
    void add_moving(const Piece& piece, const Instance& instance);
    void take_matrices(size_t count);
    void turn_mirrored(const MovingPart& part, size_t first_corner);
    void add_attributes(const Piece& piece, const std::vector<uint32_t>* vertices);
    void add_triangles(const Piece& piece, uint32_t first, bool flat, bool mirrored);
    std::string element_of(const Instance& instance) const {
        return fmt::format("nodes[{}]", hierarchy_.file_node[instance.node]);
    }

    const Document& document_;
    const tinygltf::Model& model_;
    const Hierarchy& hierarchy_;
    const std::vector<glm::dmat4>& node_to_world_;
    Scene& scene_;
    MemoryBudget& budget_;
    Notices& notices_;
    const Pose rest_;                       ///< without animation
    std::map<int, uint32_t> skin_matrices_; ///< per skin in use: its first matrix of the palette
    Materials materials_;
    std::vector<Instance> instances_;
    std::vector<size_t> uses_left_;                         ///< per mesh
    std::vector<std::optional<std::vector<Piece>>> pieces_; ///< per mesh, while it is in use
};

void Writer::find_instances() {
    std::vector<bool> weighed(hierarchy_.nodes.size(), false);
    for (const Animation& animation : scene_.motion.animations)
        for (const MotionChannel& channel : animation.channels)
            if (channel.path == MotionPath::weights)
                weighed[channel.node] = true;
    uses_left_.resize(model_.meshes.size(), 0);
    for (uint32_t place = 0; place < hierarchy_.nodes.size(); ++place) {
        const tinygltf::Node& node = model_.nodes[hierarchy_.file_node[place]];
        if (!hierarchy_.drawn[place] || node.mesh < 0)
            continue;
        Instance instance{place, static_cast<size_t>(node.mesh), node.skin, false};
        const uint32_t first = hierarchy_.nodes[place].first_weight;
        const uint32_t count = hierarchy_.nodes[place].weight_count;
        const bool bent = std::any_of(hierarchy_.weights.begin() + first,
                                      hierarchy_.weights.begin() + first + count,
                                      [](float weight) { return weight != 0.0f; });
        instance.moves = hierarchy_.moves[place] || weighed[place] || bent || node.skin >= 0;
        ++uses_left_[instance.mesh];
        instances_.push_back(instance);
    }
}

Plan Writer::make_plan() const {
    std::vector<std::optional<MeshPlan>> meshes(model_.meshes.size());
    Plan plan;
    for (const Instance& instance : instances_) {
        auto& mesh = meshes[instance.mesh];
        if (!mesh)
            mesh = plan_mesh(model_, instance.mesh, materials_);
        plan.add(*mesh, instance.moves, instance.skin >= 0, element_of(instance));
    }
    return plan;
}

/// Reserves exactly once, so that no array is copied as it grows.
void Writer::reserve(const Plan& plan) {
    constexpr size_t kWithCopy = 2; // drawing needs its own
    const size_t per_vertex = sizeof(glm::vec3) * 2 + sizeof(uint32_t) +
                              (plan.texcoords ? sizeof(glm::vec2) : 0) +
                              (plan.colors ? sizeof(uint32_t) : 0);
    budget_.take(plan.vertices, kWithCopy * per_vertex, "scene");
    budget_.take(plan.corners, kWithCopy * sizeof(uint32_t), "scene");
    budget_.take(plan.moving_vertices, kWithCopy * (2 * sizeof(glm::vec3) + sizeof(uint32_t)),
                 "scene");
    budget_.take(plan.influences, kWithCopy * sizeof(Influence), "scene");
    budget_.take(plan.deltas, kWithCopy * sizeof(MorphDelta), "scene");
    scene_.positions.reserve(plan.vertices);
    scene_.normals.reserve(plan.vertices);
    scene_.vertex_material.reserve(plan.vertices);
    if (plan.texcoords)
        scene_.texcoords.reserve(plan.vertices);
    if (plan.colors)
        scene_.colors.reserve(plan.vertices);
    scene_.indices.reserve(plan.corners);
    scene_.motion.rest_positions.reserve(plan.moving_vertices);
    scene_.motion.rest_normals.reserve(plan.moving_vertices);
    scene_.motion.influences.reserve(plan.influences);
    scene_.motion.deltas.reserve(plan.deltas);
}

void Writer::add(const Instance& instance) {
    auto& pieces = pieces_[instance.mesh];
    if (!pieces) {
        pieces.emplace();
        for (size_t p = 0; p < model_.meshes[instance.mesh].primitives.size(); ++p)
            if (auto piece = read_piece(document_, instance.mesh, p, materials_, budget_, notices_))
                pieces->push_back(std::move(*piece));
    }
    for (const Piece& piece : *pieces)
        instance.moves ? add_moving(piece, instance) : add_still(piece, instance);
    if (--uses_left_[instance.mesh] > 0)
        return;
    for (const Piece& piece : *pieces)
        budget_.give(piece.bytes());
    pieces.reset();
}

/// Texture coordinates, colours and materials of new vertices: one for each of the piece, or for
/// each corner if it is flat.
void Writer::add_attributes(const Piece& piece, const std::vector<uint32_t>* vertices) {
    const size_t first = scene_.vertex_material.size();
    const size_t count = vertices ? vertices->size() : piece.sources.size();
    const auto source = [&](size_t i) { return vertices ? (*vertices)[i] : i; };
    scene_.vertex_material.resize(first + count, materials_.use(piece.material));
    if (!piece.texcoords.empty()) {
        scene_.texcoords.resize(first, glm::vec2(0.0f)); // earlier ones without a texture
        for (size_t i = 0; i < count; ++i)
            scene_.texcoords.push_back(piece.texcoords[source(i)]);
    }
    if (!piece.colors.empty()) {
        scene_.colors.resize(first, 0xffffffffu);
        for (size_t i = 0; i < count; ++i)
            scene_.colors.push_back(piece.colors[source(i)]);
    }
}

void Writer::add_triangles(const Piece& piece, uint32_t first, bool flat, bool mirrored) {
    for (size_t i = 0; i < piece.corners.size(); i += 3) {
        uint32_t corners[3];
        for (size_t k = 0; k < 3; ++k)
            corners[k] = first + (flat ? static_cast<uint32_t>(i + k) : piece.corners[i + k]);
        if (mirrored)
            std::swap(corners[1], corners[2]);
        scene_.indices.insert(scene_.indices.end(), {corners[0], corners[1], corners[2]});
    }
}

void Writer::add_still(const Piece& piece, const Instance& instance) {
    const glm::dmat4& world = node_to_world_[instance.node];
    const glm::dmat3 linear(world);
    const bool mirrored = glm::determinant(linear) < 0.0;
    if (glm::cross(linear[1], linear[2]) == glm::dvec3(0.0) &&
        glm::cross(linear[2], linear[0]) == glm::dvec3(0.0) &&
        glm::cross(linear[0], linear[1]) == glm::dvec3(0.0))
        return; // scaled to a line or a point: the usual way to hide something
    const auto first = static_cast<uint32_t>(scene_.positions.size());
    const bool flat = piece.normals.empty(); // each triangle has its own normal and vertices
    const size_t count = flat ? piece.corners.size() : piece.positions.size();
    glm::vec3 own_normal{0.0f};
    for (size_t i = 0; i < count; ++i) {
        const auto at = [&](size_t corner) { return piece.positions[piece.corners[corner]]; };
        if (flat && i % 3 == 0)
            own_normal = face_normal(at(i), at(i + 1), at(i + 2));
        const glm::dvec3 position(world * glm::dvec4(flat ? at(i) : piece.positions[i], 1.0));
        if (!glm::all(glm::lessThanEqual(glm::abs(position), glm::dvec3(kMaxCoordinate))))
            refuse(element_of(instance),
                   fmt::format("places a vertex beyond {} m", kMaxCoordinate));
        scene_.positions.push_back(glm::vec3(position));
        scene_.normals.push_back(
            moved_normal(linear, glm::dvec3(flat ? own_normal : piece.normals[i])));
        scene_.bounds.add(scene_.positions.back());
    }
    add_attributes(piece, flat ? &piece.corners : nullptr);
    add_triangles(piece, first, flat, mirrored);
}

/// Matrices are kept by the poses of the CPU and in the palette of the GPU.
void Writer::take_matrices(size_t count) {
    budget_.take(count, sizeof(glm::dmat4) + 3 * sizeof(glm::vec4), "scene");
    scene_.motion.matrix_count += static_cast<uint32_t>(count);
}

/// Turns round those triangles of a part, from index `first_corner` on, that its matrices mirror:
/// as it stands first, or without animation where it has no size yet.
void Writer::turn_mirrored(const MovingPart& part, size_t first_corner) {
    const Motion& motion = scene_.motion;
    const auto orientation = [&](uint32_t vertex, const std::vector<glm::dmat4>& node_to_world) {
        if (part.influence_sets == 0)
            return glm::determinant(glm::dmat3(node_to_world[part.node]));
        const Skin& skin = motion.skins[static_cast<size_t>(part.skin)];
        glm::dmat3 matrix(0.0);
        const size_t first =
            part.first_influence + size_t{vertex - part.first_vertex} * part.influence_sets;
        for (size_t set = first; set < first + part.influence_sets; ++set)
            for (int i = 0; i < 4; ++i) {
                const size_t joint = motion.influences[set].joint[i];
                matrix += double{motion.influences[set].weight[i]} *
                          glm::dmat3(node_to_world[skin.joints[joint]] * skin.inverse_bind[joint]);
            }
        return glm::determinant(matrix);
    };
    for (size_t i = first_corner; i < scene_.indices.size(); i += 3) {
        const double now = orientation(scene_.indices[i], node_to_world_);
        if ((now != 0.0 ? now : orientation(scene_.indices[i], rest_.node_to_world)) < 0.0)
            std::swap(scene_.indices[i + 1], scene_.indices[i + 2]);
    }
}

void Writer::add_moving(const Piece& piece, const Instance& instance) {
    Motion& motion = scene_.motion;
    MovingPart part;
    part.first_vertex = static_cast<uint32_t>(scene_.positions.size());
    part.vertex_count = static_cast<uint32_t>(piece.positions.size());
    part.node = instance.node;
    part.first_influence = static_cast<uint32_t>(motion.influences.size());
    part.first_delta = static_cast<uint32_t>(motion.deltas.size());
    const auto influences = influence_accessors(model_, piece.mesh, piece.primitive);
    if (instance.skin >= 0 && !influences.joints.empty()) {
        const Skin& skin = motion.skins[static_cast<size_t>(instance.skin)];
        part.skin = instance.skin;
        part.influence_sets = static_cast<uint32_t>(influences.joints.size());
        const auto read = read_influences(document_, influences, piece.sources, piece.vertex_count,
                                          skin, piece.element, notices_);
        motion.influences.insert(motion.influences.end(), read.begin(), read.end());
        const auto [range, fresh] = skin_matrices_.try_emplace(instance.skin, motion.matrix_count);
        part.first_matrix = range->second;
        if (fresh)
            take_matrices(skin.joints.size());
    } else {
        part.first_matrix = motion.matrix_count;
        take_matrices(1);
    }
    const auto deltas = read_deltas(document_, piece);
    part.target_count =
        piece.positions.empty() ? 0 : static_cast<uint32_t>(deltas.size() / piece.positions.size());
    motion.deltas.insert(motion.deltas.end(), deltas.begin(), deltas.end());
    motion.parts.push_back(part);

    const size_t count = piece.positions.size();
    motion.rest_positions.insert(motion.rest_positions.end(), piece.positions.begin(),
                                 piece.positions.end());
    motion.rest_normals.resize(motion.rest_normals.size() + count, glm::vec3(0.0f));
    std::ranges::copy(piece.normals, motion.rest_normals.end() - static_cast<ptrdiff_t>(count));
    scene_.positions.resize(scene_.positions.size() + count);
    scene_.normals.resize(scene_.normals.size() + count);
    add_attributes(piece, nullptr);
    const size_t first_corner = scene_.indices.size();
    add_triangles(piece, part.first_vertex, false, false);
    turn_mirrored(part, first_corner);
}

} // namespace

void add_instances(const Document& document, const Hierarchy& hierarchy,
                   const std::vector<glm::dmat4>& node_to_world, Scene& scene, MemoryBudget& budget,
                   Notices& notices) {
    Writer(document, hierarchy, node_to_world, scene, budget, notices).write();
    const size_t count = scene.positions.size(); // of the last vertices, too, all attributes
    if (!scene.texcoords.empty())
        scene.texcoords.resize(count, glm::vec2(0.0f));
    if (!scene.colors.empty())
        scene.colors.resize(count, 0xffffffffu);
}

} // namespace romascope::gltf
