// SPDX-License-Identifier: MIT
#include "tests/support/moving_scene.h"

#include <algorithm>
#include <tuple>

namespace romascope {
namespace {

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

uint32_t below(std::mt19937& random, size_t count) {
    return std::uniform_int_distribution<uint32_t>(0, static_cast<uint32_t>(count) - 1)(random);
}

glm::dvec3 random_vector(std::mt19937& random, double size) {
    return {uniform(random, -size, size), uniform(random, -size, size),
            uniform(random, -size, size)};
}

glm::dquat random_rotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(
        glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

glm::dvec3 random_scale(std::mt19937& random) {
    glm::dvec3 scale(uniform(random, 0.7, 1.3), uniform(random, 0.7, 1.3),
                     uniform(random, 0.7, 1.3));
    if (below(random, 5) == 0)
        scale[static_cast<int>(below(random, 3))] *= -1.0;
    return scale;
}

glm::dmat4 affine(const glm::dquat& rotation, glm::dvec3 translation, glm::dvec3 scale) {
    glm::dmat4 matrix(glm::mat3_cast(rotation));
    for (int axis = 0; axis < 3; ++axis)
        matrix[axis] *= scale[axis];
    matrix[3] = glm::dvec4(translation, 1.0);
    return matrix;
}

/// Random trees, channels and pieces.
class RandomScene {
public:
    RandomScene(std::mt19937& random, int triangles) : random_(random), triangles_(triangles) {}

    Scene make(const MovingKinds& kinds) {
        std::vector<glm::vec3> floor;
        for (uint32_t i = 0; i < 3 * (1 + below(random_, 40)); ++i)
            floor.emplace_back(random_vector(random_, 4.0));
        builder_.add_still(floor);
        make_nodes();
        for (const auto& [wanted, targets, sets] :
             {std::tuple(kinds.rigid, 0u, 0u), std::tuple(kinds.skinned, 0u, 1u),
              std::tuple(kinds.skinned_twice, 0u, 2u), std::tuple(kinds.morphing, 3u, 0u),
              std::tuple(kinds.morphing_skinned, 2u, 1u)})
            for (int copy = 0; wanted && copy < 2; ++copy)
                add_piece(targets, sets);
        Scene& scene = builder_.scene();
        scene.lights.push_back({});
        builder_.motion().cameras.push_back({0, some_node()});
        builder_.motion().lights.push_back({0, some_node()});
        return builder_.build();
    }

private:
    static constexpr uint32_t kNodes = 9;

    uint32_t some_node() { return below(random_, kNodes); }

    void make_nodes() {
        for (uint32_t i = 0; i < kNodes; ++i) {
            MotionNode node;
            node.parent = i == 0 ? -1 : static_cast<int>(below(random_, i + 1)) - 1;
            node.translation = random_vector(random_, 1.5);
            node.rotation = random_rotation(random_);
            node.scale = random_scale(random_);
            if (below(random_, 4) == 0) {
                node.has_matrix = true;
                node.matrix = affine(node.rotation, node.translation, node.scale);
            }
            builder_.add_node(node);
            if (node.has_matrix)
                continue;
            for (const MotionPath path :
                 {MotionPath::translation, MotionPath::rotation, MotionPath::scale})
                if (below(random_, 2) == 0)
                    animate(i, path, path == MotionPath::rotation ? 4 : 3);
        }
    }

    void animate(uint32_t node, MotionPath path, size_t count) {
        const auto interpolation = static_cast<Interpolation>(below(random_, 3));
        std::vector<float> times;
        float time = static_cast<float>(uniform(random_, 0.0, 0.5));
        for (uint32_t key = 0; key < 2 + below(random_, 4); ++key) {
            times.push_back(time);
            time += static_cast<float>(uniform(random_, 0.1, 1.0));
        }
        std::vector<float> values;
        const int groups = interpolation == Interpolation::cubic ? 3 : 1;
        for (size_t key = 0; key < times.size(); ++key) {
            for (int group = 0; group < groups; ++group) {
                const bool tangent = groups == 3 && group != 1;
                const glm::dquat turn = random_rotation(random_);
                for (size_t i = 0; i < count; ++i) {
                    const double value = path == MotionPath::rotation ? turn[static_cast<int>(i)]
                                         : path == MotionPath::scale  ? uniform(random_, 0.6, 1.4)
                                                                      : uniform(random_, -1.0, 1.0);
                    values.push_back(static_cast<float>(tangent ? 0.5 * value : value));
                }
            }
        }
        builder_.add_channel(node, path, interpolation, times, values);
    }

    void add_piece(uint32_t targets, uint32_t sets) {
        MovingSceneBuilder::Piece piece;
        piece.influence_sets = sets;
        for (int i = 0; i < 3 * triangles_; ++i) {
            piece.corners.emplace_back(random_vector(random_, 1.0));
            // Some leave the normal to the triangle.
            piece.normals.push_back(below(random_, 8) == 0
                                        ? glm::vec3(0.0f)
                                        : glm::vec3(glm::normalize(random_vector(random_, 1.0))));
        }
        piece.node = some_node();
        if (targets > 0)
            add_targets(piece, targets);
        if (sets > 0)
            add_skin(piece);
        builder_.add_moving(piece);
    }

    /// On a node of its own: a node has the weights of one mesh.
    void add_targets(MovingSceneBuilder::Piece& piece, uint32_t targets) {
        MotionNode node;
        node.parent = static_cast<int>(some_node());
        node.first_weight = static_cast<uint32_t>(builder_.motion().weights.size());
        node.weight_count = targets;
        for (uint32_t i = 0; i < targets; ++i)
            builder_.motion().weights.push_back(static_cast<float>(uniform(random_, -1.0, 1.0)));
        piece.node = builder_.add_node(node);
        if (below(random_, 3) != 0)
            animate(piece.node, MotionPath::weights, targets);
        for (size_t i = 0; i < targets * piece.corners.size(); ++i)
            piece.deltas.push_back(
                {glm::vec3(random_vector(random_, 0.5)), glm::vec3(random_vector(random_, 0.3))});
    }

    void add_skin(MovingSceneBuilder::Piece& piece) {
        std::vector<uint32_t> joints(kNodes);
        for (uint32_t i = 0; i < kNodes; ++i)
            joints[i] = i;
        std::shuffle(joints.begin(), joints.end(), random_);
        joints.resize(2 + below(random_, kNodes - 2));
        std::vector<glm::dmat4> inverse_bind;
        for (size_t i = 0; i < joints.size(); ++i)
            inverse_bind.push_back(affine(random_rotation(random_), random_vector(random_, 0.5),
                                          random_scale(random_)));
        piece.skin = builder_.add_skin(joints, inverse_bind);
        for (size_t vertex = 0; vertex < piece.corners.size(); ++vertex) {
            std::vector<double> weights(4 * piece.influence_sets);
            double sum = 0.0;
            for (double& weight : weights)
                sum += weight = below(random_, 3) == 0 ? 0.0 : uniform(random_, 0.0, 1.0);
            if (sum == 0.0)
                sum = weights[0] = 1.0;
            for (uint32_t set = 0; set < piece.influence_sets; ++set) {
                Influence influence;
                for (int i = 0; i < 4; ++i) {
                    influence.joint[i] = static_cast<uint16_t>(below(random_, joints.size()));
                    influence.weight[i] =
                        static_cast<float>(weights[4 * set + static_cast<size_t>(i)] / sum);
                }
                piece.influences.push_back(influence);
            }
        }
    }

    std::mt19937& random_;
    int triangles_;
    MovingSceneBuilder builder_;
};

/// The sides of a box, from corner to corner, with normals outwards.
MovingSceneBuilder::Piece box(glm::vec3 low, glm::vec3 high) {
    MovingSceneBuilder::Piece piece;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool upper : {false, true}) {
            glm::vec3 corner[4];
            for (int i = 0; i < 4; ++i) {
                corner[i][axis] = upper ? high[axis] : low[axis];
                const int u = (axis + (upper ? 1 : 2)) % 3, v = (axis + (upper ? 2 : 1)) % 3;
                corner[i][u] = i == 1 || i == 2 ? high[u] : low[u];
                corner[i][v] = i >= 2 ? high[v] : low[v];
            }
            glm::vec3 normal(0.0f);
            normal[axis] = upper ? 1.0f : -1.0f;
            for (const int i : {0, 1, 2, 0, 2, 3}) {
                piece.corners.push_back(corner[i]);
                piece.normals.push_back(normal);
            }
        }
    }
    return piece;
}

/// 0 to 4 quarter turns about z, each as x, y, z, w.
const std::vector<float> kQuarterTurns = {0.0f, 0.0f, 0.0f,        1.0f,         //
                                          0.0f, 0.0f, 0.70710678f, 0.70710678f,  //
                                          0.0f, 0.0f, 1.0f,        0.0f,         //
                                          0.0f, 0.0f, 0.70710678f, -0.70710678f, //
                                          0.0f, 0.0f, 0.0f,        -1.0f};

} // namespace

