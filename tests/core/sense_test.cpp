// Readings of the sensors of every channel in a running world.
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/sensing/compiled_sensor.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::sense_test {
namespace {

using namespace sensing;
// A vehicle at rest in the middle, with one sensor that points ahead.
Scene watcher(const Sensor& sensor) {
    Scene scene = tests::alone({});
    scene.arena.width = scene.arena.height = 40;
    Kind& kind = scene.kinds[0];
    kind.sensors = {sensor};
    kind.sensors[0].name = "S";
    kind.brain = make_graph({});
    return scene;
}
Scene watcher(Channel channel) { return watcher(Sensor{.channel = channel}); }

World make(const Scene& scene, std::uint64_t seed = 1) {
    auto world = World::create(scene, seed);
    EXPECT_TRUE(world) << world.error().text();
    return std::move(*world);
}

float reading(const World& world, std::size_t sensor = 0) {
    Snapshot now;
    world.capture(now);
    return now.sensed[sensor];
}
float reading(const Scene& scene) { return reading(make(scene)); }

void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step();
}

Scene with(Scene scene, const Source& source) {
    scene.sources.push_back(source);
    scene.sources.back().name = "s" + std::to_string(scene.sources.size());
    return scene;
}

TEST(World, ColoursAreSensedByEyesForTheSameColourAndForWhite) {
    const std::array<Channel, 4> lights{Channel::light, Channel::red, Channel::green, Channel::blue};
    for (const Channel eye : lights)
        for (const Channel lamp : lights) {
            const bool seen = eye == lamp || eye == Channel::light || lamp == Channel::light;
            EXPECT_EQ(reading(with(watcher(eye), {.channel = lamp, .x = 3})) > 0, seen);
        }
}

TEST(World, ASourceIsSensedOnlyWhileItIsOn) {
    World world = make(with(watcher(Channel::light), {.x = 3, .on = {{0.5f, 1}, {2, 3}}}));
    Snapshot now;
    for (int tick = 0; tick < 200; ++tick, world.step()) {
        world.capture(now);
        const auto is_on = [](int at) { return (at >= 30 && at < 60) || (at >= 120 && at < 180); };
        EXPECT_EQ(now.sensed[0] > 0, is_on(tick - 1)) << "reading of the tick before " << tick;
        EXPECT_EQ(now.sources[0].strength, is_on(tick) ? 1 : 0) << tick;
    }
}

TEST(World, SourcesOfHeatSmellAndOxygenAreSensedOnlyOnTheirChannel) {
    const std::array<Channel, 4> all{Channel::heat, Channel::smell, Channel::oxygen, Channel::light};
    for (const Channel nose : all)
        for (const Channel source : all)
            EXPECT_EQ(reading(with(watcher(nose), {.channel = source, .x = 3})) > 0, nose == source);
}

TEST(World, ObstaclesBlockLightAndVehiclesButNotHeatAndSmell) {
    for (const Channel channel : {Channel::light, Channel::blue, Channel::heat, Channel::smell, Channel::oxygen}) {
        Scene scene = with(watcher(channel), {.channel = channel, .x = 5});
        const float open = reading(scene);
        EXPECT_GT(open, 0);
        scene.obstacles.push_back({.name = "box", .x = 3});
        EXPECT_EQ(reading(scene), is_blocked_by_obstacles(channel) ? 0 : open);
        scene.obstacles[0].y = 3;
        EXPECT_EQ(reading(scene), open);
    }
    Scene scene = watcher(Channel::vehicle);
    scene.starts.push_back({.name = "other", .kind = "tester", .x = 5});
    EXPECT_GT(reading(scene), 0);
    scene.obstacles.push_back({.name = "box", .x = 3});
    EXPECT_EQ(reading(scene), 0);
}

TEST(World, VehiclesBlockNothing) {
    for (const ChannelTraits& row : channel_table) {
        if (!row.is_source) continue;
        Scene scene = with(watcher(row.value), {.channel = row.value, .x = 5});
        const float open = reading(scene);
        scene.starts.push_back({.name = "between", .kind = "tester", .x = 3});
        EXPECT_EQ(reading(scene), open) << row.word;
    }
}

// Readings of a sensor for chance: a row for each tick, with a column for each of two vehicles.
std::vector<std::array<float, 2>> chances(Sensor sensor, int ticks, std::uint64_t seed = 1) {
    sensor.channel = Channel::random;
    Scene scene = watcher(sensor);
    scene.starts.push_back({.name = "other", .kind = "tester", .x = 3});
    World world = make(scene, seed);
    std::vector<std::array<float, 2>> rows;
    for (int i = 0; i < ticks; ++i, world.step()) rows.push_back({reading(world, 0), reading(world, 1)});
    return rows;
}

TEST(World, ASensorForChanceReadsEveryNumberAsOftenAndAgainWithTheSameSeed) {
    const auto rows = chances({}, 2000);
    std::array<int, 4> count{};
    float sum = 0, together = 0;
    for (const auto& [one, other] : rows) {
        ++count[static_cast<std::size_t>(std::min(3.0f, one * 4))];
        sum += one, together += (one - 0.5f) * (other - 0.5f);
    }
    for (const int quarter : count) EXPECT_NEAR(quarter, 500, 70);
    EXPECT_NEAR(sum / 2000, 0.5f, 0.02f);
    EXPECT_NEAR(together / 2000, 0, 0.006f) << "two vehicles draw different numbers";
    EXPECT_EQ(chances({}, 50), std::vector(rows.begin(), rows.begin() + 50));
    EXPECT_NE(chances({}, 50, 2), std::vector(rows.begin(), rows.begin() + 50));
}

TEST(World, ASensorForChanceHoldsItsSampleAndABooleanOneTossesACoin) {
    const auto rows = chances({.response = SensorResponse::boolean, .interval = 0.1f}, 600);
    int heads = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const float value = rows[i][0];
        EXPECT_TRUE(value == 0 || value == 1) << value;
        if ((i - 1) % 6 != 0) {
            EXPECT_EQ(value, rows[i - 1][0]) << "in tick " << i;
        }
        heads += value == 1;
    }
    EXPECT_GT(heads, 150);
    EXPECT_LT(heads, 450);
}

