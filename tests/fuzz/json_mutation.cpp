// SPDX-License-Identifier: MIT
#include "tests/fuzz/gltf_parts.h"
#include "tests/fuzz/mutation.h"

#include <cstring>
#include <map>
#include <sstream>
#include <vector>

namespace romascope::fuzz {
namespace {

using nlohmann::json;

std::vector<std::string> words_of(const char* text) {
    std::istringstream in(text);
    std::vector<std::string> words{""};
    for (std::string word; std::getline(in, word, ' ');)
        words.push_back(word);
    return words;
}

/// Names and values of glTF, and a few that are none.
const std::vector<std::string> kWords = words_of(
    "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4 POSITION NORMAL TANGENT TEXCOORD_0 TEXCOORD_1 COLOR_0 "
    "JOINTS_0 JOINTS_1 WEIGHTS_0 WEIGHTS_1 LINEAR STEP CUBICSPLINE translation rotation scale "
    "weights OPAQUE MASK BLEND perspective orthographic directional point spot "
    "KHR_lights_punctual KHR_mesh_quantization KHR_texture_transform EXT_meshopt_compression "
    "KHR_draco_mesh_compression KHR_materials_unlit ATTRIBUTES TRIANGLES INDICES NONE "
    "OCTAHEDRAL QUATERNION EXPONENTIAL image/png image/jpeg 2.0 1.0 .. ../x.bin /dev/zero "
    "%2e%2e/x x\n \xff mesh skin camera sparse min matrix children byteStride");

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
        const size_t way = dice_.below(8);
        if (way == 0) {
            place = dice_.of(kIntegers);
        } else if (way == 1) {
            place = dice_.of(kNumbers);
        } else if (way < 4) {
            place = dice_.below(8); // an index of something
        } else if (!place.is_number_integer()) {
            place = place.get<double>() * (dice_.one_in(2) ? 1.5 : -0.5);
        } else if (std::abs(place.get<double>()) < 1e15) {
            const auto number = place.get<int64_t>();
            place = way < 7 ? number + static_cast<int64_t>(dice_.below(9)) - 4 : 2 * number;
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

} // namespace

void mutate_json(json& root, Dice& dice) { JsonMutation(root, dice).apply(); }

} // namespace romascope::fuzz
