// SPDX-License-Identifier: MIT
// Ground truth against closed forms. A Monte Carlo mean of n rays that are free with probability p
// has standard deviation sqrt(p (1 - p) / n) if they are independent; ours are stratified, so
// theirs is smaller. Five of those plus the error of the triangles is therefore never exceeded by
// chance, and at n = 2^18 it is still only 0.005.
#include "renderer/base/error.h"
#include "renderer/reference/ao_reference.h"
#include "renderer/reference/ao_tracer.h"
#include "renderer/reference/cache.h"
#include "renderer/reference/sampling.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <thread>
#include <unistd.h>

namespace romascope {
namespace {

namespace fs = std::filesystem;
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr int kRays = 1 << 18;
const glm::vec3 kUp(0.0f, 1.0f, 0.0f);

/// Of a material that is seen from both sides.
void add_triangle(Scene& scene, const std::array<glm::vec3, 3>& corners,
                  const std::array<glm::vec3, 3>& normals) {
    if (scene.materials.empty())
        scene.materials.push_back({.double_sided = true});
    for (size_t i = 0; i < 3; ++i) {
        scene.indices.push_back(static_cast<uint32_t>(scene.positions.size()));
        scene.positions.push_back(corners[i]);
        scene.normals.push_back(normals[i]);
        scene.vertex_material.push_back(0);
        scene.bounds.add(corners[i]);
    }
}

/// A parallelogram of 2 k² triangles.
void add_quad(Scene& scene, glm::vec3 corner, glm::vec3 u, glm::vec3 v, int k = 1) {
    const glm::vec3 normal = glm::normalize(glm::cross(u, v));
    const auto at = [&](int i, int j) {
        return corner + u * (static_cast<float>(i) / static_cast<float>(k)) +
               v * (static_cast<float>(j) / static_cast<float>(k));
    };
    for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
            add_triangle(scene, {at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                         {normal, normal, normal});
            add_triangle(scene, {at(i, j), at(i + 1, j + 1), at(i, j + 1)},
                         {normal, normal, normal});
        }
}

/// A square floor at y = 0, and a camera's worth of room around it.
Scene floor_scene(float half) {
    Scene scene;
    add_quad(scene, {-half, 0.0f, half}, {2.0f * half, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f * half});
    return scene;
}

/// A disc of `sides` sides, parallel to the floor; 4096 sides miss the circle's area by 4e-7.
void add_disc(Scene& scene, glm::vec3 centre, float radius, int sides = 4096) {
    const auto rim = [&](int i) {
        const double angle = 2.0 * glm::pi<double>() * i / sides;
        return centre + radius * glm::vec3(std::cos(angle), 0.0, std::sin(angle));
    };
    for (int i = 0; i < sides; ++i)
        add_triangle(scene, {centre, rim(i), rim(i + 1)}, {kUp, kUp, kUp});
}

void add_sphere(Scene& scene, glm::vec3 centre, float radius, int rings) {
    const auto unit = [&](int ring, int segment) {
        const double polar = glm::pi<double>() * ring / rings;
        const double around = glm::pi<double>() * segment / rings;
        return glm::vec3(std::sin(polar) * std::cos(around), std::cos(polar),
                         std::sin(polar) * std::sin(around));
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int segment = 0; segment < 2 * rings; ++segment) {
            const glm::vec3 a = unit(ring, segment), b = unit(ring, segment + 1);
            const glm::vec3 c = unit(ring + 1, segment + 1), d = unit(ring + 1, segment);
            const auto at = [&](glm::vec3 n) { return centre + radius * n; };
            add_triangle(scene, {at(a), at(b), at(c)}, {a, b, c});
            add_triangle(scene, {at(a), at(c), at(d)}, {a, c, d});
        }
}

double tolerance(double p, double rays) { return 5.0 * std::sqrt(p * (1.0 - p) / rays) + 1e-4; }

const Lattice& many_rays() {
    static const Lattice lattice(kRays);
    return lattice;
}

Estimate on_floor(const AoTracer& tracer, glm::vec2 at, float radius = kInfinite,
                  uint32_t seed = 1) {
    const auto hit = tracer.closest({at.x, 1e-2f, at.y}, -kUp);
    EXPECT_TRUE(hit);
    return tracer.ambient_occlusion(hit->origin, hit->normal, radius, many_rays(), seed);
}

/// Its own cache folder for each test, so that they may run side by side and in any order.
class Reference : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("romascope_") + info->name() + std::to_string(getpid()));
        fs::create_directories(folder_);
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::vector<fs::path> cache_files() const {
        std::vector<fs::path> files;
        if (fs::exists(folder_ / "romascope" / "reference"))
            for (const auto& entry : fs::directory_iterator(folder_ / "romascope" / "reference"))
                files.push_back(entry.path());
        return files;
    }
    fs::path folder_;
};

