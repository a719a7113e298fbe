// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/error.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace romascope {

/// Text of the Error that `action` throws, empty if it throws none.
inline std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return {};
}

/// Likewise, but throwing none is a failure.
inline std::string expect_error(const std::function<void()>& action) {
    const std::string text = error_of(action);
    EXPECT_FALSE(text.empty()) << "no Error";
    return text;
}

} // namespace romascope

#define EXPECT_CONTAINS(text, part)                                                                \
    EXPECT_NE(std::string(text).find(part), std::string::npos) << (text) << "\nlacks: " << (part)
