// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/base/memory.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace romascope::gltf {

/// Memory that is in use as long as this object lives.
class Loan {
public:
    Loan(MemoryBudget& budget, size_t count, size_t size, const std::string& what)
        : budget_(budget), bytes_(count * size) {
        budget_.take(count, size, what);
    }
    ~Loan() { budget_.give(bytes_); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

private:
    MemoryBudget& budget_;
    size_t bytes_;
};

/// The bytes behind the buffer views of a model, and the views that decoding adds.
class Storage {
public:
    explicit Storage(MemoryBudget& budget) : budget_(budget) {}
    ~Storage();
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    /// Takes memory that is given back with this object.
    void take(size_t count, size_t size, const std::string& what);
    /// `count` times `size` zeros, taken from the budget.
    std::vector<std::byte> allocate(size_t count, size_t size, const std::string& what);
    /// Bytes that somebody else took from the budget: they are given back with this object.
    void adopt(size_t bytes) { taken_ += bytes; }
    /// Keeps bytes that were taken from the budget already.
    std::span<const std::byte> keep(std::vector<std::byte> bytes);

    /// Appends a view of its own to the model; returns its index.
    int add_view(tinygltf::Model& model, std::vector<std::byte> bytes);

    MemoryBudget& budget() const { return budget_; }

    /// Per view of the model; none: its buffer is a fallback that the file does not contain.
    std::vector<std::optional<std::span<const std::byte>>> views;

private:
    MemoryBudget& budget_;
    size_t taken_ = 0;
    std::deque<std::vector<std::byte>> owned_;
};

} // namespace romascope::gltf
