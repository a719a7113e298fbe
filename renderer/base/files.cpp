// SPDX-License-Identifier: MIT
#include "renderer/base/files.h"

#include "renderer/base/error.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace romascope {
namespace fs = std::filesystem;
namespace {

/// What the system said last, for the end of an error.
std::string last_reason() { return errno ? std::strerror(errno) : "input or output failed"; }

/// Empty if all went well, else the reason.
std::string write_bytes(const fs::path& path, std::span<const std::byte> bytes) {
    errno = 0;
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    return out ? std::string() : last_reason();
}

fs::path user_directory(const char* variable, const char* below_home) {
    // The XDG specification: a relative path counts as none.
    if (const char* folder = std::getenv(variable); folder && *folder == '/')
        return fs::path(folder) / "romascope";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / below_home / "romascope";
    std::error_code code;
    const fs::path temporary = fs::temp_directory_path(code);
    return (code ? fs::path("/tmp") : temporary) / ("romascope-" + std::to_string(getuid()));
}

} // namespace

std::string read_text_file(const fs::path& path) {
    const auto fail = [&](const std::string& why) {
        throw Error("cannot read " + path.string() + ": " + why, kBadInput);
    };
    std::error_code code;
    if (fs::is_directory(path, code))
        fail("it is a folder");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in)
        fail(last_reason());
    // Not by size: pipes and /proc have none.
    std::string text;
    std::array<char, 1 << 16> block;
    while (in.read(block.data(), block.size()) || in.gcount() > 0)
        text.append(block.data(), static_cast<size_t>(in.gcount()));
    if (in.bad())
        fail(last_reason());
    return text;
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
    const auto fail = [&](const std::string& why) {
        throw Error("cannot write " + path.string() + ": " + why);
    };
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::is_directory(status))
        fail("it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        // A rename would put a file in the place of /dev/null or of a pipe.
        if (const std::string why = write_bytes(path, bytes); !why.empty())
            fail(why);
        return;
    }
    // A link stays a link, and the file it points to is replaced.
    const fs::path target = fs::exists(status) ? fs::canonical(path, code) : path;
    if (fs::exists(status) && code)
        fail(code.message());
    if (target.has_parent_path()) {
        fs::create_directories(target.parent_path(), code);
        if (code)
            fail("its folder cannot be made: " + code.message());
    }
    // Process and count keep programs and threads that write the same file out of each other's way.
    static std::atomic<unsigned> count = 0;
    const fs::path temporary =
        target.string() + ".part" + std::to_string(getpid()) + "-" + std::to_string(count++);
    std::string why = write_bytes(temporary, bytes);
    if (why.empty()) {
        fs::rename(temporary, target, code);
        if (code)
            why = code.message();
    }
    if (!why.empty()) {
        fs::remove(temporary, code);
        fail(why);
    }
}

void write_file_atomically(const fs::path& path, const std::string& text) {
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

fs::path cache_directory() { return user_directory("XDG_CACHE_HOME", ".cache"); }
fs::path config_directory() { return user_directory("XDG_CONFIG_HOME", ".config"); }
fs::path state_directory() { return user_directory("XDG_STATE_HOME", ".local/state"); }

} // namespace romascope
