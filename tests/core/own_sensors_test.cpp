// Sensors of single vehicles.
#include <gtest/gtest.h>

#include "core/io/run_file.h"
#include "core/io/vehicle_table.h"
#include "core/lesson/grade.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "core/world/character.h"
#include "tests/core/scenes.h"
#include "tests/tells.h"

namespace braitenlab::tests::own_sensors_test {
namespace {

// Two vehicles of one kind side by side, and a lamp and a stove ahead of them.
Scene twins() {
    Scene scene = alone({.LM = 0.3f, .RM = 0.3f});
    scene.starts.push_back({.name = "other", .kind = "tester", .y = 6});
    scene.sources = {{"lamp", Channel::light, 4, 3, 1, false}, {"stove", Channel::heat, 4, 3, 1, false}};
    return scene;
}

Session open(const Scene& scene) { return std::move(*Session::open(scene, 1)); }

const Kind& design(const Session& session, VehicleId id) {
    return kind_of(session.snapshot(), *find_vehicle(session.snapshot(), id));
}

float reading(const Session& session, VehicleId id, std::size_t sensor) {
    const Snapshot& now = session.snapshot();
    return now.sensed[static_cast<std::size_t>(find_vehicle(now, id)->first_sensed) + sensor];
}

std::vector<Sensor> heat_eye() { return {{.name = "H", .channel = Channel::heat, .angle = 0.5f}}; }

TEST(Command, SetSensorsOfOneVehicleChangesItAlone) {
    Session session = open(twins());
    const std::vector<Sensor> of_kind = design(session, 0).sensors;
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, heat_eye()}));
    EXPECT_EQ(design(session, 0).sensors, heat_eye());
    EXPECT_EQ(design(session, 1).sensors, of_kind);
    EXPECT_EQ(session.snapshot().scene->kinds[0].sensors, of_kind);
    session.step();
    EXPECT_GT(reading(session, 0, 0), 0.1f) << "no other sensor of the scene senses heat";
    EXPECT_GT(reading(session, 1, 1), 0.01f) << "the lamp is on the right of the other vehicle";
    EXPECT_TRUE(session.apply(SetSensors{{.vehicle = 7}, {}}));
    EXPECT_TRUE(session.apply(SetSensors{{.kind = 7}, {}}));
    EXPECT_TRUE(session.apply(SetSensors{{.vehicle = 0}, {{.name = "far", .range = 1000}}}));
    EXPECT_EQ(design(session, 0).sensors, heat_eye());
}

TEST(Command, SetSensorsOfOneVehicleLeavesTheRunOfTheOthers) {
    Session plain = open(twins()), edited = open(twins());
    for (int i = 0; i < 100; ++i) plain.step(), edited.step();
    std::vector<Sensor> sensors = design(edited, 0).sensors;
    sensors.insert(sensors.begin(), heat_eye().front());
    ASSERT_FALSE(edited.apply(SetSensors{{.vehicle = 0}, sensors}));
    for (int i = 0; i < 100; ++i) plain.step(), edited.step();
    const VehicleView &one = *find_vehicle(plain.snapshot(), 1), &other = *find_vehicle(edited.snapshot(), 1);
    EXPECT_EQ(one.x, other.x);
    EXPECT_EQ(one.heading, other.heading);
    EXPECT_EQ(reading(plain, 1, 0), reading(edited, 1, 0));
    EXPECT_NE(plain.hash(), edited.hash());
}

TEST(Command, SetSensorsKeepsTheDelayedReadingsOfSensorsThatStay) {
    Scene scene = twins();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.latency = 0.5f;
    for (const Target target : {Target{.vehicle = 0}, Target{.kind = 0}}) {
        Session session = open(scene);
        for (int i = 0; i < 60; ++i) session.step();
        std::vector<Sensor> sensors = design(session, 0).sensors;
        std::swap(sensors[0], sensors[1]);
        sensors.insert(sensors.begin(), {.name = "new", .latency = 0.5f});
        const float right = reading(session, 1, 1), left = reading(session, 0, 0);
        ASSERT_GT(left, 0.01f);
        ASSERT_FALSE(session.apply(SetSensors{target, sensors}));
        session.step();
        EXPECT_EQ(reading(session, 0, 0), 0) << "its readings arrive after half a second";
        EXPECT_NEAR(reading(session, 0, 2), left, 0.01f) << "the left eye is now the third sensor";
        EXPECT_NEAR(reading(session, 1, 1), right, 0.01f);
    }
}

TEST(Command, SetSensorsKeepsTheSamplesOfSensorsThatStay) {
    Scene scene = twins();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.interval = 1;
    Session session = open(scene);
    for (int i = 0; i < 90; ++i) session.step();
    const float left = reading(session, 0, 0);
    ASSERT_GT(left, 0.01f);
    std::vector<Sensor> sensors = design(session, 0).sensors;
    std::swap(sensors[0], sensors[1]);
    sensors.push_back({.name = "new", .angle = 0.6f, .interval = 1});
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, sensors}));
    session.step();
    EXPECT_EQ(reading(session, 0, 1), left) << "the left eye is now the second sensor";
    EXPECT_EQ(reading(session, 0, 2), 0) << "until its first sample";
    for (int i = 0; i < 30; ++i) session.step();
    EXPECT_NE(reading(session, 0, 1), left);
    EXPECT_GT(reading(session, 0, 2), 0);
}

