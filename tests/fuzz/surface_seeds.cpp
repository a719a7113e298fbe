// SPDX-License-Identifier: MIT
// Materials, textures, masks, vertex colours.
#include "tests/fuzz/seed.h"
#include "tests/fuzz/seeds.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

#include <array>

namespace romascope::fuzz {
namespace {

void append(void* out, void* data, int size) {
    static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                           static_cast<size_t>(size));
}

constexpr int kSide = 4;

/// kSide times kSide texels that all differ; with 2 and 4 channels, the last is alpha.
std::vector<unsigned char> texels(int channels) {
    std::vector<unsigned char> result(static_cast<size_t>(kSide * kSide * channels));
    for (size_t i = 0; i < result.size(); ++i)
        result[i] = static_cast<unsigned char>(i * 67 % 256);
    return result;
}

std::string png(int channels) {
    std::string file;
    stbi_write_png_to_func(append, &file, kSide, kSide, channels, texels(channels).data(),
                           kSide * channels);
    return file;
}

std::string jpeg() {
    std::string file;
    stbi_write_jpg_to_func(append, &file, kSide, kSide, 3, texels(3).data(), 50);
    return file;
}

/// A square with one texture of the picture in its base colour.
Seed textured(const std::string& picture, const char* mime) {
    Seed seed = Seed().square();
    seed.attribute("TEXCOORD_0", seed.numbers<float>({0, 0, 1, 0, 0, 1, 1, 1}, kF32, "VEC2", 2));
    seed.root["images"] = {{{"bufferView", seed.view(picture)}, {"mimeType", mime}}};
    seed.root["samplers"] = {
        {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}};
    seed.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
    seed.material()["pbrMetallicRoughness"] = {{"baseColorTexture", {{"index", 0}}},
                                               {"baseColorFactor", {1, 0.5, 0.25, 0.75}}};
    return seed;
}

} // namespace

void write_surface_seeds(const std::filesystem::path& folder) {
    const std::array<const char*, 4> names = {"png_grey", "png_grey_alpha", "png_rgb", "png_rgba"};
    for (int channels = 1; channels <= 4; ++channels)
        textured(png(channels), "image/png")
            .write(folder, names[static_cast<size_t>(channels - 1)], true);
    textured(jpeg(), "image/jpeg").write(folder, "jpeg", true);

    Seed masked = textured(png(4), "image/png");
    masked.material()["alphaMode"] = "MASK";
    masked.material()["alphaCutoff"] = 0.4;
    masked.material()["doubleSided"] = true;
    masked.material()["emissiveFactor"] = {0, 1, 0.5};
    masked.write(folder, "masked", true);
    masked.material()["alphaMode"] = "BLEND";
    masked.write(folder, "blended", true);

    Seed embedded = textured(png(3), "image/png");
    std::string uri = "data:image/png;base64,";
    uri += to_base64(png(3));
    embedded.root["images"] = {{{"uri", uri}}};
    embedded.write(folder, "picture_in_data_uri", false);

    Seed moved = textured(png(3), "image/png");
    moved.use("KHR_texture_transform", false);
    moved.attribute("TEXCOORD_1",
                    moved.numbers<uint8_t>({0, 0, 255, 0, 0, 255, 255, 255}, kU8, "VEC2", 2, true));
    moved.material()["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        {"KHR_texture_transform",
         {{"offset", {0.5, 0.25}}, {"rotation", 0.7}, {"scale", {2, 3}}, {"texCoord", 1}}}};
    moved.write(folder, "texture_transform", true);

    Seed colored = Seed().square();
    colored.attribute("COLOR_0", colored.numbers<uint8_t>({255, 0, 0, 255, 0, 255, 0, 128, 0, 0,
                                                           255, 0, 255, 255, 255, 255},
                                                          kU8, "VEC4", 4, true));
    colored.write(folder, "colors_u8", true);
    colored.attribute("COLOR_0", colored.numbers<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 2, -1, 0.5f},
                                                        kF32, "VEC3", 3));
    colored.write(folder, "colors_f32", true);
}

} // namespace romascope::fuzz