MovingSceneBuilder::MovingSceneBuilder() {
    scene_.name = "moving";
    scene_.materials = {Material{}};
    scene_.cameras = {look_at("camera", {1.0f, 2.0f, 9.0f}, glm::vec3(0.0f), 1.0f)};
    scene_.motion.animations.push_back({"first", 0.0, {}});
}

void MovingSceneBuilder::add_vertices(const std::vector<glm::vec3>& corners,
                                      const std::vector<glm::vec3>& normals) {
    for (size_t i = 0; i < corners.size(); ++i) {
        scene_.indices.push_back(static_cast<uint32_t>(scene_.positions.size()));
        scene_.positions.push_back(corners[i]);
        scene_.normals.push_back(normals[i]);
        scene_.vertex_material.push_back(0);
    }
}

void MovingSceneBuilder::add_still(const std::vector<glm::vec3>& corners) {
    for (const glm::vec3& corner : corners)
        motion().still.add(corner);
    add_vertices(corners, std::vector<glm::vec3>(corners.size(), glm::vec3(0.0f)));
    motion().first_vertex = static_cast<uint32_t>(scene_.positions.size());
}

uint32_t MovingSceneBuilder::add_node(const MotionNode& node) {
    motion().nodes.push_back(node);
    return static_cast<uint32_t>(motion().nodes.size() - 1);
}

