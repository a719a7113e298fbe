// SPDX-License-Identifier: MIT
// Which scenes are too large to be voxelised in compute, and that it is said.
#include "renderer/tracers/occupancy/compute_limits.h"

#include <gtest/gtest.h>

namespace romascope {
namespace {

constexpr ComputeLimits kDriver{1000000, 80000}; // texture coordinates of 10,000 vertices
constexpr ComputeLimits kVast{size_t{1} << 40, size_t{1} << 43};

TEST(ComputeLimits, TakesWhatFits) {
    EXPECT_EQ(beyond_compute(0, 0, kDriver), "");
    EXPECT_EQ(beyond_compute(10000, 1000000, kDriver), "");
    EXPECT_EQ(beyond_compute(size_t{1} << 30, 1000000, kVast), "");
}

TEST(ComputeLimits, TellsWhatDoesNot) {
    const std::string vertices = beyond_compute(10001, 5, kDriver);
    EXPECT_NE(vertices.find("10001 vertices and 5 triangles"), std::string::npos) << vertices;
    EXPECT_NE(vertices.find("more than 10000 or 1000000"), std::string::npos) << vertices;
    EXPECT_NE(beyond_compute(3, 1000001, kDriver), "");
    // Vertices without texture coordinates still lie in a buffer texture.
    EXPECT_NE(beyond_compute(11, 3, {10, 80000}), "");
    // However much a driver allows, entries of the list of work name triangles in some of their 32
    // bits.
    EXPECT_NE(beyond_compute(3, size_t{1} << 32, kVast), "");
}

} // namespace
} // namespace romascope
