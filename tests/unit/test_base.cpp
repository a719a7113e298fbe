// SPDX-License-Identifier: MIT
#include "renderer/base/did_you_mean.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/memory.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace romascope {
namespace {
namespace fs = std::filesystem;

/// A fresh folder that goes away with the test.
class Files : public testing::Test {
protected:
    Files() {
        std::string pattern = (fs::temp_directory_path() / "romascope-test-XXXXXX").string();
        if (!mkdtemp(pattern.data()))
            throw std::runtime_error("no temporary folder");
        folder_ = pattern;
    }
    ~Files() override {
        std::error_code code;
        fs::remove_all(folder_, code);
    }
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    fs::path folder_;
};

/// The error that `action` ends with; fails the test if there is none.
template <class Action>
Error error_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "no Error";
    return Error("");
}

TEST_F(Files, AnyBytesComeBack) {
    std::mt19937 random(7);
    // Around the size of one block of the reader, too.
    for (const size_t size : {0, 1, 100, (1 << 16) - 1, 1 << 16, (1 << 16) + 1, 300000}) {
        std::string text(size, '\0');
        for (char& c : text)
            c = static_cast<char>(random());
        write_file_atomically(folder_ / "a", text);
        EXPECT_EQ(read_text_file(folder_ / "a"), text) << size;
    }
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, WritesSpansAndMakesParents) {
    const std::array<std::byte, 3> bytes{std::byte{1}, std::byte{0}, std::byte{255}};
    write_file_atomically(folder_ / "b/c/d.bin", bytes);
    EXPECT_EQ(read_text_file(folder_ / "b/c/d.bin"), std::string("\x01\x00\xff", 3));
}

TEST_F(Files, ShorterContentReplacesLonger) {
    write_file_atomically(folder_ / "a", "a long text");
    write_file_atomically(folder_ / "a", "short");
    EXPECT_EQ(read_text_file(folder_ / "a"), "short");
}

TEST_F(Files, ReadingWhatIsNotThere) {
    const Error missing = error_of([&] { read_text_file(folder_ / "none.toml"); });
    EXPECT_EQ(missing.exit_status(), kBadInput);
    EXPECT_EQ(missing.what(),
              "cannot read " + (folder_ / "none.toml").string() + ": No such file or directory");
    const Error folder = error_of([&] { read_text_file(folder_); });
    EXPECT_EQ(folder.exit_status(), kBadInput);
    EXPECT_EQ(folder.what(), "cannot read " + folder_.string() + ": it is a folder");
}

TEST_F(Files, FailuresLeaveNothingBehind) {
    write_file_atomically(folder_ / "file", "kept");
    const Error below = error_of([&] { write_file_atomically(folder_ / "file/x", "text"); });
    EXPECT_EQ(below.exit_status(), 1);
    EXPECT_NE(std::string(below.what()).find((folder_ / "file/x").string()), std::string::npos);
    EXPECT_NE(std::string(below.what()).find("Not a directory"), std::string::npos);
    fs::create_directory(folder_ / "sub");
    EXPECT_THROW(write_file_atomically(folder_ / "sub", "text"), Error);
    EXPECT_THROW(write_file_atomically(folder_ / std::string(300, 'n'), "text"), Error);
    EXPECT_EQ(read_text_file(folder_ / "file"), "kept");
    EXPECT_EQ(entries(), 2);
}

TEST_F(Files, LinksStayLinks) {
    fs::create_directory(folder_ / "real");
    write_file_atomically(folder_ / "real/file", "old");
    fs::create_symlink("real/file", folder_ / "link");
    write_file_atomically(folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(read_text_file(folder_ / "real/file"), "new");
}

// Only with things of our own folder: run as root with a mistake in the code, a test that wrote to
// /dev/null would put a file in its place.
TEST_F(Files, PipesAreWrittenNotReplaced) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDWR | O_NONBLOCK); // so that the writer need not wait
    ASSERT_GE(reader, 0);
    write_file_atomically(pipe, "text");
    fs::create_symlink("pipe", folder_ / "link");
    write_file_atomically(folder_ / "link", "more");
    std::array<char, 16> received;
    const ssize_t count = read(reader, received.data(), received.size());
    close(reader);
    EXPECT_EQ(std::string(received.data(), static_cast<size_t>(std::max<ssize_t>(count, 0))),
              "textmore");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(entries(), 2);
}

