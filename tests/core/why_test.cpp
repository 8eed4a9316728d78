// The cause of a turn: what each sensor adds to the difference between the wheels.
#include "core/insight/why.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::why_test {
namespace {

using insight::BrainMoment;
using insight::Why;

float sum_of(const Why& why) {
    float sum = why.bias + why.rest;
    for (const insight::SensorPart& part : why.sensors) sum += part.value;
    return sum;
}

const insight::SensorPart& part_of(const Why& why, const std::string& sensor) {
    for (const insight::SensorPart& part : why.sensors)
        if (part.sensor == sensor) return part;
    ADD_FAILURE() << sensor;
    return why.sensors.front();
}

// The moments of the first vehicle, the last one being the present one.
struct BrainRun {
    World world;
    std::vector<BrainMoment> past{};
    Snapshot now{};

    explicit BrainRun(const Scene& scene, int ticks) : world(make(scene)) {
        for (int tick = 0; tick <= ticks; ++tick) {
            if (tick > 0) world.step();
            world.capture(now);
            if (tick + static_cast<int>(insight::silenced_ticks) >= ticks)
                past.push_back(insight::moment_of(now, now.vehicles.front()));
        }
    }
    Why why() const { return insight::why(now, now.vehicles.front(), past); }
};

TEST(Why, OfWiresIsTheSignalToTheRightMotorMinusThatToTheLeft) {
    Scene scene = alone({.LL = 0.2f, .LR = 0.7f, .RL = 0.9f, .RR = 0.1f, .LM = 0.1f, .RM = 0.15f});
    scene.sources = {{.name = "lamp", .x = 3, .y = 2}};
    const BrainRun run(scene, 20);
    const Why why = run.why();
    const float left = run.now.sensed[0], right = run.now.sensed[1];
    ASSERT_GT(left, right);
    EXPECT_FLOAT_EQ(part_of(why, "SL").value, left * (0.9f - 0.2f)) << "RL drives the right wheel";
    EXPECT_FLOAT_EQ(part_of(why, "SR").value, right * (0.1f - 0.7f));
    EXPECT_FLOAT_EQ(part_of(why, "SL").reading, left);
    EXPECT_FLOAT_EQ(why.bias, 0.05f);
    EXPECT_NEAR(why.rest, 0, 1e-6f);
    EXPECT_EQ(why.ticks, 0u);
    EXPECT_EQ(why.sensors.front().sensor, "SL") << "the largest part first";
}

TEST(Why, PartsBiasAndRestAddUpInEveryShippedScene) {
    for (const char* name : {"2b-aggressor", "3c-values", "4b-decision", "5-logic", "tortoise", "obstacle-course",
                             "line-follower", "7-mnemotrix"}) {
        const BrainRun run(shipped_scene(name), 200);
        const Why why = run.why();
        EXPECT_NEAR(sum_of(why), why.right - why.left, 1e-5f) << name;
    }
}

// A neuron between the left sensor and the right motor: its sensor's part is what is lost without it.
TEST(Why, ThroughANeuronIsWhatIsLostWithoutTheSensor) {
    Scene scene = alone({.LM = 0.2f, .RM = 0.2f});
    BrainGraph& brain = scene.kinds[0].brain;
    const NodeId sensor = find_node(brain, std::string("SL"))->id, motor = find_node(brain, std::string("MR"))->id;
    brain.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "N"});
    brain.wires.push_back({.from = sensor, .to = 50, .weight = 0.5f});
    brain.wires.push_back({.from = 50, .to = motor, .weight = 0.8f});
    scene.sources = {{.name = "lamp", .x = 3, .y = 2}};
    const BrainRun run(scene, 60);
    const Why why = run.why();
    EXPECT_EQ(why.ticks, insight::silenced_ticks);
    EXPECT_NEAR(part_of(why, "SL").value, run.now.sensed[0] * 0.5f * 0.8f, 1e-5f);
    EXPECT_GT(part_of(why, "SL").value, 0.05f);
    EXPECT_FLOAT_EQ(part_of(why, "SR").value, 0);
    EXPECT_NEAR(why.rest, 0, 1e-5f);

    const Why unknown = insight::why(run.now, run.now.vehicles.front());
    EXPECT_EQ(unknown.ticks, 0u);
    EXPECT_NEAR(unknown.rest, why.right - why.left, 1e-5f) << "without moments the part is in the rest";
}

TEST(Why, TheCauseIsTheFirstOfTheLargestPartsThatIsNotShownAsZero) {
    using Parts = std::vector<float>;
    EXPECT_EQ(insight::main_part(Parts{}), std::nullopt);
    EXPECT_EQ(insight::main_part(Parts{0.1f, 0.3f, -0.5f}), 1u) << "a part against the turn is no cause";
    EXPECT_EQ(insight::main_part(Parts{0.1f, 0.25f, 0.25f}), 1u);
    EXPECT_EQ(insight::main_part(Parts{-0.2f, 0.004f, 0}), std::nullopt);
    EXPECT_EQ(insight::main_part(Parts{0, insight::least_part}), 1u);
}

TEST(Why, SilencedPartsHaveNoEffect) {
    Scene scene = alone({.LR = 0.7f, .RL = 0.9f});
    scene.sources = {{.name = "lamp", .x = 3}};
    find_node(scene.kinds[0].brain, std::string("SL"))->silenced = true;
    find_node(scene.kinds[0].brain, std::string("ML"))->silenced = true;
    const Why why = BrainRun(scene, 20).why();
    EXPECT_EQ(part_of(why, "SL").value, 0);
    EXPECT_EQ(part_of(why, "SL").reading, 0);
    ASSERT_GT(part_of(why, "SR").reading, 0);
    EXPECT_EQ(part_of(why, "SR").value, 0) << "its motor is silenced";
    EXPECT_EQ(why.right, 0);
}

}  // namespace
}  // namespace braitenlab::tests::why_test
