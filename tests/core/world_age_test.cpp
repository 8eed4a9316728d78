// How a run evolves must not depend on its age.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/maths/angle.h"
#include "core/world/state.h"
#include "core/world/world.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::world_age_test {
namespace {

using world::State;

constexpr std::uint64_t hour = 60 * 60 * 60;  // ticks

// Two days. A multiple of what counts ticks from the start of a run: keyframes (300), removal of old marks (60), whims
// of a wandering vehicle (45), and the delays and intervals of the sensors below (6).
constexpr std::uint64_t age = 10'000'800;

// The state at a later or, with ticks that wrap around, an earlier tick; times of lamps are moved along.
State moved(State s, std::uint64_t ticks) {
    Scene scene = *s.scene;
    const auto seconds = static_cast<float>(static_cast<std::int64_t>(ticks) / 60);
    for (Source& source : scene.sources)
        for (OnTime& time : source.on) time.from += seconds, time.until += seconds;
    s.scene = std::make_shared<const Scene>(std::move(scene));
    s.tick += ticks;
    for (auto& mark : s.marks) mark.tick += ticks;
    for (auto& bite : s.bites) bite.tick += ticks;
    for (auto& strike : s.strikes) strike.tick += ticks;
    return s;
}

State state_of(const World& world) { return *world.fork().keyframe(); }

World continued(const State& state) {
    return World::restore({std::make_shared<const State>(state), state.tick, {}, state.tick});
}

// Without what depends on the tick by definition: random numbers of sensors and of wandering vehicles.
Scene without_chance(Scene scene) {
    for (Kind& kind : scene.kinds) {
        for (Sensor& sensor : kind.sensors) sensor.noise = 0;
        if (kind.driver == Driver::wander) kind.driver = Driver::parked;
    }
    return scene;
}

void expect_same_run_at_any_age(const Scene& scene) {
    World begin = make(without_chance(scene), 3);
    while (begin.tick() < 900) begin.step();
    const State state = state_of(begin);
    World young = continued(state), old = continued(moved(state, age));
    for (int part = 0; part < 4; ++part) {
        for (int tick = 0; tick < 200; ++tick) young.step(), old.step();
        EXPECT_EQ(continued(moved(state_of(old), 0 - age)).hash(), young.hash())
            << scene.name << " at tick " << young.tick();
    }
}

TEST(World, EveryShippedSceneAtTick10MillionEvolvesAsItsStateMovedToTheBegin) {
    for (const auto& path : shipped_scenes()) expect_same_run_at_any_age(*load_scene(path));
}

TEST(World, EveryShippedExerciseAtTick10MillionEvolvesAsItsStateMovedToTheBegin) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided"))
        expect_same_run_at_any_age(load_exercise(entry.path())->scene);
}

TEST(World, LateAndHeldReadingsAtTick10MillionAreThoseAtTheBegin) {
    Scene scene = crowd(20);
    for (Kind& kind : scene.kinds) kind.sensors[0].latency = kind.sensors[1].interval = 0.1f;
    expect_same_run_at_any_age(scene);
}

// rad/s over 20 s, once the motors have reached their speed.
float rate_of_turn(World& world) {
    for (int tick = 0; tick < 120; ++tick) world.step();
    double turned = 0;
    VehicleTrace before, now;
    EXPECT_TRUE(world.trace(0, before));
    for (int tick = 0; tick < 1200; ++tick, before = now) {
        world.step();
        EXPECT_TRUE(world.trace(0, now));
        turned += static_cast<double>(maths::wrap_angle(now.pose.heading - before.pose.heading));
    }
    return static_cast<float>(turned / 20);
}

