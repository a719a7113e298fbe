// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/roma_tracer.h"

#include "renderer/gl/upload.h"
#include "renderer/tracers/roma/directions.h"

namespace romascope {
namespace {

bool is_sheared(const Settings& settings) {
    return settings.get(kRomaAlignment) == RomaAlignment::shear;
}

constexpr size_t kCounters = 2;

} // namespace

std::vector<const KnobBase*> roma_knobs() {
    return {&kRomaAlignment,
            &kRomaFit,
            &kRomaTaps,
            &kRomaAngularResolution,
            &kRomaDirectionJitter,
            &kRomaNormalOffset,
            &kRomaEscape,
            &kRomaSampling,
            &kRomaSnap,
            &kRomaIterations,
            &kRomaInvocations};
}

std::unique_ptr<Tracer> make_roma_tracer() { return std::make_unique<RomaTracer>(); }

BaseStore RomaTracer::store_for(const Settings& settings) {
    return is_sheared(settings) ? BaseStore::buffer : BaseStore::texture;
}

void RomaTracer::build(const FrameContext& frame) {
    occupancy_.build(frame, store_for(frame.settings));
    align(frame, occupancy_.map(), occupancy_.grid(), frame.scene.bounds());
}

void RomaTracer::align(const FrameContext& frame, const BaseMap& base, const OccupancyGrid& grid,
                       const Bounds& bounds) {
    const Settings& settings = frame.settings;
    candidates_ = candidate_directions(settings.get(kRomaAngularResolution),
                                       settings.get(kRomaDirectionJitter), frame.seed, frame.frame);
    alignment_ = settings.get(kRomaAlignment);
    if (is_sheared(settings)) {
        rotation_ = {};
        shearing_.build(frame, base.words(), grid, candidates_);
        for (size_t map = 0; map < candidates_.size(); ++map)
            candidates_[map] = shearing_.frame().along(map); // its slopes are rounded
    } else {
        shearing_ = {};
        rotation_.build(frame, base.texture(), grid, bounds, candidates_);
    }
    const double cell = is_sheared(settings) ? double(grid.cell_size)
                                             : enclosing_cell(bounds, grid.cell_size,
                                                              settings.get(kOccupancyResolution));
    leaving_ = {settings.get(kRomaNormalOffset) * cell, settings.get(kRomaEscape)};
    snaps_ = settings.get(kRomaSnap);
    upload_candidates(settings, bounds.centre());
    clear_counts(settings);
}

CandidateSet RomaTracer::candidate_set() const {
    if (!snaps_)
        return {};
    return CandidateSet(std::vector<glm::vec3>(candidates_.begin(), candidates_.end()));
}

void RomaTracer::upload_candidates(const Settings& settings, glm::vec3 centre) {
    std::vector<glm::vec4> uniforms = {glm::vec4(centre, 0.0f)};
    for (const int map : strata_along_curve(settings.get(kRomaAngularResolution)))
        uniforms.emplace_back(glm::vec3(candidates_[static_cast<size_t>(map)]),
                              static_cast<float>(map));
    upload_or_replace(candidate_buffer_, "roma candidates", std::span<const glm::vec4>(uniforms));
}

void RomaTracer::clear_counts(const Settings& settings) {
    if (settings.get(kRomaSnap)) {
        count_buffer_ = {};
        return;
    }
    constexpr uint32_t kZero[kCounters] = {};
    upload_or_replace(count_buffer_, "roma counts", std::span<const uint32_t>(kZero));
}

std::vector<NamedCount> RomaTracer::counts() const {
    if (count_buffer_.bytes() == 0)
        return {};
    const std::vector<uint32_t> counts = count_buffer_.download<uint32_t>();
    return {{"rays", counts[0]}, {"unfinished rays", counts[1], counts[0]}};
}

std::vector<ShaderDefine> RomaTracer::shader_defines(const Settings& settings) const {
    std::vector<ShaderDefine> defines =
        is_sheared(settings) ? Shearing::defines(settings) : Rotation::defines(settings);
    defines.push_back({"ROMA_SHEAR", is_sheared(settings) ? "1" : "0"});
    const auto add = [&](std::vector<ShaderDefine> more) {
        for (ShaderDefine& define : more)
            defines.push_back(std::move(define));
    };
    add(romascope::shader_defines(settings, {&kRomaAngularResolution, &kRomaEscape, &kRomaSnap}));
    if (!settings.get(kRomaSnap))
        add(romascope::shader_defines(settings, {&kRomaIterations}));
    return defines;
}

bool RomaTracer::sample_candidates(const Settings& settings) const {
    return settings.get(kRomaSnap) && settings.get(kRomaSampling) == RomaSampling::candidates;
}

void RomaTracer::bind(const Program&) const {
    if (alignment_ == RomaAlignment::shear)
        shearing_.bind();
    else
        rotation_.bind();
    candidate_buffer_.bind(GL_UNIFORM_BUFFER, 4);
    if (count_buffer_.bytes() > 0)
        count_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 5);
}

std::vector<StructureBytes> RomaTracer::bytes() const {
    return {occupancy_.bytes(),
            {"roma maps", rotation_.bytes() + shearing_.bytes() + candidate_buffer_.bytes() +
                              count_buffer_.bytes()}};
}

size_t RomaTracer::bytes_needed(const Settings& settings) const {
    const auto strata = static_cast<size_t>(settings.get(kRomaAngularResolution));
    const size_t uniforms = (strata * strata + 1) * sizeof(glm::vec4);
    const size_t counts = settings.get(kRomaSnap) ? 0 : kCounters * sizeof(uint32_t);
    return OccupancyMap::bytes_needed(settings) + uniforms + counts +
           (is_sheared(settings) ? Shearing::bytes_needed(settings)
                                 : Rotation::bytes_needed(settings));
}

std::vector<ShaderVariant> RomaTracer::build_variants(const Settings& settings) const {
    std::vector<ShaderVariant> variants = OccupancyMap::variants();
    variants.push_back(OccupancySlice::variant(store_for(settings)));
    variants.push_back(MapView::variant(settings, *this));
    for (ShaderVariant& variant :
         is_sheared(settings) ? Shearing::variants(settings) : Rotation::variants(settings))
        variants.push_back(std::move(variant));
    return variants;
}

std::vector<std::string_view> RomaTracer::views() const {
    return {OccupancySlice::kName, MapView::kSlice, MapView::kColumns};
}

void RomaTracer::draw_view(const FrameContext& frame, std::string_view view,
                           const Texture& picture) {
    if (view == OccupancySlice::kName)
        occupancy_slice_.draw(frame, occupancy_, picture);
    else
        map_view_.draw(frame, *this, static_cast<int>(candidates_.size()), view, picture);
}

} // namespace romascope