TEST(World, ObstaclesDoNotBlockLightOnceTheyArePushedAway) {
    Scene scene = with(watcher(Channel::light), {.x = 8});
    scene.obstacles.push_back({.name = "crate", .x = 4, .length = 0.8f, .width = 0.8f, .mass = 3});
    Kind pusher = tests::two_eyed("pusher", {.LM = 1, .RM = 1});
    scene.kinds.push_back(pusher);
    scene.starts.push_back({.name = "p", .kind = "pusher", .x = 4, .y = -2, .heading = maths::radians(90)});
    World world = make(scene);
    EXPECT_EQ(reading(world), 0);
    steps(world, 120);
    EXPECT_GT(reading(world), 0);
}

TEST(World, VehiclesSenseAllOtherVehiclesButNotThemselves) {
    Scene scene = watcher({.channel = Channel::vehicle, .shape = SensorShape::omni});
    EXPECT_EQ(reading(scene), 0);
    scene.starts.push_back({.name = "other", .kind = "tester", .x = -4});
    EXPECT_GT(reading(scene), 0);
}

TEST(World, CarriedLampsAreSensedByOtherVehiclesAtTheirPresentPosition) {
    Scene scene = watcher({.channel = Channel::red, .shape = SensorShape::omni});
    scene.kinds[0].lamps.push_back({.name = "lamp", .channel = Channel::red, .x = 0.2f, .strength = 0.8f});
    EXPECT_EQ(reading(scene), 0);  // a vehicle does not sense the lamp that it carries
    Kind bearer = tests::two_eyed("bearer", {.LM = 0.5f, .RM = 0.5f});
    bearer.lamps = {{.name = "lamp", .channel = Channel::light, .x = 0.5f, .y = 0.25f, .strength = 0.5f}};
    scene.kinds.push_back(bearer);
    scene.starts.push_back({.name = "b", .kind = "bearer", .x = 3, .y = -2, .heading = maths::radians(90)});
    World world = make(scene);
    const float before = reading(world);
    Scene lamp_alone = with(watcher(scene.kinds[0].sensors[0]), {.x = 3 - 0.25f, .y = -2 + 0.5f, .strength = 0.5f});
    EXPECT_NEAR(before, reading(lamp_alone), 1e-5f);
    steps(world, 45);
    EXPECT_GT(reading(world), before * 1.05f);  // the lamp is nearer
}

