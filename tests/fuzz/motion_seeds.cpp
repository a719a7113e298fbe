// SPDX-License-Identifier: MIT
// Node animations of all interpolations, morph targets, skins.
#include "tests/fuzz/seed.h"
#include "tests/fuzz/seeds.h"

namespace romascope::fuzz {
namespace {

void write_animations(const std::filesystem::path& folder) {
    Seed()
        .square()
        .animate("translation", "LINEAR", {0, 1}, {0, 0, 0, 1, 2, 3}, "VEC3", 3)
        .write(folder, "move_linear", true);
    Seed()
        .square()
        .animate("scale", "STEP", {0.5f, 1, 2}, {1, 1, 1, 2, 2, 2, 0, 1, -1}, "VEC3", 3)
        .write(folder, "scale_step", true);
    Seed()
        .square()
        .animate("rotation", "LINEAR", {0, 1, 2}, {0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, -1}, "VEC4", 4)
        .write(folder, "turn_linear", true);
    Seed()
        .square()
        .animate("rotation", "CUBICSPLINE", {0, 1},
                 {0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC4",
                 4)
        .write(folder, "turn_cubic", true);
    Seed packed =
        Seed().square().animate("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 1, 0, 0, 0}, "VEC4", 4);
    packed.root["animations"][0]["samplers"][0]["output"] =
        packed.numbers<int16_t>({0, 0, 0, 32767, 23170, 0, 0, 23170}, kS16, "VEC4", 4, true);
    packed.write(folder, "turn_packed", true);

    Seed rides =
        Seed().square().animate("translation", "LINEAR", {0, 2}, {0, 0, 0, 0, 0, 4}, "VEC3", 3);
    rides.root["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}}};
    rides.use("KHR_lights_punctual", false) = {{"lights", {{{"type", "point"}}}}};
    rides.root["nodes"] = {
        {{"children", {1, 2}}},
        {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
        {{"mesh", 0}}};
    rides.write(folder, "camera_and_light_ride", true);
}

void write_morphs(const std::filesystem::path& folder) {
    Seed morph = Seed().square();
    morph.attribute("NORMAL",
                    morph.numbers<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, kF32, "VEC3", 3));
    const int bend = morph.numbers<float>({0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1}, kF32, "VEC3", 3);
    const int widen = morph.numbers<float>({0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0}, kF32, "VEC3", 3);
    morph.primitive()["targets"] = {{{"POSITION", bend}, {"NORMAL", widen}}, {{"POSITION", widen}}};
    morph.root["meshes"][0]["weights"] = {0.5, 0};
    morph.write(folder, "morph_still", true);
    morph.animate("weights", "LINEAR", {0, 1}, {0, 1, 1, 0}, "SCALAR", 1);
    morph.write(folder, "morph_linear", true);
    Seed cubic = morph;
    cubic.root.erase("animations");
    cubic.animate("weights", "CUBICSPLINE", {0, 1}, {0, 0, 0, 1, 1, 1, 0, 0, 1, 0, 0, 0}, "SCALAR",
                  1);
    cubic.node()["weights"] = {1, 0.25};
    cubic.write(folder, "morph_cubic", true);
}

void write_skins(const std::filesystem::path& folder) {
    Seed skin = Seed().square();
    skin.attribute(
        "JOINTS_0",
        skin.numbers<uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, kU8, "VEC4", 4));
    skin.attribute("WEIGHTS_0", skin.numbers<float>(
                                    {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0, 0.75f, 0.25f, 0, 0},
                                    kF32, "VEC4", 4));
    skin.node()["skin"] = 0;
    skin.root["nodes"].push_back({{"children", {2}}});
    skin.root["nodes"].push_back({{"translation", {0, 1, 0}}});
    skin.root["scenes"][0]["nodes"] = {0, 1};
    const int inverse = skin.numbers<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                             1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                            kF32, "MAT4", 16);
    skin.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}, {"skeleton", 1}}};
    skin.write(folder, "skin_still", true);
    skin.animate("rotation", "LINEAR", {0, 1}, {0, 0, 0, 1, 0, 0, 1, 0}, "VEC4", 4);
    skin.root["animations"][0]["channels"][0]["target"]["node"] = 2;
    skin.write(folder, "skin_turns", true);
    Seed wide = skin;
    wide.attribute(
        "JOINTS_1",
        wide.numbers<uint16_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, kU16, "VEC4", 4));
    wide.attribute("WEIGHTS_1",
                   wide.numbers<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 0, 128, 0, 0}, kU8,
                                         "VEC4", 4, true));
    wide.root["skins"][0].erase("inverseBindMatrices");
    wide.write(folder, "skin_of_eight_influences", true);
}

} // namespace

void write_motion_seeds(const std::filesystem::path& folder) {
    write_animations(folder);
    write_morphs(folder);
    write_skins(folder);
}

} // namespace romascope::fuzz
