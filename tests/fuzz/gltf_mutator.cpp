// SPDX-License-Identifier: MIT
// libFuzzer's mutations of glTF files: most keep the container and the JSON whole and change what
// they mean, so that inputs come past the parser.
#include "tests/fuzz/drawn_inputs.h"
#include "tests/fuzz/gltf_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>
#include <vector>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace romascope::fuzz {
namespace {

using nlohmann::json;

const std::array<double, 22> kNumbers = {
    0.0,   -1.0,         1.0,          0.5,     -0.5,    3.0,      127.0, 255.0,
    256.0, 65535.0,      65536.0,      2.1e9,   4.3e9,   1e-45,    1e-20, 1e9,
    1e19,  3.4028234e38, -3.402823e38, 1.0e154, 1.7e308, -1.0e-308};
const std::array<int64_t, 24> kIntegers = {
    0,     -1,    1,          2,           3,          4,          5,         6,
    252,   256,   5120,       5121,        5122,       5123,       5125,      5126,
    65535, 65536, 2147483647, -2147483648, 4294967292, 4294967296, 1LL << 53, INT64_MIN};
const std::array<float, 12> kFloats = {0.0f,    -0.0f, 1.0f,    -1.0f,     0.5f,     1e-45f,
                                       -1e-38f, 1e9f,  3.4e38f, -INFINITY, INFINITY, NAN};
const std::array<const char*, 64> kWords = {"SCALAR",
                                            "VEC2",
                                            "VEC3",
                                            "VEC4",
                                            "MAT2",
                                            "MAT3",
                                            "MAT4",
                                            "POSITION",
                                            "NORMAL",
                                            "TANGENT",
                                            "TEXCOORD_0",
                                            "TEXCOORD_1",
                                            "COLOR_0",
                                            "JOINTS_0",
                                            "JOINTS_1",
                                            "WEIGHTS_0",
                                            "WEIGHTS_1",
                                            "LINEAR",
                                            "STEP",
                                            "CUBICSPLINE",
                                            "translation",
                                            "rotation",
                                            "scale",
                                            "weights",
                                            "OPAQUE",
                                            "MASK",
                                            "BLEND",
                                            "perspective",
                                            "orthographic",
                                            "directional",
                                            "point",
                                            "spot",
                                            "KHR_lights_punctual",
                                            "KHR_mesh_quantization",
                                            "KHR_texture_transform",
                                            "EXT_meshopt_compression",
                                            "KHR_draco_mesh_compression",
                                            "KHR_materials_unlit",
                                            "ATTRIBUTES",
                                            "TRIANGLES",
                                            "INDICES",
                                            "NONE",
                                            "OCTAHEDRAL",
                                            "QUATERNION",
                                            "EXPONENTIAL",
                                            "image/png",
                                            "image/jpeg",
                                            "2.0",
                                            "1.0",
                                            "",
                                            "..",
                                            "../x.bin",
                                            "/dev/zero",
                                            "%2e%2e/x",
                                            "x\n",
                                            "\xff",
                                            "mesh",
                                            "skin",
                                            "camera",
                                            "sparse",
                                            "min",
                                            "matrix",
                                            "children",
                                            "byteStride"};

/// What stands where there is a choice, so that most changes mean another file, not a broken one.
const std::map<std::string, std::vector<json>> kChoices = {
    {"componentType", {5120, 5121, 5122, 5123, 5125, 5126}},
    {"type", {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT4", "perspective", "directional", "spot"}},
    {"mode", {0, 3, 4, 5, 6, "ATTRIBUTES", "TRIANGLES", "INDICES"}},
    {"filter", {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"}},
    {"interpolation", {"LINEAR", "STEP", "CUBICSPLINE"}},
    {"path", {"translation", "rotation", "scale", "weights"}},
    {"alphaMode", {"OPAQUE", "MASK", "BLEND"}},
    {"wrapS", {33071, 33648, 10497}},
    {"wrapT", {33071, 33648, 10497}},
    {"minFilter", {9728, 9729, 9984, 9987}},
    {"magFilter", {9728, 9729}},
    {"byteStride", {4, 8, 12, 16, 24, 252}},
    {"normalized", {true, false}}};

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

std::string mutate_bytes(std::string bytes, size_t room) {
    const size_t size = bytes.size();
    bytes.resize(size + room);
    bytes.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(bytes.data()), size, bytes.size()));
    return bytes;
}

/// Changes one value somewhere in a document.
class JsonMutation {
public:
    JsonMutation(json& root, Dice& dice) : root_(root), dice_(dice) {}

    void apply() {
        json& place = descend(root_);
        if (const auto choice = kChoices.find(key_); choice != kChoices.end() && !dice_.one_in(4))
            place = dice_.of(choice->second);
        else if (place.is_structured() && !place.empty() && !dice_.one_in(32))
            change_children(place);
        else if (dice_.one_in(24))
            place = json(descend(root_));
        else if (dice_.one_in(32))
            place = other_type();
        else if (place.is_number())
            change_number(place);
        else if (place.is_string())
            change_string(place);
        else if (place.is_boolean())
            place = !place.get<bool>();
        else
            change_children(place);
    }

private:
    /// From the root down by equal chances, so that long arrays do not draw all mutations; key_ is
    /// then the last member's.
    json& descend(json& from) {
        json* place = &from;
        key_.clear();
        while (place->is_structured() && !place->empty() &&
               (place == &root_ || !dice_.one_in(10))) {
            const auto child =
                std::next(place->begin(), static_cast<long>(dice_.below(place->size())));
            if (place->is_object())
                key_ = child.key();
            place = &*child;
        }
        return *place;
    }

    json other_type() {
        const std::array<json, 8> values = {
            nullptr, true, -1, 0.25, "", json::array(), json::object(), json::array({0})};
        return dice_.of(values);
    }

    void change_number(json& place) {
        switch (dice_.below(5)) {
        case 0:
            place = dice_.of(kIntegers);
            break;
        case 1:
            place = dice_.of(kNumbers);
            break;
        case 2:
            place = dice_.below(8);
            break; // an index of something
        case 3:
            if (place.is_number_integer() && std::abs(place.get<double>()) < 1e15) {
                place = place.get<int64_t>() + static_cast<int64_t>(dice_.below(9)) - 4;
                break;
            }
            [[fallthrough]];
        default:
            place = place.get<double>() * (dice_.one_in(2) ? 2.0 : 0.5);
        }
    }

    void change_string(json& place) {
        auto& text = place.get_ref<std::string&>();
        const size_t comma = text.find(";base64,");
        if (text.starts_with("data:") && comma != std::string::npos) {
            const size_t start = comma + std::strlen(";base64,");
            std::string bytes = from_base64(std::string_view(text).substr(start));
            text.resize(start);
            text += to_base64(mutate_bytes(std::move(bytes), 16));
        } else if (dice_.one_in(3)) {
            text = mutate_bytes(text, 8);
        } else {
            text = dice_.of(kWords);
        }
    }

    void change_children(json& place) {
        const size_t at = dice_.below(place.size());
        if (place.is_array())
            change_elements(place, at);
        else if (place.is_object())
            change_members(place, at);
    }

    void change_elements(json& place, size_t at) {
        json copy = descend(root_);
        if (place.empty()) {
            place.push_back(std::move(copy));
            return;
        }
        switch (dice_.below(4)) {
        case 0:
            place.erase(at);
            break;
        case 1:
            place.push_back(json(place[at]));
            break;
        case 2:
            std::swap(place[at], place[dice_.below(place.size())]);
            break;
        default:
            place.push_back(std::move(copy));
        }
    }

    void change_members(json& place, size_t at) {
        json copy = descend(root_);
        if (place.empty() || dice_.one_in(4)) {
            place[dice_.of(kWords)] = std::move(copy);
            return;
        }
        const auto member = std::next(place.begin(), static_cast<long>(at));
        switch (dice_.below(4)) {
        case 0:
            place.erase(member);
            break;
        case 1:
            place[dice_.of(kWords)] = json(*member);
            break;
        case 2: {
            const auto other =
                std::next(place.begin(), static_cast<long>(dice_.below(place.size())));
            std::swap(*member, *other);
            break;
        }
        default:
            borrow_member(place);
        }
    }

    /// Takes a member from another object: a known key at a place where it may mean something.
    void borrow_member(json& place) {
        json& giver = descend(root_);
        if (!giver.is_object() || giver.empty() || &giver == &place)
            return;
        const auto member = std::next(giver.begin(), static_cast<long>(dice_.below(giver.size())));
        json value = *member;
        place[member.key()] = std::move(value);
    }

    json& root_;
    Dice& dice_;
    std::string key_;
};

/// The start of a view that the document names, or any place.
size_t place_in_bin(const GltfParts& parts, Dice& dice) {
    size_t start = 0;
    if (const auto views = parts.json.find("bufferViews");
        views != parts.json.end() && views->is_array() && !views->empty() && !dice.one_in(4)) {
        const json& view = (*views)[dice.below(views->size())];
        if (view.is_object() && view.contains("byteOffset") &&
            view["byteOffset"].is_number_unsigned())
            start = view["byteOffset"].get<size_t>();
    }
    if (start >= parts.bin.size())
        start = 0;
    const size_t rest = parts.bin.size() - start;
    return start + dice.below(dice.one_in(2) ? std::min<size_t>(rest, 64) : rest) / 4 * 4;
}

void mutate_bin(GltfParts& parts, Dice& dice) {
    std::string& bin = parts.bin;
    const size_t at = bin.empty() ? 0 : place_in_bin(parts, dice);
    const auto write = [&](auto value) {
        if (bin.size() >= at + sizeof(value))
            std::memcpy(bin.data() + at, &value, sizeof(value));
    };
    switch (dice.below(6)) {
    case 0:
        write(dice.of(kFloats));
        break;
    case 1:
        write(static_cast<uint32_t>(dice.of(kIntegers)));
        break;
    case 2:
        write(static_cast<uint16_t>(dice.of(kIntegers)));
        break;
    case 3:
        write(static_cast<uint8_t>(dice.below(256)));
        break;
    case 4:
        bin.resize(dice.below(bin.size() + 1));
        break;
    default: {
        std::string tail = bin.substr(at, 256);
        const size_t size = tail.size();
        bin.replace(at, size, mutate_bytes(std::move(tail), dice.one_in(4) ? 16 : 0));
    }
    }
}

/// Writes `file` over `data` if there is room.
size_t hand_over(const std::string& file, uint8_t* data, size_t max_size) {
    if (file.empty() || file.size() > max_size)
        return 0;
    std::memcpy(data, file.data(), file.size());
    return file.size();
}

std::string_view view_of(const uint8_t* data, size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

} // namespace
} // namespace romascope::fuzz

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size,
                                          unsigned seed) {
    using namespace romascope::fuzz;
    Dice dice(seed);
    std::string_view input = view_of(data, size);
    if (!drawn_inputs().empty() && dice.one_in(2))
        input = drawn_inputs().pick(dice.below(drawn_inputs().count()));
    auto parts = dice.one_in(64) ? std::nullopt : take_apart(input);
    if (!parts)
        return LLVMFuzzerMutate(data, size, max_size);
    for (size_t n = dice.one_in(2) ? 1 : 1 + dice.below(4); n > 0; --n) {
        if (parts->has_bin && dice.one_in(3))
            mutate_bin(*parts, dice);
        else
            JsonMutation(parts->json, dice).apply();
    }
    if (dice.one_in(64))
        parts->glb = !parts->glb;
    if (!dice.one_in(32)) // else most of what is kept would differ in how this is broken
        parts->json["asset"] = {{"version", "2.0"}};
    const size_t written =
        hand_over(put_together(std::move(*parts), !dice.one_in(32)), data, max_size);
    return written > 0 ? written : LLVMFuzzerMutate(data, size, max_size);
}

/// One member of the second document in the first, with or without the second's buffer.
extern "C" size_t LLVMFuzzerCustomCrossOver(const uint8_t* first, size_t first_size,
                                            const uint8_t* second, size_t second_size, uint8_t* out,
                                            size_t max_size, unsigned seed) {
    using namespace romascope::fuzz;
    Dice dice(seed);
    auto into = take_apart(view_of(first, first_size));
    const auto from = take_apart(view_of(second, second_size));
    if (!into || !from || from->json.empty())
        return 0;
    const auto member =
        std::next(from->json.begin(), static_cast<long>(dice.below(from->json.size())));
    nlohmann::json& place = into->json[member.key()];
    if (place.is_array() && member->is_array() && dice.one_in(2))
        place.insert(place.end(), member->begin(), member->end());
    else
        place = *member;
    if (dice.one_in(2)) {
        into->has_bin = from->has_bin;
        into->bin = from->bin;
    }
    return hand_over(put_together(std::move(*into), true), out, max_size);
}
