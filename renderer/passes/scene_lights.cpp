// SPDX-License-Identifier: MIT
#include "renderer/passes/scene_lights.h"

#include "shaders/common/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace romascope {
namespace {

constexpr uint32_t kExposurePoints = 2048;

/// Luminance of linear sRGB (IEC 61966-2-1).
float luminance(glm::vec3 color) { return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

std::vector<size_t> strongest(const std::vector<Light>& lights) {
    std::vector<size_t> order(lights.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, [&](size_t a, size_t b) {
        const bool directional_a = lights[a].kind == LightKind::directional;
        const bool directional_b = lights[b].kind == LightKind::directional;
        if (directional_a != directional_b)
            return directional_a;
        return luminance(lights[a].color) > luminance(lights[b].color);
    });
    order.resize(std::min(order.size(), size_t{gpu::kMaxLights}));
    return order;
}

/// Areas of the triangles, summed up to and with each.
std::vector<double> summed_areas(const Scene& scene) {
    std::vector<double> sums;
    sums.reserve(scene.triangle_count());
    double sum = 0.0;
    for (size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
        const glm::vec3 a = scene.positions[scene.indices[i]];
        sum += 0.5 * glm::length(glm::cross(glm::dvec3(scene.positions[scene.indices[i + 1]] - a),
                                            glm::dvec3(scene.positions[scene.indices[i + 2]] - a)));
        sums.push_back(sum);
    }
    return sums;
}

/// Luminance that falls on a point of the triangle, on its brighter side if it has two.
double received(const Scene& scene, const std::vector<gpu::LightRecord>& lights, size_t triangle,
                glm::vec2 place) {
    const uint32_t* corner = &scene.indices[3 * triangle];
    const glm::vec3 a = scene.positions[corner[0]];
    const glm::vec3 u = scene.positions[corner[1]] - a;
    const glm::vec3 v = scene.positions[corner[2]] - a;
    const glm::vec3 across = glm::cross(u, v);
    const float area = glm::length(across);
    if (!(area > 0.0f))
        return 0.0;
    if (place.x + place.y > 1.0f)
        place = 1.0f - place; // the other half of the parallelogram
    const glm::vec3 point = a + place.x * u + place.y * v;
    const bool two_sides = scene.materials[scene.vertex_material[corner[0]]].double_sided;
    double front = 0.0, back = 0.0;
    for (const gpu::LightRecord& light : lights) {
        front += luminance(gpu::light_irradiance(light, point, across / area));
        if (two_sides)
            back += luminance(gpu::light_irradiance(light, point, -across / area));
    }
    return std::max(front, back);
}

} // namespace

gpu::LightRecord light_record(const Light& light, float exposure) {
    gpu::LightRecord record{};
    record.position = light.position;
    record.inverse_range = 1.0f / light.range;
    record.direction = light.direction;
    record.directional = light.kind == LightKind::directional ? 1.0f : 0.0f;
    record.color = light.color * exposure;
    record.cone = {0.0f, 1.0f};
    if (light.kind == LightKind::spot) {
        // As the specification of KHR_lights_punctual recommends.
        const float outer = std::cos(light.outer_cone);
        const float scale = 1.0f / std::max(0.001f, std::cos(light.inner_cone) - outer);
        record.cone = {scale, -outer * scale};
    }
    return record;
}

float light_exposure(const Scene& scene) {
    std::vector<gpu::LightRecord> lights;
    for (const size_t index : strongest(scene.lights))
        lights.push_back(light_record(scene.lights[index], 1.0f));
    const std::vector<double> areas = summed_areas(scene);
    if (lights.empty() || areas.empty() || !(areas.back() > 0.0))
        return 1.0f;
    double sum = 0.0, squares = 0.0;
    for (uint32_t i = 0; i < kExposurePoints; ++i) {
        const double target = areas.back() * (i + 0.5) / kExposurePoints;
        const auto triangle = static_cast<size_t>(
            std::min(std::ranges::upper_bound(areas, target), areas.end() - 1) - areas.begin());
        const glm::uvec2 place = gpu::r2_sequence(i, glm::uvec2(0x80000000u));
        const double light =
            received(scene, lights, triangle, {gpu::unit_float(place.x), gpu::unit_float(place.y)});
        sum += light;
        squares += light * light;
    }
    const double exposure = sum / squares;
    return std::isnormal(static_cast<float>(exposure)) ? static_cast<float>(exposure) : 1.0f;
}

SceneLights::SceneLights(const Scene& scene)
    : chosen_(strongest(scene.lights)), exposure_(light_exposure(scene)),
      buffer_("lights", std::max(size_t{1}, chosen_.size()) * sizeof(gpu::LightRecord)) {
    upload(scene.lights);
}

void SceneLights::upload(const std::vector<Light>& lights) {
    std::vector<gpu::LightRecord> records;
    for (const size_t index : chosen_)
        records.push_back(light_record(lights[index], exposure_));
    buffer_.upload(std::as_bytes(std::span(records)));
}

} // namespace romascope
