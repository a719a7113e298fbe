// SPDX-License-Identifier: MIT
#include "renderer/reference/ao_reference.h"
#include "tests/gl/small_pictures.h"

#include <cmath>

namespace romascope {
namespace {

class AmbientOcclusionTest : public SmallPictures {};

TEST_F(AmbientOcclusionTest, AnOpenPlaneIsExactlyOneByCandidates) {
    leave_all_own_cells(settings_);
    std::mt19937 random(1);
    for (int i = 0; i < 40; ++i) {
        const auto [scene, camera, normal] = open_plane(random, i == 0);
        settings_.set(kRomaAlignment, i % 2 ? RomaAlignment::rotate : RomaAlignment::shear);
        settings_.set(kRomaAngularResolution, 2 + i % 7);
        settings_.set(kAoRays, 1 + i % 5);
        settings_.set(kSeed, i);
        const Image image = render(scene, camera, 3);
        for (const float value : image.data)
            ASSERT_EQ(value, 1.0f) << "normal " << normal.x << " " << normal.y << " " << normal.z;
    }
}

TEST_F(AmbientOcclusionTest, TheDefaultDarkensAnOpenPlaneALittle) {
    // Half a cell off and two cells on, rays that graze the plane can still meet it: 60 % of those
    // within 3 degrees of it, 0.2 % of those beyond 27 degrees, 2.0 % of all.
    settings_.set(kAoRays, 16);
    std::mt19937 random(2);
    double sum = 0;
    for (int i = 0; i < 20; ++i) {
        const auto [scene, camera, normal] = open_plane(random, i == 0);
        settings_.set(kSeed, i);
        sum += mean(render(scene, camera, 4)) / 20;
    }
    EXPECT_NEAR(sum, 0.980, 0.005);
}

TEST_F(AmbientOcclusionTest, SnappedRaysDarkenAnOpenPlane) {
    leave_all_own_cells(settings_);
    // Candidates of a stratum can point below the surface (sheared by up to a stratum's size): the
    // published sampling loses a few percent on some planes, which is why it is not the default.
    settings_.set(kRomaSampling, RomaSampling::snap);
    settings_.set(kAoRays, 16);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, 1.0f, 0.2f));
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, normal, 3.0f));
    const double open = mean(render(scene, look_at("above", 2.0f * normal, {0, 0, 0}, 0.8f), 8));
    EXPECT_LT(open, 0.999);
    EXPECT_GT(open, 0.85);
}

TEST_F(AmbientOcclusionTest, AWallIsSeenAsTheReferenceSeesIt) {
    std::vector<glm::vec3> corners = rectangle({5, 0, 0}, {0, 1, 0}, 5.0f);
    const std::vector<glm::vec3> wall = rectangle({0, 5, 0}, {1, 0, 0}, 5.0f);
    corners.insert(corners.end(), wall.begin(), wall.end());
    const Scene scene = scene_of_triangles(corners);
    leave_all_own_cells(settings_);
    settings_.set(kAoRays, 64);
    // From eight cells of the wall, where half the sky is closed, to where nearly all is open.
    for (const float distance : {1.25f, 4.0f, 9.0f}) {
        const Camera camera = look_at("spot", {distance, 2.0f, 0}, {distance, 0, 0}, 0.01f);
        const AoQuery query{camera, {32, 24}, 256};
        const double truth =
            mean(ambient_occlusion_reference(scene, query, {}, {.use_cache = false}).visibility);
        for (const RomaSampling sampling : {RomaSampling::candidates, RomaSampling::snap}) {
            settings_.set(kRomaSampling, sampling);
            for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
                settings_.set(kRomaAlignment, alignment);
                // Through a wall of one sheet a tenth of the rays that should meet it may pass, as
                // columns lie between the centres of cells. All pixels share the 16 directions of a
                // frame, whose mean has a standard deviation of about 0.06 here, 0.007 after 64
                // frames; three of those.
                EXPECT_NEAR(mean(render(scene, camera, 64)), truth, 0.02 + 0.1 * (1 - truth))
                    << distance << " m from the wall";
            }
        }
    }
}

TEST_F(AmbientOcclusionTest, ALidIsWeighedByItsCosineWhateverTheNormal) {
    // A lid closes the directions about the normal, which count most. The normal lies askew to the
    // strata, so that candidates taken for one another would not go unnoticed.
    settings_.set(kAoRays, 16);
    const glm::vec3 normal = glm::normalize(glm::vec3(1.0f, 1.0f, 0.3f));
    std::vector<glm::vec3> corners = rectangle({0, 0, 0}, normal, 2.0f);
    for (const glm::vec3 corner : rectangle(1.2f * normal, -normal, 0.8f))
        corners.push_back(corner);
    const Scene scene = scene_of_triangles(corners);
    const Camera camera = look_at("under", 0.6f * normal, {0, 0, 0}, 0.05f);
    const double truth =
        mean(ambient_occlusion_reference(scene, {camera, {32, 24}, 256}, {}, {.use_cache = false})
                 .visibility);
    // Along a slanted direction the map's samples lie up to 1.37 cells apart across a sheet of one
    // cell, which lets up to 27 % of the closed rays pass; noise of 32 frames as above.
    EXPECT_NEAR(mean(render(scene, camera, 32)), truth, 0.03 + 0.27 * (1 - truth));
}

