// SPDX-License-Identifier: MIT
// The ground of tests of stages that reuse pixels: a G-buffer of a small scene, values made up for
// each pixel, and what the G-buffer saw, in double precision.
#pragma once

#include "renderer/reuse/screen_reuse.h"
#include "tests/gl/gl_test.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace romascope {

class ReuseTest : public GlTest {
protected:
    static constexpr glm::ivec2 kSize{48, 40};

    static View view_of(const Camera& camera, glm::vec2 offset = {}) {
        View view;
        view.camera = camera;
        view.size = kSize;
        view.near_plane = 0.001f;
        view.offset = offset;
        return view;
    }

    static size_t index(int x, int y) { return static_cast<size_t>(y * kSize.x + x); }

    /// Of every pixel, row by row.
    static std::vector<float> each_pixel(const std::function<float(int x, int y)>& value) {
        std::vector<float> values;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                values.push_back(value(x, y));
        return values;
    }

    static Texture upload(const std::vector<float>& values, int channels = 1) {
        Texture texture("test values", GL_TEXTURE_2D, channels == 1 ? GL_R32F : GL_RGBA32F,
                        glm::ivec3(kSize, 1));
        glTextureSubImage2D(texture.id(), 0, 0, 0, kSize.x, kSize.y,
                            channels == 1 ? GL_RED : GL_RGBA, GL_FLOAT, values.data());
        return texture;
    }

    /// What the camera sees, as gbuffer_ was drawn last.
    struct Seen {
        double depth = 0; ///< 0: nothing
        glm::dvec3 position{0.0};
    };
    std::vector<Seen> seen(const View& view) const {
        const std::vector<float> stored = gbuffer_.depth().download_float(1);
        std::vector<Seen> all;
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const double depth = stored[index(x, y)];
                Seen s;
                if (depth > 0) {
                    s.depth = double{view.near_plane} / depth;
                    const glm::dvec3 way(
                        view.camera.direction_through(glm::vec2(x, y) + 0.5f + view.offset, kSize));
                    s.position = glm::dvec3(view.camera.eye) +
                                 way * (s.depth / glm::dot(way, glm::dvec3(view.camera.forward)));
                }
                all.push_back(s);
            }
        }
        return all;
    }

    /// The unit normals of those surfaces, as shaders/common/octahedral.glsl has them.
    std::vector<glm::vec3> normals_seen() const {
        std::vector<glm::vec3> all;
        for (const GLuint bits : gbuffer_.normal().download_uint(1)) {
            const auto part = [](GLuint word) {
                return std::max(static_cast<float>(static_cast<int16_t>(word)) / 32767.0f, -1.0f);
            };
            const glm::vec2 e(part(bits & 0xffffu), part(bits >> 16));
            glm::vec3 n(e, 1.0f - std::abs(e.x) - std::abs(e.y));
            if (n.z < 0.0f) {
                n.x = (1.0f - std::abs(e.y)) * (e.x >= 0.0f ? 1.0f : -1.0f);
                n.y = (1.0f - std::abs(e.x)) * (e.y >= 0.0f ? 1.0f : -1.0f);
            }
            all.push_back(glm::normalize(n));
        }
        return all;
    }

    /// Where a point is in the picture, (0, 0) the first pixel's centre.
    static glm::dvec2 place_of(const View& view, glm::dvec3 position) {
        const glm::dvec3 way = position - glm::dvec3(view.camera.eye);
        const double depth = glm::dot(way, glm::dvec3(view.camera.forward));
        const double pixel = pixels_at_unit_depth(view, 1.0);
        const glm::dvec2 slope(glm::dot(way, glm::dvec3(view.camera.right())) / depth,
                               -glm::dot(way, glm::dvec3(view.camera.up)) / depth);
        return slope / pixel + 0.5 * glm::dvec2(kSize) - 0.5 - glm::dvec2(view.offset);
    }

    static Camera moved(Camera camera, glm::vec3 way) {
        camera.eye += way;
        return camera;
    }

    Settings settings_{all_knobs()};
    GBuffer gbuffer_;
};

} // namespace romascope
