// SPDX-License-Identifier: MIT
#include "renderer/reuse/spatial_hash/spatial_hash.h"

#include "renderer/passes/compose.h"
#include "renderer/reuse/surface_history.h"
#include "shaders/common/random.h"
#include "shaders/reuse/spatial_hash/pixel_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace romascope {
namespace {

/// Sets the lookups' random numbers apart from the rays'.
constexpr uint32_t kJitterStream = 0x9E3779B9u;

uint32_t capacity_of(const Settings& settings) { return 1u << settings.get(kHashCapacity); }

/// Wanted size of a cell over the smallest, per metre from the eye; 0: all are the smallest.
float size_ratio(const Settings& settings, const View& view) {
    if (settings.get(kHashFixedSize) > 0.0)
        return 0.0f;
    return pixels_at_unit_depth(view, settings.get(kHashFootprint)) / smallest_cell_size(settings);
}

/// More than any cell holds, where tracing never stops.
uint32_t sample_cap(const Settings& settings) {
    return settings.get(kHashStop) ? static_cast<uint32_t>(settings.get(kHashSampleCap))
                                   : gpu::kSamplesMask;
}

/// Frames without use before a cell is freed.
uint32_t max_age(const Settings& settings) {
    return settings.get(kHashEvict) ? static_cast<uint32_t>(settings.get(kHashEvictionAge))
                                    : gpu::kMaxAge;
}

/// The settings with everything default that changes nothing of what a sample in a cell means, nor
/// of where in the cell's surroundings it may come from.
Settings meaning_of(const Settings& settings) {
    Settings meaning(settings.table());
    std::vector<const KnobBase*> knobs = tracer_knobs();
    knobs.insert(knobs.end(), {&kAoRadius, &kHashCapacity, &kHashSearch, &kHashProbing,
                               &kHashSmallest, &kHashFixedSize, &kHashNormalBins, &kHashJitter});
    for (const KnobBase* knob : knobs)
        meaning.set_value(*knob, settings.value(*knob));
    return meaning;
}

ShaderVariant variant_of(const char* name, const char* file, std::vector<ShaderDefine> defines) {
    return {name, {{GL_COMPUTE_SHADER, file}}, std::move(defines), {}};
}

ShaderVariant claim_variant(const Settings& settings, bool renews) {
    std::vector<ShaderDefine> defines = HashTable::defines(settings.get(kHashProbing));
    defines.push_back({"RENEWS", renews ? "1" : "0"});
    return variant_of("hash claim", "reuse/spatial_hash/claim.comp.glsl", std::move(defines));
}

ShaderVariant renew_variant() {
    return variant_of("hash renew", "reuse/spatial_hash/renew.comp.glsl",
                      HashTable::defines(HashProbing::linear));
}

ShaderVariant add_variant(const Settings& settings) {
    std::vector<ShaderDefine> defines = HashTable::defines(HashProbing::linear);
    for (ShaderDefine& define : shader_defines(settings, {&kAoRays}))
        defines.push_back(std::move(define));
    return variant_of("hash add", "reuse/spatial_hash/add.comp.glsl", defines);
}

ShaderVariant resolve_variant() {
    return variant_of("hash resolve", "reuse/spatial_hash/resolve.comp.glsl",
                      HashTable::defines(HashProbing::linear));
}

ShaderVariant view_variant(const Settings& settings) {
    std::vector<ShaderDefine> defines = HashTable::defines(settings.get(kHashProbing));
    for (ShaderDefine& define : shader_defines(settings, {&kHashView}))
        defines.push_back(std::move(define));
    return variant_of("hash view", "reuse/spatial_hash/view.comp.glsl", defines);
}

void wait_for_stores() {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                    GL_COMMAND_BARRIER_BIT);
}

/// One pixel in so many may add its rays, so that a cell's sums cannot overflow even if all fall in
/// it. 1 for all pictures below 33 million pixels.
uint32_t adding_stride(const Settings& settings, glm::ivec2 size) {
    const uint64_t rays = uint64_t{1} * static_cast<uint32_t>(size.x) *
                          static_cast<uint32_t>(size.y) *
                          static_cast<uint32_t>(settings.get(kAoRays));
    return static_cast<uint32_t>(rays / gpu::kMaxFrameSamples + 1);
}

} // namespace

