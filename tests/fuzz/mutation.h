// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace romascope::fuzz {

/// Numbers at which something may change or break.
inline const std::array<double, 22> kNumbers = {
    0.0,   -1.0,         1.0,          0.5,     -0.5,    3.0,      127.0, 255.0,
    256.0, 65535.0,      65536.0,      2.1e9,   4.3e9,   1e-45,    1e-20, 1e9,
    1e19,  3.4028234e38, -3.402823e38, 1.0e154, 1.7e308, -1.0e-308};
inline const std::array<int64_t, 24> kIntegers = {
    0,     -1,    1,          2,           3,          4,          5,         6,
    252,   256,   5120,       5121,        5122,       5123,       5125,      5126,
    65535, 65536, 2147483647, -2147483648, 4294967292, 4294967296, 1LL << 53, INT64_MIN};
inline const std::array<float, 12> kFloats = {0.0f,    -0.0f, 1.0f,    -1.0f,     0.5f,     1e-45f,
                                              -1e-38f, 1e9f,  3.4e38f, -INFINITY, INFINITY, NAN};

/// Draws for one mutation.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    size_t below(size_t count) { return count < 2 ? 0 : engine_() % count; }
    bool one_in(size_t count) { return below(count) == 0; }
    template <class Range>
    const auto& of(const Range& range) {
        return range[below(range.size())];
    }

private:
    std::minstd_rand engine_;
};

/// libFuzzer's own mutations; up to `room` bytes more.
std::string mutate_bytes(std::string bytes, size_t room);

/// Changes one value somewhere in a document, or adds, removes, copies or swaps some.
void mutate_json(nlohmann::json& root, Dice& dice);

} // namespace romascope::fuzz
