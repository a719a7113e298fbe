// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/roma_tracer.h"

#include "renderer/gl/context.h"

namespace romascope {
namespace {

static_assert(sizeof(gpu::RomaDirection) == 7 * 16, "std430 layout of RomaDirection");
static_assert(offsetof(gpu::RomaDirection, base_origin) == 3 * 16);

/// How the words of a column are cut into texels: up to four to a texel, one layer per texel.
struct ColumnLayout {
    int words, words_per_texel, layers;
    GLenum format;
    const char* glsl_format;
};

ColumnLayout layout_of(int side) {
    const int words = (side + 31) / 32;
    if (words == 1)
        return {words, 1, 1, GL_R32UI, "r32ui"};
    if (words == 2)
        return {words, 2, 1, GL_RG32UI, "rg32ui"};
    return {words, 4, (words + 3) / 4, GL_RGBA32UI, "rgba32ui"};
}

std::vector<ShaderDefine> layout_defines(int side) {
    const ColumnLayout layout = layout_of(side);
    return {{"ROMA_SIDE", std::to_string(side)},
            {"ROMA_WORDS_PER_TEXEL", std::to_string(layout.words_per_texel)},
            {"ROMA_LAYERS_PER_MAP", std::to_string(layout.layers)},
            {"ROMA_FORMAT", layout.glsl_format}};
}

ShaderVariant rotate_variant(const Settings& settings, bool by_word) {
    const int side = settings.get(kOccupancyResolution);
    std::vector<ShaderDefine> defines = layout_defines(side);
    const int group_words = by_word ? layout_of(side).words_per_texel : 1;
    defines.push_back({"ROMA_GROUP_WORDS", std::to_string(group_words)});
    return {"rotate", {{GL_COMPUTE_SHADER, "tracers/roma/rotate.comp.glsl"}}, defines, {}};
}

} // namespace

std::vector<const KnobBase*> roma_knobs() {
    return {&kRomaAngularResolution, &kRomaDirectionJitter, &kRomaNormalOffset, &kRomaSampling,
            &kRomaRotateBy};
}

std::unique_ptr<Tracer> make_roma_tracer() { return std::make_unique<RomaTracer>(); }

void RomaTracer::build(const FrameContext& frame) {
    occupancy_.build(frame);
    rotate(frame, occupancy_.texture(), occupancy_.grid(), frame.scene.bounds());
}

void RomaTracer::rotate(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid,
                        const Bounds& bounds) {
    side_ = frame.settings.get(kOccupancyResolution);
    aim(frame, grid, bounds);
    resize_maps();
    const RomaRotateBy by = frame.settings.get(kRomaRotateBy);
    const bool by_word =
        by == RomaRotateBy::word || (by == RomaRotateBy::device && !is_software_context());
    const Program& program = rotate_.get(frame.shaders, rotate_variant(frame.settings, by_word));

    auto pass = frame.timer.compute("roma rotation");
    program.use();
    program.set("base_size", grid.size);
    base.bind(0);
    direction_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    map_texture_.bind_image(0, GL_WRITE_ONLY);
    const int invocations_per_texel = by_word ? layout_of(side_).words_per_texel : 1;
    program.dispatch_covering(map_texture_.size() * glm::ivec3(1, 1, invocations_per_texel));
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

/// Draws this frame's candidates and tells the shaders.
void RomaTracer::aim(const FrameContext& frame, const OccupancyGrid& grid, const Bounds& bounds) {
    candidates_ =
        candidate_directions(frame.settings.get(kRomaAngularResolution),
                             frame.settings.get(kRomaDirectionJitter), frame.seed, frame.frame);
    const double offset =
        frame.settings.get(kRomaNormalOffset) * enclosing_cell(bounds, grid.cell_size, side_);
    directions_.clear();
    for (const glm::dvec3& candidate : candidates_) {
        const AlignedBox box = AlignedBox::around(bounds, grid.cell_size, candidate, side_);
        directions_.push_back(aligned_map(box, side_, grid, offset));
    }
    std::vector<glm::vec4> uniforms = {glm::vec4(bounds.centre(), 0.0f)};
    for (const int map : strata_along_curve(frame.settings.get(kRomaAngularResolution)))
        uniforms.emplace_back(glm::vec3(candidates_[static_cast<size_t>(map)]),
                              static_cast<float>(map));
    const auto upload = [](Buffer& buffer, const char* label, std::span<const std::byte> bytes) {
        if (buffer.bytes() != bytes.size())
            buffer = Buffer(label, bytes);
        else
            buffer.upload(bytes);
    };
    upload(direction_buffer_, "roma directions", std::as_bytes(std::span(directions_)));
    upload(candidate_buffer_, "roma candidates", std::as_bytes(std::span(uniforms)));
}

void RomaTracer::resize_maps() {
    const ColumnLayout layout = layout_of(side_);
    const int layers = static_cast<int>(candidates_.size()) * layout.layers;
    const glm::ivec3 size(side_, side_, layers);
    if (map_texture_.size() != size || map_texture_.format() != layout.format)
        map_texture_ = Texture("roma maps", GL_TEXTURE_2D_ARRAY, layout.format, size);
}

std::vector<ShaderDefine> RomaTracer::shader_defines(const Settings& settings) const {
    std::vector<ShaderDefine> defines = layout_defines(settings.get(kOccupancyResolution));
    for (ShaderDefine& define : romascope::shader_defines(settings, {&kRomaAngularResolution}))
        defines.push_back(std::move(define));
    return defines;
}

bool RomaTracer::sample_candidates(const Settings& settings) const {
    return settings.get(kRomaSampling) == RomaSampling::candidates;
}

void RomaTracer::bind(const Program&) const {
    map_texture_.bind(4);
    direction_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 4);
    candidate_buffer_.bind(GL_UNIFORM_BUFFER, 4);
}

std::vector<StructureBytes> RomaTracer::bytes() const {
    return {occupancy_.bytes(),
            {"roma maps",
             map_texture_.bytes() + direction_buffer_.bytes() + candidate_buffer_.bytes()}};
}

size_t RomaTracer::bytes_needed(const Settings& settings) const {
    const auto side = static_cast<size_t>(settings.get(kOccupancyResolution));
    const auto strata = static_cast<size_t>(settings.get(kRomaAngularResolution));
    const size_t candidates = strata * strata;
    const ColumnLayout layout = layout_of(settings.get(kOccupancyResolution));
    const size_t column = sizeof(uint32_t) * layout.words_per_texel * layout.layers;
    const size_t uniforms = (candidates + 1) * sizeof(glm::vec4);
    return OccupancyMap::bytes_needed(settings) +
           candidates * (side * side * column + sizeof(gpu::RomaDirection)) + uniforms;
}

std::vector<ShaderVariant> RomaTracer::build_variants(const Settings& settings) const {
    return {OccupancyMap::variant(false),    OccupancyMap::variant(true),
            rotate_variant(settings, false), rotate_variant(settings, true),
            OccupancySlice::variant(),       MapView::variant(settings, *this)};
}

std::vector<std::string_view> RomaTracer::views() const {
    return {OccupancySlice::kName, MapView::kSlice, MapView::kColumns};
}

void RomaTracer::draw_view(const FrameContext& frame, std::string_view view,
                           const Texture& picture) {
    if (view == OccupancySlice::kName)
        occupancy_slice_.draw(frame, occupancy_, picture);
    else
        map_view_.draw(frame, *this, static_cast<int>(directions_.size()), view, picture);
}

std::vector<uint32_t> RomaTracer::download_map(int index) const {
    const ColumnLayout layout = layout_of(side_);
    const std::vector<GLuint> texels = map_texture_.download_uint(layout.words_per_texel);
    const size_t columns = static_cast<size_t>(side_) * side_;
    std::vector<uint32_t> words;
    words.reserve(columns * layout.words);
    for (size_t column = 0; column < columns; ++column) {
        for (int word = 0; word < layout.words; ++word) {
            const size_t layer =
                static_cast<size_t>(index) * layout.layers + word / layout.words_per_texel;
            words.push_back(texels[(layer * columns + column) * layout.words_per_texel +
                                   word % layout.words_per_texel]);
        }
    }
    return words;
}

} // namespace romascope
