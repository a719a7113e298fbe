// SPDX-License-Identifier: MIT
#include "renderer/base/files.h"

#include "renderer/base/error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace romascope {
namespace fs = std::filesystem;

std::string read_text_file(const fs::path& path) {
    std::error_code code;
    if (fs::is_directory(path, code))
        throw Error("cannot read " + path.string() + ": it is a folder", kBadInput);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error("cannot read " + path.string() + ": " + std::strerror(errno), kBadInput);
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
    std::error_code code;
    if (path.has_parent_path())
        fs::create_directories(path.parent_path(), code);
    // The process id keeps two programs that write the same file out of each other's way.
    const fs::path temporary = path.string() + ".part" + std::to_string(getpid());
    const auto fail = [&](const std::string& why) {
        fs::remove(temporary, code);
        throw Error("cannot write " + path.string() + ": " + why);
    };
    errno = 0;
    std::ofstream out(temporary, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out)
        fail(errno ? std::strerror(errno) : "the disk refused it");
    fs::rename(temporary, path, code);
    if (code)
        fail(code.message());
}

void write_file_atomically(const fs::path& path, const std::string& text) {
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

fs::path cache_directory() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return fs::path(cache) / "romascope";
    if (const char* home = std::getenv("HOME"); home && *home)
        return fs::path(home) / ".cache" / "romascope";
    return fs::temp_directory_path() / ("romascope-" + std::to_string(getuid()));
}

} // namespace romascope
