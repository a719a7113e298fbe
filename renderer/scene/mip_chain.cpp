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
        size_t code = first_[std::min(bucket, kBuckets - 1)];
        while (value >= from_[code + 1])
            ++code;
        return static_cast<uint32_t>(code);
    }

private:
    static constexpr size_t kBuckets = 4096;
    std::array<float, 256> linear_;
    std::array<float, 257> from_; ///< the least value that is nearest to a code
    std::array<uint8_t, kBuckets> first_;
};

const SrgbTables& tables() {
    static const SrgbTables made;
    return made;
}

/// From linear colour and alpha.
uint32_t pack(const glm::vec4& texel) {
    const glm::vec3 color = glm::clamp(glm::vec3(texel), 0.0f, 1.0f);
    const auto alpha = static_cast<uint32_t>(glm::clamp(texel.w, 0.0f, 1.0f) * 255.0f + 0.5f);
    return tables().code(color.x) | tables().code(color.y) << 8 | tables().code(color.z) << 16 |
           alpha << 24;
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
    std::vector<uint32_t> out;
    out.reserve(texels_from_level(size, 1));
    // Sums of exact values, not of the codes of the level before: those would add up roundings.
    std::vector<glm::vec4> above, below;
    const auto source = [&](size_t i) {
        if (!above.empty())
            return above[i];
        const uint32_t texel = texels[i];
        return glm::vec4(tables().linear(texel), tables().linear(texel >> 8),
                         tables().linear(texel >> 16), static_cast<float>(texel >> 24) / 255.0f);
    };
    for (int level = 1; level < level_count(size); ++level) {
        const glm::ivec2 from = gpu::level_size(size, level - 1);
        const glm::ivec2 to = gpu::level_size(size, level);
        below.clear();
        for (int y = 0; y < to.y; ++y) {
            const Footprint rows = footprint(y, from.y, to.y);
            for (int x = 0; x < to.x; ++x) {
                const Footprint columns = footprint(x, from.x, to.x);
                glm::vec4 plain(0.0f), weighed(0.0f);
                for (int j = 0; j < rows.count; ++j)
                    for (int i = 0; i < columns.count; ++i) {
                        const auto at =
                            static_cast<size_t>(rows.first + j) * static_cast<size_t>(from.x) +
                            static_cast<size_t>(columns.first + i);
                        const glm::vec4 texel = source(at);
                        const float weight = rows.weight[static_cast<size_t>(j)] *
                                             columns.weight[static_cast<size_t>(i)];
                        plain += weight * texel;
                        if (by_alpha)
                            weighed += weight * texel.w * texel;
                    }
                if (by_alpha && plain.w > 0.0f)
                    plain = glm::vec4(glm::vec3(weighed) / plain.w, plain.w);
                below.push_back(plain);
                out.push_back(pack(plain));
            }
        }
        std::swap(above, below);
    }
    return out;
}

} // namespace romascope
