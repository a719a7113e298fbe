// SPDX-License-Identifier: MIT
// Views of intermediate results show what is there.
#include "renderer/base/error.h"
#include "renderer/image/color.h"
#include "renderer/tracers/structure_view.h"
#include "tests/gl/gl_test.h"
#include "tests/support/expect_error.h"

#include <algorithm>
#include <bit>

namespace romascope {
namespace {

class ViewsTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        settings_.set(kWidth, 64);
        settings_.set(kHeight, 48);
    }

    /// Longer than high, higher than wide.
    static Scene clutter() {
        std::mt19937 random(4);
        std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
        std::vector<glm::vec3> corners;
        for (int i = 0; i < 40; ++i) {
            const glm::vec3 place(3.0f * unit(random), 2.0f * unit(random), unit(random));
            for (const glm::vec3 corner : rectangle(place, random_direction(random), 0.4f))
                corners.push_back(corner);
        }
        return scene_of_triangles(corners);
    }

    /// Whether times and bytes have that name.
    static bool tells_of(Pipeline& pipeline, const std::string& name) {
        pipeline.timer().finish();
        const std::vector<PassTiming>& passes = pipeline.timer().timings();
        const bool timed = std::ranges::find(passes, name, &PassTiming::pass) != passes.end();
        const std::vector<StructureBytes> all = pipeline.bytes();
        const bool held = std::ranges::find(all, name, &StructureBytes::name) != all.end();
        EXPECT_EQ(timed, held) << name;
        return timed && held;
    }

    Texture blank(glm::ivec2 size) const {
        return Texture("view", GL_TEXTURE_2D, GL_RGBA32F, glm::ivec3(size, 1));
    }

    /// Cells of `plane`, given by place from the left and from the top, must fill the middle of the
    /// picture, which is `scale` times as large with a margin of (2, 0) pixels, outside of it.
    template <class Grey>
    void expect_plane(const Texture& picture, glm::ivec2 plane, int scale, const Grey& grey) {
        ASSERT_EQ(glm::ivec2(picture.size()), plane * scale + glm::ivec2(4, 0));
        const std::vector<float> pixels = picture.download_float(4);
        for (int y = 0; y < picture.size().y; ++y) {
            for (int x = 0; x < picture.size().x; ++x) {
                const float* pixel = &pixels[static_cast<size_t>(y * picture.size().x + x) * 4];
                const bool inside = x >= 2 && x < picture.size().x - 2;
                ASSERT_EQ(pixel[0] == pixel[2], inside) << x << " " << y << ": grey are cells only";
                if (inside) {
                    ASSERT_FLOAT_EQ(pixel[0], grey(glm::ivec2((x - 2) / scale, y / scale)))
                        << x << " " << y;
                }
            }
        }
    }

    Image render(Pipeline& pipeline, const Camera& camera, PictureKind kind) {
        settings_.set(kView, kind);
        pipeline.render(settings_, camera);
        return pipeline.picture();
    }

    Settings settings_{all_knobs()};
};

TEST_F(ViewsTest, AnOccupancySliceShowsTheBits) {
    const Scene scene = clutter();
    const GpuScene gpu_scene(scene);
    settings_.set(kOccupancyResolution, 45);
    OccupancyMap map;
    map.build(frame(gpu_scene, settings_, 1, 2));
    const BitGrid bits = map.download();
    const glm::ivec3 size = bits.size();
    ASSERT_TRUE(size.x != size.y && size.y != size.z && size.x != size.z);
    OccupancySlice view;
    int occupied = 0;
    for (const ViewAxis axis : {ViewAxis::x, ViewAxis::y, ViewAxis::z}) {
        const int across = static_cast<int>(axis);
        const glm::ivec2 plane = axis == ViewAxis::x   ? glm::ivec2(size.z, size.y)
                                 : axis == ViewAxis::y ? glm::ivec2(size.x, size.z)
                                                       : glm::ivec2(size.x, size.y);
        for (const double fraction : {0.0, 0.3, 0.5, 1.0}) {
            settings_.set(kViewAxis, axis);
            settings_.set(kViewSlice, fraction);
            const int depth = std::min(
                static_cast<int>(static_cast<float>(fraction) * static_cast<float>(size[across])),
                size[across] - 1);
            const Texture picture = blank(plane * 3 + glm::ivec2(4, 0));
            view.draw(frame(gpu_scene, settings_, 1, 2), map, picture);
            expect_plane(picture, plane, 3, [&](glm::ivec2 place) {
                const int up = plane.y - 1 - place.y;
                const bool bit =
                    bits.get(axis == ViewAxis::x   ? glm::ivec3(depth, up, place.x)
                             : axis == ViewAxis::y ? glm::ivec3(place.x, depth, place.y)
                                                   : glm::ivec3(place.x, up, depth));
                occupied += bit;
                return bit ? 1.0f : 0.0f;
            });
        }
    }
    EXPECT_GT(occupied, 1000) << "or there was nothing to see";
}