/// A floor with a disc above it, looked at from between the two, horizon in the picture.
struct DiscView {
    Scene scene = floor_scene(20.0f);
    AoQuery query;

    DiscView() {
        add_disc(scene, {0.0f, 2.0f, 0.0f}, 1.0f);
        query.camera = look_at("view", {0.0f, 1.5f, 4.0f}, {0.0f, 0.3f, 0.0f}, 1.0f);
        query.size = {37, 23};
        query.samples = 16;
    }
};

/// Part of the sky that a disc of radius r at height h hides from a floor point at distance d from
/// below its centre (view factor from a small element to a parallel disc).
double disc_share(double r, double h, double d) {
    const double all = d * d + h * h + r * r;
    return 0.5 * (1.0 - (all - 2.0 * r * r) / std::sqrt(all * all - 4.0 * d * d * r * r));
}

TEST_F(Reference, open_plane_is_exactly_one) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::uniform_real_distribution<float> exponent(-3.0f, 4.0f);
    for (int trial = 0; trial < 300; ++trial) {
        const glm::quat turn = glm::normalize(
            glm::quat(unit(random), unit(random), unit(random), unit(random) + 0.01f));
        const float scale = std::pow(10.0f, exponent(random));
        const glm::vec3 place =
            scale * std::pow(10.0f, unit(random)) * glm::vec3(unit(random), unit(random), 1.0f);
        const glm::vec3 u = turn * glm::vec3(scale, 0.0f, 0.0f);
        const glm::vec3 v = turn * glm::vec3(0.0f, scale, 0.0f);
        Scene scene;
        add_quad(scene, place - 0.5f * (u + v), u, v, 1 + trial % 9);
        const AoTracer tracer(scene);
        const glm::vec3 side = turn * glm::vec3(0.0f, 0.0f, trial % 2 ? scale : -scale);
        int seen = 0;
        for (int ray = 0; ray < 20; ++ray) {
            const glm::vec3 target = place + 0.45f * (unit(random) * u + unit(random) * v);
            const glm::vec3 eye = place + side + 0.5f * (unit(random) * u + unit(random) * v);
            const auto hit = tracer.closest(eye, glm::normalize(target - eye));
            if (!hit)
                continue;
            ++seen;
            EXPECT_GT(glm::dot(hit->normal, side), 0.0f);
            const auto seed = static_cast<uint32_t>(trial * 20 + ray);
            EXPECT_EQ(tracer.ambient_occlusion(hit->origin, hit->normal, kInfinite, 256, seed).mean,
                      1.0f)
                << "trial " << trial << " scale " << scale;
        }
        EXPECT_GE(seen, 19);
    }
}

TEST_F(Reference, foot_of_a_wall_is_one_half) {
    Scene scene = floor_scene(1000.0f);
    add_quad(scene, {-1000.0f, 0.0f, 0.0f}, {2000.0f, 0.0f, 0.0f}, {0.0f, 1000.0f, 0.0f});
    const AoTracer tracer(scene);
    // An endless wall of height H at distance d hides (1 - d / sqrt(d² + H²)) / 2.
    for (const float distance : {0.01f, 0.05f, 1.0f, 30.0f}) {
        const double hidden = 0.5 * (1.0 - distance / std::hypot(distance, 1000.0f));
        EXPECT_NEAR(on_floor(tracer, {3.0f, distance}).mean, 1.0 - hidden,
                    tolerance(hidden, kRays));
    }
}