TEST(World, ABumperReportsTheSideOfAContact) {
    Scene scene = watcher({.channel = Channel::touch});
    Kind& kind = scene.kinds[0];
    kind.sensors.push_back({.name = "rear", .channel = Channel::touch, .x = -0.3f, .angle = maths::pi});
    kind.brain = make_graph({.LM = 0.5f, .RM = 0.5f});
    scene.arena.width = 6;
    World world = make(scene);
    steps(world, 30);
    EXPECT_EQ(reading(world, 0), 0);
    steps(world, 150);
    EXPECT_EQ(reading(world, 0), 1);
    EXPECT_EQ(reading(world, 1), 0);
}

TEST(World, ABumperSensesOtherVehicles) {
    Scene scene = watcher({.channel = Channel::touch});
    scene.kinds.push_back(tests::two_eyed("rammer", {.LM = 0.6f, .RM = 0.6f}));
    scene.starts.push_back({.name = "r", .kind = "rammer", .x = 4, .heading = maths::pi});
    World world = make(scene);
    EXPECT_EQ(reading(world), 0);
    bool felt = false;
    for (int i = 0; i < 300 && !felt; ++i) world.step(), felt = reading(world) == 1;
    EXPECT_TRUE(felt);
}

TEST(World, TheSensorsOfEachVehicleDifferByTheirGainSpread) {
    const Scene plain = with(watcher(Channel::light), {.x = 3});
    const float ideal = reading(plain);
    Scene scene = plain;
    scene.kinds[0].sensors.push_back(scene.kinds[0].sensors[0]);
    scene.kinds[0].sensors[1].name = "T";
    scene.kinds[0].sensors[0].gain_spread = scene.kinds[0].sensors[1].gain_spread = 0.2f;
    float least = 2, most = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        World world = make(scene, seed);
        const float share = reading(world) / ideal;
        least = std::min(least, share), most = std::max(most, share);
        EXPECT_NE(reading(world, 1), reading(world)) << "each sensor has its own gain";
        steps(world, 10);
        EXPECT_FLOAT_EQ(reading(world) / ideal, share) << "it does not change";
    }
    EXPECT_NEAR(least, 0.8f, 0.02f);
    EXPECT_NEAR(most, 1.2f, 0.02f);
    scene.kinds[0].sensors[0].gain_spread = 0;
    EXPECT_EQ(reading(make(scene, 7)), ideal);
    scene.kinds[0].sensors[0].gain_spread = 0.1f;
    const float half = reading(make(scene, 7));
    scene.kinds[0].sensors[0].gain_spread = 0.2f;
    EXPECT_NEAR(reading(make(scene, 7)) - ideal, 2 * (half - ideal), 1e-6f) << "the same sensor, twice as far off";
}

TEST(World, AForkWithOtherNoiseKeepsTheGainsOfTheSensors) {
    Scene scene = with(watcher(Channel::light), {.x = 3});
    scene.kinds[0].sensors[0].gain_spread = 0.2f;
    World world = make(scene, 3);
    steps(world, 5);
    World other = world.fork(99);
    world.step(), other.step();
    EXPECT_EQ(reading(other), reading(world));
}

TEST(World, AnEyeThatIsAPhotocellReadsLampsAndAmbientLightTogether) {
    Scene scene = with(
        watcher({.channel = Channel::light, .response = SensorResponse::photocell, .x = 0, .gamma = 0.7f}), {.x = 3});
    EXPECT_NEAR(reading(scene), 0.5f, 1e-5f) << "half scale at the half distance";
    scene.arena.ambient = 0.5f;
    EXPECT_NEAR(reading(scene), std::pow(2.0, 0.7) / (1 + std::pow(2.0, 0.7)), 1e-5);
    scene.sources.clear();
    EXPECT_NEAR(reading(scene), 0.5f, 1e-5f);
}

