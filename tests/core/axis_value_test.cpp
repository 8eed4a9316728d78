// The values that an axis can vary: what is offered, its paths and its commands.
#include "core/insight/axis_value.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/scene_number.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::axis_value_test {
namespace {

using insight::AxisValue;
using insight::ValueSubject;

struct Values : testing::Test {
    Scene scene = lit();
    World world = make(scene);
    Snapshot now = snapshot_of(world);

    static Scene lit() {
        Scene scene = alone({.LL = 0.5f, .RR = 0.25f});
        scene.sources = {{.name = "lamp", .x = 4, .y = 1, .strength = 0.75f}};
        return scene;
    }
    ValueSubject subject(Target target = {no_vehicle, 0}) const { return {now, now.vehicles[0], target, {}}; }
    std::vector<AxisValue> values(Target target = {no_vehicle, 0}) const { return axis_values(subject(target)); }
    void set(const std::string& id, float to, Target target = {no_vehicle, 0}) {
        const auto all = values(target);
        for (const Command& command : commands_that_set(subject(target), *find_value(all, id), to))
            ASSERT_FALSE(world.apply(command));
        now = snapshot_of(world);
    }
};

TEST_F(Values, AreThoseOfBrainBodyAndSceneWithThePresentValueInTheUsualRange) {
    const auto all = values();
    for (const char* id : {"LL=RR", "threshold_LR", "sensor.angle", "sensor.field", "sensor.noise", "body.top_speed",
                           "start.x", "start.heading", "source.lamp.x", "source.lamp.strength", "arena.ambient"})
        EXPECT_TRUE(find_value(all, id)) << id;
    for (const AxisValue& value : all) {
        EXPECT_LT(value.from, value.to) << value.id;
        EXPECT_LE(value.from, value.now) << value.id;
        EXPECT_GE(value.to, value.now) << value.id;
        EXPECT_GE(value.from, value.allowed.low) << value.id;
        EXPECT_LE(value.to, value.allowed.high) << value.id;
    }
    EXPECT_FLOAT_EQ(find_value(all, "source.lamp.strength")->now, 0.75f);
    EXPECT_FLOAT_EQ(find_value(all, "sensor.angle")->now, 35);
    EXPECT_TRUE(find_value(all, "sensor.angle")->is_one) << "both sides are mirror images";
    EXPECT_FALSE(find_value(all, "LL=RR")->is_one);
}

TEST_F(Values, OfEachPathIsWhatASettingOfThatPathGives) {
    for (const AxisValue& value : values()) {
        if (value.paths.empty() || !value.dials.empty()) continue;
        Scene set = scene;
        std::vector<Setting> settings;
        for (const std::string& path : value.paths) {
            const bool negative = path.front() == '-';
            const double to = 0.37 * value.from + 0.63 * value.to;
            settings.push_back({path.substr(negative ? 1 : 0), std::to_string(negative ? -to : to)});
            EXPECT_TRUE(set_number_at(set, settings.back().path, std::stod(settings.back().value))) << path;
        }
        const auto read = parse_scene(write_scene(scene), "scene", settings);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(write_scene(*read), write_scene(set)) << value.id;
        EXPECT_NE(write_scene(set), write_scene(scene)) << value.id;
    }
}

TEST_F(Values, AreSetByCommands) {
    for (const auto& [id, to] : {std::pair("sensor.angle", 50.0f),
                                 {"body.mass", 12.0f},
                                 {"source.lamp.strength", 0.5f},
                                 {"arena.ambient", 0.25f},
                                 {"start.x", 3.0f},
                                 {"LL=RR", 1.0f}}) {
        set(id, to);
        EXPECT_NEAR(find_value(values(), id)->now, to, 1e-4f) << id;
        EXPECT_TRUE(find_value(values(), id)->is_one) << id;
        EXPECT_TRUE(commands_that_set(subject(), *find_value(values(), id), find_value(values(), id)->now).empty());
    }
    EXPECT_FLOAT_EQ(now.scene->kinds[0].sensors[1].angle, maths::radians(-50));
    EXPECT_EQ(now.vehicles[0].x, 3) << "moved before the first tick";
    world.step();
    now = snapshot_of(world);
    set("start.x", 1);
    EXPECT_NEAR(now.vehicles[0].x, 3, 0.1f);
    EXPECT_EQ(now.scene->starts[0].x, 1);
}

TEST_F(Values, OfOneVehicleAreItsOwnSensorsAndBrain) {
    scene.starts.push_back(scene.starts[0]);
    scene.starts[1].name = "other", scene.starts[1].x = 9;
    world = make(scene), now = snapshot_of(world);
    const Target alone{0, -1};
    EXPECT_EQ(find_value(values(alone), "sensor.angle")->paths.front(), "vehicle.it.sensor.SL.angle");
    Scene placed = scene;
    place_sensors(placed, subject(alone));
    ASSERT_TRUE(placed.starts[0].sensors);
    EXPECT_FALSE(placed.starts[1].sensors);
    place_brain(placed, subject(alone));
    const std::string path = find_value(values(alone), "LL")->paths.front();
    EXPECT_EQ(path, "vehicle.it.brain.LL");
    const auto varied = parse_scene(write_scene(placed), "scene", {{path, "1.5"}});
    ASSERT_TRUE(varied) << varied.error().text();
    EXPECT_EQ(read_dials(*varied->starts[0].brain).LL, 1.5f);
    EXPECT_EQ(read_dials(*varied->starts[0].brain).RR, 0.25f) << "the rest of its kind's brain";
    EXPECT_FALSE(varied->starts[1].brain);
    set("sensor.angle", 50, alone);
    EXPECT_FLOAT_EQ(kind_of(now, now.vehicles[0]).sensors[0].angle, maths::radians(50));
    EXPECT_FLOAT_EQ(kind_of(now, now.vehicles[1]).sensors[0].angle, maths::radians(35));
}

TEST_F(Values, OfADialOfAnotherPairHasNoPath) {
    EXPECT_EQ(find_value(values(), "LL=RR")->paths,
              (std::vector<std::string>{"kind.tester.brain.LL", "kind.tester.brain.RR"}));
    const ValueSubject other{now, now.vehicles[0], {no_vehicle, 0}, {"SL2", "SR2"}};
    EXPECT_TRUE(find_value(axis_values(other), "LL=RR")->paths.empty());
}

TEST(MapAxis, OfWholePathsMayGiveTheNegativeValue) {
    const auto axis = insight::parse_axis("kind.tester.sensor.SL.angle=-kind.tester.sensor.SR.angle=10:80", "--x");
    ASSERT_TRUE(axis) << axis.error().text();
    EXPECT_EQ(axis->values, (std::vector<std::string>{"kind.tester.sensor.SL.angle", "-kind.tester.sensor.SR.angle"}));
    insight::MapQuestion question{.scene = Values::lit(), .vehicle = 0, .target = {no_vehicle, 0}, .size = 2};
    question.x = *axis;
    const auto base = insight::MapBase::create(question);
    ASSERT_TRUE(base) << base.error().text();
    const Snapshot start = snapshot_of(*(*base)->world({1, 0}, 0));
    EXPECT_FLOAT_EQ(start.scene->kinds[0].sensors[0].angle, maths::radians(80));
    EXPECT_FLOAT_EQ(start.scene->kinds[0].sensors[1].angle, maths::radians(-80));
    question.y = *insight::axis_of("kind.tester.sensor.SR.angle");
    EXPECT_FALSE(insight::MapBase::create(question)) << "both axes set SR";
}

}  // namespace
}  // namespace braitenlab::tests::axis_value_test
