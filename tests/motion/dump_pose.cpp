// SPDX-License-Identifier: MIT
// Prints where the triangles of a glTF file stand: for each animation and time a line "pose
// ANIMATION SECONDS TRIANGLES", then a line for each triangle: nine coordinates of its corners,
// nine of their normals (0 0 0: the triangle's own).
//
// dump_pose FILE ANIMATION SECONDS [ANIMATION SECONDS]...; animation: a number or "none"
#include "renderer/base/error.h"
#include "renderer/scene/gltf/import.h"
#include "renderer/scene/pose.h"

#include <fmt/format.h>

#include <cstdlib>

namespace {

void print(const romascope::Scene& scene) {
    for (size_t i = 0; i < scene.indices.size(); i += 3) {
        for (const auto& values : {scene.positions, scene.normals})
            for (size_t corner = i; corner < i + 3; ++corner) {
                const glm::vec3& v = values[scene.indices[corner]];
                fmt::print("{} {} {} ", v.x, v.y, v.z);
            }
        fmt::print("\n");
    }
}

} // namespace

int main(int count, char** arguments) {
    if (count < 4 || count % 2)
        return 2;
    try {
        romascope::Scene scene = romascope::load_gltf(arguments[1]);
        for (int i = 2; i < count; i += 2) {
            const int animation = romascope::find_animation(scene, arguments[i]);
            const double seconds = std::strtod(arguments[i + 1], nullptr);
            romascope::apply_pose(scene, romascope::pose_at(scene.motion, animation, seconds));
            fmt::print("pose {} {} {}\n", arguments[i], arguments[i + 1], scene.triangle_count());
            print(scene);
        }
    } catch (const romascope::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return error.exit_status();
    }
    return 0;
}