TEST(World, AnEyeThatIsAPhotocellAddsLampsInCandelaAndAmbientLightInLux) {
    // GL5528 (γ 0.7, 15 kΩ at 10 lx) over 1.5 kΩ, torches of 84 cd and a room: 1/(1 + (R10/Rf)·(E/10 lx)^−γ).
    const auto divider = [](double lux) { return 1 / (1 + 10 * std::pow(lux / 10, -0.7)); };
    const Sensor eye{
        .channel = Channel::light, .response = SensorResponse::photocell, .x = 0, .gamma = 0.7f, .half_lux = 268.27f};
    Scene scene = with(watcher(eye), {.x = 1, .candela = 84});
    EXPECT_NEAR(reading(scene), divider(84), 1e-4);
    for (const float half_distance : {0.1f, 5.0f}) {
        scene.kinds[0].sensors[0].half_distance = half_distance;
        EXPECT_NEAR(reading(scene), divider(84), 1e-4) << "a distance does not matter to candela";
    }
    scene = with(scene, {.x = 2, .candela = 200});
    EXPECT_NEAR(reading(scene), divider(84 + 50), 1e-4);
    scene.arena.lux = 300;
    EXPECT_NEAR(reading(scene), divider(84 + 50 + 300), 1e-4) << "added before the curve";
    scene.sources[1].strength = 0.5f;
    EXPECT_NEAR(reading(scene), divider(84 + 25 + 300), 1e-4) << "a dimmed lamp";
    scene.kinds.push_back(tests::two_eyed("bearer", {}));
    scene.kinds[1].lamps.push_back({.name = "torch", .x = 0, .candela = 90});
    scene.starts.push_back({.name = "b", .kind = "bearer", .x = 3});
    EXPECT_NEAR(reading(scene), divider(84 + 25 + 300 + 10), 1e-4) << "a lamp on a vehicle";
}

TEST(World, CandelaAndLuxAreForPhotocellsAlone) {
    Scene scene = with(watcher(Channel::light), {.x = 3});
    const float by_strength = reading(scene);
    scene.sources[0].candela = 500, scene.arena.lux = 500;
    EXPECT_EQ(reading(scene), by_strength);
    scene = watcher({.channel = Channel::heat, .response = SensorResponse::photocell});
    scene.arena.lux = 500;
    EXPECT_EQ(reading(scene), 0) << "ambient light is no heat";
}

TEST(World, AFloorSensorReadsTheBrightnessOfTheFloorBelowIt) {
    Scene scene = watcher(Sensor{.channel = Channel::floor, .x = 0.5f});
    EXPECT_FLOAT_EQ(reading(scene), scene.arena.reflectance);
    scene.zones.push_back({.name = "line", .x = 0.5f, .length = 0.1f, .width = 4, .surface = Surface::tape});
    EXPECT_FLOAT_EQ(reading(scene), floor_constants(scene.arena, Surface::tape).reflectance);
    scene.kinds[0].sensors[0].x = 0.3f;
    EXPECT_FLOAT_EQ(reading(scene), scene.arena.reflectance);
    scene.kinds[0].sensors[0].response = SensorResponse::boolean;
    EXPECT_EQ(reading(scene), 1);
    scene.kinds[0].sensors[0].x = 0.5f;
    EXPECT_EQ(reading(scene), 0);
}

TEST(World, AnEnergySensorReadsTheEnergyOfItsVehicle) {
    Scene scene = watcher(Channel::energy);
    scene.ecology.drain = 0.1f;
    World world = make(scene);
    EXPECT_EQ(reading(world), 1);
    steps(world, 180);
    Snapshot now;
    world.capture(now);
    world.step();
    EXPECT_NEAR(reading(world), now.vehicles[0].energy, 1e-6f);
    EXPECT_NEAR(reading(world), 0.7f, 0.01f);
}

