#include "ui/panels/brain/brain_analysis.h"

#include "core/brain/presets.h"
#include "core/insight/why.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "desk.h"

namespace braitenlab::tests::motor_sum_test {

using namespace ui;

namespace {

// What wires beside the pair bring.
float further(const MotorSum& sum) {
    float all = sum.rest;
    for (const Term& term : sum.terms) all += term.value;
    return all;
}
float added_up(const MotorSum& sum) { return sum.products[0].value + sum.products[1].value + sum.bias + further(sum); }

// One vehicle whose left motor has a third wire, from a neuron with the value `neuron`.
Snapshot with_a_third_wire(float neuron, float weight) {
    Snapshot now = snapshot(0);
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    brain->nodes.push_back({.id = 10, .kind = NodeKind::neuron, .name = "N"});
    brain->wires.push_back({.from = 10, .to = find_node(*brain, "ML")->id, .weight = weight});
    now.brains[0] = brain;
    const float left = 0.4f * 1.5f + 0.1f + neuron * weight, right = 0.2f * 1.5f + 0.1f;
    now.neurons = {neuron, left, right};
    now.vehicles[0].neuron_count = 3;
    now.vehicles[0].motor = {std::min(left, 1.0f), right};
    return now;
}

}  // namespace

TEST(BrainAnalysis, GivesProductsAndBiasForABrainWithFourWires) {
    const Snapshot now = snapshot(0);  // a coward: SL 0.4 and SR 0.2 times 1.5, and 0.1
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_FLOAT_EQ(added_up(sums[0]), 0.7f);
    EXPECT_FLOAT_EQ(added_up(sums[1]), 0.4f);
    EXPECT_FALSE(sums[0].more_wires);
}

TEST(BrainAnalysis, ReportsTheEffectOfALesion) {
    Snapshot now = snapshot(0);
    BrainGraph hurt = *now.brains[0];
    find_node(hurt, "SR")->silenced = true;
    find_wire(hurt, 0, 2)->cut = true;  // LL
    now.brains[0] = std::make_shared<BrainGraph>(hurt);
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_TRUE(sums[0].products[0].cut);
    EXPECT_EQ(sums[0].products[0].value, 0);
    EXPECT_EQ(sums[1].products[0].input, 0) << "a covered eye reads zero";
    EXPECT_FALSE(sums[0].more_wires) << "a lesion is not a further wire";

    find_node(hurt, "MR")->silenced = true;
    now.brains[0] = std::make_shared<BrainGraph>(hurt);
    now.vehicles[0].motor[1] = 0;
    const auto stopped = motor_sums(now, now.vehicles[0]);
    EXPECT_TRUE(stopped[1].stopped);
    EXPECT_EQ(stopped[1].rest, 0) << "a stopped motor is not braked by further wires";
}

TEST(BrainAnalysis, AddsTheSignalsOfFurtherWires) {
    const Snapshot now = with_a_third_wire(0.5f, -0.8f);
    const auto sums = motor_sums(now, now.vehicles[0]);
    ASSERT_TRUE(sums[0].more_wires);
    EXPECT_NEAR(further(sums[0]), -0.4f, 1e-6f);
    EXPECT_NEAR(added_up(sums[0]), sums[0].total, 1e-6f);
    EXPECT_NEAR(further(sums[1]), 0, 1e-6f);
}

TEST(BrainAnalysis, ShowsProductsOfWiresThatExist) {
    Snapshot now = with_a_third_wire(0.5f, -0.8f);
    EXPECT_TRUE(motor_sums(now, now.vehicles[0])[0].shows_products);
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    std::erase_if(brain->wires, [&](const Wire& wire) {
        const Node* from = find_node(*brain, wire.from);
        return from && from->kind == NodeKind::sensor;
    });
    now.brains[0] = brain;
    for (const MotorSum& sum : motor_sums(now, now.vehicles[0])) EXPECT_FALSE(sum.shows_products);
}

TEST(BrainAnalysis, NamesTheLargestContributionsAndSumsTheRest) {
    Snapshot now = with_a_third_wire(0.5f, -0.8f);
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    const NodeId motor = find_node(*brain, "ML")->id;
    for (const auto& [id, name, weight] :
         {std::tuple{11, "A", 0.2f}, std::tuple{12, "B", 1.5f}, std::tuple{13, "C", 0.1f}}) {
        brain->nodes.push_back({.id = id, .kind = NodeKind::neuron, .name = name});
        brain->wires.push_back({.from = id, .to = motor, .weight = weight});
    }
    now.brains[0] = brain;
    now.neurons = {0.5f, 0.5f, 0.5f, 0.5f, 0.6f + 0.1f - 0.4f + 0.1f + 0.75f + 0.05f, 0.4f};
    now.vehicles[0].neuron_count = 6;
    now.vehicles[0].motor = {1, 0.4f};
    const auto sums = motor_sums(now, now.vehicles[0]);
    ASSERT_EQ(sums[0].terms.size(), 2u);
    EXPECT_EQ(sums[0].terms[0].name, "B");
    EXPECT_EQ(sums[0].terms[1].name, "N");
    EXPECT_FLOAT_EQ(sums[0].terms[0].value, 0.75f);
    EXPECT_NEAR(sums[0].rest, 0.15f, 1e-5f) << "A and C";
    EXPECT_EQ(cause(sums).name, "B") << "the largest push to the right";
}

TEST(BrainAnalysis, ShowsTheWiresOfTheChosenPairAsProducts) {
    auto scene = load_scene(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/3c-values.toml");
    ASSERT_TRUE(scene);
    auto world = World::create(*scene, 1);
    Snapshot now;
    for (int tick = 0; tick < 200; ++tick) world->step();
    world->capture(now);
    const auto sums = motor_sums(now, now.vehicles[0], {"HL", "HR"});
    EXPECT_EQ(sums[0].products[0].letters, "HL·LL");
    EXPECT_EQ(sums[0].products[0].weight, read_dials(*now.brains[0], {"HL", "HR"}).LL);
    EXPECT_NE(sums[0].products[0].weight, 0);
    EXPECT_NEAR(std::clamp(added_up(sums[0]), -1.0f, 1.0f), sums[0].total, 1e-4f);
}

TEST(BrainAnalysis, DescribesABrainWithNeuronsByItsPartsIfItsResponseSaysLittle) {
    Snapshot now = with_a_third_wire(0.5f, 0.8f);
    Recognised known;
    known.single = Character::indifferent;
    EXPECT_FALSE(shown_character(known, now, now.vehicles[0], {}));
    known.single = Character::orbiting;
    EXPECT_EQ(shown_character(known, now, now.vehicles[0], {}), Character::orbiting);
    now = snapshot(0);
    known.single = Character::indifferent;
    EXPECT_EQ(shown_character(known, now, now.vehicles[0], {}), Character::indifferent) << "it has no neuron";
}

TEST(BrainAnalysis, DoesNotReportTheLimitOfAWheelAsAFurtherWire) {
    const Snapshot now = with_a_third_wire(1, 1);  // 1.7, which the wheel clamps to 1
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_NEAR(further(sums[0]), 1, 1e-6f);
    EXPECT_FLOAT_EQ(sums[0].total, 1);
}

// The sum of the further wires of a motor without curve and memory, wire by wire.
float brought_by_others(const Snapshot& now, const VehicleView& vehicle, const BrainGraph& brain, const Node& motor) {
    float sum = 0;
    for (const Wire& wire : brain.wires) {
        const std::string& from = find_node(brain, wire.from)->name;
        if (wire.to == motor.id && from != "SL" && from != "SR")
            sum += signal(wire, node_value(now, vehicle, wire.from), learned(now, vehicle, wire.from, wire.to));
    }
    return sum;
}

TEST(BrainAnalysis, HasSumsEqualToTheMotorInputsForEveryPreset) {
    int seen = 0, curved = 0;
    for (const Preset& preset : presets()) {
        auto scene =
            load_scene(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/" + std::string(preset.scene) + ".toml");
        ASSERT_TRUE(scene) << scene.error().text();
        auto world = World::create(*scene, 1);
        ASSERT_TRUE(world) << world.error().text();
        Snapshot now;
        for (int tick = 0; tick < 600; ++tick) {
            world->step();
            if (tick % 20 != 0) continue;
            world->capture(now);
            for (const VehicleView& vehicle : now.vehicles) {
                if (vehicle.driver != Driver::brain) continue;
                const BrainGraph& brain = *now.brains[static_cast<std::size_t>(vehicle.brain)];
                for (const MotorSum& sum : motor_sums(now, vehicle)) {
                    float shown = sum.bias + further(sum);
                    for (const Product& p : sum.products) {
                        EXPECT_NEAR(p.value, p.input * p.weight, 1e-5f) << preset.name << ' ' << p.letters;
                        shown += p.input * p.weight;
                        seen += p.value != 0;
                    }
                    EXPECT_NEAR(std::clamp(shown, -1.0f, 1.0f), sum.total, 1e-4f) << preset.name << ' ' << sum.motor;
                    EXPECT_EQ(sum.limited, std::fabs(shown) > 1.0001f) << preset.name << ' ' << shown;
                    const Node* motor = find_node(brain, std::string(sum.motor));
                    for (const Wire& wire : brain.wires) curved += wire.curve != Curve{};
                    if (motor->curve == Curve{} && motor->time_constant == 0) {
                        EXPECT_NEAR(further(sum), brought_by_others(now, vehicle, brain, *motor), 1e-4f)
                            << preset.name << ' ' << sum.motor << ": the remainder is listed wire by wire";
                    }
                }
            }
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_GT(curved, 0) << "a preset has a wire with a curve";
}

TEST(BrainAnalysis, ShowsTheOutputOfThresholdAndCurve) {
    Snapshot now = snapshot(0);  // SL reads 0.4, SR 0.2
    BrainGraph bent = *now.brains[0];
    find_wire(bent, 0, 2)->curve = {Response::inverted};
    find_wire(bent, 1, 3)->threshold = 0.3f;
    now.brains[0] = std::make_shared<BrainGraph>(bent);
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_FLOAT_EQ(sums[0].products[0].input, 0.6f);
    EXPECT_FLOAT_EQ(sums[0].products[0].value, 0.6f * 1.5f);
    EXPECT_EQ(sums[1].products[0].input, 0);
    EXPECT_TRUE(sums[1].products[0].masked);
    EXPECT_FLOAT_EQ(sums[1].products[0].reading, 0.2f);
    EXPECT_FALSE(sums[0].products[0].masked || sums[0].products[1].masked || sums[1].products[1].masked);
    EXPECT_FALSE(sums[0].more_wires) << "a wire with a curve is not a further wire";
    EXPECT_EQ(sums[0].products[0].letters, "f(SL)·LL") << "what the curve makes of the reading is multiplied";
    EXPECT_EQ(sums[0].products[1].letters, "SR·LR");
}

TEST(BrainAnalysis, ReportsAWheelAtItsLimit) {
    Snapshot now = snapshot(0);
    now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = 2, .RR = 2, .LM = 0.3f, .RM = 0.3f}));
    now.vehicles[0].motor = {1, 0.7f};
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_TRUE(sums[0].limited) << "0.4·2 + 0.3";
    EXPECT_FALSE(sums[1].limited);
    now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = -2, .RR = -2, .LM = -0.3f, .RM = -0.3f}));
    now.vehicles[0].motor = {-1, -0.7f};
    const auto backwards = motor_sums(now, now.vehicles[0]);
    EXPECT_TRUE(backwards[0].limited);
    EXPECT_FALSE(backwards[1].limited);
}

