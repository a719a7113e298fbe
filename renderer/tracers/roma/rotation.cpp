// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/rotation.h"

#include "renderer/gl/upload.h"
#include "renderer/tracers/occupancy/occupancy_map.h"
#include "renderer/tracers/roma/roma_knobs.h"

namespace romascope {
namespace {

static_assert(sizeof(gpu::RomaDirection) == 7 * 16, "std430 layout of RomaDirection");
static_assert(offsetof(gpu::RomaDirection, base_origin) == 3 * 16);

ShaderVariant rotate_variant(const Settings& settings, bool many) {
    std::vector<ShaderDefine> defines = Rotation::defines(settings);
    const ColumnLayout layout = ColumnLayout::of(settings.get(kOccupancyResolution));
    const int group_words = many ? layout.words_per_texel : 1;
    defines.push_back({"ROMA_GROUP_WORDS", std::to_string(group_words)});
    return {"rotate", {{GL_COMPUTE_SHADER, "tracers/roma/rotate.comp.glsl"}}, defines, {}};
}

} // namespace

void Rotation::build(const FrameContext& frame, const Texture& base, const OccupancyGrid& grid,
                     const Bounds& bounds, std::span<const glm::dvec3> candidates) {
    side_ = frame.settings.get(kOccupancyResolution);
    const double offset =
        frame.settings.get(kRomaNormalOffset) * enclosing_cell(bounds, grid.cell_size, side_);
    const auto fit = frame.settings.get(kRomaFit) == RomaFit::cube ? &AlignedBox::enclosing
                                                                   : &AlignedBox::around;
    directions_.clear();
    for (const glm::dvec3& candidate : candidates) {
        const AlignedBox box = fit(bounds, grid.cell_size, candidate, side_);
        directions_.push_back(aligned_map(box, side_, grid, offset));
    }
    upload_or_replace(direction_buffer_, "roma directions",
                      std::span<const gpu::RomaDirection>(directions_));

    const ColumnLayout layout = ColumnLayout::of(side_);
    const glm::ivec3 size(side_, side_, static_cast<int>(candidates.size()) * layout.texels);
    if (maps_.size() != size || maps_.format() != layout.format)
        maps_ = Texture("roma maps", GL_TEXTURE_2D_ARRAY, layout.format, size);
    const bool many = wants_many(frame.settings.get(kRomaInvocations));
    const Program& program = program_.get(frame.shaders, rotate_variant(frame.settings, many));

    auto pass = frame.timer.compute("roma rotation");
    program.use();
    program.set("base_size", grid.size);
    base.bind(0);
    direction_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    maps_.bind_image(0, GL_WRITE_ONLY);
    pass.repeat([&] {
        program.dispatch_covering(size * glm::ivec3(1, 1, many ? layout.words_per_texel : 1));
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
}

void Rotation::bind() const {
    maps_.bind(4);
    direction_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 4);
}

std::vector<ShaderDefine> Rotation::defines(const Settings& settings) {
    const int side = settings.get(kOccupancyResolution);
    std::vector<ShaderDefine> defines = ColumnLayout::of(side).defines();
    defines.push_back({"ROMA_SIDE", std::to_string(side)});
    return defines;
}

size_t Rotation::bytes_needed(const Settings& settings) {
    const auto side = static_cast<size_t>(settings.get(kOccupancyResolution));
    const auto strata = static_cast<size_t>(settings.get(kRomaAngularResolution));
    const ColumnLayout layout = ColumnLayout::of(settings.get(kOccupancyResolution));
    const size_t column = layout.texel_bytes() * static_cast<size_t>(layout.texels);
    return strata * strata * (side * side * column + sizeof(gpu::RomaDirection));
}

std::vector<ShaderVariant> Rotation::variants(const Settings& settings) {
    return {rotate_variant(settings, false), rotate_variant(settings, true)};
}

std::vector<uint32_t> Rotation::download_map(int index) const {
    const ColumnLayout layout = ColumnLayout::of(side_);
    const std::vector<GLuint> texels = maps_.download_uint(layout.words_per_texel);
    const size_t columns = static_cast<size_t>(side_) * side_;
    std::vector<uint32_t> words;
    words.reserve(columns * layout.words);
    for (size_t column = 0; column < columns; ++column) {
        for (int word = 0; word < layout.words; ++word) {
            const size_t layer =
                static_cast<size_t>(index) * layout.texels + word / layout.words_per_texel;
            words.push_back(texels[(layer * columns + column) * layout.words_per_texel +
                                   word % layout.words_per_texel]);
        }
    }
    return words;
}

} // namespace romascope