TEST_F(Files, WhatCannotBeWrittenIsKept) {
    const fs::path path = folder_ / "socket"; // opening a socket as a file fails
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(path.string().size(), sizeof address.sun_path);
    path.string().copy(address.sun_path, sizeof address.sun_path - 1);
    const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_GE(descriptor, 0);
    ASSERT_EQ(bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const Error error = error_of([&] { write_file_atomically(path, "text"); });
    close(descriptor);
    EXPECT_EQ(error.what(), "cannot write " + path.string() + ": No such device or address");
    EXPECT_TRUE(fs::is_socket(path));
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ReadersNeverSeeHalfOfAFile) {
    const fs::path path = folder_ / "shared";
    const auto content = [](int writer) {
        return std::string(200000, static_cast<char>('a' + writer));
    };
    write_file_atomically(path, content(0));
    std::atomic<int> running = 2, failures = 0;
    std::vector<std::thread> writers;
    for (int writer = 0; writer < 2; ++writer)
        writers.emplace_back([&, writer] {
            for (int i = 0; i < 50; ++i) {
                try {
                    write_file_atomically(path, content(writer));
                } catch (const Error&) {
                    ++failures;
                }
            }
            --running;
        });
    int reads = 0, halves = 0;
    do {
        const std::string text = read_text_file(path);
        halves += text != content(0) && text != content(1);
        ++reads;
    } while (running > 0);
    for (std::thread& writer : writers)
        writer.join();
    EXPECT_EQ(halves, 0) << "of " << reads;
    EXPECT_EQ(failures, 0);
    EXPECT_EQ(entries(), 1);
}

/// An environment variable for the length of a scope; null: unset.
class Environment {
public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name))
            old_ = old;
        set(value);
    }
    ~Environment() { set(old_ ? old_->c_str() : nullptr); }

private:
    void set(const char* value) const { value ? setenv(name_, value, 1) : unsetenv(name_); }
    const char* name_;
    std::optional<std::string> old_;
};

TEST(CacheDirectory, FollowsTheXdgSpecification) {
    const Environment home("HOME", "/home/someone");
    {
        const Environment cache("XDG_CACHE_HOME", "/var/cache/x");
        EXPECT_EQ(cache_directory(), "/var/cache/x/romascope");
    }
    for (const char* none : {static_cast<const char*>(nullptr), "", "relative/path"}) {
        const Environment cache("XDG_CACHE_HOME", none);
        EXPECT_EQ(cache_directory(), "/home/someone/.cache/romascope");
    }
}

TEST(CacheDirectory, WorksWithoutAHome) {
    const Environment cache("XDG_CACHE_HOME", nullptr);
    const Environment home("HOME", nullptr);
    const std::string name = "romascope-" + std::to_string(getuid());
    {
        const Environment temporary("TMPDIR", nullptr);
        EXPECT_EQ(cache_directory(), fs::path("/tmp") / name);
    }
    const Environment temporary("TMPDIR", "/there/is/no/such/folder");
    EXPECT_EQ(cache_directory(), fs::path("/tmp") / name);
}

const std::vector<std::string> kNames = {"roma.angular_resolution", "occupancy.resolution",
                                         "ao.radius", "ao.rays", "seed"};

TEST(NearestName, FindsTypingMistakes) {
    EXPECT_EQ(nearest_name("ao.radios", kNames), "ao.radius");
    EXPECT_EQ(nearest_name("ao.ardius", kNames), "ao.radius");
    EXPECT_EQ(nearest_name("AO.RAYS", kNames), "ao.rays");
    EXPECT_EQ(nearest_name("sed", kNames), "seed");
    EXPECT_EQ(nearest_name("roma.angularresolution", kNames), "roma.angular_resolution");
}

TEST(NearestName, TriesTheLastWordAlone) {
    EXPECT_EQ(nearest_name("angular_resolution", kNames), "roma.angular_resolution");
    EXPECT_EQ(nearest_name("resolution", kNames), "occupancy.resolution");
    EXPECT_EQ(nearest_name("rays", {"ao.rays", "rays"}), "rays");
}

TEST(NearestName, SwappedNeighboursCountOnce) {
    // "ba" is one swap from "ab" but two changes from "cd".
    EXPECT_EQ(nearest_name("ba", {"cd", "ab"}), "ab");
    EXPECT_EQ(nearest_name("abdc", {"abxx", "abcd"}), "abcd");
}

TEST(NearestName, Ends) {
    EXPECT_EQ(nearest_name("x", {}), "");
    EXPECT_EQ(nearest_name("abx", {"abc", "abd"}), "abc"); // the first of equals
    EXPECT_EQ(nearest_name("", {"abc", "a", "b"}), "");
    EXPECT_EQ(nearest_name("zzz", {"abc"}), "");
}

