// SPDX-License-Identifier: MIT
// The ground of every test that needs GL: one context per process, of the backend that
// ROMASCOPE_TEST_BACKEND names (egl if unset); any GL debug message or error fails the test.
#pragma once

#include "renderer/frame/pipeline.h"
#include "renderer/gl/context.h"
#include "renderer/gl/debug.h"
#include "renderer/tracers/roma/roma_tracer.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

namespace romascope {

class GlTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// A frame context over a scene with these settings; lives as long as the test.
    FrameContext frame(const GpuScene& scene, const Settings& settings, uint32_t seed = 0,
                       uint32_t number = 0) {
        return {settings, shaders_, scene, *timer_, seed, number};
    }

    ShaderLibrary shaders_;
    std::optional<DebugLog> log_;
    std::optional<PassTimer> timer_;
};

/// Triangles without an index shared, white, with flat normals, seen from both sides.
Scene scene_of_triangles(const std::vector<glm::vec3>& corners);

/// A rectangle of two triangles around `centre`, at right angles to `normal`.
std::vector<glm::vec3> rectangle(glm::vec3 centre, glm::vec3 normal, float half_side);

/// Adds the six sides of a cube around `centre`.
void add_box(std::vector<glm::vec3>& corners, glm::vec3 centre, float half_side);

glm::vec3 random_direction(std::mt19937& random);

/// So that rays start beyond all cells of the plane they start on, however they graze it; the
/// default, which has the fewest wrong rays over all scenes, leaves some within. A thin cell's
/// centre lies half a cell off the plane at most; a sheared column passes cells whose centre is off
/// the ray by half a cell of the column and half a cell of rounding across, and half a slice along:
/// sqrt(1 + 1 + 1/4). With the rotation these 2 cells are longer.
void leave_all_own_cells(Settings& settings);

/// The grid as the occupancy map's texture holds it.
BaseMap upload_base(const BitGrid& grid, BaseStore store);

} // namespace romascope