TEST_F(ViewsTest, AnAlignedMapShowsItsBits) {
    const Scene scene = clutter();
    const GpuScene gpu_scene(scene);
    for (const RomaAlignment alignment : {RomaAlignment::rotate, RomaAlignment::shear}) {
        for (const int side : {32, 45, 100, 129}) { // each layout of columns
            settings_.set(kRomaAlignment, alignment);
            settings_.set(kOccupancyResolution, side);
            RomaTracer tracer;
            tracer.build(frame(gpu_scene, settings_));
            int occupied = 0;
            for (const int map : {0, 7, 200}) {
                settings_.set(kViewMap, map);
                const int index = std::min(map, 15);
                const bool sheared = alignment == RomaAlignment::shear;
                const glm::ivec3 size =
                    sheared ? tracer.shearing().frame().size(static_cast<size_t>(index))
                            : glm::ivec3(side);
                const std::vector<uint32_t> bits = sheared ? tracer.shearing().download_map(index)
                                                           : tracer.rotation().download_map(index);
                const size_t words = static_cast<size_t>(size.z + 31) / 32;
                const auto column = [&](glm::ivec2 place) {
                    const int up = size.y - 1 - place.y;
                    return std::span(&bits[static_cast<size_t>(up * size.x + place.x) * words],
                                     words);
                };
                const Texture picture = blank(2 * glm::ivec2(size) + glm::ivec2(4, 0));
                for (const double fraction : {0.0, 0.47, 1.0}) {
                    settings_.set(kViewSlice, fraction);
                    const auto cell = static_cast<size_t>(
                        std::min(static_cast<float>(fraction) * static_cast<float>(size.z),
                                 static_cast<float>(size.z - 1)));
                    tracer.draw_view(frame(gpu_scene, settings_), "map_slice", picture);
                    expect_plane(picture, glm::ivec2(size), 2, [&](glm::ivec2 place) {
                        const uint32_t bit = column(place)[cell / 32] >> (cell % 32) & 1u;
                        occupied += static_cast<int>(bit);
                        return static_cast<float>(bit);
                    });
                }
                tracer.draw_view(frame(gpu_scene, settings_), "map_columns", picture);
                expect_plane(picture, glm::ivec2(size), 2, [&](glm::ivec2 place) {
                    int count = 0;
                    for (const uint32_t word : column(place))
                        count += std::popcount(word);
                    return static_cast<float>(count) / static_cast<float>(size.z);
                });
            }
            EXPECT_GT(occupied, 100) << "or there was nothing to see";
        }
    }
}

TEST_F(ViewsTest, EveryTracerDrawsEachOfItsViews) {
    const Scene scene = clutter();
    Pipeline pipeline(scene, ShaderLibrary());
    for (const TracerEntry& entry : tracers()) {
        settings_.set(kTracer, std::string(entry.name));
        const std::vector<std::string_view> views = entry.make()->views();
        for (const std::string_view view : views) {
            SCOPED_TRACE(std::string(entry.name) + " " + std::string(view));
            settings_.set(kViewStructure, std::string(view));
            const Image picture = render(pipeline, scene.cameras.front(), PictureKind::structure);
            ASSERT_EQ(picture.channels, 3);
            const auto [low, high] = std::ranges::minmax_element(picture.data);
            EXPECT_EQ(*low, 0.0f);
            EXPECT_GT(*high, 0.05f);
            EXPECT_LE(*high, 1.0f);
        }
        if (views.empty())
            continue;
        const auto picture_of = [&](std::string_view view) {
            settings_.set(kViewStructure, std::string(view));
            pipeline.restart();
            return render(pipeline, scene.cameras.front(), PictureKind::structure).data;
        };
        EXPECT_EQ(picture_of(""), picture_of(views.front()));
    }
}

