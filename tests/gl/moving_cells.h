// SPDX-License-Identifier: MIT
#pragma once

#include "tests/gl/gl_test.h"
#include "tests/support/moving_scene.h"

namespace romascope {

/// Ambient occlusion by the spatial hash in a scene in which one block moves.
class MovingCells : public GlTest {
protected:
    static constexpr float kCell = 0.1f;

    MovingCells() {
        settings_.set(kWidth, 96);
        settings_.set(kHeight, 72);
        settings_.set(kOccupancyResolution, 64);
        settings_.set(kAoRadius, 0.6);
        settings_.set(kHashEnabled, true);
        settings_.set(kHashCapacity, 16);
        settings_.set(kHashFixedSize, double{kCell});
        settings_.set(kHashSampleCap, 32768);
    }

    /// A floor of 8 m with posts on it, and a block that stands where pose() puts it.
    static Scene yard() {
        MovingSceneBuilder builder;
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 4.0f);
        for (const glm::vec2 place : {glm::vec2(-3, -1), glm::vec2(-1, -3), glm::vec2(2, 2)})
            add_box(corners, {place.x, 0.3f, place.y}, 0.3f);
        add_box(corners, {3.8f, 1.8f, 3.8f}, 0.2f); // so that what jumps stays within bounds
        builder.add_still(corners);
        std::vector<glm::vec3> block;
        add_box(block, {0, 0.25f, 0}, 0.25f);
        const uint32_t node = builder.add_node({});
        builder.add_moving({block, std::vector<glm::vec3>(block.size()), node, -1, 0, {}, {}});
        Scene scene = builder.build();
        scene.cameras = {look_at("above", {0.5f, 9, 0}, {0, 0, 0}, 0.9f),
                         look_at("sky", {0, 5, 0}, {0, 9, 1}, 0.9f)};
        return scene;
    }

    static Pose pose(glm::dvec3 place) {
        Pose pose{{glm::dmat4(1.0)}, {}};
        pose.node_to_world[0][3] = glm::dvec4(place, 1.0);
        return pose;
    }

    void render(Pipeline& pipeline, const Pose& pose, const Camera& camera, int frames) {
        for (int i = 0; i < frames; ++i) {
            pipeline.set_pose(pose);
            pipeline.render(settings_, camera);
        }
    }

    static uint64_t count(const Pipeline& pipeline, const std::string& name) {
        for (const NamedCount& count : pipeline.counts())
            if (count.name == name)
                return count.count;
        ADD_FAILURE() << "no count " << name;
        return 0;
    }

    Settings settings_{all_knobs()};
};

} // namespace romascope
