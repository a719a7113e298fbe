// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/files.h"
#include "renderer/scene/gltf/document.h"
#include "tests/support/expect_error.h"
#include "tests/support/gltf_text.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>

namespace romascope::gltf {

namespace fs = std::filesystem;

/// Opens documents that pretend to lie in folder_/asset.
class GltfDocument : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("romascope_") + info->name() + std::to_string(getpid()));
        fs::create_directories(folder_ / "asset");
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::unique_ptr<Document> open(const std::string& content) {
        return std::make_unique<Document>(content, folder_ / "asset" / "thing.gltf", budget_);
    }
    std::unique_ptr<Document> open_square(const std::string& from, const std::string& to) {
        return open(glb(replaced(kSquare, from, to), square_bytes()));
    }
    std::string refusal(const std::string& content) {
        return error_of([&] { open(content); });
    }
    std::string square_refusal(const std::string& from, const std::string& to) {
        return refusal(glb(replaced(kSquare, from, to), square_bytes()));
    }
    /// The square as text with its buffer behind `uri`.
    static std::string with_uri(const std::string& uri) {
        return replaced(kSquare, "{\"byteLength\": 108",
                        "{\"uri\": \"" + uri + "\", \"byteLength\": 108");
    }
    std::string bytes_of_view(const Document& document, int view) {
        const auto bytes = document.view(view);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }

    MemoryBudget budget_{size_t{1} << 30};
    fs::path folder_;
};

inline std::string base64(const std::string& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t bits = 0;
        for (size_t k = 0; k < 3; ++k)
            bits =
                bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace romascope::gltf
