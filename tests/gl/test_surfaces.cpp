// SPDX-License-Identifier: MIT
// Masks, sides, textures and vertex colours: what the picture, the occupancy map and the reference
// make of them.
#include "renderer/image/color.h"
#include "renderer/reference/ao_reference.h"
#include "renderer/reference/ao_tracer.h"
#include "renderer/scene/surface_mask.h"
#include "tests/gl/gl_test.h"

#include <cmath>

namespace romascope {
namespace {

/// A square around `centre` with texture coordinates from (0, 0) to `repeats`; its front faces
/// `u` x `v`, half sides both. A new material.
void add_square(Scene& scene, const Material& material, glm::vec3 centre, glm::vec3 u, glm::vec3 v,
                float repeats = 1.0f) {
    const auto first = static_cast<uint32_t>(scene.positions.size());
    for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        scene.positions.push_back(centre + (2.0f * corner.x - 1.0f) * u +
                                  (2.0f * corner.y - 1.0f) * v);
        scene.normals.push_back(glm::normalize(glm::cross(u, v)));
        scene.texcoords.push_back(repeats * corner);
        scene.vertex_material.push_back(static_cast<uint32_t>(scene.materials.size()));
        scene.bounds.add(scene.positions.back());
    }
    for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        scene.indices.push_back(first + corner);
    scene.materials.push_back(material);
    sort_by_group(scene);
}

/// White where there; alpha 0 or 255 by chance.
SurfaceTexture random_mask(int side, double density, unsigned seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution there(density);
    SurfaceTexture texture;
    texture.size = glm::ivec2(side);
    texture.nearest = true;
    for (int i = 0; i < side * side; ++i)
        texture.texels.push_back(there(random) ? 0xffffffffu : 0x00ffffffu);
    return texture;
}

class SurfacesTest : public GlTest {
protected:
    SurfacesTest() {
        settings_.set(kWidth, 96);
        settings_.set(kHeight, 72);
        settings_.set(kOccupancyResolution, 64);
    }

    Image render(const Scene& scene, const Camera& camera, PictureKind kind, int frames = 1) {
        settings_.set(kView, kind);
        Pipeline pipeline(scene, ShaderLibrary());
        for (int i = 0; i < frames; ++i)
            pipeline.render(settings_, camera);
        return pipeline.picture();
    }

    static double mean(const Image& image) {
        double sum = 0;
        for (const float value : image.data)
            sum += value;
        return sum / static_cast<double>(image.data.size());
    }

    glm::ivec2 size() const { return {settings_.get(kWidth), settings_.get(kHeight)}; }

