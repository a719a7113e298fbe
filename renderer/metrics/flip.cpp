// SPDX-License-Identifier: MIT
#include "renderer/metrics/flip.h"

#include "renderer/base/error.h"
#include "renderer/metrics/color_maps.h"
#include "renderer/metrics/inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

// Names and equations follow the paper: section 4.1 (colour pipeline), 4.2 (features), 4.3 (both).

namespace romascope {
namespace {

constexpr float kQc = 0.7f, kPc = 0.4f, kPt = 0.95f, kQf = 0.5f;
constexpr double kFeatureWidth = 0.082; // w, degrees

using Vec3 = std::array<float, 3>;
using Kernel = std::vector<float>; // an odd number of weights around its middle

constexpr Vec3 kInverseWhite = {1.052156925f, 1.0f, 0.918357670f};
constexpr Vec3 kWhite = {0.950428545f, 1.0f, 1.088900371f};

// ---- Filters

/// A 1-channel picture.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> data;

    Plane(int w, int h) : width(w), height(h), data(static_cast<size_t>(w) * h) {}
    float* row(int y) { return &data[static_cast<size_t>(y) * width]; }
    const float* row(int y) const { return &data[static_cast<size_t>(y) * width]; }
};

/// Weights of the function `f` at -radius..radius.
Kernel sample(int radius, const std::function<double(double)>& f) {
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x)
        kernel.push_back(static_cast<float>(f(x)));
    return kernel;
}

/// Correlates the rows with a kernel; a pixel beyond the border has the border's value.
Plane filter_x(const Plane& in, const Kernel& kernel) {
    Plane out(in.width, in.height);
    const int size = static_cast<int>(kernel.size()), radius = size / 2;
    std::vector<float> padded(static_cast<size_t>(in.width + 2 * radius));
    for (int y = 0; y < in.height; ++y) {
        const float* source = in.row(y);
        std::fill_n(padded.begin(), radius, source[0]);
        std::copy_n(source, in.width, padded.begin() + radius);
        std::fill_n(padded.end() - radius, radius, source[in.width - 1]);
        float* target = out.row(y);
        for (int k = 0; k < size; ++k) {
            const float weight = kernel[static_cast<size_t>(k)];
            const float* shifted = &padded[static_cast<size_t>(k)];
            for (int x = 0; x < in.width; ++x)
                target[x] += weight * shifted[x];
        }
    }
    return out;
}

/// The same down the columns.
Plane filter_y(const Plane& in, const Kernel& kernel) {
    Plane out(in.width, in.height);
    const int size = static_cast<int>(kernel.size()), radius = size / 2;
    for (int y = 0; y < in.height; ++y) {
        float* target = out.row(y);
        for (int k = 0; k < size; ++k) {
            const float weight = kernel[static_cast<size_t>(k)];
            const float* shifted = in.row(std::clamp(y + k - radius, 0, in.height - 1));
            for (int x = 0; x < in.width; ++x)
                target[x] += weight * shifted[x];
        }
    }
    return out;
}

Plane filter(const Plane& in, const Kernel& kernel) {
    return filter_y(filter_x(in, kernel), kernel);
}

/// All kernels for one viewing distance.
struct Kernels {
    Kernel achromatic, red_green;        // contrast sensitivity: both ways
    Kernel blue_yellow_1, blue_yellow_2; // the sum of two, each both ways
    Kernel gauss, edge, point;           // feature detection

