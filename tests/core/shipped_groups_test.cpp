// The shipped scenes with several vehicles that sense one another, and the scene of all drivers.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/maths/angle.h"
#include "tests/core/runs.h"

namespace braitenlab::tests::shipped_groups_test {
namespace {

constexpr std::uint64_t seeds = 10;
constexpr int minute = 60;  // s

// The same scene with vehicles that carry no lamps.
Scene without_lamps(Scene scene) {
    for (Kind& kind : scene.kinds) kind.lamps.clear();
    return scene;
}

// How often the second vehicle goes round the first from 10 s to 60 s, and their distances (m) in that time.
struct Turns {
    float rounds = 0, nearest = INFINITY, farthest = 0;
};

Turns turns_of(const Scene& scene, std::uint64_t seed) {
    Turns turns;
    float before = 0;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        const maths::vec2 d = position(now.vehicles[1]) - position(now.vehicles[0]);
        const float angle = maths::arctangent2(d.y, d.x);
        if (now.seconds > 10) {
            turns.rounds += maths::wrap_angle(angle - before) / (2 * maths::pi);
            turns.nearest = std::min(turns.nearest, maths::length(d));
            turns.farthest = std::max(turns.farthest, maths::length(d));
        }
        before = angle;
    });
    return turns;
}

TEST(ShippedScenes, DancersTurnRoundOnePointOnlyWithTheirLamps) {
    const Scene scene = shipped_scene("dance"), dark = without_lamps(scene);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Turns dance = turns_of(scene, seed), apart = turns_of(dark, seed);
        EXPECT_GT(std::fabs(dance.rounds), 5) << seed;
        EXPECT_GT(dance.nearest, 1.3f) << seed;
        EXPECT_LT(dance.farthest, 5) << seed;
        EXPECT_LT(std::fabs(apart.rounds), 3) << seed;
    }
}

// The smallest and largest distance (m) between a vehicle and the next one, from 5 s to 60 s.
struct Gaps {
    float smallest = INFINITY, largest = 0;
    std::int64_t contacts = 0;
};

Gaps gaps_of(const Scene& scene, std::uint64_t seed) {
    Gaps gaps;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        gaps.contacts = now.events.contacts;
        if (now.seconds < 5) return;
        for (std::size_t i = 1; i < now.vehicles.size(); ++i) {
            const float gap = maths::distance(position(now.vehicles[i]), position(now.vehicles[i - 1]));
            gaps.smallest = std::min(gaps.smallest, gap), gaps.largest = std::max(gaps.largest, gap);
        }
    });
    return gaps;
}

TEST(ShippedScenes, AConvoyKeepsItsOrderAndItsDistancesOnlyWithTailLamps) {
    const Scene scene = shipped_scene("convoy"), dark = without_lamps(scene);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Gaps gaps = gaps_of(scene, seed);
        EXPECT_GT(gaps.smallest, 1.2f) << seed;
        EXPECT_LT(gaps.largest, 4) << seed;
        EXPECT_EQ(gaps.contacts, 0) << seed;
        EXPECT_GT(gaps_of(dark, seed).largest, 8) << seed;
    }
}

// One run of moths and hunter: captures, and the share of their time that moths are within 4 m of a lamp.
struct Hunt {
    std::int64_t captures = 0;
    double near_lamps = 0;
};

Hunt hunt_of(const Scene& scene, std::uint64_t seed) {
    Hunt hunt;
    int near = 0, all = 0;
    watch_run(scene, seed, minute, [&](const Snapshot& now) {
        hunt.captures = now.events.captures;
        for (const VehicleView& it : now.vehicles) {
            if (it.role != Role::prey) continue;
            ++all;
            near += std::any_of(now.sources.begin(), now.sources.end(), [&](const SourceView& lamp) {
                return maths::distance(position(it), {lamp.x, lamp.y}) < 4;
            });
        }
    });
    hunt.near_lamps = all > 0 ? static_cast<double>(near) / all : 0;
    return hunt;
}

TEST(ShippedScenes, MothsStayNearTheLampsAndTheHunterBitesThem) {
    const Scene scene = shipped_scene("moth-and-hunter");
    double near_lamps = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const Hunt hunt = hunt_of(scene, seed);
        EXPECT_GE(hunt.captures, 5) << seed;
        near_lamps += hunt.near_lamps / seeds;
    }
    EXPECT_GT(near_lamps, 0.6);
}

TEST(ShippedScenes, RolesOfMothsAndHunterFollowFromTheWiring) {
    const Scene scene = shipped_scene("moth-and-hunter");
    World world = make(scene);
    Snapshot now = look(world);
    ASSERT_EQ(now.predators, 1);
    ASSERT_EQ(now.prey, 4);
    const int hunter = find_kind(scene, "hunter");
    const Target target{.kind = hunter};
    for (const auto& [dial, value] : {std::pair{Dial::LL, 0.4f}, {Dial::RR, 0.4f}, {Dial::LR, 0.0f}, {Dial::RL, 0.0f}})
        ASSERT_FALSE(world.apply(TurnDial{target, dial, value}));
    now = after(world, 30);
    EXPECT_EQ(now.predators, 0) << "with uncrossed wires the hunter is prey";
    EXPECT_EQ(now.events.captures, 0);
}

TEST(ShippedScenes, EachDriverMovesItsVehicleInItsOwnWay) {
    const Scene scene = shipped_scene("drivers");
    const auto vehicle = [&scene](const Snapshot& now, Driver driver) {
        const auto it = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                     [driver](const VehicleView& v) { return v.driver == driver; });
        EXPECT_NE(it, now.vehicles.end()) << scene.name;
        return *it;
    };
    std::vector<maths::vec2> ends;  // of the vehicle that wanders
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::vector<bool> visited(scene.kinds[0].waypoints.size(), false);
        float wandered = 0, largest_gap = 0;
        Snapshot first, last;
        watch_run(scene, seed, minute, [&](const Snapshot& now) {
            if (now.tick == 0) first = now;
            const VehicleView path = vehicle(now, Driver::path), brain = vehicle(now, Driver::brain);
            for (std::size_t i = 0; i < visited.size(); ++i) {
                const Waypoint& point = scene.kinds[0].waypoints[i];
                if (maths::distance(position(path), {point.x, point.y}) < 0.7f) visited[i] = true;
            }
            if (now.seconds > 5) largest_gap = std::max(largest_gap, maths::distance(position(path), position(brain)));
            wandered += std::fabs(vehicle(now, Driver::wander).speed) / 60;
            last = now;
        });
        EXPECT_EQ(std::count(visited.begin(), visited.end(), false), 0) << seed;
        EXPECT_LT(largest_gap, 4.5f) << seed;
        EXPECT_GT(wandered, 20) << seed;
        ends.push_back(position(vehicle(last, Driver::wander)));
        for (const Driver still : {Driver::parked, Driver::manual})
            EXPECT_LT(maths::distance(position(vehicle(first, still)), position(vehicle(last, still))), 0.05f) << seed;
    }
    for (std::size_t i = 1; i < ends.size(); ++i) EXPECT_GT(maths::distance(ends[i], ends[i - 1]), 0.01f);

    World world = make(scene);
    const VehicleView manual = vehicle(look(world), Driver::manual);
    ASSERT_FALSE(world.apply(Steer{manual.id, 0.5f, 0.5f}));
    EXPECT_GT(maths::distance(position(vehicle(after(world, 2), Driver::manual)), position(manual)), 2);
}

}  // namespace
}  // namespace braitenlab::tests::shipped_groups_test