TEST_F(AmbientOcclusionTest, NothingBeyondTheRadiusOccludes) {
    const auto [scene, camera, normal] = below_a_ceiling();
    leave_all_own_cells(settings_);
    settings_.set(kAoRays, 16);
    settings_.set(kAoRadius, 1.8);
    EXPECT_EQ(mean(render(scene, camera, 4)), 1.0);
    settings_.set(kAoRadius, 2.3);
    const double reached = mean(render(scene, camera, 16));
    EXPECT_LT(reached, 0.95); // straight up and near it
    settings_.set(kAoRadius, std::numeric_limits<double>::infinity());
    EXPECT_LT(mean(render(scene, camera, 16)), reached);
}

TEST_F(AmbientOcclusionTest, BackgroundIsOpen) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0, 1, 0}, 1.0f));
    const Image image = render(scene, look_at("away", {0, 1, 0}, {0, 2, 0.1f}, 1.0f), 1);
    for (const float value : image.data)
        EXPECT_EQ(value, 1.0f);
}

TEST_F(AmbientOcclusionTest, MoreRaysAreFewerFrames) {
    std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 2.0f);
    const std::vector<glm::vec3> block = rectangle({0.5f, 0.7f, 0}, {1, 0.2f, 0}, 0.7f);
    corners.insert(corners.end(), block.begin(), block.end());
    const Scene scene = scene_of_triangles(corners);
    const Camera camera = look_at("view", {-2, 2, 1}, {0, 0, 0}, 0.7f);
    const Image many_frames = render(scene, camera, 48);
    settings_.set(kAoRays, 16);
    const Image many_rays = render(scene, camera, 48);
    EXPECT_NEAR(mean(many_frames), mean(many_rays), 0.006);
}

TEST_F(AmbientOcclusionTest, TheSameSeedGivesTheSameBytes) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0.2f, 1, 0.1f}, 1.0f));
    settings_.set(kRomaSampling, RomaSampling::snap); // noise, so that there is something to differ
    settings_.set(kSeed, 42);
    const Image first = render(scene, scene.cameras[0], 3);
    EXPECT_EQ(render(scene, scene.cameras[0], 3).data, first.data);
    settings_.set(kSeed, 43);
    EXPECT_NE(render(scene, scene.cameras[0], 3).data, first.data);
}

TEST_F(AmbientOcclusionTest, DoesNotDependOnWhatElseIsInFlight) {
    // Frames of a new pipeline wait behind those of another; what is uploaded for the second frame
    // must not be seen by the first.
    std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0.2f, 1, 0.1f}, 1.0f);
    for (const glm::vec3& corner : rectangle({0.3f, 0.4f, 0}, {1, 0.3f, 0.2f}, 0.5f))
        corners.push_back(corner);
    const Scene scene = scene_of_triangles(corners);
    Pipeline busy(scene, ShaderLibrary());
    std::vector<Image> found;
    for (int trial = 0; trial < 3; ++trial) {
        Pipeline pipeline(scene, ShaderLibrary());
        for (int i = 0; i < 2; ++i) {
            busy.render(settings_, scene.cameras[0]);
            pipeline.render(settings_, scene.cameras[0]);
        }
        found.push_back(pipeline.picture());
    }
    Pipeline calm(scene, ShaderLibrary());
    for (int i = 0; i < 2; ++i) {
        calm.render(settings_, scene.cameras[0]);
        glFinish();
    }
    for (const Image& image : found)
        EXPECT_TRUE(image.data == calm.picture().data);
}

TEST_F(AmbientOcclusionTest, AChangeOfSettingsStartsTheMeanAnew) {
    const Scene scene = scene_of_triangles(rectangle({0, 0, 0}, {0.2f, 1, 0.1f}, 1.0f));
    settings_.set(kRomaSampling, RomaSampling::snap);
    Pipeline pipeline(scene, ShaderLibrary());
    pipeline.render(settings_, scene.cameras[0]);
    pipeline.render(settings_, scene.cameras[0]);
    EXPECT_EQ(pipeline.frame_count(), 2u);
    settings_.set(kRomaAngularResolution, 3);
    pipeline.render(settings_, scene.cameras[0]);
    EXPECT_EQ(pipeline.frame_count(), 1u);
    // Nothing of the old frames is left, but the directions are new: as a fresh pipeline's third.
    Settings other = settings_;
    other.set(kAoRadius, 1000.0);
    Pipeline fresh(scene, ShaderLibrary());
    fresh.render(other, scene.cameras[0]);
    fresh.render(other, scene.cameras[0]);
    fresh.render(settings_, scene.cameras[0]);
    EXPECT_EQ(pipeline.picture().data, fresh.picture().data);
    EXPECT_NE(pipeline.picture().data, render(scene, scene.cameras[0], 1).data);
    // Sizes, too, and all over again when asked.
    settings_.set(kWidth, 7);
    settings_.set(kHeight, 5);
    pipeline.restart();
    pipeline.render(settings_, scene.cameras[0]);
    EXPECT_EQ(pipeline.picture().data, render(scene, scene.cameras[0], 1).data);
    settings_.set(kView, PictureKind::lit);
    pipeline.render(settings_, scene.cameras[0]);
    EXPECT_EQ(pipeline.picture().channels, 3);
}

} // namespace
} // namespace romascope
