// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <span>
#include <string_view>

namespace romascope {

enum class Metric { flip, rmse, mae, bias };

struct MetricInfo {
    Metric metric;
    const char* name;
    const char* description; ///< one line, without a full stop
};

/// All metrics, in the order in which they are shown.
std::span<const MetricInfo> metric_table();

const char* metric_name(Metric metric);

/// Throws Error (kBadInput) with the known names, and the nearest one, for an unknown name.
Metric metric_from_name(std::string_view name);

/// One figure for the difference between two linear images of one size (FLIP: its mean at the
/// default pixels per degree). 0 is equal; only bias can be negative. Throws Error (kBadInput) as
/// error_figures does.
double metric_value(Metric metric, const Image& reference, const Image& test);

/// A metric's figure with a picture of where it comes from.
struct MetricPicture {
    double value = 0; ///< as metric_value
    Image picture;    ///< linear RGB
    float scale = 1;  ///< the error that the end of the colour scale stands for
};

/// FLIP: magma from 0 to 1. RMSE and MAE: magma from 0 to the largest error of a pixel (over its
/// channels, the root mean square or the mean). Bias: blue (too dark), white, red (too bright), to
/// the largest absolute mean over a pixel's channels. The scale is 1 if there is no error.
MetricPicture metric_picture(Metric metric, const Image& reference, const Image& test);

} // namespace romascope