void SpatialHash::prepare(const FrameContext& frame, const View& view) {
    const uint32_t capacity = capacity_of(frame.settings);
    if (table_.capacity() != capacity) {
        table_ = {}; // first, so that both are never held at once
        table_ = HashTable(capacity);
        stale_ = true;
    }
    Settings meaning = meaning_of(frame.settings);
    if (stale_ || meaning_ != meaning)
        renewal_.release(); // which then cannot follow
    stale_ = true; // until settle(): a frame that fails leaves neither ages nor changes right
    if (!renewal_.follow(frame, max_age(frame.settings))) {
        table_.clear();
        renewal_.begin(frame);
    }
    meaning_ = std::move(meaning);

    const glm::ivec3 extent(view.size, 1);
    if (cells_.size() != extent)
        cells_ = Texture("hash cells of pixels", GL_TEXTURE_2D, GL_RG32UI, extent);
    list_.begin(view.size);
    constexpr std::array<uint32_t, gpu::kHashCounts> kZero = {};
    if (counts_.bytes() == 0)
        counts_ = Buffer::from("hash counts", std::span<const uint32_t>(kZero));
    else
        counts_.upload(std::as_bytes(std::span<const uint32_t>(kZero)));
    rays_ = frame.settings.get(kAoRays);
}

void SpatialHash::run(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                      const Tracer& tracer, AmbientOcclusion& ambient_occlusion) {
    const bool shown = frame.settings.get(kView) == PictureKind::hash;
    const bool before = frame.settings.get(kHashView) == HashView::age;
    prepare(frame, view);
    if (shown && before) // what is seen is used, and then its age is 0
        draw(frame, view, gbuffer);
    const Texture& visibility = ambient_occlusion.visibility_of_size(view.size);
    claim(frame, view, gbuffer, visibility);
    if (renewal_.is_needed())
        renew(frame);
    ambient_occlusion.run(frame, view, gbuffer, tracer, &list_);
    add(frame, visibility);
    resolve(frame, visibility);
    settle(frame);
    stale_ = false;
    if (shown && !before)
        draw(frame, view, gbuffer);
    if (!shown)
        picture_ = {};
}

void SpatialHash::set_key_uniforms(const Program& program, const FrameContext& frame,
                                   const View& view) const {
    const Settings& settings = frame.settings;
    view.set_uniforms(program);
    program.set("size_ratio", size_ratio(settings, view));
    program.set("inverse_smallest", 1.0f / smallest_cell_size(settings));
    program.set("normal_bins", static_cast<float>(settings.get(kHashNormalBins)));
    program.set("frame", frame.frame);
    program.set("jitter_key", gpu::pcg_hash(gpu::pcg_hash(frame.seed) + kJitterStream));
    program.set("jitter_scale", static_cast<float>(settings.get(kHashJitter)));
    program.set("blend_sizes",
                settings.get(kHashBlend) && settings.get(kHashFixedSize) == 0.0 ? 1 : 0);
    table_.bind(program, settings.get(kHashSearch));
}

void SpatialHash::claim(const FrameContext& frame, const View& view, const GBuffer& gbuffer,
                        const Texture& visibility) {
    const Settings& settings = frame.settings;
    const bool renews = renewal_.is_needed();
    const Program& program = (renews ? renewing_claim_program_ : claim_program_)
                                 .get(frame.shaders, claim_variant(settings, renews));
    auto pass = frame.timer.compute("hash claim");
    program.use();
    set_key_uniforms(program, frame, view);
    program.set("sample_cap", sample_cap(settings));
    program.set("adding_stride", adding_stride(settings, view.size));
    if (renews)
        renewal_.bind(program);
    gbuffer.bind_surface();
    visibility.bind_image(0, GL_WRITE_ONLY);
    cells_.bind_image(1, GL_WRITE_ONLY);
    list_.bind_to_fill();
    counts_.bind(GL_SHADER_STORAGE_BUFFER, 3);
    program.dispatch_covering(cells_.size());
    wait_for_stores();
}

void SpatialHash::renew(const FrameContext& frame) {
    const Program& program = renew_program_.get(frame.shaders, renew_variant());
    auto pass = frame.timer.compute("hash renew");
    program.use();
    table_.bind(program, 1);
    cells_.bind(0);
    counts_.bind(GL_SHADER_STORAGE_BUFFER, 3);
    list_.dispatch();
    wait_for_stores();
}

void SpatialHash::add(const FrameContext& frame, const Texture& visibility) {
    const Program& program = add_program_.get(frame.shaders, add_variant(frame.settings));
    auto pass = frame.timer.compute("hash add");
    program.use();
    table_.bind(program, 1);
    cells_.bind(0);
    visibility.bind(1);
    list_.dispatch();
    wait_for_stores();
}

void SpatialHash::resolve(const FrameContext& frame, const Texture& visibility) {
    const Program& program = resolve_program_.get(frame.shaders, resolve_variant());
    auto pass = frame.timer.compute("hash resolve");
    program.use();
    table_.bind(program, 1);
    cells_.bind(0);
    visibility.bind_image(0, GL_WRITE_ONLY);
    list_.dispatch();
    wait_for_stores();
}