TEST(Command, SetSensorsOfAKindReplacesOwnSensorsAndUndoRestoresThem) {
    Session session = open(twins());
    const std::vector<Sensor> of_kind = design(session, 0).sensors;
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 1}, heat_eye()}));
    ASSERT_FALSE(session.apply(SetSensors{{.kind = 0}, {of_kind[0]}}));
    EXPECT_EQ(design(session, 1).sensors, std::vector{of_kind[0]});
    session.undo();
    EXPECT_EQ(design(session, 0).sensors, of_kind);
    EXPECT_EQ(design(session, 1).sensors, heat_eye());
    session.undo();
    EXPECT_EQ(design(session, 1).sensors, of_kind);
    EXPECT_LT(find_vehicle(session.snapshot(), 1)->design, 0);
}

TEST(Command, EditsOfTheScenePreserveOwnSensors) {
    Session session = open(twins());
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, heat_eye()}));
    ASSERT_FALSE(session.apply(AddObstacle{{"", 10, 10}}));
    ASSERT_FALSE(session.apply(NewPopulation{}));
    EXPECT_EQ(design(session, 0).sensors, heat_eye());
    ASSERT_FALSE(session.apply(RemoveVehicle{0}));
    session.undo();
    EXPECT_EQ(design(session, 0).sensors, heat_eye()) << "it returns with them";
    session.reset();
    EXPECT_EQ(design(session, 0).sensors, heat_eye());
    EXPECT_GT(reading(session, 0, 0), 0);
}

TEST(Command, ABrainOfTheKindIsCompiledForOwnSensors) {
    Scene scene = twins();
    Session session = open(scene);
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, heat_eye()}));
    BrainGraph brain = scene.kinds[0].brain;
    brain.nodes.push_back({.id = 50, .kind = NodeKind::sensor, .name = "H"});
    brain.wires.push_back({.from = 50, .to = find_node(brain, "ML")->id, .weight = 0.5f});
    ASSERT_FALSE(session.apply(SetBrain{{.kind = 0}, brain}));
    const Snapshot& now = session.snapshot();
    EXPECT_EQ(missing_sensors(*brain_of(now, now.vehicles[0]), design(session, 0)),
              (std::vector<std::string>{"SL", "SR"}));
    EXPECT_EQ(missing_sensors(*brain_of(now, now.vehicles[1]), design(session, 1)), std::vector<std::string>{"H"});
    EXPECT_GT(now.vehicles[0].motor[0], now.vehicles[0].motor[1] + 0.05f) << "the heat drives the left motor";
    EXPECT_NEAR(now.vehicles[1].motor[0], now.vehicles[1].motor[1], 1e-5f);
}

TEST(SceneFile, ReadsOwnSensorsOfAVehicleAndOfAMember) {
    const std::string text = R"(format = 1
[ecology]
population = 1
[kind.k]
[kind.k.sensor.SL]
[vehicle.a]
kind = "k"
[vehicle.a.sensor.H]
channel = "heat"
range = 5
[vehicle.b]
kind = "k"
[vehicle.b.sensor]
[member.0.sensor.S]
channel = "smell"
)";
    const auto scene = parse_scene(text, "own.toml");
    ASSERT_TRUE(scene) << scene.error().text();
    ASSERT_TRUE(scene->starts[0].sensors && scene->starts[1].sensors && scene->members[0].sensors);
    EXPECT_EQ(scene->starts[0].sensors->front().range, 5);
    EXPECT_TRUE(scene->starts[1].sensors->empty()) << "an empty table: no sensors";
    const Session session = open(*scene);
    EXPECT_EQ(design(session, 0).sensors.front().channel, Channel::heat);
    EXPECT_TRUE(design(session, 1).sensors.empty());
    EXPECT_EQ(design(session, 2).sensors.front().channel, Channel::smell);
    const auto saved = parse_scene(write_scene(session.edited_scene()), "saved.toml");
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(saved->starts, scene->starts);
    EXPECT_EQ(saved->members.at(0).sensors, scene->members[0].sensors);
    const auto wrong = parse_scene(text + "range = 1000\n", "own.toml");
    ASSERT_FALSE(wrong);
    EXPECT_TRUE(tells(wrong.error(), message_of("out_of_range", "range", 1000, 0.05, 100)));
    EXPECT_TRUE(wrong.error().text().starts_with("own.toml:16: "));
    const auto wide = parse_scene(text + "shape = \"triangle\"\nfield = 200\n", "own.toml");
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().text().rfind("own.toml:17: a triangle opens by 179 degrees at most", 0), 0u);
}

