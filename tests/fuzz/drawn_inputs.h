// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace romascope::fuzz {

/// The latest input that was drawn of each kind of scene. Most of what libFuzzer keeps for its new
/// coverage is refused, and what is made from that is refused again: mutations start from these
/// as well.
class DrawnInputs {
public:
    /// Kinds beyond kMost are forgotten.
    void add(uint64_t kind, std::string_view input);
    bool empty() const { return inputs_.empty(); }
    /// Any of them; `number` < count() chooses.
    const std::string& pick(size_t number) const;
    size_t count() const { return inputs_.size(); }

private:
    static constexpr size_t kMost = 4096;
    std::map<uint64_t, std::string> inputs_;
};

/// Those of this process.
DrawnInputs& drawn_inputs();

} // namespace romascope::fuzz