TEST(NearestName, IsNotFarOff) {
    const std::vector<std::string> keys = {"roma.iterations", "roma.sampling",    "hash.footprint",
                                           "temporal.length", "taa.length",       "view.map",
                                           "ao.radius",       "occupancy.builder"};
    for (const char* far : {"roma.directions", "a", "map.view", "roma.rays", "iterations.roma",
                            "roma", "view.radios", "", "."})
        EXPECT_EQ(nearest_name(far, keys), "") << far;
    EXPECT_EQ(nearest_name("roma.iteration", keys), "roma.iterations");
    EXPECT_EQ(nearest_name("roma.sampler", keys), "roma.sampling");
    EXPECT_EQ(nearest_name("romasampling", keys), "roma.sampling");
}

TEST(NearestName, OfWordsInSeveralGroupsTheNearestGroupCounts) {
    const std::vector<std::string> keys = {"temporal.length", "taa.length", "hash.footprint"};
    EXPECT_EQ(nearest_name("taa.lenght", keys), "taa.length");
    EXPECT_EQ(nearest_name("ta.length", keys), "taa.length");
    EXPECT_EQ(nearest_name("temporal.lengths", keys), "temporal.length");
    EXPECT_EQ(nearest_name("view.footprint", keys), "hash.footprint"); // the word is written right
}

TEST(DidYouMean, IsSilentWhereNothingIsNear) {
    EXPECT_EQ(did_you_mean("sed", kNames), ": did you mean 'seed'?");
    EXPECT_EQ(did_you_mean("sed", kNames, "; "), "; did you mean 'seed'?");
    EXPECT_EQ(did_you_mean("directions", kNames), "");
}

TEST(NearestName, EveryNameIsNearestToItselfAndToOneSlip) {
    std::mt19937 random(11);
    const auto below = [&](size_t n) {
        return std::uniform_int_distribution<size_t>(0, n - 1)(random);
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string& name = kNames[below(kNames.size())];
        EXPECT_EQ(nearest_name(name, kNames), name);
        std::string slip = name;
        const size_t at = below(slip.size());
        switch (below(4)) {
        case 0:
            slip.erase(at, 1);
            break;
        case 1:
            slip.insert(at, 1, 'q');
            break;
        case 2:
            slip[at] = 'q';
            break;
        default:
            std::swap(slip[at], slip[(at + 1) % slip.size()]);
        }
        if (slip.size() > 5) { // short words have real neighbours
            EXPECT_EQ(nearest_name(slip, kNames), name) << slip;
        }
    }
}

} // namespace
TEST(Memory, amounts_are_read_and_written) {
    EXPECT_EQ(parse_bytes("1234"), 1234u);
    EXPECT_EQ(parse_bytes("512MiB"), size_t{512} << 20);
    EXPECT_EQ(parse_bytes("1.5 GiB"), size_t{3} << 29);
    EXPECT_EQ(parse_bytes("2GB"), 2'000'000'000u);
    for (const char* text :
         {"", "0", "-1", "lots", "1 XiB", "4GiBs", "nan", "inf", "1e300GiB", "0x10"})
        EXPECT_THROW(parse_bytes(text), Error) << text;
    EXPECT_EQ(format_bytes(1023), "1023 B");
    EXPECT_EQ(format_bytes(size_t{3} << 29), "1.5 GiB");
    EXPECT_GT(free_memory(), size_t{1} << 20);
    EXPECT_LT(default_memory_limit(), free_memory() + (size_t{1} << 30));
}

TEST(Memory, budget_refuses_before_it_overflows) {
    MemoryBudget budget(1000);
    budget.take(10, 60, "first");
    EXPECT_EQ(budget.taken(), 600u);
    EXPECT_THROW(budget.take(401, 1, "second"), Error);
    EXPECT_THROW(budget.take(SIZE_MAX, SIZE_MAX, "third"), Error);
    EXPECT_THROW(budget.take(SIZE_MAX / 2, 3, "fourth"), Error);
    EXPECT_EQ(budget.taken(), 600u);
    budget.take(400, 1, "the rest");
    EXPECT_THROW(budget.take(1, 1, "one more"), Error);
    budget.take(SIZE_MAX, 0, "nothing");
    budget.give(500);
    budget.take(500, 1, "again");
    try {
        budget.take(size_t{1} << 62, 1, "scene");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_status(), kBadInput);
        EXPECT_NE(std::string(error.what()).find("--max-memory"), std::string::npos)
            << error.what();
    }
}

} // namespace romascope
