// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/shader_source.h"

#include <glad/gl.h>

#include <vector>

namespace romascope {

/// How the words of a column, 32 cells each, are cut into texels: up to four to a texel.
struct ColumnLayout {
    int words, words_per_texel, texels;
    GLenum format;
    const char* glsl_format;

    /// For columns of up to `cells` cells.
    static ColumnLayout of(int cells);
    size_t texel_bytes() const { return sizeof(GLuint) * static_cast<size_t>(words_per_texel); }
    /// ROMA_WORDS_PER_TEXEL, ROMA_TEXELS_PER_COLUMN, ROMA_FORMAT.
    std::vector<ShaderDefine> defines() const;
};

} // namespace romascope
