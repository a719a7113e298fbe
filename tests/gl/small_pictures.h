// SPDX-License-Identifier: MIT
// Small pictures of ambient occlusion, and scenes where it is known.
#pragma once

#include "tests/gl/gl_test.h"

namespace romascope {

/// Pictures of 32 x 24 pixels, so that a software rasteriser has done with them soon.
class SmallPictures : public GlTest {
protected:
    struct View {
        Scene scene;
        Camera camera;
        glm::vec3 normal; ///< of what is seen
    };

    SmallPictures() {
        settings_.set(kWidth, 32);
        settings_.set(kHeight, 24);
        settings_.set(kOccupancyResolution, 64);
    }

    /// The mean of so many frames.
    Image render(const Scene& scene, const Camera& camera, int frames) {
        Pipeline pipeline(scene, ShaderLibrary());
        for (int i = 0; i < frames; ++i)
            pipeline.render(settings_, camera);
        return pipeline.picture();
    }

    static double mean(const Image& image) {
        double sum = 0;
        for (const float value : image.data)
            sum += value;
        return sum / static_cast<double>(image.data.size());
    }

    /// A plane seen from above, level or turned at random.
    static View open_plane(std::mt19937& random, bool level) {
        const glm::vec3 normal = level ? glm::vec3(0, 1, 0) : random_direction(random);
        const glm::vec3 centre = 10.0f * random_direction(random);
        const Camera camera = look_at(
            "above", centre + 2.0f * normal + 0.3f * random_direction(random), centre, 1.2f);
        return {scene_of_triangles(rectangle(centre, normal, 3.0f)), camera, normal};
    }

    /// A floor with a ceiling 2 m above it, looked at from between the two.
    static View below_a_ceiling() {
        std::vector<glm::vec3> corners = rectangle({0, 0, 0}, {0, 1, 0}, 2.0f);
        const std::vector<glm::vec3> ceiling = rectangle({0, 2, 0}, {0, -1, 0}, 2.0f);
        corners.insert(corners.end(), ceiling.begin(), ceiling.end());
        return {
            scene_of_triangles(corners), look_at("under", {0, 1, 0}, {0, 0, 0}, 0.2f), {0, 1, 0}};
    }

    Settings settings_{all_knobs()};
};

} // namespace romascope
