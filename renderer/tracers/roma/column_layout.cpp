// SPDX-License-Identifier: MIT
#include "renderer/tracers/roma/column_layout.h"

namespace romascope {

ColumnLayout ColumnLayout::of(int cells) {
    const int words = (cells + 31) / 32;
    if (words == 1)
        return {words, 1, 1, GL_R32UI, "r32ui"};
    if (words == 2)
        return {words, 2, 1, GL_RG32UI, "rg32ui"};
    return {words, 4, (words + 3) / 4, GL_RGBA32UI, "rgba32ui"};
}

std::vector<ShaderDefine> ColumnLayout::defines() const {
    return {{"ROMA_WORDS_PER_TEXEL", std::to_string(words_per_texel)},
            {"ROMA_TEXELS_PER_COLUMN", std::to_string(texels)},
            {"ROMA_FORMAT", glsl_format}};
}

} // namespace romascope