    Settings settings_{all_knobs()};
};

TEST_F(SurfacesTest, PictureAndReferenceSeeTheSameTexels) {
    const Material masked{.texture = 0, .alpha_cutoff = 0.4f, .double_sided = true};
    for (const bool nearest : {false, true})
        for (const TextureWrap wrap :
             {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
            Scene scene;
            std::mt19937 random(5);
            SurfaceTexture texture;
            texture.size = {7, 5};
            texture.nearest = nearest;
            texture.wrap_u = texture.wrap_v = wrap;
            for (int i = 0; i < 35; ++i)
                texture.texels.push_back(static_cast<uint32_t>(random()) | 0x00ffffffu);
            scene.textures = {texture};
            add_square(scene, masked, {0, 0, 0}, {1, 0, 0.2f}, {0.1f, 1, -0.3f}, 2.7f);
            const Camera camera = look_at("askew", {0.8f, 0.5f, 2.2f}, {0, 0, 0}, 0.9f);
            const Image picture = render(scene, camera, PictureKind::base_color);
            const AoTracer tracer(scene);
            int there = 0, differ = 0;
            for (int y = 0; y < size().y; ++y)
                for (int x = 0; x < size().x; ++x) {
                    // What a pixel's rounding moves must not change what is seen.
                    int hits = 0;
                    for (const glm::vec2 off : {glm::vec2(0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                        hits +=
                            tracer
                                .seen(camera.eye, camera.direction_through(
                                                      glm::vec2(x, y) + 0.5f + 0.01f * off, size()))
                                .has_value();
                    if (hits != 0 && hits != 5)
                        continue;
                    there += hits == 5;
                    differ += (picture.at(x, y, 0) > 0.5f) != (hits == 5);
                }
            EXPECT_EQ(differ, 0);
            EXPECT_GT(there, 500);
            EXPECT_LT(there, 3000);
        }
}

TEST_F(SurfacesTest, TheOccupancyMapHasWhatTheMaskLeavesAtCellCentres) {
    Scene scene;
    SurfaceTexture texture = random_mask(9, 0.5, 1);
    texture.nearest = false;
    scene.textures = {texture};
    // Single-sided and seen from behind along z: voxels know no sides.
    add_square(scene, {.texture = 0, .alpha_cutoff = 0.5f}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1.5f);
    add_square(scene, {}, {0, 0, -1}, {0.01f, 0, 0}, {0, 0.01f, 0}); // depth for the grid
    const GpuScene gpu_scene(scene);
    for (const OccupancyBuilder builder : {OccupancyBuilder::raster, OccupancyBuilder::compute}) {
        settings_.set(kOccupancyBuilder, builder);
        OccupancyMap map;
        map.build(frame(gpu_scene, settings_, 1, 7));
        const BitGrid grid = map.download();
        const glm::vec3 first = (glm::vec3(0) - map.grid().origin) / map.grid().cell_size;
        size_t set = 0, checked = 0;
        for (int y = 0; y < grid.size().y; ++y)
            for (int x = 0; x < grid.size().x; ++x) {
                const auto uv_at = [&](glm::vec2 off) {
                    const glm::vec2 place = map.grid().cell_size * (glm::vec2(x, y) + 0.5f + off) +
                                            glm::vec2(map.grid().origin);
                    return 0.75f * (glm::vec2(place.y, place.x) + 1.0f);
                };
                int there = 0;
                for (const glm::vec2 off : {glm::vec2(0), {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    const glm::vec2 uv = uv_at(0.01f * off);
                    const bool inside = uv.x > 0 && uv.y > 0 && uv.x < 1.5f && uv.y < 1.5f;
                    there += inside && surface_is_there(scene.materials[0], &texture, uv, 1.0f);
                }
                if (there != 0 && there != 5)
                    continue;
                ++checked;
                const bool found = grid.get({x, y, static_cast<int>(std::floor(first.z))});
                EXPECT_EQ(found, there == 5) << x << " " << y;
                set += found;
            }
        EXPECT_GT(checked, 3000u);
        EXPECT_GT(set, 800u);
        EXPECT_LT(set, 3200u);
    }
}

TEST_F(SurfacesTest, AlphaOfMaterialAndVerticesCounts) {
    // Vertex alpha falls from 1 to 0 along x; half of it stays above the cutoff of 0.5, and with a
    // material of alpha 2/3 a quarter.
    for (const float alpha : {1.0f, 2.0f / 3.0f}) {
        Scene scene;
        add_square(scene, {.alpha = alpha, .alpha_cutoff = 0.5f}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        scene.texcoords.clear();
        scene.colors = {0xffffffffu, 0x00ffffffu, 0x00ffffffu, 0xffffffffu};
        const Camera camera = look_at("front", {0, 0, 1.5f}, {0, 0, 0}, 1.0f);
        const Image picture = render(scene, camera, PictureKind::base_color);
        const AoTracer tracer(scene);
        const GpuScene gpu_scene(scene);
        OccupancyMap map;
        map.build(frame(gpu_scene, settings_));
        const double share = (1.0 - 0.5 / alpha);
        EXPECT_NEAR(static_cast<double>(map.download().count()), share * 63 * 63, 70); // one column
        for (int x = 0; x < size().x; ++x) {
            const glm::vec3 way = camera.direction_through({x + 0.5f, 36.5f}, size());
            const float along = way.x * 1.5f / -way.z; // in [-1, 1] on the square
            if (std::abs(along - (2 * share - 1)) < 0.02 || std::abs(std::abs(along) - 1) < 0.02)
                continue;
            const bool there = std::abs(along) < 1 && along < 2 * share - 1;
            EXPECT_EQ(picture.at(x, 36, 0) > 0.5f, there) << x;
            EXPECT_EQ(tracer.seen(camera.eye, way).has_value(), there) << x;
            EXPECT_EQ(tracer.occluded(camera.eye, way, 10.0f), there) << x;
        }
    }
}

TEST_F(SurfacesTest, AMaskedLidLetsItsShareOfTheRaysThrough) {
    settings_.set(kWidth, 24);
    settings_.set(kHeight, 18);
    settings_.set(kAoRays, 16);
    double closed = 0.0;
    for (const double density : {1.0, 0.5, 0.2}) {
        Scene scene;
        scene.textures = {random_mask(64, density, 3)};
        add_square(scene, {}, {0, 0, 0}, {1, 0, 0}, {0, 0, -1});
        add_square(scene, {.texture = 0, .alpha_cutoff = 0.5f}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1});
        const Camera camera = look_at("under", {0, 0.5f, 0}, {0, 0, 0}, 0.1f);
        AoQuery query{camera, {24, 18}, 256};
        const double truth =
            mean(ambient_occlusion_reference(scene, query, {}, {.use_cache = false}).visibility);
        if (density == 1.0)
            closed = 1.0 - truth;
        // 4096 texels drawn with that density, weighed unevenly: their share deviates by 0.02 at
        // most.
        EXPECT_NEAR(1.0 - truth, density * closed, 0.03);
        // Texels are half a cell wide, and maps are turned: what is between is filled by some of
        // its neighbours. It must still go with the density.
        const double estimate =
            1.0 - mean(render(scene, camera, PictureKind::ambient_occlusion, 32));
        EXPECT_NEAR(estimate, density * closed, 0.12) << "density " << density;
    }
    EXPECT_GT(closed, 0.5);
}

TEST_F(SurfacesTest, BacksOfSingleSidedMaterialsAreNotSeenButOcclude) {
    // Before a red wall a white sheet that shows its back to the camera.
    for (const bool double_sided : {false, true})
        for (const bool masked : {false, true}) {
            Scene scene;
            add_square(scene, {.base_color = {1, 0, 0}}, {0, 0, -1}, {2, 0, 0}, {0, 2, 0});
            add_square(scene, {.alpha_cutoff = masked ? 0.5f : 0.0f, .double_sided = double_sided},
                       {0, 0, 0}, {0, 1, 0}, {1, 0, 0});
            const Camera camera = look_at("front", {0, 0, 2}, {0, 0, 0}, 0.5f);
            const Image picture = render(scene, camera, PictureKind::base_color);
            const AoTracer tracer(scene);
            const auto seen = tracer.seen(camera.eye, camera.forward);
            ASSERT_TRUE(seen.has_value());
            EXPECT_EQ(picture.at(48, 36, 1) > 0.5f, double_sided);
            EXPECT_NEAR(seen->distance, double_sided ? 2.0f : 3.0f, 1e-5f);
            EXPECT_TRUE(tracer.occluded({0, 0, -0.5f}, {0, 0, 1}, 10.0f));
            EXPECT_NEAR(tracer.closest(camera.eye, camera.forward)->distance, 2.0f, 1e-5f);
            // From the other side it is seen by all.
            const Camera behind = look_at("behind", {0, 0, -0.9f}, {0, 0, 0}, 0.5f);
            EXPECT_GT(render(scene, behind, PictureKind::base_color).at(48, 36, 1), 0.5f);
            EXPECT_TRUE(tracer.seen(behind.eye, behind.forward).has_value());
            // It closes most of the hemisphere of the wall, whether the camera sees it or not.
            settings_.set(kAoRays, 16);
            const Camera wall = look_at("wall", {0, 0, -0.5f}, {0, 0, -1}, 0.1f);
            EXPECT_LT(mean(render(scene, wall, PictureKind::ambient_occlusion, 4)), 0.8);
        }
}

TEST_F(SurfacesTest, ColoursAreMaterialTimesTextureTimesVertex) {
    const glm::vec3 base(0.8f, 0.5f, 0.3f);
    std::mt19937 random(9);
    for (int i = 0; i < 8; ++i) {
        const auto texel = static_cast<uint32_t>(random());
        const auto color = static_cast<uint32_t>(random());
        Scene scene;
        SurfaceTexture texture;
        texture.size = {2, 2};
        texture.texels.assign(4, texel);
        scene.textures = {texture};
        add_square(scene, {.base_color = base, .texture = 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5);
        scene.colors.assign(4, color);
        const Camera camera = look_at("front", {0, 0, 1}, {0, 0, 0}, 0.5f);
        const Image picture = render(scene, camera, PictureKind::base_color);
        for (int c = 0; c < 3; ++c) {
            const float expected = base[c] * decode_srgb8(static_cast<uint8_t>(texel >> 8 * c)) *
                                   static_cast<float>(color >> 8 * c & 0xff) / 255.0f;
            EXPECT_NEAR(255.0f * encode_srgb(picture.at(48, 36, c)), 255.0f * encode_srgb(expected),
                        1.0f);
        }
    }
}

TEST_F(SurfacesTest, TexturesAreAtTheirPlace) {
    // Four colours by nearest lookup; (0, 0) is where the picture has its first row.
    Scene scene;
    SurfaceTexture texture;
    texture.size = {2, 2};
    texture.nearest = true;
    texture.texels = {0xff0000ffu, 0xff00ff00u, 0xffff0000u, 0xffffffffu};
    scene.textures = {texture};
    add_square(scene, {.texture = 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Camera camera = look_at("front", {0, 0, 2}, {0, 0, 0}, 1.0f);
    const Image picture = render(scene, camera, PictureKind::base_color);
    const auto color = [&](int x, int y) {
        return glm::vec3(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
    };
    EXPECT_EQ(color(38, 46), glm::vec3(1, 0, 0)); // u, v < 0.5: lower left, v grows with y here
    EXPECT_EQ(color(58, 46), glm::vec3(0, 1, 0));
    EXPECT_EQ(color(38, 26), glm::vec3(0, 0, 1));
    EXPECT_EQ(color(58, 26), glm::vec3(1, 1, 1));
}

TEST_F(SurfacesTest, FarTexturesAreTheirMean) {
    // Black and white texels far smaller than pixels: a linear 0.5, whatever the pixel.
    Scene scene;
    SurfaceTexture texture;
    texture.size = {256, 256};
    for (int i = 0; i < 256 * 256; ++i)
        texture.texels.push_back((i + i / 256) % 2 == 0 ? 0xffffffffu : 0xff000000u);
    scene.textures = {texture};
    add_square(scene, {.texture = 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
    const Camera camera = look_at("front", {0, 0, 4}, {0, 0, 0}, 0.3f);
    const Image picture = render(scene, camera, PictureKind::base_color);
    for (int y = 0; y < size().y; ++y)
        for (int x = 0; x < size().x; ++x)
            EXPECT_NEAR(255.0f * encode_srgb(picture.at(x, y, 1)), 188.0f, 1.0f);
}

TEST_F(SurfacesTest, ZeroNormalsAreTheTrianglesOwn) {
    for (const float side : {1.0f, -1.0f}) {
        Scene scene;
        const glm::vec3 u(1, 0.2f, 0), v(0, 1, 0.4f);
        add_square(scene, {.double_sided = true}, {0, 0, 0}, u, v);
        scene.normals.assign(4, glm::vec3(0));
        const glm::vec3 normal = side * glm::normalize(glm::cross(u, v));
        const Camera camera = look_at("camera", 2.0f * normal, {0, 0, 0}, 0.5f);
        const Image picture = render(scene, camera, PictureKind::normal);
        const auto seen = AoTracer(scene).seen(camera.eye, camera.forward);
        ASSERT_TRUE(seen.has_value());
        EXPECT_LT(glm::distance(seen->normal, normal), 1e-5f);
        for (int c = 0; c < 3; ++c) // derivatives over a pixel's differences of float positions
            EXPECT_NEAR(2.0f * picture.at(48, 36, c) - 1.0f, normal[c], 1e-3f);
    }
}

} // namespace
} // namespace romascope