TEST_F(Reference, point_under_a_disc) {
    for (const float radius : {0.1f, 1.0f, 5.0f}) {
        Scene scene = floor_scene(20.0f);
        add_disc(scene, {0.0f, 2.0f, 0.0f}, radius);
        const AoTracer tracer(scene);
        for (const float aside : {0.0f, 0.7f, 4.0f}) {
            const double hidden = disc_share(radius, 2.0, aside);
            if (aside == 0.0f) {
                EXPECT_NEAR(hidden, radius * radius / (radius * radius + 4.0), 1e-6);
            }
            const Estimate estimate = on_floor(tracer, {aside, 0.0f});
            EXPECT_NEAR(estimate.mean, 1.0 - hidden, tolerance(hidden, kRays));
            EXPECT_NEAR(estimate.standard_error, std::sqrt(hidden * (1.0 - hidden) / kRays), 1e-4);
        }
    }
}

TEST_F(Reference, point_under_a_sphere_from_any_normal) {
    Scene scene;
    const glm::vec3 centre(1.0f, 2.0f, 3.0f);
    add_sphere(scene, centre, 0.8f, 256); // its outline is short of the circle by 1e-4
    const AoTracer tracer(scene);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int trial = 0; trial < 20; ++trial) {
        const float distance = 1.0f + 3.0f * unit(random);
        const glm::vec3 way = glm::normalize(glm::vec3(unit(random), unit(random), -unit(random)));
        // Tilted by no more than keeps the whole sphere above the horizon.
        const float tilt = unit(random) * (glm::half_pi<float>() - std::asin(0.8f / distance));
        const glm::vec3 across = glm::normalize(glm::cross(way, kUp));
        const glm::vec3 normal = std::cos(tilt) * way + std::sin(tilt) * across;
        const double hidden = 0.8 * 0.8 / (distance * distance) * std::cos(tilt);
        const Estimate estimate = tracer.ambient_occlusion(
            centre - distance * way, normal, kInfinite, many_rays(), static_cast<uint32_t>(trial));
        EXPECT_NEAR(estimate.mean, 1.0 - hidden, tolerance(hidden, kRays) + 3e-4);
    }
}

TEST_F(Reference, only_occluders_within_the_radius_count) {
    Scene scene = floor_scene(20.0f);
    add_disc(scene, {0.0f, 2.0f, 0.0f}, 5.0f);
    const AoTracer tracer(scene);
    EXPECT_EQ(on_floor(tracer, {}, 1.999f).mean, 1.0f);
    // Of the disc, what lies within distance r of the point is a disc of radius sqrt(r² - h²).
    for (const float radius : {2.1f, 3.0f, 5.0f}) {
        const double hidden = 1.0 - 4.0 / (radius * radius);
        EXPECT_NEAR(on_floor(tracer, {}, radius).mean, 1.0 - hidden, tolerance(hidden, kRays));
    }
    const double whole = disc_share(5.0, 2.0, 0.0);
    EXPECT_NEAR(on_floor(tracer, {}, 100.0f).mean, 1.0 - whole, tolerance(whole, kRays));
}