TEST(World, PlaceMemoryMarksContactsWithObstaclesAndFadesTheMarks) {
    Scene scene = watcher({.channel = Channel::memory, .shape = SensorShape::omni});
    scene.kinds[0].memory = {.marks = 3, .fade = 2, .strength = 0.8f};
    scene.kinds[0].brain = make_graph({.LM = 0.6f, .RM = 0.6f});
    scene.arena.width = 6;
    scene.starts.push_back({.name = "other", .kind = "tester", .x = 2, .y = 8});
    scene.starts[0].x = -1;
    World world = make(scene);
    Snapshot now;
    world.capture(now);
    EXPECT_TRUE(now.marks.empty());
    EXPECT_EQ(now.sensed[0], 0);
    steps(world, 300);
    world.capture(now);
    ASSERT_EQ(now.marks.size(), 2u);  // one mark each during a long contact
    EXPECT_NEAR(now.marks[0].x, 3, 0.05f);
    EXPECT_EQ(now.marks[0].owner, now.vehicles[0].id);
    EXPECT_NEAR(now.marks[0].strength, 0.8f, 0.02f);
    const float fresh = now.sensed[0];
    EXPECT_GT(fresh, 0.3f);
    // Away from the wall and at rest: the mark fades by half-lives.
    ASSERT_FALSE(world.apply(ChooseDriver{now.vehicles[0].id, Driver::parked}));
    ASSERT_FALSE(world.apply(MoveVehicle{now.vehicles[0].id, 1, 0, 0}));
    const float away = reading(world);
    steps(world, 120);
    EXPECT_NEAR(reading(world), away / 2, 0.02f);
    steps(world, 60 * 25);
    world.capture(now);
    EXPECT_EQ(now.marks.size(), 1u);
    EXPECT_EQ(now.sensed[0], 0);  // a vehicle does not sense the marks of another
}

TEST(World, PlaceMemoryDropsTheOldestMarkBeyondItsCapacity) {
    Scene scene = watcher({.channel = Channel::memory, .shape = SensorShape::omni});
    scene.kinds[0].memory = {.marks = 2, .fade = 1000};
    scene.arena.width = 6;
    World world = make(scene);
    for (const float y : {-4.0f, 0.0f, 4.0f, 8.0f}) {
        ASSERT_FALSE(world.apply(MoveVehicle{0, 2.495f, y, 0}));
        steps(world, 5);
    }
    Snapshot now;
    world.capture(now);
    ASSERT_EQ(now.marks.size(), 2u);
    EXPECT_NEAR(now.marks[0].y, 4, 0.1f);
    EXPECT_NEAR(now.marks[1].y, 8, 0.1f);
}

TEST(World, AmbientLightRaisesTheReadingOfLightSensorsOnly) {
    for (const auto& [channel, lit] : {std::pair{Channel::light, true},
                                       {Channel::green, true},
                                       {Channel::heat, false},
                                       {Channel::prey, false},
                                       {Channel::energy, false}}) {
        Scene scene = watcher(channel);
        const float before = reading(scene);
        scene.arena.ambient = 0.25f;
        EXPECT_FLOAT_EQ(reading(scene), before + (lit ? 0.25f : 0));
    }
    Scene scene = with(with(watcher(Channel::light), {.x = 0.6f}), {.x = 0.7f});
    scene.arena.ambient = 0.5f;
    EXPECT_EQ(reading(scene), 1);  // saturated
}

TEST(World, NoiseHasTheGivenSpreadAndNoCorrelation) {
    Scene scene = watcher({.channel = Channel::light, .noise = 0.1f});
    scene.kinds[0].sensors.push_back(scene.kinds[0].sensors[0]);
    scene.kinds[0].sensors[1].name = "second";
    scene.arena.ambient = 0.5f;
    World world = make(scene);
    double sum = 0, squares = 0, with_last = 0, with_other = 0, last = 0;
    const int count = 4000;
    for (int i = 0; i < count; ++i) {
        world.step();
        Snapshot now;
        world.capture(now);
        const double off = now.sensed[0] - 0.5, other = now.sensed[1] - 0.5;
        sum += off, squares += off * off, with_last += off * last, with_other += off * other;
        last = off;
    }
    EXPECT_NEAR(sum / count, 0, 0.006);
    EXPECT_NEAR(std::sqrt(squares / count), 0.1, 0.005);
    EXPECT_NEAR(with_last / squares, 0, 0.05);
    EXPECT_NEAR(with_other / squares, 0, 0.05);
}

TEST(World, NoiseDependsOnTheSeedAndKeepsReadingsBetween0And1) {
    Scene scene = watcher({.channel = Channel::light, .noise = 1});
    World a = make(scene, 5), b = make(scene, 5), c = make(scene, 6);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        a.step(), b.step(), c.step();
        EXPECT_EQ(reading(a), reading(b));
        different += reading(a) != reading(c);
        EXPECT_GE(reading(a), 0);
        EXPECT_LE(reading(a), 1);
    }
    EXPECT_GT(different, 30);
}

