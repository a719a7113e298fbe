// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/storage.h"

#include <tiny_gltf.h>

namespace romascope::gltf {

Storage::~Storage() { budget_.give(taken_); }

void Storage::take(size_t count, size_t size, const std::string& what) {
    budget_.take(count, size, what);
    taken_ += count * size;
}

std::vector<std::byte> Storage::allocate(size_t count, size_t size, const std::string& what) {
    take(count, size, what);
    return std::vector<std::byte>(count * size);
}

std::span<const std::byte> Storage::keep(std::vector<std::byte> bytes) {
    return owned_.emplace_back(std::move(bytes));
}

int Storage::add_view(tinygltf::Model& model, std::vector<std::byte> bytes) {
    tinygltf::BufferView view;
    view.byteLength = bytes.size();
    model.bufferViews.push_back(std::move(view));
    views.emplace_back(keep(std::move(bytes)));
    return static_cast<int>(model.bufferViews.size() - 1);
}

} // namespace romascope::gltf
