// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

namespace romascope {

/// 0.7 m from a monitor 0.7 m wide with 3840 pixels across, the default of FLIP's authors.
inline constexpr float kDefaultPixelsPerDegree = 67.0206433f;

struct FlipResult {
    double mean = 0; ///< of the map
    Image map;       ///< 1 channel, per pixel: 0 (no visible difference) to 1
};

/// The visible difference between two pictures shown in turns: LDR-FLIP (Andersson et al. 2020,
/// "FLIP: A Difference Evaluator for Alternating Images"), with the constants of its authors'
/// program 1.6.
///
/// The images hold linear values, which are clamped to [0, 1] and not quantised; pictures read from
/// 8-bit files are compared as those 8 bits. Grey counts as three equal channels.
/// `pixels_per_degree`, in [1, 1000], is how many pixels a degree of the viewer's sight covers.
/// Throws Error (kBadInput) for images of different sizes, for NaN or infinity naming the pixel,
/// and for pixels_per_degree out of range.
FlipResult flip(const Image& reference, const Image& test,
                float pixels_per_degree = kDefaultPixelsPerDegree);

/// A FLIP map in the colours its authors show it in ("magma", black to pale yellow), linear RGB.
Image flip_heatmap(const Image& map);

} // namespace romascope
