// SPDX-License-Identifier: MIT
#include "renderer/metrics/flicker.h"

#include "renderer/metrics/errors.h"

#include <utility>

namespace romascope {

void Flicker::add(const Image& truth, const Image& picture) {
    Image error = difference_map(truth, picture);
    if (!last_error_.data.empty()) {
        sum_ += error_figures(last_error_, error).mae;
        ++pairs_;
    }
    last_error_ = std::move(error);
}

} // namespace romascope