TEST(BrainAnalysis, NamesTheLargestTermAsTheCause) {
    Snapshot now = snapshot(0);
    now.vehicles[0].motor = {0.7f, 0.4f};
    const auto coward = motor_sums(now, now.vehicles[0]);
    EXPECT_EQ(cause(coward).by, Cause::By::product);
    EXPECT_EQ(cause(coward).product->letters, "SL·LL");
    EXPECT_FALSE(cause(coward).holds_back);

    now = with_a_third_wire(1, -0.9f);  // braked so much that the right wheel is faster
    const auto braked = motor_sums(now, now.vehicles[0]);
    EXPECT_EQ(cause(braked).by, Cause::By::term) << "0.9 towards the right, more than the 0.3 of SR·RR";
    now = with_a_third_wire(1, 0.9f);
    const auto pushed = motor_sums(now, now.vehicles[0]);
    EXPECT_EQ(cause(pushed).by, Cause::By::term);
    EXPECT_EQ(cause(pushed).product, nullptr);
}

// Each eye drives both wheels alike: what differs is the bias.
TEST(BrainAnalysis, NamesNoSensorThatDrivesBothWheelsAlike) {
    Snapshot now = snapshot(0);
    now.sensed = {0, 0.45f};
    now.brains[0] = std::make_shared<BrainGraph>(
        make_graph({.LL = 0.4f, .LR = 0.4f, .RL = 0.4f, .RR = 0.4f, .LM = 0.70f, .RM = 0.66f}));
    now.vehicles[0].motor = {0.88f, 0.84f};
    EXPECT_EQ(cause(motor_sums(now, now.vehicles[0])).by, Cause::By::biases);
    now.brains[0] = std::make_shared<BrainGraph>(
        make_graph({.LL = 0.4f, .LR = 0.4f, .RL = 0.4f, .RR = 0.2f, .LM = 0.70f, .RM = 0.66f}));
    now.vehicles[0].motor = {0.88f, 0.75f};
    EXPECT_EQ(cause(motor_sums(now, now.vehicles[0])).name, "SR·LR") << "0.09 more to the left wheel";
}