    explicit Kernels(double pixels_per_degree) {
        make_contrast(pixels_per_degree);
        make_features(pixels_per_degree);
    }

private:
    void make_contrast(double p) {
        using std::numbers::pi;
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * p));
        const auto shape = [=](double b) {
            return [=](double x) { return std::exp(-pi * pi * x * x / (p * p * b)); };
        };
        const auto sum = [=](const auto& f) {
            double total = 0;
            for (int x = -radius; x <= radius; ++x)
                total += f(x);
            return total;
        };
        const auto unit_sum = [&](double b) {
            const auto f = shape(b);
            const double total = sum(f);
            return sample(radius, [&](double x) { return f(x) / total; });
        };
        achromatic = unit_sum(0.0047);
        red_green = unit_sum(0.0053);
        // Two Gaussians: their sum is not separable, each alone is.
        const double a1 = 34.1, b1 = 0.04, a2 = 13.5, b2 = 0.025;
        const double scale1 = std::sqrt(a1 * std::sqrt(pi / b1));
        const double scale2 = std::sqrt(a2 * std::sqrt(pi / b2));
        const auto f1 = shape(b1), f2 = shape(b2);
        const double norm = std::hypot(scale1 * sum(f1), scale2 * sum(f2));
        blue_yellow_1 = sample(radius, [&](double x) { return scale1 * f1(x) / norm; });
        blue_yellow_2 = sample(radius, [&](double x) { return scale2 * f2(x) / norm; });
    }

    void make_features(double p) {
        const double s = 0.5 * kFeatureWidth * p;
        const int radius = static_cast<int>(std::ceil(3 * s));
        const auto g = [=](double x) { return std::exp(-x * x / (2 * s * s)); };
        // Positive and negative weights are scaled apart, to sums of 1 and -1.
        const auto balanced = [=](const auto& f) {
            double positive = 0, negative = 0;
            for (int x = -radius; x <= radius; ++x)
                (f(x) > 0 ? positive : negative) += f(x);
            return sample(radius, [&](double x) {
                return f(x) > 0 ? f(x) / positive : f(x) < 0 ? f(x) / -negative : 0.0;
            });
        };
        double total = 0;
        for (int x = -radius; x <= radius; ++x)
            total += g(x);
        gauss = sample(radius, [&](double x) { return g(x) / total; });
        edge = balanced([=](double x) { return -x * g(x); });
        point = balanced([=](double x) { return (x * x / (s * s) - 1) * g(x); });
    }
};

// ---- Colours

Vec3 linear_to_xyz(const Vec3& c) {
    return {(10135552 * c[0] + 8788810 * c[1] + 4435075 * c[2]) / 24577794,
            (2613072 * c[0] + 8788810 * c[1] + 887015 * c[2]) / 12288897,
            (1425312 * c[0] + 8788810 * c[1] + 70074185 * c[2]) / 73733382};
}

Vec3 xyz_to_clamped_linear(const Vec3& c) {
    const auto unit = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    return {unit(3.241003275f * c[0] - 1.537398934f * c[1] - 0.498615861f * c[2]),
            unit(-0.969224334f * c[0] + 1.875930071f * c[1] + 0.041554224f * c[2]),
            unit(0.055639423f * c[0] - 0.204011202f * c[1] + 1.057148933f * c[2])};
}