TEST(RunFile, KeepsOwnSensors) {
    Scene scene = twins();
    Session session = open(scene);
    std::vector<Sensor> slow = heat_eye();
    slow.front().latency = 0.3f;
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 1}, slow}));
    for (int i = 0; i < 400; ++i) session.step();
    const auto run = io::read_run(io::write_run(session.save()), "own.run");
    ASSERT_TRUE(run) << run.error().text();
    Session resumed = Session::resume(*run);
    EXPECT_EQ(design(resumed, 1).sensors, slow);
    for (int i = 0; i < 400; ++i) session.step(), resumed.step();
    EXPECT_EQ(resumed.hash(), session.hash());
}

TEST(RunFile, RefusesOwnSensorsThatAreNotValid) {
    Session session = open(twins());
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 1}, heat_eye()}));
    for (int i = 0; i < 301; ++i) session.step();
    const std::string text = io::write_run(session.save());
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const auto at = changed.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return io::read_run(changed.replace(at, from.size(), to), "own.run");
    };
    ASSERT_TRUE(with("\"own_sensors\":[-1,0]", "\"own_sensors\":[-1,0]"));
    EXPECT_FALSE(with("\"own_sensors\":[-1,0]", "\"own_sensors\":[-1,1]"));
    EXPECT_FALSE(with("\"own_sensors\":[-1,0]", "\"own_sensors\":[0]"));
    EXPECT_FALSE(with("\"own_sensors\":[-1,0]", "\"own_sensors\":[0,0]")) << "the readings do not fit";
    EXPECT_FALSE(with("\"name\":\"H\",", "\"name\":\"\","));
}

TEST(VehicleTable, HasTheOwnSensorsOfVehicles) {
    Session session = open(twins());
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, heat_eye()}));
    const std::string header = io::csv_header(io::vehicle_columns(session.snapshot(), {io::ColumnGroup::sensors}));
    EXPECT_NE(header.find("sensor_SL,sensor_SR,sensor_H"), std::string::npos) << header;
}

Exercise exercise_with(const Scene& scene) {
    Exercise exercise;
    exercise.scene = scene;
    exercise.seconds = 1;
    return exercise;
}

TEST(Grade, ASubmissionHasTheOwnSensorsOfTheFirstVehicle) {
    const Exercise exercise = exercise_with(twins());
    Session session = open(exercise.scene);
    EXPECT_EQ(submission_of(exercise, session.snapshot()), as_shipped(exercise));
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, heat_eye()}));
    EXPECT_EQ(submission_of(exercise, session.snapshot()).sensors, heat_eye());
    EXPECT_EQ(as_shipped(exercise).sensors, exercise.scene.kinds[0].sensors);
}

TEST(Referee, OwnSensorsOfAnotherKindAreHelp) {
    Scene scene = twins();
    scene.kinds.push_back(scene.kinds[0]);
    scene.kinds[1].name = "other";
    scene.starts[1].kind = "other";
    const Exercise exercise = exercise_with(scene);
    for (const bool given : {false, true}) {
        Exercise own = exercise;
        if (given) own.scene.starts[1].sensors = heat_eye();
        for (const VehicleId changed : {0, 1}) {
            Session session = open(own.scene);
            Referee referee(own);
            referee.watch(session.snapshot());
            EXPECT_FALSE(referee.by_hand());
            ASSERT_FALSE(session.apply(SetSensors{{.vehicle = changed}, {{.name = "X"}}}));
            referee.watch(session.snapshot(), SetSensors{{.vehicle = changed}, {{.name = "X"}}});
            session.step();
            referee.watch(session.snapshot());
            EXPECT_EQ(referee.by_hand(), changed == 1) << given;
        }
    }
}

TEST(Command, SetSensorsKeepsTheReadingOfARenamedSensor) {
    Scene scene = twins();
    for (Sensor& sensor : scene.kinds[0].sensors) sensor.latency = 0.5f;
    for (const Target target : {Target{.vehicle = 0}, Target{.kind = 0}}) {
        Session session = open(scene);
        for (int i = 0; i < 60; ++i) session.step();
        std::vector<Sensor> sensors = design(session, 0).sensors;
        const float left = reading(session, 0, 0), right = reading(session, 0, 1);
        ASSERT_GT(left, 0.01f);
        sensors[0].name = "eye";
        ASSERT_FALSE(session.apply(SetSensors{target, sensors}));
        EXPECT_NEAR(reading(session, 0, 0), left, 0.01f);
        EXPECT_NEAR(reading(session, 0, 1), right, 0.01f);
        session.step();
        EXPECT_NEAR(reading(session, 0, 0), left, 0.01f) << "also what its brain has not received yet";
        sensors[0].name = "heat", sensors[0].channel = Channel::heat;
        ASSERT_FALSE(session.apply(SetSensors{target, sensors}));
        EXPECT_EQ(reading(session, 0, 0), 0) << "a sensor of another channel is a new one";
    }
}

}  // namespace
}  // namespace braitenlab::tests::own_sensors_test
