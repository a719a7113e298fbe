// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/shearing.h"

#include "renderer/gl/upload.h"
#include "renderer/tracers/occupancy/occupancy_map.h"
#include "renderer/tracers/roma/roma_knobs.h"

#include <algorithm>

namespace romascope {
namespace {

static_assert(sizeof(gpu::ShearGrid) == 5 * 16, "std140 layout of ShearGrid");
static_assert(offsetof(gpu::ShearGrid, columns) == 2 * 16);
static_assert(sizeof(gpu::ShearMap) == 4 * 16, "std430 layout of ShearMap");

ShaderVariant pack_variant(const Settings& settings) {
    std::vector<ShaderDefine> defines =
        ColumnLayout::of(settings.get(kOccupancyResolution)).defines();
    defines.push_back({"TRANSPOSE_ROWS_APART", "0"});
    return {"shear pack", {{GL_COMPUTE_SHADER, "tracers/roma/shear_pack.comp.glsl"}}, defines, {}};
}

/// From the base map at once, or from its packings, with few invocations.
ShaderVariant shear_variant(const Settings& settings, bool many) {
    const ColumnLayout layout = ColumnLayout::of(settings.get(kOccupancyResolution));
    std::vector<ShaderDefine> defines = layout.defines();
    defines.push_back({"SHEAR_TAPS", std::to_string(settings.get(kRomaTaps))});
    defines.push_back({"TRANSPOSE_ROWS_APART", many ? "1" : "0"});
    const char* file =
        many ? "tracers/roma/shear.comp.glsl" : "tracers/roma/shear_blocks.comp.glsl";
    return {"shear", {{GL_COMPUTE_SHADER, file}}, defines, {}};
}

} // namespace

void Shearing::build(const FrameContext& frame, const TexelBuffer& base, const OccupancyGrid& grid,
                     std::span<const glm::dvec3> candidates) {
    const Settings& settings = frame.settings;
    const int taps = settings.get(kRomaTaps);
    layout_ = ColumnLayout::of(settings.get(kOccupancyResolution));
    frame_ = shear_frame(candidates, grid, taps, layout_.texels, settings.get(kRomaNormalOffset));
    upload_or_replace(grid_buffer_, "shear grid", std::span<const gpu::ShearGrid>(&frame_.grid, 1));
    upload_or_replace(map_buffer_, "sheared maps", std::span<const gpu::ShearMap>(frame_.maps));
    if (places_.texels() < frame_.places)
        places_ = TexelBuffer("shear places", GL_RG32UI, frame_.places);
    if (texels_.format() != layout_.format || texels_.texels() < frame_.texels)
        texels_ = TexelBuffer("roma maps", layout_.format, frame_.texels);
    const bool many = wants_many(settings.get(kRomaInvocations));
    const Program& program = shear_program_.get(frame.shaders, shear_variant(settings, many));
    // A driver compiles when a program is first asked for, and the passes are timed.
    if (!many)
        pack_program_.get(frame.shaders, pack_variant(frame.settings));

    map_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 1);
    places_.bind_storage(2);
    grid_buffer_.bind(GL_UNIFORM_BUFFER, 5);
    if (many)
        shear_at_once(frame, program, base, grid.size);
    else
        shear_by_blocks(frame, program, base, grid.size);
}