TEST(World, LatencyDelaysEveryReadingByItsTicks) {
    Scene scene = with(watcher({.channel = Channel::light, .latency = 0.25f}), {.x = 4});
    World world = make(scene);
    const float prompt = reading(with(watcher(Channel::light), {.x = 4}));
    for (int i = 0; i < 15; ++i) {
        EXPECT_EQ(reading(world), 0) << i;
        EXPECT_EQ(reading(world), 0) << i;  // a reading does not change the world
        world.step();
    }
    world.step();
    EXPECT_EQ(reading(world), prompt);
    ASSERT_FALSE(world.apply(MoveSource{0, -4, 0}));
    for (int i = 0; i < 15; ++i) {
        EXPECT_EQ(reading(world), prompt) << i;
        world.step();
    }
    world.step();
    EXPECT_EQ(reading(world), 0);
}

// A vehicle before a lamp that moves away by a little before every tick; step() gives the reading of the tick.
class Receding {
public:
    explicit Receding(const Sensor& sensor) : world_(make(with(watcher(sensor), {.x = 4}))) {}
    float step() {
        EXPECT_FALSE(world_.apply(MoveSource{0, 4 + 0.01f * static_cast<float>(moved_++), 0}));
        world_.step();
        return reading(world_);
    }
    World& world() { return world_; }

private:
    World world_;
    int moved_ = 0;
};

TEST(World, ASensorWithAnIntervalHoldsItsLastSample) {
    const Sensor prompt{.channel = Channel::light}, slow{.channel = Channel::light, .interval = 0.1f};
    Receding every_tick(prompt), every_sixth(slow);
    EXPECT_EQ(reading(every_sixth.world()), reading(every_tick.world())) << "the first sample is at the start";
    float sample = 0;
    for (int tick = 0; tick < 40; ++tick) {
        const float now = every_tick.step();
        EXPECT_NE(now, sample);
        if (tick % 6 == 0) sample = now;
        EXPECT_EQ(every_sixth.step(), sample) << tick;
    }
}

TEST(World, AnIntervalThatIsNoMultipleOfATickIsKeptOnTheAverage) {
    // 50 samples of a robot's program in the 60 ticks of a second.
    int samples = 0, longest = 0, last = 0;
    for (int tick = 0; tick < 6000; ++tick) {
        if (!sensing::is_sampled(20000, static_cast<std::uint64_t>(tick))) continue;
        ++samples, longest = std::max(longest, tick - last), last = tick;
    }
    EXPECT_EQ(samples, 5000);
    EXPECT_EQ(longest, 2);
    const Sensor fast{.channel = Channel::light, .interval = 0.01f}, prompt{.channel = Channel::light};
    Receding a(fast), b(prompt);
    for (int tick = 0; tick < 20; ++tick) EXPECT_EQ(a.step(), b.step()) << "an interval shorter than a tick";
}

TEST(World, ASampleTravelsForTheLatencyAndIsThenHeld) {
    Receding prompt({.channel = Channel::light}), slow({.channel = Channel::light, .latency = 0.05f, .interval = 0.1f});
    std::vector<float> all;
    for (int tick = 0; tick < 40; ++tick) {
        all.push_back(prompt.step());
        const float received = slow.step();
        if (tick < 3) continue;
        EXPECT_EQ(received, all[static_cast<std::size_t>((tick - 3) / 6 * 6)]) << tick;
    }
}

TEST(World, AConverterReadsOneOfItsSteps) {
    Receding plain({.channel = Channel::light}), stepped({.channel = Channel::light, .bits = 4});
    std::set<float> values;
    for (int tick = 0; tick < 600; ++tick) {
        const float exact = plain.step(), read = stepped.step();
        values.insert(read);
        EXPECT_NEAR(read, exact, 1.0f / 16);
        EXPECT_NEAR(read * 15, std::round(read * 15), 1e-5f);
        EXPECT_EQ(std::lround(read * 15), std::lround(std::floor(exact * 16))) << "as a converter counts";
    }
    EXPECT_GE(values.size(), 4u);
    EXPECT_EQ(sensing::converted(1, 1024), 1);
    EXPECT_EQ(sensing::converted(0, 1024), 0);
    EXPECT_FLOAT_EQ(sensing::converted(0.5f, 1024), 512.0f / 1023);
}

