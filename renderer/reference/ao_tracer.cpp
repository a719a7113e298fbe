// SPDX-License-Identifier: MIT
#include "renderer/reference/ao_tracer.h"

#include "renderer/base/error.h"
#include "renderer/reference/sampling.h"
#include "renderer/reference/surfaces.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// What Embree hands to filters with every ray.
struct Context {
    RTCIntersectContext embree; ///< first, so that a pointer to it is one to the whole
    bool from_camera = false;

    Context() { rtcInitIntersectContext(&embree); }
};

/// Triangles that follow each other and are one geometry to Embree.
struct Part {
    uint32_t first = 0;
    size_t count = 0;
    bool masked = false;
    const ReferenceSurfaces* surfaces = nullptr;
};

/// Rejects hits on what is not there for this ray. Called for each hit that Embree considers.
void filter(const RTCFilterFunctionNArguments* args) {
    const auto& part = *static_cast<const Part*>(args->geometryUserPtr);
    const bool from_camera = reinterpret_cast<const Context*>(args->context)->from_camera;
    for (unsigned i = 0; i < args->N; ++i) {
        if (args->valid[i] == 0)
            continue;
        const uint32_t triangle = part.first + RTCHitN_primID(args->hit, args->N, i);
        // Embree's normal is on the side from which the corners are counter-clockwise.
        const float along =
            RTCHitN_Ng_x(args->hit, args->N, i) * RTCRayN_dir_x(args->ray, args->N, i) +
            RTCHitN_Ng_y(args->hit, args->N, i) * RTCRayN_dir_y(args->ray, args->N, i) +
            RTCHitN_Ng_z(args->hit, args->N, i) * RTCRayN_dir_z(args->ray, args->N, i);
        if ((from_camera && along > 0.0f && !part.surfaces->is_double_sided(triangle)) ||
            !part.surfaces->is_there(triangle, RTCHitN_u(args->hit, args->N, i),
                                     RTCHitN_v(args->hit, args->N, i)))
            args->valid[i] = 0;
    }
}

} // namespace

struct AoTracer::State {
    explicit State(const Scene& from);
    ~State() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    void attach(Part& part);
    std::optional<Hit> trace(glm::vec3 origin, glm::vec3 direction, bool from_camera) const;
    Hit resolve(const RTCRayHit& ray) const;

    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    ReferenceSurfaces surfaces;
    // Shared with Embree, which reads 16 bytes at a time: one element more than there are.
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices;
    std::vector<glm::vec3> normals;
    std::vector<Part> parts; ///< by Embree's number of the geometry
};

AoTracer::State::State(const Scene& from)
    : surfaces(from), positions(from.positions), indices(from.indices), normals(from.normals) {
    positions.emplace_back();
    indices.resize(indices.size() + 3);
    for (const TriangleGroup& group : triangle_groups(from)) {
        if (parts.empty() || parts.back().masked != group.masked)
            parts.push_back({static_cast<uint32_t>(group.first), 0, group.masked, &surfaces});
        parts.back().count += group.count;
    }
}

void AoTracer::State::attach(Part& part) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               positions.data(), 0, sizeof(glm::vec3), positions.size() - 1);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               indices.data() + size_t{3} * part.first, 0, 3 * sizeof(uint32_t),
                               part.count);
    // Only where there is something to reject: rays without filters are faster.
    rtcSetGeometryUserData(geometry, &part);
    if (part.masked || !surfaces.all_double_sided())
        rtcSetGeometryIntersectFilterFunction(geometry, filter);
    if (part.masked)
        rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

AoTracer::AoTracer(const Scene& scene) : state_(std::make_unique<State>(scene)) {
    State& state = *state_;
    // Built by one thread: the order of triangles within a leaf depends on the number of threads,
    // and with it which of two triangles a ray through their common edge meets.
    state.device = rtcNewDevice("threads=1");
    if (!state.device)
        throw Error(fmt::format("reference: Embree does not start (error {})",
                                static_cast<int>(rtcGetDeviceError(nullptr))));
    state.scene = rtcNewScene(state.device);
    rtcSetSceneFlags(state.scene, RTC_SCENE_FLAG_ROBUST);
    for (Part& part : state.parts)
        state.attach(part);
    rtcCommitScene(state.scene);
    if (const RTCError code = rtcGetDeviceError(state.device); code != RTC_ERROR_NONE)
        throw Error(fmt::format("reference: Embree cannot build the scene (error {})",
                                static_cast<int>(code)));
}

AoTracer::~AoTracer() = default;
AoTracer::AoTracer(AoTracer&&) noexcept = default;
AoTracer& AoTracer::operator=(AoTracer&&) noexcept = default;

std::optional<Hit> AoTracer::closest(glm::vec3 origin, glm::vec3 direction) const {
    return state_->trace(origin, direction, false);
}

std::optional<Hit> AoTracer::seen(glm::vec3 origin, glm::vec3 direction) const {
    return state_->trace(origin, direction, true);
}

std::optional<Hit> AoTracer::State::trace(glm::vec3 origin, glm::vec3 direction,
                                          bool from_camera) const {
    Context context;
    context.from_camera = from_camera;
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
    rtcIntersect1(scene, &context.embree, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    return resolve(query);
}

/// In double: the point lies in the plane of the triangle's float vertices to far less than a
/// float's rounding, whatever the distance to the ray's start.
Hit AoTracer::State::resolve(const RTCRayHit& query) const {
    Hit hit;
    hit.distance = query.ray.tfar;
    hit.triangle = parts[query.hit.geomID].first + query.hit.primID;
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
    Context context;
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tfar = t_max;
    ray.mask = ~0u;
    rtcOccluded1(state_->scene, &context.embree, &ray);
    return ray.tfar < 0.0f; // Embree's sign for "something is there"
}

Estimate AoTracer::ambient_occlusion(glm::vec3 origin, glm::vec3 normal, float radius,
                                     const Lattice& lattice, uint32_t seed) const {
    Context context;
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
        rtcOccluded8(valid, state_->scene, &context.embree, &rays);
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
