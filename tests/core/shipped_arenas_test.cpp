// The shipped scenes that show a property of the floor or of the arena: line, ice, wind, open edge, torus.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/maths/geometry.h"
#include "tests/core/runs.h"

namespace braitenlab::tests::shipped_arenas_test {
namespace {

constexpr std::uint64_t seeds = 10;
constexpr int minute = 60;  // s

// Distance (m) of a point to the middle line of the nearest zone.
float distance_to_line(const Scene& scene, maths::vec2 point) {
    float nearest = INFINITY;
    for (const Zone& zone : scene.zones) {
        const maths::vec2 ahead = maths::direction(zone.heading), from = point - maths::vec2{zone.x, zone.y};
        const float along = std::clamp(maths::dot(from, ahead), -zone.length / 2, zone.length / 2);
        nearest = std::min(nearest, maths::distance(from, ahead * along));
    }
    return nearest;
}

// The largest distance (m) of any vehicle to the line within 60 s.
float farthest_from_line(const Scene& scene, std::uint64_t seed) {
    float farthest = 0;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        for (const VehicleView& it : now.vehicles) farthest = std::max(farthest, distance_to_line(scene, position(it)));
    });
    return farthest;
}

TEST(ShippedScenes, LineFollowersStayOnTheLineAndDriveMoreThanOneAndAHalfRounds) {
    const Scene scene = shipped_scene("line-follower");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        EXPECT_LT(farthest_from_line(scene, seed), 0.3f) << seed;
        std::vector<float> turned(2, 0.0f), before;
        watch_run(scene, seed, minute, [&](const Snapshot& now) {
            for (std::size_t i = 0; i < 2; ++i) {
                const float angle = maths::arctangent2(now.vehicles[i].y, now.vehicles[i].x);
                if (before.size() == 2) turned[i] += maths::wrap_angle(angle - before[i]);
                before.resize(2), before[i] = angle;
            }
        });
        for (const float angle : turned) EXPECT_GT(angle, 1.5f * 2 * maths::pi) << seed;
    }
}

TEST(ShippedScenes, LineFollowersWithCrossedWiresLeaveTheLine) {
    Scene scene = shipped_scene("line-follower");
    scene.kinds[0].brain = make_graph({.LR = 0.8f, .RL = 0.8f, .LM = -0.14f, .RM = -0.14f});
    for (std::uint64_t seed = 1; seed <= seeds / 2; ++seed) EXPECT_GT(farthest_from_line(scene, seed), 1) << seed;
}

// Distances (m) of a vehicle to the lamp of the same index, from 15 s to 60 s.
struct Swing {
    float nearest = INFINITY, farthest = 0;
};

Swing swing_of(const Scene& scene, std::uint64_t seed, std::size_t vehicle) {
    Swing swing;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        if (now.seconds < 15) return;
        const maths::vec2 lamp{now.sources[vehicle].x, now.sources[vehicle].y};
        const float distance = maths::distance(position(now.vehicles[vehicle]), lamp);
        swing = {std::min(swing.nearest, distance), std::max(swing.farthest, distance)};
    });
    return swing;
}

TEST(ShippedScenes, AVehicleSlidesOffItsCircleOnIceOnly) {
    const Scene ice = shipped_scene("ice-rink");
    Scene without_ice = ice;
    without_ice.zones.clear();
    int slides = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Swing on_ice = swing_of(ice, seed, 0), on_floor = swing_of(ice, seed, 1),
                    melted = swing_of(without_ice, seed, 0);
        slides += on_ice.farthest > on_ice.nearest + 2 && on_ice.farthest > on_floor.farthest + 1;
        EXPECT_LT(on_floor.farthest, on_floor.nearest + 0.1f) << seed;
        EXPECT_LT(melted.farthest, melted.nearest + 0.1f) << seed;
    }
    EXPECT_GE(slides, 9);
}

// How often each vehicle of a torus crosses the seam within 60 s, and its smallest and largest x in the second half.
struct Crossing {
    std::vector<int> times = std::vector<int>(3, 0);
    std::vector<float> low = std::vector<float>(3, INFINITY), high = std::vector<float>(3, -INFINITY);
};

Crossing watch_wind(const Scene& scene, std::uint64_t seed) {
    Crossing crossing;
    std::vector<float> before;
    int tick = 0;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        for (std::size_t i = 0; i < 3; ++i) {
            const float x = now.vehicles[i].x;
            if (before.size() == 3 && before[i] - x > scene.arena.width / 2) ++crossing.times[i];
            before.resize(3), before[i] = x;
            if (tick < minute / 2 * 60) continue;
            crossing.low[i] = std::min(crossing.low[i], x), crossing.high[i] = std::max(crossing.high[i], x);
        }
        ++tick;
    });
    return crossing;
}