void MovingSceneBuilder::add_channel(uint32_t node, MotionPath path, Interpolation interpolation,
                                     std::vector<float> times, std::vector<float> values) {
    Animation& animation = motion().animations.front();
    animation.duration = std::max(animation.duration, double{times.back()});
    animation.channels.push_back({node, path, interpolation, std::move(times), std::move(values)});
}

int MovingSceneBuilder::add_skin(const std::vector<uint32_t>& joints,
                                 const std::vector<glm::dmat4>& inverse_bind) {
    motion().skins.push_back({joints, inverse_bind});
    return static_cast<int>(motion().skins.size() - 1);
}

void MovingSceneBuilder::add_moving(const Piece& piece) {
    Motion& all = motion();
    MovingPart part;
    part.first_vertex = static_cast<uint32_t>(scene_.positions.size());
    part.vertex_count = static_cast<uint32_t>(piece.corners.size());
    part.node = piece.node;
    part.skin = piece.skin;
    part.first_matrix = all.matrix_count;
    part.first_influence = static_cast<uint32_t>(all.influences.size());
    part.influence_sets = piece.influence_sets;
    part.first_delta = static_cast<uint32_t>(all.deltas.size());
    part.target_count = static_cast<uint32_t>(piece.deltas.size() / piece.corners.size());
    all.parts.push_back(part);
    all.matrix_count +=
        piece.skin < 0
            ? 1
            : static_cast<uint32_t>(all.skins[static_cast<size_t>(piece.skin)].joints.size());
    all.influences.insert(all.influences.end(), piece.influences.begin(), piece.influences.end());
    all.deltas.insert(all.deltas.end(), piece.deltas.begin(), piece.deltas.end());
    all.rest_positions.insert(all.rest_positions.end(), piece.corners.begin(), piece.corners.end());
    all.rest_normals.insert(all.rest_normals.end(), piece.normals.begin(), piece.normals.end());
    add_vertices(piece.corners, piece.normals);
}

Scene MovingSceneBuilder::build() {
    scene_.bounds = motion().still;
    apply_pose(scene_, pose_at(motion(), find_animation(scene_, ""), 0.0));
    return std::move(scene_);
}

Scene random_moving_scene(std::mt19937& random, const MovingKinds& kinds, int triangles) {
    return RandomScene(random, triangles).make(kinds);
}

Scene exact_moving_scene() {
    MovingSceneBuilder builder;
    const auto floor = box({-4.0f, -2.5f, -4.0f}, {4.0f, -2.25f, 4.0f});
    builder.add_still(floor.corners);
    const std::vector<float> seconds = {0.0f, 1.0f, 2.0f, 3.0f, 4.0f};

    // Turns a quarter each second.
    const uint32_t turning = builder.add_node({});
    builder.add_channel(turning, MotionPath::rotation, Interpolation::linear, seconds,
                        kQuarterTurns);
    auto rigid = box({1.0f, -0.5f, -1.0f}, {2.0f, 0.75f, 0.25f});
    rigid.node = turning;
    builder.add_moving(rigid);

    // Half of it hangs on a joint that turns, half on one that slides.
    MotionNode slide;
    slide.translation = {-2.0, 0.0, 0.0};
    const uint32_t sliding = builder.add_node(slide);
    builder.add_channel(sliding, MotionPath::translation, Interpolation::linear, {0.0f, 4.0f},
                        {-2.0f, 0.0f, 0.0f, -2.0f, 1.0f, 1.0f});
    auto skinned = box({-0.5f, -0.5f, 1.0f}, {0.5f, 1.5f, 2.0f});
    skinned.skin = builder.add_skin({turning, sliding}, {glm::dmat4(1.0), glm::dmat4(1.0)});
    skinned.influence_sets = 1;
    for (const glm::vec3& corner : skinned.corners) {
        const float half = corner.y > 0.0f ? 0.5f : 0.0f;
        skinned.influences.push_back({{0, 1, 0, 0}, {half, 1.0f - half, 0.0f, 0.0f}});
    }
    builder.add_moving(skinned);

    // Grows and shrinks.
    MotionNode morph;
    morph.translation = {0.0, -1.0, -2.0};
    morph.weight_count = 1;
    builder.motion().weights = {0.0f};
    const uint32_t morphing = builder.add_node(morph);
    builder.add_channel(morphing, MotionPath::weights, Interpolation::linear, {0.0f, 4.0f},
                        {0.0f, 1.0f});
    auto growing = box({-1.0f, -1.0f, -1.0f}, {1.0f, 0.0f, 1.0f});
    growing.node = morphing;
    for (const glm::vec3& corner : growing.corners)
        growing.deltas.push_back({glm::vec3(0.0f, corner.y == 0.0f ? 1.5f : 0.0f, 0.0f), {}});
    builder.add_moving(growing);
    return builder.build();
}

} // namespace romascope