TEST_F(Reference, occlusion_of_single_rays) {
    Scene scene;
    add_quad(scene, {-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f});
    const AoTracer tracer(scene);
    for (const float side : {1.0f, -1.0f}) { // both sides of a triangle count
        const glm::vec3 eye(0.3f, 0.2f, 2.0f * side);
        const glm::vec3 way(0.0f, 0.0f, -side);
        EXPECT_TRUE(tracer.occluded(eye, way, kInfinite));
        EXPECT_TRUE(tracer.occluded(eye, way, 2.001f));
        EXPECT_FALSE(tracer.occluded(eye, way, 1.999f));
        EXPECT_FALSE(tracer.occluded(eye, -way, kInfinite));
        const auto hit = tracer.closest(eye, way);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->distance, 2.0f, 1e-6f);
        EXPECT_LT(glm::distance(hit->position, {0.3f, 0.2f, 0.0f}), 1e-6f);
        EXPECT_EQ(hit->geometric_normal, glm::vec3(0.0f, 0.0f, side));
        EXPECT_EQ(hit->normal, glm::vec3(0.0f, 0.0f, side));
        EXPECT_GT(hit->origin.z * side, 0.0f);
        EXPECT_LT(hit->origin.z * side, 1e-5f);
    }
    EXPECT_FALSE(tracer.closest({5.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -1.0f}));
}

TEST_F(Reference, normals_are_interpolated_and_face_the_seen_side) {
    const glm::vec3 a(0.0f, 0.6f, 0.8f), b(0.6f, 0.0f, 0.8f), c(0.0f, 0.0f, 1.0f);
    Scene scene;
    add_triangle(scene, {glm::vec3(0.0f), {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}, {a, b, c});
    Scene turned = scene; // normals on the wrong side of their triangle
    for (glm::vec3& normal : turned.normals)
        normal = -normal;
    const glm::vec3 expected = glm::normalize(0.5f * a + 0.2f * b + 0.3f * c);
    for (const Scene& each : {scene, turned})
        for (const float side : {1.0f, -1.0f}) {
            const auto hit = AoTracer(each).closest({0.2f, 0.3f, side}, {0.0f, 0.0f, -side});
            ASSERT_TRUE(hit);
            EXPECT_LT(glm::distance(hit->normal, side * expected), 1e-6f);
            EXPECT_GT(hit->geometric_normal.z * side, 0.999f);
        }
}

TEST_F(Reference, cosine_directions_have_their_density) {
    // E[z] = 2/3, E[z²] = 1/2, E[x] = E[y] = E[xy] = 0, E[x²] = 1/4, all of unit length.
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const int n = 200000;
    glm::dvec3 mean(0.0), square(0.0);
    double product = 0.0;
    for (int i = 0; i < n; ++i) {
        const glm::vec3 d = cosine_direction({unit(random), unit(random)});
        ASSERT_NEAR(glm::length(d), 1.0f, 1e-6f);
        mean += glm::dvec3(d) / double{n};
        square += glm::dvec3(d * d) / double{n};
        product += static_cast<double>(d.x) * d.y / n;
    }
    const double slack = 5.0 * 0.5 / std::sqrt(n); // no term deviates by more than 1/2
    EXPECT_NEAR(mean.z, 2.0 / 3.0, slack);
    EXPECT_NEAR(mean.x, 0.0, slack);
    EXPECT_NEAR(mean.y, 0.0, slack);
    EXPECT_NEAR(square.x, 0.25, slack);
    EXPECT_NEAR(square.z, 0.5, slack);
    EXPECT_NEAR(product, 0.0, slack);
    EXPECT_GT(cosine_direction({fraction(0), fraction(0)}).z, 0.0f); // never along the surface
}

TEST_F(Reference, few_samples_are_unbiased_over_seeds) {
    Scene scene = floor_scene(20.0f);
    add_disc(scene, {0.6f, 1.0f, 0.0f}, 0.7f);
    const AoTracer tracer(scene);
    const double hidden = disc_share(0.7, 1.0, 0.6);
    const int seeds = 40000;
    for (const int samples : {1, 2, 3, 7, 16}) {
        const Lattice lattice(samples);
        double sum = 0.0;
        for (int seed = 0; seed < seeds; ++seed)
            sum += tracer
                       .ambient_occlusion({0.0f, 1e-5f, 0.0f}, kUp, kInfinite, lattice,
                                          static_cast<uint32_t>(seed))
                       .mean;
        EXPECT_NEAR(sum / seeds, 1.0 - hidden, tolerance(hidden, double{seeds} * samples))
            << samples << " samples";
    }
}

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

TEST_F(Reference, cache_returns_the_same_bytes) {
    const DiscView view;
    const AoReference first = ambient_occlusion_reference(view.scene, view.query);
    EXPECT_FALSE(first.from_cache);
    ASSERT_EQ(cache_files().size(), 1u);
    const AoReference second = ambient_occlusion_reference(view.scene, view.query);
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(first.visibility.data, second.visibility.data);
    EXPECT_EQ(first.standard_error.data, second.standard_error.data);
    EXPECT_EQ(first.seconds, second.seconds);
    const AoReference fresh =
        ambient_occlusion_reference(view.scene, view.query, {}, {.use_cache = false});
    EXPECT_FALSE(fresh.from_cache);
    EXPECT_EQ(first.visibility.data, fresh.visibility.data);
}

TEST_F(Reference, anything_that_matters_misses_the_cache) {
    const DiscView view;
    ambient_occlusion_reference(view.scene, view.query);
    const auto hits = [&](const std::function<void(DiscView&)>& change) {
        DiscView changed = view;
        change(changed);
        return ambient_occlusion_reference(changed.scene, changed.query).from_cache;
    };
    EXPECT_TRUE(hits([](DiscView&) {}));
    EXPECT_TRUE(hits([](DiscView& v) { v.query.camera.name = "other"; }));
    EXPECT_TRUE(hits([](DiscView& v) { v.scene.name = "other"; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.positions[5].x += 1e-3f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.normals[0] = {0.6f, 0.8f, 0.0f}; }));
    EXPECT_FALSE(hits([](DiscView& v) { std::swap(v.scene.indices[0], v.scene.indices[1]); }));
    EXPECT_TRUE(hits([](DiscView& v) { v.scene.materials[0].base_color = glm::vec3(0.2f); }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.materials[0].double_sided = false; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.scene.materials[0].alpha_cutoff = 0.5f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.eye.x += 1e-4f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.up = -v.query.camera.up; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.camera.vertical_fov += 1e-4f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.size = {23, 37}; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.samples += 1; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.radius = 7.0f; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.seed += 1; }));
    EXPECT_FALSE(hits([](DiscView& v) { v.query.pixel_jitter = true; }));
}

