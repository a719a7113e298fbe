// SPDX-License-Identifier: MIT
// Pictures of the reference: what they show, and that nothing but the query decides it.
#include "renderer/base/error.h"
#include "tests/support/reference_fixture.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <thread>

namespace romascope {
namespace {

TEST_F(Reference, picture_agrees_with_the_closed_form) {
    DiscView view;
    view.query.samples = 1024;
    const AoReference result = ambient_occlusion_reference(view.scene, view.query);
    double z_sum = 0.0;
    int floor_pixels = 0, background = 0;
    for (int y = 0; y < view.query.size.y; ++y)
        for (int x = 0; x < view.query.size.x; ++x) {
            const Camera& camera = view.query.camera;
            const glm::vec3 way = camera.direction_through(glm::vec2(x, y) + 0.5f, view.query.size);
            const float seen = result.visibility.at(x, y, 0);
            const glm::vec3 point = camera.eye - way * (camera.eye.y / way.y);
            if (way.y >= 0.0f || std::abs(point.x) > 20.0f || std::abs(point.z) > 20.0f) {
                if (way.y <= 0.0f) {
                    EXPECT_EQ(seen, 1.0f);
                    ++background;
                }
                continue;
            }
            ++floor_pixels;
            const double hidden = disc_share(1.0, 2.0, std::hypot(point.x, point.z));
            EXPECT_NEAR(seen, 1.0 - hidden, tolerance(hidden, 1024)) << x << ' ' << y;
            z_sum += (seen - (1.0 - hidden)) / std::sqrt(hidden * (1.0 - hidden) / 1024);
        }
    EXPECT_GT(floor_pixels, 400);
    EXPECT_GT(background, 10);
    // Independent pixels: their mean z has deviation 1 / sqrt(n) at most.
    EXPECT_LT(std::abs(z_sum / floor_pixels), 5.0 / std::sqrt(floor_pixels));
}

TEST_F(Reference, jittered_pixels_average_finer_ones) {
    DiscView view;
    view.query.size = {12, 8};
    view.query.samples = 4096;
    view.query.pixel_jitter = true;
    const Image jittered = ambient_occlusion_reference(view.scene, view.query).visibility;
    AoQuery fine = view.query;
    fine.pixel_jitter = false;
    fine.size *= 16;
    fine.samples = 32;
    const Image finer = ambient_occlusion_reference(view.scene, fine).visibility;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 12; ++x) {
            double mean = 0.0;
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 16; ++i)
                    mean += finer.at(16 * x + i, 16 * y + j, 0) / 256.0;
            // 4096 samples deviate by 0.008 at most, a straight edge through 16 rows adds 1/64.
            EXPECT_NEAR(jittered.at(x, y, 0), mean, 5.0 * 0.008 + 0.016) << x << ' ' << y;
        }
}

TEST_F(Reference, result_does_not_depend_on_threads) {
    DiscView view;
    view.query.size = {100, 61};
    for (const bool jitter : {false, true}) {
        view.query.pixel_jitter = jitter;
        const auto with = [&](int threads) {
            return ambient_occlusion_reference(view.scene, view.query, {}, {false, threads})
                .visibility.data;
        };
        const auto one = with(1);
        EXPECT_EQ(one, with(2));
        EXPECT_EQ(one, with(7));
        EXPECT_EQ(one, with(0));
        view.query.seed += 1;
        EXPECT_NE(one, with(2));
    }
}

TEST_F(Reference, progress_rises_to_one_on_the_callers_thread) {
    DiscView view;
    view.query.size = {200, 200};
    view.query.samples = 1;
    double last = 0.0;
    int calls = 0;
    const auto caller = std::this_thread::get_id();
    const auto watch = [&](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
        ++calls;
    };
    ambient_occlusion_reference(view.scene, view.query, watch, {false, 3});
    EXPECT_EQ(last, 1.0);
    EXPECT_GT(calls, 2);
    EXPECT_THROW(ambient_occlusion_reference(view.scene, view.query,
                                             [](double) { throw std::runtime_error("stop"); },
                                             {false, 3}),
                 std::runtime_error);
}

TEST_F(Reference, refuses_queries_out_of_range) {
    const auto refused = [](const std::function<void(AoQuery&)>& change, const char* word) {
        DiscView view;
        change(view.query);
        try {
            ambient_occlusion_reference(view.scene, view.query);
            ADD_FAILURE() << word;
        } catch (const Error& error) {
            EXPECT_EQ(error.exit_status(), kBadInput);
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    };
    refused([](AoQuery& q) { q.size = {0, 5}; }, "pixels");
    refused([](AoQuery& q) { q.size = {5, 1 << 20}; }, "pixels");
    refused([](AoQuery& q) { q.samples = 0; }, "samples");
    refused([](AoQuery& q) { q.radius = 0.0f; }, "radius");
    refused([](AoQuery& q) { q.radius = std::nanf(""); }, "radius");
    refused([](AoQuery& q) { q.camera.eye.y = kInfinite; }, "camera");
}

TEST_F(Reference, empty_scene_is_all_background) {
    AoQuery query = DiscView().query;
    const Image picture = ambient_occlusion_reference({}, query, {}, {false, 1}).visibility;
    EXPECT_EQ(std::ranges::count(picture.data, 1.0f), query.size.x * query.size.y);
}

} // namespace
} // namespace romascope
