// SPDX-License-Identifier: MIT
// A monkey at the window: it turns knobs at random through their whole range, moves the camera,
// plays, opens scenes, and looks whether all of it stays whole.
//
//     monkey SECONDS [SEED]
//
// Fails for a GL error or any other error that is told, a picture with NaN, a picture that is not
// drawn, or memory that is allocated anew, by more than 1 % of what the program holds, when it does
// all that it has done a second time. Left out, as nothing could be learnt from how long they take
// here: pictures above 640 pixels, maps of a resolution and of directions that would each take a
// software renderer minutes together.
#include "app/scene_files.h"
#include "app/viewer/interface/known_names.h"
#include "app/viewer/render_command.h"
#include "app/viewer/viewer.h"
#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/scene/gltf/import.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <malloc.h>
#include <random>
#include <unistd.h>

namespace romascope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMostGrowth = 0.01;
constexpr int kLargestPicture = 640;
/// What real knobs without an end are turned up to.
constexpr double kFar = 1e6;

/// What is allocated on the heap. Not what is resident:
/// the heap's gaps come and go by several percent.
size_t allocated_bytes() {
    const struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

size_t resident_bytes() {
    std::ifstream file("/proc/self/statm");
    size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

class Monkey {
public:
    Monkey(Viewer& viewer, uint32_t seed) : viewer_(viewer), seed_(seed), random_(seed) {}

    /// From here on it does once more what it did from the start.
    void begin_again() {
        random_.seed(seed_);
        turns_ = 0;
    }

    /// The next thing it does, and a few pictures of it.
    void act() {
        turn_something();
        if (turns_ % 40 == 0)
            open_some_scene();
        look();
    }

    int turns() const { return turns_; }
    int looks() const { return looks_; }

    void open(const std::string& name) {
        session().open(name);
        viewer_.step();
        check("opened " + name);
    }

    void check(const std::string& when) {
        for (const Message& message : viewer_.messages().all())
            if (message.severity == Severity::error)
                throw Error(
                    fmt::format("{}: {}\n{}", when, message.text, session().settings().to_toml()));
        if (session().failed())
            throw Error(fmt::format("{}: nothing is drawn", when));
        for (const float value : session().pipeline()->picture().data)
            if (!std::isfinite(value))
                throw Error(fmt::format("{}: {} in the picture\n{}", when, value, command()));
        ++looks_;
    }

private:
    void turn_something() {
        const auto& knobs = session().settings().table().all();
        const int kind = whole(0, 19);
        if (kind == 0)
            session().reset_all();
        else if (kind == 1)
            session().choose_camera(static_cast<size_t>(whole(0, 3)));
        else if (kind == 2)
            session().fit_view();
        else if (kind == 3)
            fly();
        else if (kind == 4)
            session().play(!session().playback().playing());
        else
            turn(*knobs[static_cast<size_t>(whole(0, static_cast<int>(knobs.size()) - 1))]);
        ++turns_;
    }

    void open_some_scene() {
        const auto scenes = built_in_scenes();
        open(scenes[static_cast<size_t>(whole(0, static_cast<int>(scenes.size()) - 1))].name);
    }

    /// A few frames; throws Error for whatever is not as it should be.
    void look() {
        for (int i = whole(1, 2); i > 0; --i)
            viewer_.step();
        check(fmt::format("turn {}", turns_));
    }

    Session& session() { return viewer_.session(); }
    std::string command() {
        return render_command(session().scene_file(), session().settings(), 1, {});
    }
    int whole(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    double real(double low, double high) {
        return std::uniform_real_distribution(low, high)(random_);
    }

    void fly() {
        Viewpoint viewpoint = session().viewpoint();
        viewpoint.orbit(real(-1.0, 1.0), real(-1.0, 1.0));
        viewpoint.approach(real(0.7, 1.5));
        session().set_viewpoint(viewpoint);
    }

    double number(const KnobBase& knob) {
        const double low = std::isfinite(knob.minimum()) ? knob.minimum() : -kFar;
        double high = std::isfinite(knob.maximum()) ? knob.maximum() : kFar;
        if (&knob == &kWidth || &knob == &kHeight)
            high = kLargestPicture;
        switch (whole(0, 5)) {
        case 0:
            return low;
        case 1:
            return std::isfinite(knob.maximum()) ? high : knob.maximum();
        case 2: // many small ones
            return low + (high - low) * std::pow(10.0, real(-6.0, 0.0));
        default:
            return real(low, high);
        }
    }

    template <class T>
    std::string one_of(const std::vector<T>& names) {
        return names.empty()
                   ? std::string()
                   : std::string(
                         names[static_cast<size_t>(whole(0, static_cast<int>(names.size()) - 1))]);
    }

    std::string text(const KnobBase& knob) {
        std::vector<std::string> names;
        for (const KnownName& name : known_names(knob, session()).names)
            names.push_back(name.value);
        return one_of(names);
    }

    void turn(const KnobBase& knob) {
        switch (knob.kind()) {
        case KnobKind::boolean:
            session().set(knob, whole(0, 1) == 1);
            break;
        case KnobKind::integer:
            session().set(knob, static_cast<int64_t>(number(knob)));
            break;
        case KnobKind::real:
            session().set(knob, number(knob));
            break;
        case KnobKind::choice:
            session().set(knob, one_of(knob.choices()));
            break;
        case KnobKind::text:
            session().set(knob, text(knob));
            break;
        }
        // Either can be as large as it likes, but not both.
        Settings settings = session().settings();
        const KnobBase& resolution = settings.table().at("occupancy.resolution");
        const KnobBase& directions = settings.table().at("roma.angular_resolution");
        const auto value = [&](const KnobBase& of) {
            return std::get<int64_t>(settings.value(of));
        };
        if (value(resolution) > 128 && value(directions) > 4)
            session().reset(&knob == &resolution ? directions : resolution);
    }

    Viewer& viewer_;
    uint32_t seed_;
    std::mt19937 random_;
    int turns_ = 0, looks_ = 0;
};

void run(double seconds, uint32_t seed) {
    Settings settings(all_knobs());
    settings.set(kWidth, 200);
    settings.set(kHeight, 120);
    const std::string home_scene = "cornell";
    const auto file = find_scene(home_scene);
    ViewerOptions options;
    options.exact_size = true;
    options.gl_debug = true;
    Viewer viewer(options, settings, file, load_gltf(file, default_memory_limit()));
    Monkey monkey(viewer, seed);

    // The least of a few times: pools of the driver and the heap take and give by the megabyte.
    const auto rest = [&] {
        monkey.open(home_scene);
        viewer.session().reset_all();
        viewer.session().play(false);
        viewer.session().follow_window(true);
        size_t least = std::numeric_limits<size_t>::max();
        for (int i = 0; i < 5; ++i) {
            monkey.open(home_scene);
            for (int frame = 0; frame < 4; ++frame)
                viewer.step();
            least = std::min(least, allocated_bytes());
        }
        monkey.check("at rest");
        return least;
    };
    // What is only used once (a driver's caches, a font) is there after the first time.
    const Clock::time_point begin = Clock::now();
    while (std::chrono::duration<double>(Clock::now() - begin).count() < 0.5 * seconds)
        monkey.act();
    const int turns = monkey.turns();
    const size_t before = rest();
    monkey.begin_again();
    while (monkey.turns() < turns)
        monkey.act();
    const size_t after = rest();
    const size_t resident = resident_bytes();
    const double growth =
        (static_cast<double>(after) - static_cast<double>(before)) / static_cast<double>(resident);
    fmt::print("{} turns twice, {} pictures, seed {}: {} allocated half-way, {} at the end, "
               "{:+.2f} % of {} "
               "resident\n",
               turns, monkey.looks(), seed, format_bytes(before), format_bytes(after),
               100.0 * growth, format_bytes(resident));
    if (growth > kMostGrowth)
        throw Error(fmt::format("memory grew by {:.2f} %", 100.0 * growth));
}

} // namespace
} // namespace romascope

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: monkey SECONDS [SEED]\n");
        return 2;
    }
    try {
        const auto seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : std::random_device()();
        romascope::run(std::atof(argv[1]), static_cast<uint32_t>(seed));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "monkey: {}\n", error.what());
        return 1;
    }
}
