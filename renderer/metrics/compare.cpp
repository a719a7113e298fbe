// SPDX-License-Identifier: MIT
#include "renderer/metrics/compare.h"

#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/metrics/color_maps.h"
#include "renderer/metrics/errors.h"
#include "renderer/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace romascope {
namespace {

constexpr MetricInfo kMetrics[] = {
    {Metric::flip, "flip", "mean LDR-FLIP: how visible the difference is, from 0 to 1"},
    {Metric::rmse, "rmse", "root mean square error of linear values"},
    {Metric::mae, "mae", "mean absolute error of linear values"},
    {Metric::bias, "bias", "mean of test - reference, linear; positive is too bright"},
};

double figure(Metric metric, const ErrorFigures& figures) {
    if (metric == Metric::rmse)
        return figures.rmse;
    return metric == Metric::mae ? figures.mae : figures.bias;
}

/// One value per pixel out of a difference map's channels.
Image pixel_errors(Metric metric, const Image& differences) {
    const size_t channels = static_cast<size_t>(differences.channels);
    Image errors(differences.width, differences.height, 1);
    for (size_t i = 0; i < errors.data.size(); ++i) {
        float sum = 0;
        for (size_t c = 0; c < channels; ++c) {
            const float difference = differences.data[i * channels + c];
            sum += metric == Metric::rmse  ? difference * difference
                   : metric == Metric::mae ? std::abs(difference)
                                           : difference;
        }
        sum /= static_cast<float>(channels);
        errors.data[i] = metric == Metric::rmse ? std::sqrt(sum) : sum;
    }
    return errors;
}

} // namespace

std::span<const MetricInfo> metric_table() { return kMetrics; }

const char* metric_name(Metric metric) { return kMetrics[static_cast<size_t>(metric)].name; }

Metric metric_from_name(std::string_view name) {
    std::vector<std::string> names;
    std::string listed;
    for (const MetricInfo& info : kMetrics) {
        if (name == info.name)
            return info.metric;
        names.emplace_back(info.name);
        listed += (listed.empty() ? "" : ", ") + names.back();
    }
    throw Error("unknown metric '" + std::string(name) + "'" + did_you_mean(name, names) +
                    " (there are " + listed + ")",
                kBadInput);
}

double metric_value(Metric metric, const Image& reference, const Image& test) {
    if (metric == Metric::flip)
        return flip(reference, test).mean;
    return figure(metric, error_figures(reference, test));
}

MetricPicture metric_picture(Metric metric, const Image& reference, const Image& test) {
    if (metric == Metric::flip) {
        const FlipResult result = flip(reference, test);
        return {result.mean, flip_heatmap(result.map), 1};
    }
    const Image errors = pixel_errors(metric, difference_map(reference, test));
    float scale = 0;
    for (const float error : errors.data)
        scale = std::max(scale, std::abs(error));
    if (scale == 0)
        scale = 1;
    return {figure(metric, error_figures(reference, test)),
            metric == Metric::bias ? diverging_picture(errors, scale)
                                   : magma_picture(errors, scale),
            scale};
}

} // namespace romascope