void SpatialHash::settle(const FrameContext& frame) {
    const Program& program = settle_program_.get(frame.shaders, HashTable::settle_variant());
    auto pass = frame.timer.compute("hash settle");
    program.use();
    counts_.bind(GL_SHADER_STORAGE_BUFFER, 3);
    table_.settle(program, frame.frame, max_age(frame.settings));
}

void SpatialHash::draw(const FrameContext& frame, const View& view, const GBuffer& gbuffer) {
    const Settings& settings = frame.settings;
    if (picture_.size() != cells_.size())
        picture_ = Texture("hash view", GL_TEXTURE_2D, GL_RGBA32F, cells_.size());
    const Program& program = view_program_.get(frame.shaders, view_variant(settings));
    auto pass = frame.timer.compute("hash view");
    program.use();
    set_key_uniforms(program, frame, view);
    program.set("sample_cap", static_cast<GLuint>(settings.get(kHashSampleCap)));
    program.set("max_age", static_cast<GLuint>(settings.get(kHashEvictionAge)));
    gbuffer.bind_surface();
    picture_.bind_image(0, GL_WRITE_ONLY);
    program.dispatch_covering(picture_.size());
    wait_for_stores();
}

void SpatialHash::release() {
    table_ = {};
    list_ = {};
    cells_ = {};
    counts_ = {};
    picture_ = {};
    renewal_.release();
    meaning_.reset();
}

bool SpatialHash::is_used(const Settings& settings) {
    return settings.get(kHashEnabled) || settings.get(kView) == PictureKind::hash;
}

std::vector<StructureBytes> SpatialHash::bytes() const {
    if (table_.capacity() == 0)
        return {};
    std::vector<StructureBytes> all = {
        {"hash table", table_.bytes()},
        {"hash of pixels", list_.bytes() + cells_.bytes() + counts_.bytes() + picture_.bytes()}};
    if (renewal_.bytes() > 0)
        all.push_back({"hash changes", renewal_.bytes()});
    return all;
}

size_t SpatialHash::bytes_needed(const Settings& settings, size_t pixels) {
    if (!is_used(settings))
        return 0;
    return capacity_of(settings) * sizeof(gpu::Cell) +
           pixels * (PixelList::kBytesPerPixel + 2 * sizeof(uint32_t));
}

std::vector<ShaderVariant> SpatialHash::variants(const Settings& settings) {
    std::vector<ShaderVariant> all = {claim_variant(settings, false),
                                      claim_variant(settings, true),
                                      renew_variant(),
                                      add_variant(settings),
                                      resolve_variant(),
                                      HashTable::settle_variant(),
                                      view_variant(settings)};
    for (ShaderVariant& variant : ChangeVolume::variants())
        all.push_back(std::move(variant));
    return all;
}

std::vector<NamedCount> SpatialHash::counts() const {
    if (counts_.bytes() == 0)
        return {};
    const std::vector<uint32_t> words = counts_.download<uint32_t>();
    const auto at = [&](int place) { return uint64_t{words[static_cast<size_t>(place)]}; };
    const auto rays = static_cast<uint64_t>(rays_);
    const uint64_t pixels = uint64_t{1} * static_cast<uint32_t>(cells_.size().x) *
                            static_cast<uint32_t>(cells_.size().y);
    const uint64_t surfaces = pixels - at(gpu::kCountBackground);
    std::vector<NamedCount> counts = {
        {"hash rays traced", at(gpu::kCountTraced) * rays},
        {"hash rays saved", (surfaces - at(gpu::kCountTraced)) * rays},
        {"hash cells", at(gpu::kCountCells)},
        {"hash slots", table_.capacity()},
        {"hash insertions", at(gpu::kCountInsertions)},
        {"hash evictions", at(gpu::kCountEvictions)},
        {"hash renewals", at(gpu::kCountRenewals)},
        {"hash failed pixels", at(gpu::kCountFailed)},
        {"hash longest probe", std::max(at(gpu::kCountProbes), std::min(surfaces, uint64_t{1}))}};
    for (int bin = 0; bin < gpu::kHistogramBins; ++bin)
        counts.push_back(
            {fmt::format("hash samples {} {}", bin + 1 < gpu::kHistogramBins ? "<" : ">=",
                         1 << 2 * std::min(bin + 1, gpu::kHistogramBins - 1)),
             at(gpu::kCountSamples + bin)});
    for (int bin = 0; bin < gpu::kHistogramBins; ++bin)
        counts.push_back({fmt::format("hash age {} {}", bin + 1 < gpu::kHistogramBins ? "<" : ">=",
                                      1 << std::min(bin, gpu::kHistogramBins - 2)),
                          at(gpu::kCountAges + bin)});
    return counts;
}

} // namespace romascope