TEST_F(ViewsTest, AViewThatIsNotThereIsRefusedWithThoseThatAre) {
    settings_.set(kViewStructure, "shadow_map");
    const Scene scene = clutter();
    Pipeline pipeline(scene, ShaderLibrary());
    for (const TracerEntry& entry : tracers()) {
        settings_.set(kTracer, std::string(entry.name));
        settings_.set(kView, PictureKind::ambient_occlusion);
        EXPECT_NO_THROW(check_tracer(settings_)) << "it is not shown";
        settings_.set(kView, PictureKind::structure);
        const std::string error = error_of([&] { check_tracer(settings_); });
        EXPECT_CONTAINS(error, "view.structure");
        EXPECT_CONTAINS(error, "'shadow_map'");
        for (const std::string_view view : entry.make()->views())
            EXPECT_CONTAINS(error, view);
        EXPECT_THROW(pipeline.render(settings_, scene.cameras.front()), Error);
    }
    settings_.set(kViewStructure, "");
    EXPECT_NO_THROW(pipeline.render(settings_, scene.cameras.front())) << "and it goes on";
}

TEST_F(ViewsTest, DepthFallsEvenlyToBlack) {
    // Walls at right angles to the view, 2 and 3 m away; the scene's diagonal is known from them.
    std::vector<glm::vec3> corners = rectangle({-2, 0, -2}, {0, 0, 1}, 1.5f);
    for (const glm::vec3 corner : rectangle({2, 0, -3}, {0, 0, 1}, 1.5f))
        corners.push_back(corner);
    const Scene scene = scene_of_triangles(corners);
    const Camera camera = look_at("camera", {0, 0, 0}, {0, 0, -1}, 1.5f);
    const float diagonal = glm::length(scene.bounds.extent());
    Pipeline pipeline(scene, ShaderLibrary());
    for (const double range : {0.6, 1.0, 4.0}) {
        settings_.set(kDepthRange, range);
        const Image picture = render(pipeline, camera, PictureKind::depth);
        const auto metres = [&](int x, int y) {
            const float code = static_cast<float>(encode_srgb8(picture.at(x, y, 0))) / 255.0f;
            EXPECT_EQ(picture.at(x, y, 0), picture.at(x, y, 2));
            return (1.0f - code) * static_cast<float>(range) * diagonal;
        };
        const float step = static_cast<float>(range) * diagonal / 255.0f;
        EXPECT_NEAR(metres(8, 24), 2.0f, step);
        EXPECT_NEAR(metres(18, 20), 2.0f, step) << "along the view, not from the eye";
        EXPECT_NEAR(metres(50, 24), 3.0f, step);
        EXPECT_GT(picture.at(32, 24, 2), 2.0f * picture.at(32, 24, 0)) << "nothing is blue";
    }
    settings_.set(kDepthRange, 0.1);
    EXPECT_EQ(render(pipeline, camera, PictureKind::depth).at(8, 24, 0), 0.0f);
}

TEST_F(ViewsTest, RawAmbientOcclusionIsTheLastFrameOfTheMean) {
    const Scene scene = clutter();
    Pipeline raw(scene, ShaderLibrary()), mean(scene, ShaderLibrary());
    std::vector<double> sum(64 * 48);
    for (int i = 0; i < 3; ++i) {
        const Image last = render(raw, scene.cameras.front(), PictureKind::ambient_occlusion_raw);
        EXPECT_EQ(raw.frame_count(), 1u);
        ASSERT_EQ(last.channels, 1);
        const Image all = render(mean, scene.cameras.front(), PictureKind::ambient_occlusion);
        for (size_t k = 0; k < sum.size(); ++k) {
            sum[k] += last.data[k];
            ASSERT_NEAR(all.data[k], sum[k] / (i + 1), 1e-6);
        }
    }
    EXPECT_TRUE(tells_of(raw, "last frame") && !tells_of(raw, "running mean"));
    EXPECT_TRUE(tells_of(mean, "running mean") && !tells_of(mean, "last frame"));
}

TEST_F(ViewsTest, WithoutAMeanThePictureIsThatOfTheFirstFrame) {
    const Scene scene = clutter();
    for (const PictureKind kind : {PictureKind::ambient_occlusion, PictureKind::lit}) {
        settings_.set(kMean, true);
        Pipeline pipeline(scene, ShaderLibrary());
        const Image one = render(pipeline, scene.cameras.front(), kind);
        settings_.set(kMean, false);
        Pipeline alone(scene, ShaderLibrary());
        EXPECT_EQ(render(alone, scene.cameras.front(), kind).data, one.data);
        EXPECT_TRUE(tells_of(alone, "last frame") && !tells_of(alone, "running mean"));
    }
}

} // namespace
} // namespace romascope
