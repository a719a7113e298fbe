// SPDX-License-Identifier: MIT
// Closed surfaces as triangles, turned and placed anyhow.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace romascope {

struct ClosedMesh {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> indices; ///< three a triangle

    void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        for (const uint32_t i : {a, b, c, a, c, d})
            indices.push_back(i);
    }
};

/// The box [-1, 1]^3 through this matrix.
inline ClosedMesh box_mesh(const glm::mat4& matrix) {
    ClosedMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(matrix *
                                    glm::vec4(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1, 1));
    mesh.quad(0, 2, 3, 1);
    mesh.quad(4, 5, 7, 6);
    mesh.quad(0, 1, 5, 4);
    mesh.quad(2, 6, 7, 3);
    mesh.quad(0, 4, 6, 2);
    mesh.quad(1, 3, 7, 5);
    return mesh;
}

/// The unit sphere by latitude and longitude through this matrix; needles at the poles.
inline ClosedMesh sphere_mesh(const glm::mat4& matrix, int rings, int sectors) {
    ClosedMesh mesh;
    for (int ring = 0; ring <= rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector) {
            const double polar = M_PI * ring / rings, around = 2 * M_PI * sector / sectors;
            const double radius = ring == 0 || ring == rings ? 0.0 : std::sin(polar);
            mesh.positions.emplace_back(matrix * glm::vec4(radius * std::cos(around),
                                                           radius * std::sin(around),
                                                           std::cos(polar), 1.0));
        }
    const auto at = [&](int ring, int sector) {
        return static_cast<uint32_t>(ring * sectors + sector % sectors);
    };
    for (int ring = 0; ring < rings; ++ring)
        for (int sector = 0; sector < sectors; ++sector)
            mesh.quad(at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1),
                      at(ring, sector + 1));
    return mesh;
}

/// Turns by a random angle about a random axis.
inline glm::mat4 random_turn(std::mt19937& random) {
    std::normal_distribution<float> normal;
    std::uniform_real_distribution<float> angle(0.0f, 6.28f);
    return glm::rotate(glm::mat4(1.0f), angle(random),
                       glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
}

} // namespace romascope
