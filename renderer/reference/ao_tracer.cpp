// SPDX-License-Identifier: MIT
#include "renderer/reference/ao_tracer.h"

#include "renderer/base/error.h"
#include "renderer/reference/sampling.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace romascope {
namespace {

/// Distance of Hit::origin from the surface, in units of the triangle's largest coordinate. The
/// rounding of a vertex or of a point is half a unit in the last place (2^-24), that of Embree's
/// plane equation a few; 16 of them leave room, and are 0.03 mm in a hall of 30 m.
constexpr double kOffset = 16.0 * 0x1p-24;

/// Rays per packet: as many as AVX2 holds.
constexpr int kPacket = 8;

float largest(glm::vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

template <class T>
void upload(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& data,
            size_t count) {
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, type, 0, format, data.size() * sizeof(T) / count, count);
    if (!buffer)
        throw Error("reference: not enough memory for the scene's triangles");
    std::memcpy(buffer, data.data(), data.size() * sizeof(T));
}

} // namespace

struct AoTracer::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<uint32_t> indices;

    ~State() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    Hit resolve(const RTCRayHit& ray) const;
};

void AoTracer::attach_triangles(State& state) {
    const RTCGeometry geometry = rtcNewGeometry(state.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    upload(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, state.positions,
           state.positions.size());
    upload(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, state.indices,
           state.indices.size() / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state.scene, geometry);
    rtcReleaseGeometry(geometry);
}

AoTracer::AoTracer(const Scene& scene) : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.positions = scene.positions;
    state.normals = scene.normals;
    state.indices = scene.indices;
    // Built by one thread: the order of triangles within a leaf depends on the number of threads,
    // and with it which of two triangles a ray through their common edge meets.
    state.device = rtcNewDevice("threads=1");
    if (!state.device)
        throw Error(fmt::format("reference: Embree does not start (error {})",
                                static_cast<int>(rtcGetDeviceError(nullptr))));
    state.scene = rtcNewScene(state.device);
    rtcSetSceneFlags(state.scene, RTC_SCENE_FLAG_ROBUST);
    if (!state.indices.empty())
        attach_triangles(state);
    rtcCommitScene(state.scene);
    if (const RTCError code = rtcGetDeviceError(state.device); code != RTC_ERROR_NONE)
        throw Error(fmt::format("reference: Embree cannot build the scene (error {})",
                                static_cast<int>(code)));
}

AoTracer::~AoTracer() = default;
AoTracer::AoTracer(AoTracer&&) noexcept = default;
AoTracer& AoTracer::operator=(AoTracer&&) noexcept = default;

std::optional<Hit> AoTracer::closest(glm::vec3 origin, glm::vec3 direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    return state_->resolve(query);
}

/// In double: the point lies in the plane of the triangle's float vertices to far less than a
/// float's rounding, whatever the distance to the ray's start.
Hit AoTracer::State::resolve(const RTCRayHit& query) const {
    Hit hit;
    hit.distance = query.ray.tfar;
    hit.triangle = query.hit.primID;
    const uint32_t* corner = &indices[size_t{3} * hit.triangle];
    const double u = query.hit.u;
    const double v = query.hit.v;
    const glm::dvec3 a(positions[corner[0]]);
    const glm::dvec3 b(positions[corner[1]]);
    const glm::dvec3 c(positions[corner[2]]);
    const glm::dvec3 point = (1.0 - u - v) * a + u * b + v * c;
    const glm::dvec3 direction(query.ray.dir_x, query.ray.dir_y, query.ray.dir_z);

    glm::dvec3 geometric = glm::normalize(glm::cross(b - a, c - a));
    if (glm::dot(geometric, direction) > 0.0)
        geometric = -geometric;
    glm::dvec3 normal = (1.0 - u - v) * glm::dvec3(normals[corner[0]]) +
                        u * glm::dvec3(normals[corner[1]]) + v * glm::dvec3(normals[corner[2]]);
    const double length = glm::length(normal);
    normal = length > 1e-12 ? normal / length : geometric; // opposed normals may cancel
    if (glm::dot(normal, geometric) < 0.0)
        normal = -normal;

    const double scale = std::max({largest(positions[corner[0]]), largest(positions[corner[1]]),
                                   largest(positions[corner[2]])});
    hit.position = glm::vec3(point);
    hit.geometric_normal = glm::vec3(geometric);
    hit.normal = glm::vec3(normal);
    hit.origin = glm::vec3(point + kOffset * scale * geometric);
    return hit;
}

bool AoTracer::occluded(glm::vec3 origin, glm::vec3 direction, float t_max) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = t_max;
    ray.mask = ~0u;
    rtcOccluded1(state_->scene, &context, &ray);
    return ray.tfar < 0.0f; // Embree's sign for "something is there"
}

Estimate AoTracer::ambient_occlusion(glm::vec3 origin, glm::vec3 normal, float radius,
                                     const Lattice& lattice, uint32_t seed) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    const glm::mat3 frame = frame_about(normal);
    RTCRay8 rays{};
    std::fill_n(rays.org_x, kPacket, origin.x);
    std::fill_n(rays.org_y, kPacket, origin.y);
    std::fill_n(rays.org_z, kPacket, origin.z);
    std::fill_n(rays.mask, kPacket, ~0u);
    int free = 0;
    for (int first = 0; first < lattice.size(); first += kPacket) {
        alignas(32) int valid[kPacket] = {};
        const int count = std::min(kPacket, lattice.size() - first);
        for (int i = 0; i < count; ++i) {
            const glm::vec3 direction =
                frame * cosine_direction(lattice.direction(first + i, seed));
            rays.dir_x[i] = direction.x;
            rays.dir_y[i] = direction.y;
            rays.dir_z[i] = direction.z;
            rays.tfar[i] = radius;
            valid[i] = -1;
        }
        rtcOccluded8(valid, state_->scene, &context, &rays);
        for (int i = 0; i < count; ++i)
            free += rays.tfar[i] < 0.0f ? 0 : 1;
    }
    return estimate_of(free, lattice.size());
}

Estimate AoTracer::ambient_occlusion(glm::vec3 origin, glm::vec3 normal, float radius, int samples,
                                     uint32_t seed) const {
    return ambient_occlusion(origin, normal, radius, Lattice(samples), seed);
}

Estimate estimate_of(int free, int samples) {
    const double p = static_cast<double>(free) / samples;
    return {static_cast<float>(p), static_cast<float>(std::sqrt(p * (1.0 - p) / samples))};
}

} // namespace romascope
