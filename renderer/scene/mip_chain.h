// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace romascope {

/// Levels of a texture of that size, down to 1 x 1.
int level_count(glm::ivec2 size);

/// Texels of the levels from `first` on.
size_t texels_from_level(glm::ivec2 size, int first);

/// The levels of a texture below the given one, which is not among them, the largest first: each
/// texel the mean, by area, of those it covers, colour in linear light. `by_alpha`: colours count
/// by their alpha, so that what a mask leaves out does not bleed into what it keeps. `texels`:
/// sRGB-encoded colour and linear alpha, red in the lowest byte.
std::vector<uint32_t> smaller_levels(glm::ivec2 size, std::span<const uint32_t> texels,
                                     bool by_alpha);

} // namespace romascope
