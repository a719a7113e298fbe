// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/image/image.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace romascope {

/// FLIP a second time: in double precision, with whole two-dimensional kernels, straight from the
/// published equations. Shares nothing with the library's.
namespace slow {

inline constexpr double kPi = 3.14159265358979323846;

struct Color {
    double a, b, c;
};
using Picture = std::vector<Color>;
using Weights = std::vector<std::vector<double>>; // [j + radius][i + radius]

struct Size {
    int width, height;
    size_t clamped(int x, int y) const {
        x = x < 0 ? 0 : x >= width ? width - 1 : x;
        y = y < 0 ? 0 : y >= height ? height - 1 : y;
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
};

inline Color xyz_over_white(Color rgb) {
    return {(10135552 * rgb.a + 8788810 * rgb.b + 4435075 * rgb.c) / 24577794 * 1.052156925,
            (2613072 * rgb.a + 8788810 * rgb.b + 887015 * rgb.c) / 12288897,
            (1425312 * rgb.a + 8788810 * rgb.b + 70074185 * rgb.c) / 73733382 * 0.918357670};
}

inline Color opponent(Color rgb) {
    const Color n = xyz_over_white(rgb);
    return {116 * n.b - 16, 500 * (n.a - n.b), 200 * (n.b - n.c)};
}

inline Color opponent_to_clamped_rgb(Color o) {
    const double y = (o.a + 16) / 116;
    const double X = (y + o.b / 500) * 0.950428545, Z = (y - o.c / 200) * 1.088900371;
    const auto unit = [](double v) { return v < 0 ? 0 : v > 1 ? 1 : v; };
    return {unit(3.241003275 * X - 1.537398934 * y - 0.498615861 * Z),
            unit(-0.969224334 * X + 1.875930071 * y + 0.041554224 * Z),
            unit(0.055639423 * X - 0.204011202 * y + 1.057148933 * Z)};
}

inline Color hunt_lab(Color rgb) {
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const Color n = xyz_over_white(rgb);
    const double L = 116 * f(n.b) - 16;
    return {L, 0.01 * L * 500 * (f(n.a) - f(n.b)), 0.01 * L * 200 * (f(n.b) - f(n.c))};
}

inline double hyab(Color p, Color q) {
    return std::abs(p.a - q.a) + std::hypot(p.b - q.b, p.c - q.c);
}

inline Weights contrast_kernel(double p, double a1, double b1, double a2, double b2) {
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * p));
    Weights weights;
    double sum = 0;
    for (int j = -r; j <= r; ++j) {
        weights.emplace_back();
        for (int i = -r; i <= r; ++i) {
            const double z = (i * i + j * j) / (p * p);
            weights.back().push_back(a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * z / b1) +
                                     a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * z / b2));
            sum += weights.back().back();
        }
    }
    for (auto& row : weights)
        for (double& w : row)
            w /= sum;
    return weights;
}

/// `order` 1: edge, 2: point; along x.
inline Weights feature_kernel(double p, int order) {
    const double s = 0.5 * 0.082 * p;
    const int r = static_cast<int>(std::ceil(3 * s));
    std::vector<double> g, d;
    double g_sum = 0, positive = 0, negative = 0;
    for (int i = -r; i <= r; ++i) {
        g.push_back(std::exp(-i * i / (2 * s * s)));
        d.push_back((order == 1 ? -i : i * i / (s * s) - 1) * g.back());
        g_sum += g.back();
        (d.back() > 0 ? positive : negative) += d.back();
    }
    Weights weights;
    for (const double gy : g) {
        weights.emplace_back();
        for (const double dx : d)
            weights.back().push_back(gy / g_sum * dx / (dx > 0 ? positive : -negative));
    }
    return weights;
}

template <class Value>
double correlate(Size size, int x, int y, const Weights& weights, bool transposed,
                 const Value& value) {
    const int r = static_cast<int>(weights.size()) / 2;
    double sum = 0;
    for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) {
            const auto row = static_cast<size_t>((transposed ? i : j) + r);
            const auto column = static_cast<size_t>((transposed ? j : i) + r);
            sum += weights[row][column] * value(size.clamped(x + i, y + j));
        }
    return sum;
}

inline std::vector<double> flip(Size size, const Picture& reference, const Picture& test,
                                double p) {
    const Weights ky = contrast_kernel(p, 1, 0.0047, 0, 1e-5);
    const Weights kx = contrast_kernel(p, 1, 0.0053, 0, 1e-5);
    const Weights kz = contrast_kernel(p, 34.1, 0.04, 13.5, 0.025);
    const Weights edge = feature_kernel(p, 1), point = feature_kernel(p, 2);
    const double cmax = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
    const Picture* pictures[2] = {&reference, &test};
    Picture opponents[2];
    for (int k = 0; k < 2; ++k)
        for (const Color& rgb : *pictures[k])
            opponents[k].push_back(opponent(rgb));

    std::vector<double> map;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            Color lab[2];
            double edges[2], points[2];
            for (int k = 0; k < 2; ++k) {
                const Picture& o = opponents[k];
                const auto luma = [&](size_t i) { return (o[i].a + 16) / 116; };
                lab[k] = hunt_lab(opponent_to_clamped_rgb(
                    {correlate(size, x, y, ky, false, [&](size_t i) { return o[i].a; }),
                     correlate(size, x, y, kx, false, [&](size_t i) { return o[i].b; }),
                     correlate(size, x, y, kz, false, [&](size_t i) { return o[i].c; })}));
                edges[k] = std::hypot(correlate(size, x, y, edge, false, luma),
                                      correlate(size, x, y, edge, true, luma));
                points[k] = std::hypot(correlate(size, x, y, point, false, luma),
                                       correlate(size, x, y, point, true, luma));
            }
            const double d = std::pow(hyab(lab[0], lab[1]), 0.7), knee = 0.4 * cmax;
            const double color =
                d < knee ? d * 0.95 / knee : 0.95 + (d - knee) / (cmax - knee) * 0.05;
            const double feature =
                std::sqrt(std::max(std::abs(edges[0] - edges[1]), std::abs(points[0] - points[1])) /
                          std::sqrt(2.0));
            map.push_back(std::pow(color, 1 - feature));
        }
    }
    return map;
}

inline Picture picture(const Image& image) {
    Picture result;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto channel = [&](int c) {
                const double v = image.at(x, y, image.channels == 1 ? 0 : c);
                return v < 0 ? 0 : v > 1 ? 1 : v;
            };
            result.push_back({channel(0), channel(1), channel(2)});
        }
    return result;
}

} // namespace slow

} // namespace romascope
