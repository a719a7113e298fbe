// SPDX-License-Identifier: MIT
// Lets a header be read by both compilers, so that the CPU tests check the lines the GPU runs.
// EXACT keeps a GLSL compiler from fusing or reordering: sums, differences and products then have
// the bits of IEEE single precision, as on the CPU (which is built without contraction). Division,
// square root and trigonometry are not correctly rounded in GLSL; exact_math.h has substitutes.
#pragma once
#ifdef __cplusplus
#include <glm/glm.hpp>
#include <glm/integer.hpp>
namespace romascope::gpu {
using glm::abs;
using glm::bitfieldReverse;
using glm::ceil;
using glm::clamp;
using glm::dot;
using glm::findLSB;
using glm::findMSB;
using glm::floor;
using glm::inversesqrt;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::max;
using glm::min;
using glm::uint;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
inline uint floatBitsToUint(float x) { return glm::floatBitsToUint(x); }
inline float uintBitsToFloat(uint x) { return glm::uintBitsToFloat(x); }
} // namespace romascope::gpu
#define EXACT
#define SHARED_FN inline
#else
#define EXACT precise
#define SHARED_FN
#endif