// The sentence of the card and the callout in the scene name the same cause, also of equal parts.
TEST(BrainAnalysis, NamesTheCauseThatTheCalloutNames) {
    int by_sensor = 0, by_bias = 0;
    for (int i = 0; i < 256; ++i) {
        const auto quarter = [&](int digit) { return static_cast<float>((i >> (2 * digit)) % 4 - 1) / 4; };
        const FourNeurons dials{
            .LL = quarter(0), .LR = quarter(1), .RL = quarter(2), .RR = quarter(3), .LM = 0.25f, .RM = 0};
        Snapshot now = snapshot(0);
        now.brains[0] = std::make_shared<BrainGraph>(make_graph(dials));
        now.sensed = {1, 0.5f};
        now.vehicles[0].motor = {dials.LL + dials.LR / 2 + 0.25f, dials.RR / 2 + dials.RL};
        const insight::Why why = insight::why(now, now.vehicles[0]);
        const float towards = why.right > why.left ? 1.0f : -1.0f;
        std::vector<float> parts;
        for (const insight::SensorPart& part : why.sensors) parts.push_back(part.value * towards);
        parts.push_back(why.bias * towards);
        parts.push_back(why.rest * towards);
        const auto main = insight::main_part(parts);
        const auto sums = motor_sums(now, now.vehicles[0]);
        const Cause shown = cause(sums);
        if (!main) {
            EXPECT_EQ(shown.by, Cause::By::nothing) << i;
        } else if (*main < why.sensors.size()) {
            EXPECT_EQ(shown.name.substr(0, 2), why.sensors[*main].sensor) << i;
            ++by_sensor;
        } else {
            EXPECT_EQ(shown.by, Cause::By::biases) << i;
            ++by_bias;
        }
    }
    EXPECT_GT(by_sensor, 50);
    EXPECT_GT(by_bias, 10);
}