TEST(World, ATriangularFieldIsRefusedAt180DegreesOrMore) {
    Scene scene = watcher({.shape = SensorShape::triangle, .fov = maths::radians(200)});
    EXPECT_FALSE(World::create(scene, 1));
    scene.kinds[0].sensors[0].fov = maths::radians(120);
    EXPECT_TRUE(World::create(scene, 1));
}

TEST(World, ATorusLetsSensorsReadAcrossTheSeam) {
    for (const Channel channel : {Channel::light, Channel::vehicle, Channel::obstacle}) {
        Scene scene = watcher(Sensor{.channel = channel});
        scene.arena.width = 20;
        scene.arena.edge = Boundary::torus;
        scene.starts[0].x = 8;
        if (channel == Channel::light) scene = with(scene, {.x = -8});
        if (channel == Channel::vehicle) scene.starts.push_back({.name = "o", .kind = "tester", .x = -8});
        if (channel == Channel::obstacle) scene.obstacles.push_back({.name = "box", .x = -8});
        EXPECT_GT(reading(scene), 0.1f);
        scene.arena.edge = Boundary::open;
        EXPECT_EQ(reading(scene), 0);
    }
}

// A crowd with every type of sensor state that lasts for several ticks.
Scene crowd_with_every_sense() {
    Scene scene = tests::crowd(20);
    scene.arena.ambient = 0.05f;
    scene.zones.push_back({.name = "line", .length = 8, .width = 0.5f, .surface = Surface::tape});
    scene.obstacles.push_back({.name = "crate", .x = 3, .mass = 2});
    scene.sources.push_back({.name = "lamp", .x = -4, .y = 2});
    for (Kind& kind : scene.kinds) {
        kind.memory.marks = 5;
        kind.lamps = {{.name = "l", .channel = Channel::red}};
        std::vector<std::pair<std::string, Channel>> senses{
            {"a", Channel::touch}, {"b", Channel::floor}, {"c", Channel::memory}, {"d", Channel::red}};
        for (const auto& [name, channel] : senses) {
            kind.sensors.push_back({.name = name, .channel = channel, .noise = 0.02f, .latency = 0.1f});
            if (channel == Channel::red) kind.sensors.back().interval = 0.25f;
            const auto id = static_cast<NodeId>(100 + kind.brain.nodes.size());
            kind.brain.nodes.push_back({.id = id, .kind = NodeKind::sensor, .name = name});
            kind.brain.wires.push_back({.from = id, .to = find_node(kind.brain, "ML")->id, .weight = -0.4f});
        }
    }
    return scene;
}

TEST(World, ACheckpointStoresTheStateOfSlowSensorsNoisySensorsAndMemories) {
    World world = make(crowd_with_every_sense(), 3);
    for (const int more : {137, 290, 41, 333}) {
        steps(world, more);
        World restored = World::restore(world.checkpoint());
        EXPECT_EQ(restored.hash(), world.hash());
        steps(restored, 310);
        World on = World::restore(world.checkpoint());
        steps(on, 310);
        steps(world, 310);
        EXPECT_EQ(restored.hash(), world.hash());
        EXPECT_EQ(on.hash(), world.hash());
        Snapshot a, b;
        restored.capture(a), world.capture(b);
        EXPECT_EQ(a.sensed, b.sensed);
        EXPECT_FALSE(b.marks.empty());
    }
}

TEST(World, SetSensorsResetsTheBuffersOfSlowSensors) {
    World world = make(crowd_with_every_sense(), 3);
    steps(world, 50);
    Snapshot now;
    world.capture(now);
    std::vector<Sensor> sensors = now.scene->kinds[0].sensors;
    for (Sensor& s : sensors) s.latency = s.latency > 0 ? 0 : 0.5f;
    ASSERT_FALSE(world.apply(SetSensors{{.kind = 0}, sensors}));
    steps(world, 50);
    ASSERT_FALSE(world.apply(RemoveVehicle{}));
    steps(world, 50);
    World restored = World::restore(world.checkpoint());
    EXPECT_EQ(restored.hash(), world.hash());
}

}  // namespace
}  // namespace braitenlab::tests::sense_test
