// SPDX-License-Identifier: MIT
// What of the viewer needs no window: moves of the camera, the course of time, the command line it
// copies, where its files go.
#include "app/scene_files.h"
#include "app/viewer/navigate.h"
#include "app/viewer/render_command.h"
#include "app/viewer/screenshot_files.h"
#include "app/viewer/session.h"
#include "app/viewer/start_settings.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/tracers/occupancy/occupancy_knobs.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>
#include <unistd.h>

namespace romascope {
namespace {

namespace fs = std::filesystem;

/// Sets an environment variable for as long as it lives.
class Environment {
public:
    Environment(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name))
            before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~Environment() {
        if (before_)
            setenv(name_, before_->c_str(), 1);
        else
            unsetenv(name_);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

/// A new empty folder that is the user's home.
class ViewerFiles : public testing::Test {
protected:
    fs::path home_ = fs::path(testing::TempDir()) /
                     ("viewer-" + std::to_string(getpid()) + "-" +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
    Environment environment_[5] = {{"HOME", home_},
                                   {"XDG_CONFIG_HOME", (home_ / "config")},
                                   {"XDG_STATE_HOME", (home_ / "state")},
                                   {"XDG_CACHE_HOME", (home_ / "cache")},
                                   {"XDG_PICTURES_DIR", ""}};
    void SetUp() override { fs::create_directories(home_); }
    void TearDown() override { fs::remove_all(home_); }
};

Viewpoint random_viewpoint(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-20.0, 20.0), angle(20.0, 100.0);
    Viewpoint viewpoint;
    viewpoint.eye = {place(random), place(random), place(random)};
    viewpoint.target = {place(random), place(random), place(random)};
    viewpoint.fov = angle(random);
    return viewpoint;
}

glm::dvec3 forward_of(const Viewpoint& viewpoint) {
    return glm::normalize(viewpoint.target - viewpoint.eye);
}

TEST(Viewpoint, TextIsTheSameCameraAgain) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        Viewpoint viewpoint = random_viewpoint(random);
        const Camera camera = parse_camera(viewpoint.text());
        EXPECT_EQ(camera.eye, glm::vec3(viewpoint.eye));
        EXPECT_NEAR(glm::degrees(camera.vertical_fov), viewpoint.fov, 1e-4);
        // Places are rounded to 2^-24 of up to 35 m, and seldom lie within a metre of each other.
        const double rounding = 1e-6 + 1e-5 / std::min(viewpoint.distance(), 1.0);
        EXPECT_LT(glm::distance(glm::dvec3(camera.forward), forward_of(viewpoint)), rounding);
    }
}

TEST(Viewpoint, OfACameraLooksTheSameWay) {
    std::mt19937 random(2);
    Bounds scene;
    scene.add({-3.0f, 0.0f, -4.0f});
    scene.add({3.0f, 5.0f, 4.0f});
    for (int i = 0; i < 1000; ++i) {
        const Camera camera = parse_camera(random_viewpoint(random).text());
        const Viewpoint viewpoint = Viewpoint::of(camera, scene);
        EXPECT_EQ(glm::vec3(viewpoint.eye), camera.eye);
        // Straight up and down are out of bounds by a degree.
        EXPECT_GT(glm::dot(forward_of(viewpoint), glm::dvec3(camera.forward)),
                  std::cos(glm::radians(1.01)));
    }
}

TEST(Viewpoint, OrbitKeepsTargetAndDistance) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-4.0, 4.0);
    for (int i = 0; i < 1000; ++i) {
        Viewpoint viewpoint = random_viewpoint(random);
        const Viewpoint before = viewpoint;
        viewpoint.orbit(angle(random), angle(random));
        EXPECT_EQ(viewpoint.target, before.target);
        EXPECT_NEAR(viewpoint.distance(), before.distance(), 1e-9);
        EXPECT_LT(std::abs(forward_of(viewpoint).y), std::sin(glm::radians(89.1)));
        parse_camera(viewpoint.text()); // would throw for what is no camera
    }
}