// A vehicle that turns on the spot, at the start and after it has turned for so many hours at 7 rad/s.
struct Spin {
    float at_start, later;
};
Spin spin(float command, std::uint64_t hours) {
    const Scene scene = alone({.LM = -command, .RM = command});
    World fresh = make(scene),
          old = begin_with(scene, [&](State&state) {
              state.tick = hours * hour;
              state.vehicles.motion[0] = mechanics::at_rest({}, 7 * 3600 * static_cast<float>(hours));
          });
    return {rate_of_turn(fresh), rate_of_turn(old)};
}

TEST(World, AVehicleThatHasTurnedForHoursTurnsAsFastAsAtTheStart) {
    const Spin fast = spin(0.7f, 11), slow = spin(0.003f, 1);
    EXPECT_NEAR(fast.at_start, 7, 0.1f);
    EXPECT_NEAR(fast.later / fast.at_start, 1, 1e-5f);
    EXPECT_NEAR(slow.at_start, 0.03f, 0.001f);
    EXPECT_NEAR(slow.later / slow.at_start, 1, 1e-3f);
}

TEST(World, AHeadingStaysWithinOneTurn) {
    World world = make(alone({.LM = -1, .RM = 1}));
    float widest = 0;
    for (int tick = 0; tick < 600; ++tick) {
        world.step();
        widest = std::max(widest, std::fabs(state_of(world).vehicles.motion[0].heading));
    }
    EXPECT_LE(widest, maths::pi);
}

// The noise in 2,000 readings.
std::vector<double> noise_from(std::uint64_t tick) {
    Scene scene = alone({});
    scene.sources.push_back({.name = "lamp", .x = 3});
    scene.kinds[0].sensors[0].noise = 0.05f;
    const auto at = [&](State& state) { state.tick = tick; };
    World noisy = begin_with(scene, at);
    scene.kinds[0].sensors[0].noise = 0;
    const float exact = look(begin_with(scene, at)).sensed[0];
    std::vector<double> parts;
    Snapshot now;
    while (parts.size() < 2000) {
        noisy.step();
        noisy.capture(now);
        parts.push_back(static_cast<double>(now.sensed[0] - exact));
    }
    return parts;
}

// Mean, standard deviation and correlation with the next tick.
struct Noise {
    double mean = 0, deviation = 0, correlation = 0;
};
Noise describe_noise(const std::vector<double>& parts) {
    const auto count = static_cast<double>(parts.size());
    Noise noise;
    noise.mean = std::accumulate(parts.begin(), parts.end(), 0.0) / count;
    for (const double part : parts) noise.deviation += (part - noise.mean) * (part - noise.mean) / count;
    for (std::size_t i = 1; i < parts.size(); ++i)
        noise.correlation += (parts[i] - noise.mean) * (parts[i - 1] - noise.mean) / count / noise.deviation;
    noise.deviation = std::sqrt(noise.deviation);
    return noise;
}

TEST(World, NoiseIsAsLargeAndAsIndependentAtAnyAge) {
    for (const std::uint64_t tick : {std::uint64_t{0}, age, (std::uint64_t{1} << 24U) - 1000,
                                     (std::uint64_t{1} << 31U) - 1000, (std::uint64_t{1} << 32U) - 1000}) {
        const Noise noise = describe_noise(noise_from(tick));
        EXPECT_NEAR(noise.mean, 0, 0.005) << tick;
        EXPECT_NEAR(noise.deviation, 0.05, 0.003) << tick;
        EXPECT_NEAR(noise.correlation, 0, 0.08) << tick;
    }
}

TEST(World, NoiseDoesNotRepeatAfterTick2To31) {
    const std::vector<double> young = noise_from(0);
    for (const unsigned bits : {31U, 32U, 33U}) {
        const std::vector<double> old = noise_from(std::uint64_t{1} << bits);
        int same = 0;
        for (std::size_t i = 0; i < young.size(); ++i) same += !(young[i] < old[i]) && !(young[i] > old[i]);
        EXPECT_LT(same, 20) << bits;
    }
}

}  // namespace
}  // namespace braitenlab::tests::world_age_test
