// SPDX-License-Identifier: MIT
#include "renderer/frame/notices.h"

#include "renderer/estimators/ambient_occlusion/ambient_occlusion.h"
#include "renderer/frame/technique.h"

#include <gtest/gtest.h>

namespace romascope {
namespace {

/// As the hash counts with two rays a pixel, where 1000 pixels see a surface.
std::vector<std::string> told_of(uint64_t failed) {
    Settings settings(all_knobs());
    settings.set(kAoRays, 2);
    return notices_of(settings, std::vector<NamedCount>{{"hash rays traced", 600},
                                                        {"hash rays saved", 1400},
                                                        {"hash failed pixels", failed}});
}

TEST(Notices, TellOfAFullHashTableAboveOnePercentOfThePixels) {
    EXPECT_TRUE(told_of(0).empty());
    EXPECT_TRUE(told_of(10).empty());
    ASSERT_EQ(told_of(11).size(), 1u);
    EXPECT_EQ(told_of(11).front(),
              "hash table full: 11 of 1000 pixels found no room in the last frame and show their "
              "own rays; pictures may differ from run to run; raise hash.capacity");
}

TEST(Notices, TellNothingOfFramesWithoutAHash) {
    const Settings settings(all_knobs());
    EXPECT_TRUE(notices_of(settings, std::vector<NamedCount>{}).empty());
    EXPECT_TRUE(notices_of(settings, std::vector<NamedCount>{{"rays", 100}}).empty());
}

} // namespace
} // namespace romascope