void Shearing::shear_at_once(const FrameContext& frame, const Program& program,
                             const TexelBuffer& base, glm::ivec3 size) {
    packed_rows_ = {};
    auto pass = frame.timer.compute("roma shear");
    program.use();
    program.set("base_size", size);
    base.bind_storage(0);
    texels_.bind_image(0, GL_WRITE_ONLY);
    int groups = 0;
    for (size_t map = 0; map < frame_.maps.size(); ++map) {
        const glm::ivec2 columns(frame_.size(map));
        const bool along_z = frame_.maps[map].slope.z == 2;
        const int together = 32 * layout_.words_per_texel;
        groups =
            std::max(groups, columns.y * (along_z ? (columns.x + together - 1) / together : 1));
    }
    const int layers = static_cast<int>(frame_.maps.size()) * layout_.texels + 1;
    pass.repeat([&] {
        glDispatchCompute(static_cast<GLuint>(groups), static_cast<GLuint>(layers), 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
}

void Shearing::shear_by_blocks(const FrameContext& frame, const Program& program,
                               const TexelBuffer& base, glm::ivec3 size) {
    const ShearPackings packings = shear_packings(size, frame_.grid.columns.w);
    if (packed_rows_.texels() < shear_packing_words(packings))
        packed_rows_ = TexelBuffer("packed rows", GL_R32UI, shear_packing_words(packings));
    {
        const Program& pack = pack_program_.get(frame.shaders, pack_variant(frame.settings));
        auto pass = frame.timer.compute("roma packing");
        pack.use();
        pack.set("base_size", size);
        base.bind(0);
        packed_rows_.bind_storage(0);
        pass.repeat([&] {
            pack.dispatch_covering(
                {packings[2].row_words, packings[2].columns.y, (packings[2].slices + 31) / 32 + 2});
            glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
        });
    }
    auto pass = frame.timer.compute("roma shear");
    program.use();
    packed_rows_.bind(0);
    texels_.bind_image(0, GL_WRITE_ONLY);
    glm::ivec2 columns(0);
    for (size_t map = 0; map < frame_.maps.size(); ++map)
        columns = glm::max(columns, glm::ivec2(frame_.size(map)));
    const int layers = static_cast<int>(frame_.maps.size()) * layout_.texels;
    pass.repeat([&] {
        program.dispatch_covering({(columns.x + 31) / 32, columns.y, layers});
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
}

void Shearing::bind() const {
    texels_.bind(4);
    places_.bind(5);
    grid_buffer_.bind(GL_UNIFORM_BUFFER, 5);
    map_buffer_.bind(GL_SHADER_STORAGE_BUFFER, 4);
}

std::vector<ShaderDefine> Shearing::defines(const Settings& settings) {
    return ColumnLayout::of(settings.get(kOccupancyResolution)).defines();
}

size_t Shearing::bytes_needed(const Settings& settings) {
    const int resolution = settings.get(kOccupancyResolution);
    const int guard = shear_guard(settings.get(kRomaTaps));
    const auto strata = static_cast<size_t>(settings.get(kRomaAngularResolution));
    const ColumnLayout layout = ColumnLayout::of(resolution);
    const auto side = static_cast<size_t>(resolution + 2 * guard);
    const size_t column = layout.texel_bytes() * static_cast<size_t>(layout.texels);
    const size_t places = 2 * sizeof(glm::uvec2) *
                          static_cast<size_t>(shear_table_places(glm::ivec3(resolution), guard));
    return strata * strata * (side * side * column + sizeof(gpu::ShearMap) + places) +
           sizeof(gpu::ShearGrid) +
           sizeof(GLuint) * shear_packing_words(shear_packings(glm::ivec3(resolution), guard));
}

std::vector<ShaderVariant> Shearing::variants(const Settings& settings) {
    return {pack_variant(settings), shear_variant(settings, false), shear_variant(settings, true)};
}

std::vector<uint32_t> Shearing::download_map(int index) const {
    const gpu::ShearMap& map = frame_.maps[static_cast<size_t>(index)];
    const glm::ivec3 size = frame_.size(static_cast<size_t>(index));
    const std::vector<GLuint> all = texels_.download();
    const size_t columns = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    const auto words = static_cast<size_t>((size.z + 31) / 32);
    const auto words_apart =
        static_cast<size_t>(layout_.words_per_texel) * static_cast<size_t>(layout_.texels);
    const size_t first =
        static_cast<size_t>(map.slope.w) * static_cast<size_t>(layout_.words_per_texel);
    std::vector<uint32_t> found;
    found.reserve(columns * words);
    for (size_t column = 0; column < columns; ++column) {
        const auto begin = all.begin() + static_cast<ptrdiff_t>(first + column * words_apart);
        found.insert(found.end(), begin, begin + static_cast<ptrdiff_t>(words));
    }
    return found;
}

std::vector<uint32_t> Shearing::download_packings() const {
    std::vector<uint32_t> words = packed_rows_.download();
    const int guard = frame_.grid.columns.w;
    words.resize(
        shear_packing_words(shear_packings(glm::ivec3(frame_.grid.columns) - 2 * guard, guard)));
    return words;
}

} // namespace romascope
