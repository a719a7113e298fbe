// SPDX-License-Identifier: MIT
#include "renderer/scene/mip_chain.h"

#include "renderer/image/color.h"
#include "shaders/common/surface_texture.h"

#include <algorithm>
#include <array>

namespace romascope {
namespace {

/// decode_srgb8 and encode_srgb8 by tables: a large texture has millions of texels.
class SrgbTables {
public:
    SrgbTables() {
        for (size_t code = 0; code < 256; ++code) {
            linear_[code] = decode_srgb8(static_cast<uint8_t>(code));
            from_[code] = decode_srgb((static_cast<float>(code) - 0.5f) / 255.0f);
        }
        from_[256] = 2.0f;
        for (size_t i = 0; i < kBuckets; ++i)
            first_[i] = encode_srgb8(static_cast<float>(i) / kBuckets);
    }
    float linear(uint32_t code) const { return linear_[code & 0xffu]; }
    /// The nearest code to a value in [0, 1].
    uint32_t code(float value) const {
        const auto bucket = static_cast<size_t>(value * kBuckets);
        const uint32_t code = first_[std::min(bucket, kBuckets - 1)];
        // The curve's steepest slope, 12.92 * 255 codes, passes less than one per bucket.
        return code + (value >= from_[code + 1] ? 1 : 0);
    }

private:
    static constexpr size_t kBuckets = 4096;
    std::array<float, 256> linear_;
    std::array<float, 257> from_; ///< the least value that is nearest to a code
    std::array<uint8_t, kBuckets> first_;
};

/// From linear colour and alpha.
uint32_t pack(const SrgbTables& tables, const glm::vec4& texel) {
    const glm::vec3 color = glm::clamp(glm::vec3(texel), 0.0f, 1.0f);
    const auto alpha = static_cast<uint32_t>(glm::clamp(texel.w, 0.0f, 1.0f) * 255.0f + 0.5f);
    return tables.code(color.x) | tables.code(color.y) << 8 | tables.code(color.z) << 16 |
           alpha << 24;
}

glm::vec4 unpack(const SrgbTables& tables, uint32_t texel) {
    return {tables.linear(texel), tables.linear(texel >> 8), tables.linear(texel >> 16),
            static_cast<float>(texel >> 24) / 255.0f};
}

/// The source texels along one axis that a texel of the next level covers, and how much of them.
struct Footprint {
    int first = 0, count = 0;
    std::array<float, 3> weight{}; ///< sum 1
};

Footprint footprint(int i, int from, int to) {
    if (from == to)
        return {i, 1, {1.0f, 0.0f, 0.0f}};
    if (from % 2 == 0)
        return {2 * i, 2, {0.5f, 0.5f, 0.0f}};
    // 2 n + 1 texels become n: each covers 2 + 1 / n of them.
    const auto n = static_cast<float>(to);
    const auto k = static_cast<float>(i);
    const float whole = n / static_cast<float>(from);
    return {2 * i, 3, {whole * (n - k) / n, whole, whole * (k + 1.0f) / n}};
}

/// Rows of source texels, weighed and added up: all that one row of the next level covers.
class RowSum {
public:
    RowSum(size_t width, bool by_alpha) : plain_(width), by_alpha_(by_alpha ? width : 0) {}

    void add(size_t x, const glm::vec4& texel, float weight) {
        plain_[x] += weight * texel;
        if (!by_alpha_.empty())
            by_alpha_[x] += weight * texel.w * glm::vec3(texel);
    }
    glm::vec4 mean(const Footprint& columns) const {
        glm::vec4 plain(0.0f);
        glm::vec3 color(0.0f);
        for (size_t i = 0; i < static_cast<size_t>(columns.count); ++i) {
            const size_t x = static_cast<size_t>(columns.first) + i;
            plain += columns.weight[i] * plain_[x];
            if (!by_alpha_.empty())
                color += columns.weight[i] * by_alpha_[x];
        }
        // Where all is left out there is nothing to weigh by.
        return !by_alpha_.empty() && plain.w > 0.0f ? glm::vec4(color / plain.w, plain.w) : plain;
    }

private:
    std::vector<glm::vec4> plain_;
    std::vector<glm::vec3> by_alpha_; ///< empty if alpha does not weigh
};

} // namespace

int level_count(glm::ivec2 size) {
    int count = 1;
    for (int side = std::max(size.x, size.y); side > 1; side /= 2)
        ++count;
    return count;
}

size_t texels_from_level(glm::ivec2 size, int first) {
    size_t sum = 0;
    for (int level = first; level < level_count(size); ++level) {
        const glm::ivec2 side = gpu::level_size(size, level);
        sum += static_cast<size_t>(side.x) * static_cast<size_t>(side.y);
    }
    return sum;
}

std::vector<uint32_t> smaller_levels(glm::ivec2 size, std::span<const uint32_t> texels,
                                     bool by_alpha) {
    static const SrgbTables tables;
    std::vector<uint32_t> out;
    out.reserve(texels_from_level(size, 1));
    // Means of exact values, not of the codes of the level before: those would add up roundings.
    std::vector<glm::vec4> above, below;
    for (int level = 1; level < level_count(size); ++level) {
        const glm::ivec2 from = gpu::level_size(size, level - 1);
        const glm::ivec2 to = gpu::level_size(size, level);
        const auto width = static_cast<size_t>(from.x);
        below.clear();
        for (int y = 0; y < to.y; ++y) {
            const Footprint rows = footprint(y, from.y, to.y);
            RowSum sum(width, by_alpha);
            for (int j = 0; j < rows.count; ++j) {
                const size_t first = static_cast<size_t>(rows.first + j) * width;
                const float weight = rows.weight[static_cast<size_t>(j)];
                for (size_t x = 0; x < width; ++x)
                    sum.add(x, level == 1 ? unpack(tables, texels[first + x]) : above[first + x],
                            weight);
            }
            for (int x = 0; x < to.x; ++x) {
                below.push_back(sum.mean(footprint(x, from.x, to.x)));
                out.push_back(pack(tables, below.back()));
            }
        }
        std::swap(above, below);
    }
    return out;
}

} // namespace romascope
