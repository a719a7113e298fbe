// SPDX-License-Identifier: MIT
#include "tests/fuzz/drawn_inputs.h"

#include <iterator>

namespace romascope::fuzz {

void DrawnInputs::add(uint64_t kind, std::string_view input) {
    if (inputs_.size() < kMost || inputs_.contains(kind))
        inputs_[kind] = input;
}

const std::string& DrawnInputs::pick(size_t number) const {
    return std::next(inputs_.begin(), static_cast<long>(number))->second;
}

DrawnInputs& drawn_inputs() {
    static DrawnInputs inputs;
    return inputs;
}

} // namespace romascope::fuzz
