// SPDX-License-Identifier: MIT
#include "tests/gl/gl_test.h"

#include "renderer/base/error.h"

#include <cstdlib>
#include <vector>

namespace romascope {
namespace {

/// Made when the first test asks; null with a reason where the machine lacks the backend.
struct SharedContext {
    std::unique_ptr<Context> context;
    std::string why_not;
};

const SharedContext& shared_context() {
    static const SharedContext shared = [] {
        const char* name = std::getenv("ROMASCOPE_TEST_BACKEND");
        SharedContext made;
        ContextRequest request;
        request.debug = true;
        const std::vector<const char*> backends =
            name ? std::vector{name} : std::vector{"egl", "osmesa"};
        for (const char* backend : backends) {
            request.backend = backend_from_name(backend);
            try {
                made.context = create_context(request);
                break;
            } catch (const Error& error) {
                made.why_not = error.what();
            }
        }
        return made;
    }();
    return shared;
}

} // namespace

void GlTest::SetUp() {
    if (!shared_context().context) {
        // A library that is not there is what a machine can lack; anything else is a failure.
        if (shared_context().why_not.find("is not installed") != std::string::npos)
            GTEST_SKIP() << "this machine lacks the backend: " << shared_context().why_not;
        FAIL() << shared_context().why_not;
    }
    log_.emplace();
    timer_.emplace();
}

void GlTest::TearDown() {
    if (!log_)
        return;
    EXPECT_NO_THROW(check_gl_error("the test"));
    for (const std::string& message : log_->messages())
        ADD_FAILURE() << message;
    timer_.reset();
    log_.reset();
}

Scene scene_of_triangles(const std::vector<glm::vec3>& corners) {
    Scene scene;
    scene.name = "test";
    scene.materials = {{.double_sided = true}};
    for (size_t i = 0; i + 2 < corners.size(); i += 3) {
        const glm::vec3 normal =
            glm::normalize(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
        for (size_t k = i; k < i + 3; ++k) {
            scene.indices.push_back(static_cast<uint32_t>(scene.positions.size()));
            scene.positions.push_back(corners[k]);
            scene.normals.push_back(normal);
            scene.vertex_material.push_back(0);
            scene.bounds.add(corners[k]);
        }
    }
    scene.cameras = {
        look_at("camera", scene.bounds.centre() + glm::vec3(0, 1, 3), scene.bounds.centre(), 1.0f)};
    return scene;
}

std::vector<glm::vec3> rectangle(glm::vec3 centre, glm::vec3 normal, float half_side) {
    const glm::vec3 helper = std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = half_side * glm::normalize(glm::cross(helper, normal));
    const glm::vec3 v = half_side * glm::normalize(glm::cross(normal, u));
    return {centre - u - v, centre + u - v, centre + u + v,
            centre - u - v, centre + u + v, centre - u + v};
}

void add_box(std::vector<glm::vec3>& corners, glm::vec3 centre, float half_side) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f);
            normal[axis] = side;
            for (const glm::vec3 corner : rectangle(centre + half_side * normal, normal, half_side))
                corners.push_back(corner);
        }
    }
}

glm::vec3 random_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

void leave_all_own_cells(Settings& settings) {
    settings.set(kRomaNormalOffset, 2.0);
    settings.set(kRomaEscape, 0);
}

BaseMap upload_base(const BitGrid& grid, BaseStore store) {
    BaseMap map(store, grid.size());
    if (store == BaseStore::texture) {
        const glm::ivec3 texels = map.texture().size();
        glTextureSubImage3D(map.texture().id(), 0, 0, 0, 0, texels.x, texels.y, texels.z,
                            GL_RED_INTEGER, GL_UNSIGNED_INT, grid.words().data());
    } else {
        const Buffer given = Buffer::from("test words", std::span<const uint32_t>(grid.words()));
        map.words().bind_storage(0);
        glBindBuffer(GL_COPY_READ_BUFFER, given.id());
        glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_SHADER_STORAGE_BUFFER, 0, 0,
                            static_cast<GLsizeiptr>(given.bytes()));
    }
    return map;
}

} // namespace romascope