TEST(ShippedScenes, VehiclesInTheWindTunnelStopWhereTheWindEqualsTheirMotors) {
    const Scene scene = shipped_scene("wind-tunnel");
    Scene calm = scene;
    calm.zones.clear();
    const auto front = [&](std::size_t zone) { return scene.zones[zone].x - scene.zones[zone].length / 2; };
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Crossing windy = watch_wind(scene, seed), still = watch_wind(calm, seed);
        for (const std::size_t i : {0U, 1U}) {  // the weak and the middling vehicle
            EXPECT_EQ(windy.times[i], 0) << seed;
            EXPECT_NEAR(windy.low[i], front(i + 1), 1.5f) << seed;
            EXPECT_NEAR(windy.high[i], front(i + 1), 1.5f) << seed;
            EXPECT_GE(still.times[i], 3) << seed;
        }
        EXPECT_GE(windy.times[2], 3) << seed;
    }
}

TEST(ShippedScenes, TheRobotWithEightEyesNeverStopsAtAnObstacle) {
    const Scene scene = shipped_scene("eight-eyes");
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::vector<maths::vec2> way;
        watch_run(scene, seed, 3 * minute, [&](const Snapshot& now) { way.push_back(position(now.vehicles[0])); });
        float driven = 0;
        int standing = 0, longest = 0;
        for (std::size_t i = 1; i < way.size(); ++i) {
            driven += maths::distance(way[i - 1], way[i]);
            standing = maths::distance(way[i - 1], way[i]) < 1e-4f ? standing + 1 : 0;  // slower than 6 mm/s
            longest = std::max(longest, standing);
        }
        EXPECT_GT(driven, 7) << seed;
        EXPECT_LT(longest, 120) << seed;
    }
}

// How often each vehicle falls off the table within 60 s: a fall is a jump to another place.
std::vector<int> falls(const Scene& scene, std::uint64_t seed) {
    std::vector<int> count;
    std::vector<maths::vec2> before;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        count.resize(now.vehicles.size(), 0);
        for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
            if (before.size() > i) count[i] += maths::distance(before[i], position(now.vehicles[i])) > 0.5f;
            before.resize(std::max(before.size(), i + 1)), before[i] = position(now.vehicles[i]);
        }
    });
    return count;
}

TEST(ShippedScenes, VehiclesThatSenseTheRimStayOnTheTableAndTheOtherFalls) {
    const Scene scene = shipped_scene("table-edge");
    Scene without_rim = scene;
    without_rim.zones.clear();
    int careful = 0, careless = 0, unwarned = 0;
    for (std::uint64_t seed = 1; seed <= 2 * seeds; ++seed) {
        const std::vector<int> count = falls(scene, seed), bare = falls(without_rim, seed);
        careful += count[0] + count[1];
        careless += count[2];
        EXPECT_GE(count[2], 1) << seed;
        unwarned += bare[0] + bare[1];
    }
    EXPECT_LE(careful, 2) << "in 20 runs";
    EXPECT_GT(careless, 100);
    EXPECT_GT(unwarned, 100);
}

TEST(ShippedScenes, FollowersOnATorusStayBehindTheirLeadersAcrossTheSeam) {
    const Scene scene = shipped_scene("torus");
    Scene walled = scene;
    walled.arena.edge = Boundary::wall;
    const auto widest_gap = [](const Scene& in, std::uint64_t seed, int& crossings) {
        float widest = 0;
        std::vector<maths::vec2> before;
        const auto shortest = [&](float d, float length) { return d - length * std::round(d / length); };
        watch_run(in, seed, minute, [&](const Snapshot& now) {
            std::vector<maths::vec2> at;
            for (const VehicleView& it : now.vehicles) at.push_back(position(it));
            for (std::size_t i = 0; i < at.size() && !before.empty(); i += 2)
                crossings += maths::distance(at[i], before[i]) > 2;
            before = at;
            for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
                const maths::vec2 d = at[i] - at[i + 1];
                const float x = shortest(d.x, in.arena.width), y = shortest(d.y, in.arena.height);
                widest = std::max(widest, std::hypot(x, y));
            }
        });
        return widest;
    };
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        int crossings = 0;
        EXPECT_LT(widest_gap(scene, seed, crossings), 3.5f) << seed;
        EXPECT_GE(crossings, 15) << seed;
        int none = 0;
        (void)widest_gap(walled, seed, none);
        EXPECT_EQ(none, 0) << seed;
    }
}

}  // namespace
}  // namespace braitenlab::tests::shipped_arenas_test
