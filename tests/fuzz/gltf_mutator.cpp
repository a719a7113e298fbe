// SPDX-License-Identifier: MIT
// libFuzzer's mutations of glTF files: most keep the container and the JSON whole and change what
// they mean, so that inputs come past the parser.
#include "tests/fuzz/drawn_inputs.h"
#include "tests/fuzz/gltf_parts.h"
#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);

namespace romascope::fuzz {

std::string mutate_bytes(std::string bytes, size_t room) {
    const size_t size = bytes.size();
    bytes.resize(size + room);
    bytes.resize(LLVMFuzzerMutate(reinterpret_cast<uint8_t*>(bytes.data()), size, bytes.size()));
    return bytes;
}

namespace {

using nlohmann::json;

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
    const size_t way = dice.below(32);
    if (way == 0) {
        bin.resize(dice.below(bin.size() + 1));
    } else if (way < 6) {
        write(dice.of(kFloats));
    } else if (way < 10) {
        write(static_cast<uint32_t>(dice.of(kIntegers)));
    } else if (way < 14) {
        write(static_cast<uint16_t>(dice.of(kIntegers)));
    } else if (way < 18) {
        write(static_cast<uint8_t>(dice.below(256)));
    } else {
        std::string tail = bin.substr(at, 256);
        const size_t size = tail.size();
        bin.replace(at, size, mutate_bytes(std::move(tail), dice.one_in(16) ? 16 : 0));
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
            mutate_json(parts->json, dice);
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
