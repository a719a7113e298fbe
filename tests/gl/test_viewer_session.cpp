// SPDX-License-Identifier: MIT
// What a session in the window keeps of its frames when something changes, and that a picture at
// rest is a new pipeline's where it keeps nothing.
#include "app/viewer/session.h"
#include "renderer/tracers/structure_view.h"
#include "tests/gl/gl_test.h"

#include <utility>

namespace romascope {
namespace {

class ViewerSession : public GlTest {
protected:
    static constexpr int kFramesDrawn = 6;

    void begin(const std::string& technique) {
        Settings settings(all_knobs());
        apply_technique(settings, technique);
        settings.set(kOccupancyResolution, 48);
        settings.set(kFrames, kFramesDrawn);
        settings.set(kWidth, 48);
        settings.set(kHeight, 36);
        settings.set(kCamera, kHere);
        session_.emplace(settings, std::filesystem::path{}, SceneOptions{}, messages_);
        session_->show("yard.glb", yard());
        draw_to_rest();
    }

    /// A floor and a wall that meet.
    static Scene yard() {
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 3.0f);
        for (const glm::vec3 corner : rectangle({0, 1, -1}, {0, 0, 1}, 1.0f))
            corners.push_back(corner);
        return scene_of_triangles(corners);
    }

    int draw_to_rest() {
        int frames = 0;
        while (session_->draw())
            ++frames;
        EXPECT_FALSE(session_->failed());
        EXPECT_EQ(session_->frame_count(), static_cast<uint32_t>(kFramesDrawn));
        return frames;
    }

    /// Moves as a drag does: a change in each of several frames.
    void drag() {
        for (const char* camera : {"0.2,2,3/0,0.5,0/60", "0.4,2,3/0,0.5,0/60", kThere}) {
            session_->set(kCamera, std::string(camera));
            EXPECT_TRUE(session_->draw());
            EXPECT_EQ(session_->frame_count(), 1u);
        }
    }

    /// What `render` makes of the session's settings.
    Image of_new_pipeline() {
        Pipeline pipeline(session_->scene(), ShaderLibrary());
        for (int i = 0; i < kFramesDrawn; ++i)
            pipeline.render(session_->settings(), session_->camera());
        return pipeline.picture();
    }

    bool is_as_rendered() { return picture().data == of_new_pipeline().data; }
    Image picture() { return session_->pipeline()->picture(); }

    /// In all cells of the spatial hash.
    uint64_t samples() {
        uint64_t sum = 0;
        for (const gpu::Cell& cell : session_->pipeline()->spatial_hash().table().download())
            sum += cell.checksum != 0 ? gpu::cell_samples(cell) : 0;
        return sum;
    }

    static constexpr const char* kHere = "0,2,3/0,0.5,0/60";
    static constexpr const char* kThere = "0.6,2,3/0,0.5,0/60";
    Messages messages_;
    std::optional<Session> session_;
};

TEST_F(ViewerSession, WithoutMemoryAMoveEndsAtWhatIsRendered) {
    begin("roma");
    EXPECT_TRUE(is_as_rendered());
    drag();
    draw_to_rest();
    EXPECT_TRUE(is_as_rendered());
}

TEST_F(ViewerSession, AMoveKeepsTheCellsOfTheHash) {
    begin("roma-hash");
    EXPECT_TRUE(is_as_rendered());
    const uint64_t before = samples();
    ASSERT_GT(before, 0u);
    drag();
    EXPECT_GT(samples(), before);
    draw_to_rest();
    EXPECT_GT(samples(), before);
    EXPECT_FALSE(is_as_rendered());
    session_->begin_anew();
    EXPECT_FALSE(session_->at_rest());
    EXPECT_EQ(draw_to_rest(), kFramesDrawn);
    EXPECT_TRUE(is_as_rendered());
}

TEST_F(ViewerSession, LookingAtSomethingElseKeepsTheCellsOfTheHash) {
    begin("roma-hash");
    uint64_t before = samples();
    const auto grew = [&] {
        draw_to_rest();
        return samples() > std::exchange(before, samples());
    };
    session_->set(kView, PictureKind::hash);
    EXPECT_TRUE(grew());
    session_->set(kView, PictureKind::structure);
    EXPECT_TRUE(grew());
    session_->set(kViewMap, 3);
    EXPECT_TRUE(grew());
    session_->set(kView, PictureKind::ambient_occlusion);
    EXPECT_TRUE(grew());
    EXPECT_FALSE(is_as_rendered());
    session_->set(kOccupancyResolution, 32); // other hits
    EXPECT_FALSE(grew());
    EXPECT_TRUE(is_as_rendered());
}

TEST_F(ViewerSession, AMoveKeepsHistories) {
    begin("roma-filtered");
    EXPECT_TRUE(is_as_rendered());
    drag();
    draw_to_rest();
    EXPECT_FALSE(is_as_rendered());
    session_->begin_anew();
    draw_to_rest();
    EXPECT_TRUE(is_as_rendered());
}

TEST_F(ViewerSession, AnyOtherChangeEndsAtWhatIsRendered) {
    begin("roma-hash");
    drag();
    draw_to_rest();
    session_->set(kSeed, 5);
    draw_to_rest();
    EXPECT_TRUE(is_as_rendered());
    // Also several in a row, as a slider makes them, with a move among them.
    drag();
    for (const double radius : {1.0, 0.8, 0.6}) {
        session_->set(kAoRadius, radius);
        EXPECT_TRUE(session_->draw());
    }
    draw_to_rest();
    EXPECT_TRUE(is_as_rendered());
    session_->choose_technique("roma");
    session_->set(kOccupancyResolution, 32);
    draw_to_rest();
    EXPECT_TRUE(is_as_rendered());
}

} // namespace
} // namespace romascope