TEST(Viewpoint, OrbitToTheRightMovesTheEyeToTheLeft) {
    Viewpoint viewpoint;
    viewpoint.eye = {0.0, 0.0, 10.0};
    viewpoint.target = {0.0, 0.0, 0.0};
    viewpoint.orbit(glm::half_pi<double>(), 0.0);
    EXPECT_NEAR(glm::distance(viewpoint.eye, {-10.0, 0.0, 0.0}), 0.0, 1e-9);
    viewpoint.orbit(0.0, -glm::radians(30.0)); // the view turns down: one stands higher
    EXPECT_NEAR(viewpoint.eye.y, 5.0, 1e-9);
}

TEST(Viewpoint, LookKeepsTheEye) {
    Viewpoint viewpoint;
    viewpoint.eye = {1.0, 2.0, 3.0};
    viewpoint.target = {1.0, 2.0, 0.0};
    viewpoint.look(glm::half_pi<double>(), 0.0);
    EXPECT_EQ(viewpoint.eye, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_NEAR(glm::distance(viewpoint.target, {4.0, 2.0, 3.0}), 0.0, 1e-9);
}

TEST(Viewpoint, WalksAsTheCameraSeesIt) {
    Viewpoint viewpoint;
    viewpoint.eye = {0.0, 0.0, 0.0};
    viewpoint.target = {5.0, 0.0, 0.0}; // +x is ahead, +z to the right
    viewpoint.walk({1.0, 2.0, 3.0});
    EXPECT_NEAR(glm::distance(viewpoint.eye, {3.0, 2.0, 1.0}), 0.0, 1e-9);
    EXPECT_NEAR(viewpoint.distance(), 5.0, 1e-9);
}

TEST(Viewpoint, NeverReachesItsTargetNorTheEndOfTheWorld) {
    Viewpoint viewpoint;
    viewpoint.eye = {100.0, 1.0, 0.0};
    viewpoint.target = {100.0, 1.0, -2.0};
    for (int i = 0; i < 1000; ++i)
        viewpoint.approach(1.5);
    parse_camera(viewpoint.text());
    for (int i = 0; i < 1000; ++i)
        viewpoint.approach(0.5);
    parse_camera(viewpoint.text());
    EXPECT_LE(viewpoint.distance(), kMaxCoordinate * 1.001);
    for (int i = 0; i < 100; ++i)
        viewpoint.walk({0.0, 0.0, 1e8});
    EXPECT_LE(std::abs(viewpoint.eye.z), kMaxCoordinate);
}

TEST(Navigate, StillIsStill) {
    EXPECT_TRUE(is_still({}));
    EXPECT_FALSE(is_still({.wheel = 1.0}));
    EXPECT_FALSE(is_still({.fly = {0.0, 0.0, 1.0}}));
}

TEST(Navigate, APanKeepsTheTargetUnderTheMouse) {
    Viewpoint viewpoint;
    viewpoint.eye = {0.0, 0.0, 10.0};
    viewpoint.target = {0.0, 0.0, 0.0};
    viewpoint.fov = 90.0; // 20 m high at the target
    const Viewpoint after = moved(viewpoint, {.pan = {0.25, 0.0}}, 1.0);
    EXPECT_NEAR(after.eye.x, -5.0, 1e-9); // the origin is a quarter of the height further right
}

TEST(Navigate, TheWheelGoesAwayNoFartherThanTheSceneIsSeen) {
    const double diagonal = 3.0;
    Viewpoint viewpoint;
    viewpoint.eye = {0.0, 0.0, 4.0};
    for (int i = 0; i < 300; ++i)
        viewpoint = moved(viewpoint, {.wheel = -1.0}, diagonal);
    EXPECT_NEAR(viewpoint.distance(), 30.0, 1e-9);
    viewpoint = moved(viewpoint, {.wheel = 1.0}, diagonal);
    EXPECT_LT(viewpoint.distance(), 27.0); // the first notch back counts
    // A camera of the scene that stands farther off stays there.
    viewpoint.eye = {0.0, 0.0, 500.0};
    EXPECT_NEAR(moved(viewpoint, {.wheel = -1.0}, diagonal).distance(), 500.0, 1e-9);
    EXPECT_LT(moved(viewpoint, {.wheel = 1.0}, diagonal).distance(), 450.0);
}

TEST(Navigate, FliesFasterInLargerScenesAndWithShift) {
    Viewpoint viewpoint;
    const auto way = [&](bool fast, double diagonal) {
        const CameraMove move{.fly = {0.0, 0.0, 0.1}, .fast = fast};
        return glm::distance(moved(viewpoint, move, diagonal).eye, viewpoint.eye);
    };
    EXPECT_NEAR(way(false, 20.0), 2.0 * way(false, 10.0), 1e-9);
    EXPECT_GT(way(true, 10.0), 2.0 * way(false, 10.0));
}

TEST(Playback, TimeWraps) {
    EXPECT_NEAR(wrapped_time(9.0, 4.0), 1.0, 1e-12);
    EXPECT_NEAR(wrapped_time(-0.25, 4.0), 3.75, 1e-12);
    EXPECT_NEAR(wrapped_time(-0.5, 0.2), 0.1, 1e-12);
    EXPECT_EQ(wrapped_time(1.0, 0.0), 0.0);
}

TEST(Playback, StartsOverAtTheEnd) {
    Playback playback;
    EXPECT_EQ(playback.advanced(1.0, 0.5, 0.0, 4.0), 1.0); // it stands
    playback.play(true);
    EXPECT_NEAR(playback.advanced(1.0, 0.5, 0.0, 4.0), 1.5, 1e-12);
    EXPECT_NEAR(playback.advanced(3.75, 0.5, 0.0, 4.0), 0.25, 1e-12);
    EXPECT_NEAR(playback.advanced(1.0, 0.5, 25.0, 4.0), 1.04, 1e-12); // by frames, not by the clock
    EXPECT_EQ(playback.advanced(1.0, 0.5, 0.0, 0.0), 1.0);            // nothing that could play
}

TEST(Messages, WhatHoldsIsToldOnceAndWithdrawnWhenItNoLongerDoes) {
    Messages messages;
    const auto texts = [&] {
        std::vector<std::string> all;
        for (const Message& message : messages.all()) {
            EXPECT_EQ(message.times, 1);
            all.push_back(message.text);
        }
        return all;
    };
    using Texts = std::vector<std::string>;
    Texts held;
    messages.tell(Severity::info, "opened");
    messages.replace(Severity::notice, held, {"a", "b"});
    EXPECT_EQ(texts(), (Texts{"opened", "a", "b"}));
    messages.replace(Severity::notice, held, {"b", "c"});
    messages.replace(Severity::notice, held, {"b", "c"});
    EXPECT_EQ(texts(), (Texts{"opened", "b", "c"}));
    EXPECT_EQ(messages.all().back().severity, Severity::notice);
    messages.replace(Severity::notice, held, {});
    EXPECT_EQ(texts(), (Texts{"opened"}));
    EXPECT_TRUE(held.empty());
}

TEST(Session, AChosenTechniqueIsTheCommandLinesWhicheverWasBefore) {
    ASSERT_FALSE(techniques().empty());
    for (const Technique& before : techniques()) {
        for (const Technique& now : techniques()) {
            Settings start(all_knobs());
            start.set(kCamera, "nave");
            start.set(kWidth, 33);
            Settings wanted = start;
            apply_technique(wanted, now.name);
            Messages messages;
            Session session(start, {}, {}, messages);
            session.choose_technique(before.name);
            session.set(kOccupancyResolution, 33); // by hand
            session.choose_technique(now.name);
            EXPECT_EQ(session.settings(), wanted) << before.name << ", then " << now.name;
            EXPECT_EQ(session.technique(), now.name);
            EXPECT_TRUE(messages.all().empty());
        }
    }
}

TEST(Session, AnUnknownTechniqueIsToldAndChangesNothing) {
    Messages messages;
    Session session(Settings(all_knobs()), {}, {}, messages);
    session.choose_technique("roma-hash");
    const Settings before = session.settings();
    session.choose_technique("rona");
    EXPECT_EQ(session.settings(), before);
    EXPECT_EQ(session.technique(), "roma-hash");
    ASSERT_EQ(messages.all().size(), 1u);
    EXPECT_NE(messages.all()[0].text.find("did you mean 'roma'"), std::string::npos);
}

TEST_F(ViewerFiles, CommandNamesWhatIsNotDefault) {
    Settings settings(all_knobs());
    settings.set(kWidth, 640);
    settings.set(kHeight, 360);
    settings.set(kFrames, 1024);
    settings.set(kFps, 25.0);
    settings.set(kTime, 1.5);
    settings.set_text("ao.rays", "7");
    EXPECT_EQ(render_command(find_scene("cornell"), settings, 12, {}),
              "romascope render cornell -o romascope.png --size 640x360 --frames 12 "
              "--set render.time=1.5 --set ao.rays=7");
    settings.set(kCamera, "-1,2,3/0,0,0/45");
    EXPECT_EQ(render_command(home_ / "it's mine.glb", settings, 0, home_ / "shaders"),
              "romascope render '" + (home_ / "it").string() +
                  "'\\''s mine.glb' -o romascope.png --size 640x360 --frames 1 "
                  "--camera=-1,2,3/0,0,0/45 --set render.time=1.5 --set ao.rays=7 --shaders " +
                  (home_ / "shaders").string());
}

TEST_F(ViewerFiles, StartSettingsComeBack) {
    Settings settings(all_knobs());
    EXPECT_FALSE(load_start_settings(settings));
    EXPECT_EQ(settings, Settings(all_knobs()));
    settings.set_text("ao.rays", "7");
    settings.set(kCamera, "nave");
    settings.set(kWidth, 33);
    save_start_settings(settings);
    const fs::path file = home_ / "config" / "romascope" / "viewer.toml";
    EXPECT_EQ(read_text_file(file), "ao.rays = 7\n"); // later defaults hold for the rest
    Settings loaded(all_knobs());
    EXPECT_TRUE(load_start_settings(loaded));
    EXPECT_EQ(to_text(loaded.value(all_knobs().at("ao.rays"))), "7");
    EXPECT_EQ(loaded.get(kCamera), ""); // of one scene, not of all
    EXPECT_TRUE(loaded.is_default(kWidth));
    EXPECT_TRUE(forget_start_settings());
    EXPECT_FALSE(forget_start_settings());
    EXPECT_FALSE(load_start_settings(loaded));
}

TEST_F(ViewerFiles, AFaultInTheStartSettingsNamesTheFile) {
    write_file_atomically(start_settings_file(), "[ao]\nrays = 0\n");
    Settings settings(all_knobs());
    try {
        load_start_settings(settings);
        FAIL() << "0 rays were taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("viewer.toml"), std::string::npos) << error.what();
    }
}

TEST_F(ViewerFiles, ScreenshotsGoToTheUsersPictures) {
    EXPECT_EQ(screenshot_folder(), home_ / "state" / "romascope" / "screenshots");
    fs::create_directories(home_ / "Pictures");
    EXPECT_EQ(screenshot_folder(), home_ / "Pictures" / "romascope");
    fs::create_directories(home_ / "config");
    std::ofstream(home_ / "config" / "user-dirs.dirs")
        << "# comment\nXDG_DESKTOP_DIR=\"$HOME/Desk\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n";
    EXPECT_EQ(screenshot_folder(), home_ / "Bilder" / "romascope");
    const Environment own("XDG_PICTURES_DIR", "/srv/pictures");
    EXPECT_EQ(screenshot_folder(), "/srv/pictures/romascope");
}

TEST_F(ViewerFiles, AScreenshotNeverReplacesAnother) {
    std::set<fs::path> files;
    for (int i = 0; i < 5; ++i) {
        const fs::path file = new_screenshot_file(home_, "folder/hall.glb");
        EXPECT_TRUE(file.filename().string().starts_with("hall-")) << file;
        EXPECT_EQ(file.extension(), ".png");
        EXPECT_TRUE(files.insert(file).second) << file;
        std::ofstream(file) << "x";
    }
}

} // namespace
} // namespace romascope