TEST(BrainAnalysis, NamesTheBiasesIfAllOtherTermsAreZero) {
    Snapshot now = snapshot(0);
    FourNeurons biased;
    biased.RM = 0.3f;
    now.brains[0] = std::make_shared<BrainGraph>(make_graph(biased));
    now.vehicles[0].motor = {0, 0.3f};
    const auto sums = motor_sums(now, now.vehicles[0]);
    EXPECT_EQ(cause(sums).by, Cause::By::biases);
}

TEST(BrainAnalysis, TwoEyesForDifferentColoursHaveNoCharacterInAnyBrain) {
    Snapshot now = snapshot(0);
    Scene scene = *now.scene;
    scene.kinds[0].sensors[0].channel = Channel::red, scene.kinds[0].sensors[1].channel = Channel::green;
    now.scene = std::make_shared<Scene>(scene);
    Recognised known;
    recognised(known, now, now.vehicles[0], 0);
    EXPECT_FALSE(shown_character(known, now, now.vehicles[0], {}));
    scene.kinds[0].sensors.pop_back();
    now.scene = std::make_shared<Scene>(scene);
    recognised(known, now, now.vehicles[0], 1);
    EXPECT_TRUE(shown_character(known, now, now.vehicles[0], {})) << "one eye has one";
}

TEST(BrainAnalysis, ABrainThatReadsNoSensorIsIndifferentOrStillWithAnySensors) {
    const Snapshot before = snapshot(0);
    BrainGraph brain = *brain_of(before, before.vehicles[0]);
    brain.wires.clear();
    for (const bool drives : {true, false}) {
        for (Node& node : brain.nodes)
            if (node.kind == NodeKind::motor) node.bias = drives ? 0.5f : 0;
        for (const bool has_eyes : {true, false}) {
            Snapshot now = before;
            now.brains[0] = std::make_shared<BrainGraph>(brain);
            Scene scene = *now.scene;
            if (!has_eyes) scene.kinds[0].sensors.clear();
            now.scene = std::make_shared<Scene>(scene);
            Recognised known;
            recognised(known, now, now.vehicles[0], 0);
            EXPECT_EQ(character_key(known, now, now.vehicles[0], {"SL", "SR"}), drives ? "indifferent" : "still");
        }
    }
}

TEST(BrainAnalysis, OnlyABrainWithANeuronIsNamedAfterItsNeurons) {
    Snapshot now = snapshot(0);
    Scene scene = *now.scene;
    scene.kinds[0].sensors[0].channel = Channel::red, scene.kinds[0].sensors[1].channel = Channel::green;
    now.scene = std::make_shared<Scene>(scene);
    Recognised known;
    recognised(known, now, now.vehicles[0], 0);
    EXPECT_EQ(character_key(known, now, now.vehicles[0], {}), "single_sensors");
    BrainGraph brain = *brain_of(now, now.vehicles[0]);
    Node& neuron = brain.nodes.emplace_back();
    neuron.name = "N", neuron.kind = NodeKind::neuron;
    now.brains[0] = std::make_shared<BrainGraph>(brain);
    recognised(known, now, now.vehicles[0], 1);
    EXPECT_EQ(character_key(known, now, now.vehicles[0], {}), "parts");
}

}  // namespace braitenlab::tests::motor_sum_test