Vec3 xyz_to_ycxcz(const Vec3& xyz) {
    const float x = xyz[0] * kInverseWhite[0];
    const float y = xyz[1] * kInverseWhite[1];
    const float z = xyz[2] * kInverseWhite[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Vec3 ycxcz_to_xyz(const Vec3& c) {
    const float y = (c[0] + 16) / 116;
    return {(y + c[1] / 500) * kWhite[0], y * kWhite[1], (y - c[2] / 200) * kWhite[2]};
}

/// L*a*b* with the Hunt effect: colours lose chroma as they get darker.
Vec3 linear_to_hunt_lab(const Vec3& rgb) {
    const Vec3 xyz = linear_to_xyz(rgb);
    Vec3 f;
    for (size_t i = 0; i < 3; ++i) {
        constexpr float kDelta = 6.0f / 29;
        const float t = xyz[i] * kInverseWhite[i];
        f[i] = t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0f / 29;
    }
    const float lightness = 116 * f[1] - 16;
    return {lightness, 0.01f * lightness * (500 * (f[0] - f[1])),
            0.01f * lightness * (200 * (f[1] - f[2]))};
}

float hyab_power(const Vec3& a, const Vec3& b) {
    const float da = a[1] - b[1], db = a[2] - b[2];
    return std::pow(std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db), kQc);
}

/// The colour difference on a scale from 0 to 1; `largest` is that between green and blue.
float compress(float difference, float largest) {
    const float knee = kPc * largest;
    return difference < knee ? difference * kPt / knee
                             : kPt + (difference - knee) / (largest - knee) * (1 - kPt);
}

// ---- One picture's share of the work

/// What has to be known of one picture.
struct Seen {
    std::vector<Vec3> lab;          // as the eye's contrast sensitivity lets it through
    std::vector<float> edge, point; // lengths of the feature vectors
};

std::vector<float> length(const Plane& x, const Plane& y) {
    std::vector<float> result(x.data.size());
    for (size_t i = 0; i < result.size(); ++i)
        result[i] = std::sqrt(x.data[i] * x.data[i] + y.data[i] * y.data[i]);
    return result;
}

Seen look_at(const Image& image, const Kernels& kernels) {
    Plane luma(image.width, image.height), red_green = luma, blue_yellow = luma;
    const size_t count = luma.data.size();
    for (size_t i = 0; i < count; ++i) {
        Vec3 rgb;
        for (int c = 0; c < 3; ++c)
            rgb[static_cast<size_t>(c)] = std::clamp(channel_value(image, i, c), 0.0f, 1.0f);
        const Vec3 color = xyz_to_ycxcz(linear_to_xyz(rgb));
        luma.data[i] = color[0];
        red_green.data[i] = color[1];
        blue_yellow.data[i] = color[2];
    }

    Seen seen;
    {
        const Plane y = filter(luma, kernels.achromatic);
        const Plane cx = filter(red_green, kernels.red_green);
        const Plane cz1 = filter(blue_yellow, kernels.blue_yellow_1);
        const Plane cz2 = filter(blue_yellow, kernels.blue_yellow_2);
        seen.lab.resize(count);
        for (size_t i = 0; i < count; ++i)
            seen.lab[i] = linear_to_hunt_lab(xyz_to_clamped_linear(
                ycxcz_to_xyz({y.data[i], cx.data[i], cz1.data[i] + cz2.data[i]})));
    }

    for (float& value : luma.data)
        value = (value + 16) / 116;
    const Plane smooth_x = filter_x(luma, kernels.gauss);
    seen.edge = length(filter_y(filter_x(luma, kernels.edge), kernels.gauss),
                       filter_y(smooth_x, kernels.edge));
    seen.point = length(filter_y(filter_x(luma, kernels.point), kernels.gauss),
                        filter_y(smooth_x, kernels.point));
    return seen;
}

} // namespace

FlipResult flip(const Image& reference, const Image& test, float pixels_per_degree) {
    check_comparable(reference, test);
    if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
        throw Error("FLIP needs pixels per degree from 1 to 1000, not " +
                        std::to_string(pixels_per_degree),
                    kBadInput);
    const Kernels kernels(pixels_per_degree);
    const Seen r = look_at(reference, kernels);
    const Seen t = look_at(test, kernels);
    const float largest = hyab_power(linear_to_hunt_lab({0, 1, 0}), linear_to_hunt_lab({0, 0, 1}));

    FlipResult result{0, Image(reference.width, reference.height, 1)};
    for (size_t i = 0; i < result.map.data.size(); ++i) {
        const float color = compress(hyab_power(r.lab[i], t.lab[i]), largest);
        const float edge = std::abs(r.edge[i] - t.edge[i]);
        const float point = std::abs(r.point[i] - t.point[i]);
        const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kQf);
        // Rounding must not make the exponent negative: 0 to that power is infinite.
        const float value = std::pow(color, std::max(0.0f, 1 - feature));
        result.map.data[i] = value;
        result.mean += static_cast<double>(value);
    }
    result.mean /= static_cast<double>(result.map.data.size());
    return result;
}

Image flip_heatmap(const Image& map) { return magma_picture(map); }

} // namespace romascope
