// SPDX-License-Identifier: MIT
#include "renderer/base/memory.h"

#include "renderer/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

namespace romascope {
namespace {

constexpr size_t kUnknown = std::numeric_limits<size_t>::max();

/// A file that holds one number; none if there is no such file, or the word "max".
std::optional<size_t> number_in(const std::string& file) {
    std::ifstream in(file);
    size_t value = 0;
    return in >> value ? std::optional(value) : std::nullopt;
}

/// What the control group of this process leaves: version 2, else version 1.
size_t free_in_control_group() {
    std::string group;
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::"))
            group = line.substr(3);
    size_t least = kUnknown;
    const auto look = [&](const std::string& limit_file, const std::string& use_file) {
        const auto limit = number_in(limit_file);
        const auto use = number_in(use_file);
        if (limit && use)
            least = std::min(least, *limit > *use ? *limit - *use : 0);
    };
    // Within a container the group's own folder is often mounted as the root.
    for (const std::string& folder : {"/sys/fs/cgroup" + group, std::string("/sys/fs/cgroup")})
        look(folder + "/memory.max", folder + "/memory.current");
    look("/sys/fs/cgroup/memory/memory.limit_in_bytes",
         "/sys/fs/cgroup/memory/memory.usage_in_bytes");
    return least;
}

} // namespace

size_t free_memory() {
    std::ifstream facts("/proc/meminfo");
    std::string name, rest;
    size_t kibibytes = 0;
    size_t available = kUnknown;
    while (facts >> name >> kibibytes && std::getline(facts, rest))
        if (name == "MemAvailable:")
            available = kibibytes * 1024;
    return std::min(available, free_in_control_group());
}

size_t default_memory_limit() { return free_memory() / 10 * 9; }

size_t parse_bytes(const std::string& text) {
    constexpr std::pair<const char*, double> kUnits[] = {
        {"", 1.0},       {"B", 1.0},  {"KiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30},
        {"TiB", 0x1p40}, {"KB", 1e3}, {"MB", 1e6},     {"GB", 1e9},     {"TB", 1e12}};
    double number = 0.0;
    const char* const end = text.data() + text.size();
    auto [unit, code] = std::from_chars(text.data(), end, number);
    while (code == std::errc() && unit != end && *unit == ' ')
        ++unit;
    for (const auto& [name, size] : kUnits)
        if (code == std::errc() && std::string(unit, end) == name && number > 0.0 &&
            number * size < 0x1p63)
            return std::max(size_t{1}, static_cast<size_t>(number * size));
    throw Error(fmt::format("'{}' is not an amount of memory, like 512MiB, 4GiB or 1.5GB", text),
                kBadInput);
}

std::string format_bytes(size_t bytes) {
    constexpr std::array kUnits = {"KiB", "MiB", "GiB", "TiB"};
    if (bytes < 1024)
        return fmt::format("{} B", bytes);
    double value = static_cast<double>(bytes) / 1024.0;
    size_t unit = 0;
    for (; value >= 1024.0 && unit + 1 < kUnits.size(); ++unit)
        value /= 1024.0;
    return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

void MemoryBudget::take(size_t count, size_t size, const std::string& what) {
    const size_t left = limit_ - std::min(limit_, taken_);
    if (size == 0 || count <= left / size) {
        taken_ += count * size;
        return;
    }
    const double needed =
        static_cast<double>(taken_) + static_cast<double>(count) * static_cast<double>(size);
    throw Error(
        fmt::format("{}: needs at least {} of memory, the limit is {}; raise --max-memory, "
                    "if there is more",
                    what,
                    needed < 0x1p63 ? format_bytes(static_cast<size_t>(needed)) : "more than 8 EiB",
                    format_bytes(limit_)),
        kBadInput);
}

} // namespace romascope
