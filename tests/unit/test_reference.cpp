// SPDX-License-Identifier: MIT
// Ground truth against closed forms. A Monte Carlo mean of n rays that are free with probability p
// has standard deviation sqrt(p (1 - p) / n) if they are independent; ours are stratified, so
// theirs is smaller. Five of those plus the error of the triangles is therefore never exceeded by
// chance, and at n = 2^18 it is still only 0.005.
#include "renderer/reference/ao_tracer.h"
#include "renderer/reference/sampling.h"
#include "tests/support/reference_fixture.h"

#include <glm/gtc/quaternion.hpp>

#include <random>

namespace romascope {
namespace {

constexpr int kRays = 1 << 18;

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

} // namespace
} // namespace romascope