TEST_F(Reference, damaged_cache_files_are_computed_anew) {
    const DiscView view;
    const AoReference good = ambient_occlusion_reference(view.scene, view.query);
    const fs::path file = cache_files().at(0);
    const auto size = fs::file_size(file);
    const std::vector<std::function<void()>> damages = {
        [&] { fs::resize_file(file, size - 1); },
        [&] { fs::resize_file(file, size + 4); },
        [&] { fs::resize_file(file, 0); },
        [&] { std::ofstream(file) << "not a result"; },
        [&] {
            fs::remove(file);
            fs::create_directory(file);
        },
        [&] {
            std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
            stream.seekp(static_cast<std::streamoff>(size / 2));
            stream.put('\x77');
        },
        [&] {
            std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
            stream.seekp(0);
            stream.put('X');
        }};
    for (size_t i = 0; i < damages.size(); ++i) {
        damages[i]();
        const AoReference again = ambient_occlusion_reference(view.scene, view.query);
        EXPECT_FALSE(again.from_cache) << "damage " << i;
        EXPECT_EQ(again.visibility.data, good.visibility.data);
        if (fs::is_directory(file))
            fs::remove(file);
        ambient_occlusion_reference(view.scene, view.query);
        EXPECT_TRUE(ambient_occlusion_reference(view.scene, view.query).from_cache);
    }
}

TEST_F(Reference, works_without_a_writable_cache) {
    std::ofstream(folder_ / "file") << "in the way";
    setenv("XDG_CACHE_HOME", (folder_ / "file" / "below").c_str(), 1);
    const DiscView view;
    EXPECT_FALSE(ambient_occlusion_reference(view.scene, view.query).from_cache);
    EXPECT_FALSE(ambient_occlusion_reference(view.scene, view.query).from_cache);
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
