// SPDX-License-Identifier: MIT
#include "renderer/reference/ao_reference.h"

#include "renderer/base/error.h"
#include "renderer/reference/ao_tracer.h"
#include "renderer/reference/cache.h"
#include "renderer/reference/sampling.h"
#include "renderer/scene/surface_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <system_error>
#include <thread>

namespace romascope {
namespace {

/// Goes up with every change of what is computed, so that older cache files are not taken.
constexpr uint32_t kAlgorithmVersion = 2;
constexpr int kTile = 16; ///< pixels per side: neighbours meet the same part of the hierarchy

void check(const AoQuery& query) {
    const auto refuse = [](const std::string& what) {
        throw Error("reference: " + what, kBadInput);
    };
    if (query.size.x < 1 || query.size.y < 1 || query.size.x > 32768 || query.size.y > 32768)
        refuse(
            fmt::format("a picture of {} x {} pixels is not possible", query.size.x, query.size.y));
    if (query.samples < 1 || query.samples > kMaxReferenceSamples)
        refuse(fmt::format("{} samples per pixel, 1 to {} are possible", query.samples,
                           kMaxReferenceSamples));
    const Camera& camera = query.camera;
    for (const glm::vec3& v : {camera.eye, camera.forward, camera.up})
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            refuse("the camera is not finite");
    if (!(query.radius > 0.0f))
        refuse(fmt::format("radius {} m, it must be above 0", query.radius));
}

/// What of the surfaces decides which are there, and to whom.
void add_surfaces(CacheKey& key, const Scene& scene) {
    bool any_mask = false;
    for (const TriangleGroup& group : triangle_groups(scene)) {
        key.add(group.count);
        key.add(group.masked);
        key.add(group.double_sided);
        any_mask = any_mask || group.masked;
    }
    if (!any_mask)
        return;
    key.add(scene.vertex_material);
    key.add(scene.texcoords);
    key.add(scene.colors);
    for (const Material& material : scene.materials) {
        key.add(material.alpha);
        key.add(material.alpha_cutoff);
        key.add(material.texture);
    }
    for (const SurfaceTexture& texture : scene.textures) {
        key.add(texture.size.x);
        key.add(texture.size.y);
        key.add(texture_rules(texture, 1));
        key.add(texture.texels);
    }
}

std::string cache_name(const Scene& scene, const AoQuery& query) {
    CacheKey key;
    key.add(kAlgorithmVersion);
    key.add(scene.positions);
    key.add(scene.normals);
    key.add(scene.indices);
    add_surfaces(key, scene);
    for (const glm::vec3& v : {query.camera.eye, query.camera.forward, query.camera.up})
        for (int axis = 0; axis < 3; ++axis)
            key.add(v[axis]);
    key.add(query.camera.vertical_fov);
    key.add(query.size.x);
    key.add(query.size.y);
    key.add(query.samples);
    key.add(query.radius);
    key.add(query.seed);
    key.add(query.pixel_jitter);
    return key.name();
}

/// Visibility of pixels, as number of free rays out of query.samples.
class Renderer {
public:
    Renderer(const Scene& scene, const AoQuery& query)
        : query_(query), tracer_(scene), lattice_(query.samples),
          tiles_((query.size + kTile - 1) / kTile) {}

    Image render(const std::function<void(double)>& progress, int threads);

private:
    void render_tile(int tile, Image& out) const;
    float pixel(int x, int y) const;

    const AoQuery& query_;
    AoTracer tracer_;
    Lattice lattice_;
    glm::ivec2 tiles_;
};

float Renderer::pixel(int x, int y) const {
    const glm::vec2 corner(x, y);
    const uint32_t seed =
        hash(static_cast<uint32_t>(x) + hash(static_cast<uint32_t>(y) + hash(query_.seed)));
    if (!query_.pixel_jitter) {
        const auto hit = tracer_.seen(query_.camera.eye,
                                      query_.camera.direction_through(corner + 0.5f, query_.size));
        return hit ? tracer_
                         .ambient_occlusion(hit->origin, hit->normal, query_.radius, lattice_, seed)
                         .mean
                   : 1.0f;
    }
    int free = 0;
    for (int i = 0; i < lattice_.size(); ++i) {
        const auto hit = tracer_.seen(
            query_.camera.eye,
            query_.camera.direction_through(corner + lattice_.pixel(i, seed), query_.size));
        const glm::vec3 local = cosine_direction(lattice_.direction(i, seed));
        free +=
            hit && tracer_.occluded(hit->origin, frame_about(hit->normal) * local, query_.radius)
                ? 0
                : 1;
    }
    return estimate_of(free, lattice_.size()).mean;
}

void Renderer::render_tile(int tile, Image& out) const {
    const glm::ivec2 low = glm::ivec2(tile % tiles_.x, tile / tiles_.x) * kTile;
    const glm::ivec2 high = glm::min(low + kTile, query_.size);
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x)
            out.at(x, y, 0) = pixel(x, y);
}

Image Renderer::render(const std::function<void(double)>& progress, int threads) {
    Image out(query_.size.x, query_.size.y, 1);
    const int count = tiles_.x * tiles_.y;
    std::atomic<int> next{0};
    std::atomic<int> done{0};
    const auto take_one = [&] {
        const int tile = next.fetch_add(1);
        if (tile >= count)
            return false;
        render_tile(tile, out);
        done.fetch_add(1);
        return true;
    };
    // Declared after what the threads use: they are joined first, whatever `progress` throws.
    struct Workers {
        std::atomic<int>& next;
        int end;
        std::vector<std::jthread> threads;
        ~Workers() { next.store(end); }
    } workers{next, count, {}};
    if (threads <= 0)
        threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    try {
        for (int i = 1; i < std::min(threads, count); ++i)
            workers.threads.emplace_back([&] {
                while (take_one())
                    ;
            });
    } catch (const std::system_error&) {
        // The system allows no more threads: those there are do the work.
    }
    while (take_one())
        if (progress)
            progress(static_cast<double>(done.load()) / count);
    workers.threads.clear();
    if (progress)
        progress(1.0);
    return out;
}

Image standard_errors(const Image& visibility, int samples) {
    Image errors(visibility.width, visibility.height, 1);
    std::ranges::transform(visibility.data, errors.data.begin(), [&](float mean) {
        return static_cast<float>(std::sqrt(double{mean} * (1.0 - double{mean}) / samples));
    });
    return errors;
}

} // namespace

AoReference ambient_occlusion_reference(const Scene& scene, const AoQuery& query,
                                        const std::function<void(double)>& progress,
                                        const AoOptions& options) {
    check(query);
    AoReference result;
    result.visibility = Image(query.size.x, query.size.y, 1);
    const std::string name = options.use_cache ? cache_name(scene, query) : std::string();
    if (options.use_cache) {
        if (auto cached = read_cached(name, result.visibility.data.size())) {
            result.visibility.data = std::move(cached->values);
            result.seconds = cached->seconds;
            result.from_cache = true;
        }
    }
    if (result.from_cache) {
        if (progress)
            progress(1.0);
    } else {
        const auto start = std::chrono::steady_clock::now();
        result.visibility = Renderer(scene, query).render(progress, options.threads);
        result.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (options.use_cache)
            write_cached(name, {result.visibility.data, result.seconds});
    }
    result.standard_error = standard_errors(result.visibility, query.samples);
    return result;
}

} // namespace romascope
