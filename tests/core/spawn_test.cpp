// Kind and position of new vehicles, and the memory that removed vehicles release.
#include <cmath>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "core/maths/geometry.h"
#include "core/maths/random.h"
#include "core/world/world_data.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::spawn_test {
namespace {

using namespace world;
using maths::vec2;
using tests::after;
using tests::crowd;
using tests::look;
using tests::make;

TEST(FreeSpace, AgreesWithASearchOfAllObjects) {
    Scene scene = crowd(40);
    scene.arena.width = 60, scene.arena.height = 24;
    scene.kinds[0].body.length = 2.5f;
    scene.sources = {{.name = "lamp", .x = 3, .y = 1}};
    scene.obstacles = {{.name = "wall", .x = -5, .heading = 0.7f, .length = 30, .width = 0.2f},
                       {.name = "wedge", .x = 15, .corners = {{-3, -2}, {2, 0}, {-1, 4}}}};
    const WorldData s(*make(scene).checkpoint().keyframe);
    const FreeSpace places(s);
    const auto is_free = [&](vec2 place, float reach) {
        for (std::size_t row = 0; row < s.vehicles.size(); ++row)
            if (maths::distance(s.vehicles.motion[row].position, place) < s.kinds[s.kind(row)].reach + reach)
                return false;
        if (maths::distance({3, 1}, place) < 0.65f + reach) return false;
        for (const Obstacle& o : scene.obstacles) {
            // Sampled finely: anywhere in the obstacle nearer than the reach?
            const auto corners = corners_of(o);
            const vec2 p = maths::rotate(place - vec2{o.x, o.y}, maths::direction(-o.heading));
            bool inside = maths::in_triangle(p, corners[0], corners[1], corners[2]) ||
                          (corners.size() == 4 && maths::in_triangle(p, corners[0], corners[2], corners[3]));
            for (std::size_t i = 0; i < corners.size(); ++i)
                inside |= maths::distance(maths::nearest_on_segment(p, corners[i], corners[(i + 1) % corners.size()]),
                                          p) < reach;
            if (inside) return false;
        }
        return true;
    };
    maths::Random chance{9, 1};
    int free = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec2 place{chance.uniform(-35, 35), chance.uniform(-14, 14)};
        const float reach = chance.uniform(0.05f, s.kinds[0].reach);
        const bool wanted = is_free(place, reach);
        ASSERT_EQ(places.is_free(place, reach), wanted) << place << ' ' << reach;
        free += wanted;
    }
    EXPECT_GT(free, 2000);
    EXPECT_LT(free, 18000);
}

TEST(World, APopulationOfSmallRobotsFitsOnASmallTable) {
    Scene scene = crowd(12);
    scene.arena.width = scene.arena.height = 2;
    for (Kind& kind : scene.kinds) kind.body.length = 0.2f, kind.body.width = 0.14f;
    const Snapshot now = look(make(scene));
    for (std::size_t i = 0; i < now.vehicles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(std::hypot(now.vehicles[i].x - now.vehicles[j].x, now.vehicles[i].y - now.vehicles[j].y), 0.24f);
}

Scene large_crowd(int population) {
    Scene scene = crowd(population);
    scene.arena.width = scene.arena.height = 2 * std::sqrt(static_cast<float>(population));
    for (Kind& kind : scene.kinds)
        for (Sensor& eye : kind.sensors) eye.range = 2;
    return scene;
}

TEST(World, APopulationOfTwentyThousandLoadsRunsStarvesAndIsReplaced) {
    Scene scene = large_crowd(20000);
    scene.ecology.bite = 0;
    // All vehicles starve in the same tick.
    World world = tests::begin_with(scene, [](State& m) { m.vehicles.energy.assign(20000, 0); });
    Snapshot now = after(world, 2.0 / 60);
    EXPECT_EQ(now.vehicles.size(), 20000u);
    EXPECT_EQ(now.events.deaths, 20000);
    EXPECT_EQ(now.events.births, 20000);
    ASSERT_FALSE(world.apply(NewPopulation{}));
    now = after(world, 0.05);
    EXPECT_EQ(now.vehicles.size(), 20000u);
    EXPECT_EQ(now.generation, 2);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
// Allocated memory of the C library, in bytes.
std::size_t in_use() {
    const auto all = mallinfo2();
    return all.uordblks + all.hblkhd;
}

TEST(World, APopulationLeaksNoMemoryInTenThousandAdditionsAndRemovals) {
    Scene scene = crowd(20);
    scene.arena.width = scene.arena.height = 60;
    World world = make(scene);
    const auto come_and_go = [&](int times) {
        for (int i = 0; i < times; ++i) {
            EXPECT_FALSE(world.apply(AddVehicle{}));
            if (i % 3 == 0) world.step();
            EXPECT_FALSE(world.apply(RemoveVehicle{i % 2 == 0 ? no_vehicle : look(world).vehicles.back().id}));
        }
        after(world, 6);  // past the next keyframe, which drops the commands
    };
    come_and_go(1000);
    const std::size_t before = in_use();
    come_and_go(10000);
    EXPECT_EQ(look(world).vehicles.size(), 20u);
    EXPECT_LT(in_use(), before + 16 * 1024);
}
#endif

}  // namespace
}  // namespace braitenlab::tests::spawn_test
