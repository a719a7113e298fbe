// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

namespace romascope {

/// How far `test` is from `reference`, over all pixels and channels, on linear values.
struct ErrorFigures {
    double rmse = 0;
    double mae = 0;     ///< mean absolute error
    double bias = 0;    ///< mean of test - reference: positive where the test is too bright
    double max_abs = 0; ///< largest absolute error of one channel of one pixel
};

/// The images have the same size; a grey one counts as three equal channels beside an RGB one.
/// Throws Error (kBadInput) for other sizes, and for NaN or infinity naming the pixel.
ErrorFigures error_figures(const Image& reference, const Image& test);

/// test - reference per pixel and channel, linear; 1 channel if both have 1, else 3. Same errors.
Image difference_map(const Image& reference, const Image& test);

} // namespace romascope
