// The shipped tortoise behaves as Grey Walter describes his Machina Speculatrix (The Living Brain, 1953): it explores,
// seeks moderate light, avoids bright light, pushes and turns when touched, and goes home at low energy.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/core/runs.h"

namespace braitenlab::tests::shipped_tortoise_test {
namespace {

constexpr std::uint64_t seeds = 20;

// The tortoise alone on an empty floor, with energy that does not fall, at a pose that does not vary with the seed.
Scene alone_at(float x, float y, float heading) {
    Scene scene = shipped_scene("tortoise");
    scene.sources.clear(), scene.obstacles.clear(), scene.zones.clear();
    scene.ecology.drain = 0;
    Start& start = scene.starts[0];
    start.x = x, start.y = y, start.heading = heading;
    start.place_spread = start.heading_spread = 0;
    return scene;
}

// Headings (rad) from -60 to 54 degrees.
std::vector<float> headings() {
    std::vector<float> all;
    for (int i = 0; i < 20; ++i) all.push_back(maths::radians(-60 + 6 * static_cast<float>(i)));
    return all;
}

// The smallest distance (m) to the point 1, 0 between two times (s).
float nearest_to_light(const Scene& scene, double from, int until) {
    float nearest = INFINITY;
    watch_run(scene, 1, until, [&](const Snapshot& now) {
        if (now.seconds < from) return;
        nearest = std::min(nearest, maths::distance(position(now.vehicles[0]), {1, 0}));
    });
    return nearest;
}

Scene with_light(Scene scene, float strength) {
    scene.sources.push_back({.name = "light", .x = 1, .strength = strength});
    return scene;
}

TEST(ShippedTortoise, ExploresTheFloorInTheDark) {
    Scene scene = alone_at(0, 0, 0);
    scene.starts[0].heading_spread = maths::pi, scene.starts[0].place_spread = 2;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::set<std::pair<int, int>> cells;  // of 4 m x 4 m; the arena has 16
        watch_run(scene, seed, 120, [&](const Snapshot& now) {
            const VehicleView& it = now.vehicles[0];
            cells.insert({static_cast<int>(std::floor(it.x / 4)), static_cast<int>(std::floor(it.y / 4))});
        });
        EXPECT_GE(cells.size(), 9U) << seed;
    }
}

TEST(ShippedTortoise, SeeksModerateLight) {
    constexpr float moderate = 0.3f;  // the strength of the candle in the scene
    int found_in_the_dark = 0;
    for (const float heading : headings()) {
        const Scene dark = alone_at(-5, 0, heading);
        EXPECT_LT(nearest_to_light(with_light(dark, moderate), 0, 20), 0.7f) << maths::degrees(heading);
        found_in_the_dark += nearest_to_light(dark, 0, 20) < 0.7f;
    }
    EXPECT_LE(found_in_the_dark, 5) << "of 20";
}

TEST(ShippedTortoise, AvoidsBrightLight) {
    for (const float heading : headings()) {
        EXPECT_GT(nearest_to_light(with_light(alone_at(-5, 0, heading), 1), 0, 60), 2.5f) << maths::degrees(heading);
        const Scene close = with_light(alone_at(0, 0, heading), 1);
        EXPECT_GT(nearest_to_light(close, 3, 4), 2) << maths::degrees(heading) << ": leaves the light";
        EXPECT_GT(nearest_to_light(close, 6, 20), 2.5f) << maths::degrees(heading) << ": stays away";
    }
}

// What happens when the tortoise drives against a box of this mass (kg; 0: fixed) in its way.
struct Encounter {
    float turned = 0;       // rad, within 2 s
    float slowest = 0;      // m/s, within 2 s; negative: backwards
    float pushed = 0;       // m, of the box
    double resumed = 1000;  // s until it drives forward again
};

Encounter drive_against(float mass, float heading) {
    Scene scene = alone_at(-3, 0, heading);
    Obstacle& box = scene.obstacles.emplace_back();
    box.name = "box", box.length = 0.5f, box.width = 2, box.mass = mass;
    Encounter encounter;
    double met = -1;
    float heading_then = 0;
    watch_run(scene, 1, 8, [&](const Snapshot& now) {
        const VehicleView& it = now.vehicles[0];
        encounter.pushed = std::hypot(now.obstacles[0].x, now.obstacles[0].y);
        if (met < 0 && now.events.contacts > 0) met = now.seconds, heading_then = it.heading;
        if (met < 0 || now.seconds > met + 2) return;
        encounter.turned = std::max(encounter.turned, std::fabs(maths::wrap_angle(it.heading - heading_then)));
        encounter.slowest = std::min(encounter.slowest, it.speed);
        if (encounter.slowest < 0 && it.speed > 0.5f)
            encounter.resumed = std::min(encounter.resumed, now.seconds - met);
    });
    return encounter;
}

TEST(ShippedTortoise, PushesAndTurnsWhenTouched) {
    for (const float degrees : {-6.0f, -3.0f, 0.0f, 3.0f, 6.0f}) {
        const Encounter fixed = drive_against(0, maths::radians(degrees)),
                        loose = drive_against(3, maths::radians(degrees));
        EXPECT_GT(fixed.turned, maths::radians(60)) << degrees;
        EXPECT_GT(loose.turned, maths::radians(15)) << degrees;
        EXPECT_GT(loose.pushed, 0.25f) << degrees;
        for (const Encounter& encounter : {fixed, loose}) {
            EXPECT_LT(encounter.slowest, -1) << degrees;
            EXPECT_LT(encounter.resumed, 1.5) << degrees;
        }
    }
}

TEST(ShippedTortoise, GoesHomeWhenHungryAndNotBefore) {
    const Scene scene = shipped_scene("tortoise");
    const Zone& hutch = scene.zones.front();
    const auto first_at_home = [&](float energy, std::uint64_t seed) {
        Scene same = scene;
        same.ecology.drain = 0;
        same.starts[0].x = -1, same.starts[0].y = 3, same.starts[0].heading_spread = maths::radians(60);
        World run = begin_with(
            same, [energy](world::State& state) { state.vehicles.energy = {energy}; }, seed);
        while (run.tick() < 60 * 60) {
            const VehicleView it = look(run).vehicles[0];
            if (maths::distance(position(it), {hutch.x, hutch.y}) < hutch.length / 2) return look(run).seconds;
            run.step();
        }
        return 1000.0;
    };
    int hungry = 0, fed = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        hungry += first_at_home(0.3f, seed) < 60;
        fed += first_at_home(1, seed) < 60;
    }
    EXPECT_EQ(hungry, 20);
    EXPECT_EQ(fed, 0);
}

}  // namespace
}  // namespace braitenlab::tests::shipped_tortoise_test
