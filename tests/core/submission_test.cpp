#include "core/lesson/submission.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"

namespace braitenlab::tests::submission_test {
namespace {

const std::string text = R"(format = 1
title = "Title"
goal = "Goal"
chapter = 2
offers = ["LL=RR", "LM"]

[scene.kind.one.sensor.SL]
y = 0.2
angle = 35
[scene.kind.one.sensor.SR]
y = -0.2
angle = -35
[scene.kind.one.brain]
LL = 1.5
RR = 1.5
[scene.vehicle.one]
kind = "one"
x = -3
[scene.source.lamp]
x = 3

[[step]]
text = "It runs"
goal = "runs"
seconds = 1

[solution]
LL = 0.5
RR = 0.5

[[wrong]]
name = "narrow eyes"
text = "It sees too little."
[wrong.set]
"kind.one.sensor.SL.angle" = 10

[[wrong]]
name = "a loop"
[[wrong.node]]
name = "N"
[[wrong.node]]
name = "ML"
kind = "motor"
[[wrong.node]]
name = "MR"
kind = "motor"
[[wrong.wire]]
from = "N"
to = "ML"
)";

std::string with(const std::string& from, const std::string& to) {
    std::string changed = text;
    return changed.replace(changed.find(from), from.size(), to);
}

Exercise read(const std::string& toml) {
    auto exercise = parse_exercise(toml, "own.toml");
    if (!exercise) throw std::runtime_error(exercise.error().text());
    return *exercise;
}

std::string error_of(const std::string& toml) {
    const auto exercise = parse_exercise(toml, "own.toml");
    return exercise ? "accepted" : exercise.error().text();
}

int line_of(const std::string& toml, const std::string& part) {
    const auto end = toml.begin() + static_cast<std::ptrdiff_t>(toml.find(part));
    return 1 + static_cast<int>(std::count(toml.begin(), end, '\n'));
}

TEST(Submission, AnExerciseHoldsItsScene) {
    const Exercise exercise = read(text);
    EXPECT_EQ(exercise.scene.sources.size(), 1u);
    EXPECT_EQ(exercise.scene.name, "own");
    EXPECT_EQ(exercise.chapter, 2);
    const std::string outside = with("x = 3\n\n", "x = 3000\n\n");
    EXPECT_NE(error_of(outside).find("own.toml:" + std::to_string(line_of(outside, "x = 3000"))), std::string::npos)
        << error_of(outside);
    EXPECT_NE(error_of(with("[scene.source.lamp]\nx", "[scene.source.lamp]\nxx")).find("nearest is"),
              std::string::npos);
}

TEST(Submission, AnAnswerReplacesTheBrainOrChangesValues) {
    const Exercise exercise = read(text);
    EXPECT_EQ(with_solution(exercise).brain, make_graph({.LL = 0.5f, .RR = 0.5f}));
    EXPECT_EQ(with_solution(exercise).sensors, as_shipped(exercise).sensors);
    const Submission& narrow = exercise.wrong[0].submission;
    EXPECT_EQ(narrow.brain, as_shipped(exercise).brain);
    EXPECT_NEAR(narrow.sensors[0].angle, 0.1745f, 1e-3f);
    EXPECT_EQ(exercise.wrong[1].submission.brain.nodes.size(), 3u);
}

TEST(Submission, AnErrorInAnAnswerNamesItsLine) {
    const auto expect = [](const std::string& toml, const std::string& at, const std::string& told) {
        const std::string error = error_of(toml);
        EXPECT_NE(error.find("own.toml:" + std::to_string(line_of(toml, at))), std::string::npos) << error;
        EXPECT_NE(error.find(told), std::string::npos) << error;
    };
    expect(with("to = \"ML\"", "to = \"MX\""), "to = \"MX\"", "nearest is");
    expect(with("SL.angle\" = 10", "SX.angle\" = 10"), "SX.angle", "nearest is 'kind.one.sensor.S");
    expect(with("SL.angle\" = 10", "SL.angle\" = 999"), "SL.angle\" = 999", "outside -180 .. 180");
}

TEST(Submission, OffersAreDialsThatMoveTogetherOrParts) {
    EXPECT_EQ(parse_offer("LL=RR")->dials, (std::vector<Dial>{Dial::LL, Dial::RR}));
    EXPECT_EQ(parse_offer("threshold_LR")->dials, std::vector<Dial>{Dial::threshold_LR});
    EXPECT_TRUE(parse_offer("wiring")->dials.empty());
    for (const char* offer : {"", "LX", "LL=", "=LL", "LL=wiring", "wirings"})
        EXPECT_FALSE(parse_offer(offer)) << offer;
    const std::string unknown = with("\"LM\"]", "\"LX\"]");
    EXPECT_NE(error_of(unknown).find("'LX' is no control"), std::string::npos) << error_of(unknown);
}

using Names = std::vector<std::string>;

TEST(Submission, WhatIsNotOfferedIsNamed) {
    const Exercise exercise = read(text);
    const Submission shipped = as_shipped(exercise);
    EXPECT_EQ(outside_offers(exercise, shipped), Names{});
    EXPECT_EQ(outside_offers(exercise, with_solution(exercise)), Names{});
    const auto dials = [&](const FourNeurons& four) {
        return outside_offers(exercise, with_brain(exercise, make_graph(four)));
    };
    EXPECT_EQ(dials({.LL = 1, .RR = 1, .LM = 0.5f}), Names{});
    EXPECT_EQ(dials({.LL = 1.5f, .LR = 1, .RR = 1.5f, .RM = 0.5f}), (Names{"LR", "RM"}));
    EXPECT_EQ(outside_offers(exercise, exercise.wrong[0].submission), Names{"sensors"});
    EXPECT_EQ(outside_offers(exercise, exercise.wrong[1].submission), (Names{"wiring"}));
    Submission heavy = shipped;
    heavy.body.mass = 20;
    EXPECT_EQ(outside_offers(exercise, heavy), Names{"body"});
    Submission curved = shipped;
    curved.brain.wires[0].curve.response = Response::hump;
    EXPECT_EQ(outside_offers(exercise, curved), Names{"curves"});
    Submission moved = shipped;
    moved.brain.nodes[0].place = maths::vec2{7, 7};
    EXPECT_EQ(outside_offers(exercise, moved), Names{}) << "positions on the canvas do not count";
}

TEST(Submission, LesionsAndLearningOfDirectWiresAreWiring) {
    const Exercise exercise = read(text);
    const Submission shipped = as_shipped(exercise);
    const auto outside = [&](const std::function<void(Wire&)>& change) {
        Submission changed = shipped;
        change(*find_wire(changed.brain, four_neuron_ids::SR, four_neuron_ids::ML));
        return outside_offers(exercise, changed);
    };
    EXPECT_EQ(outside([](Wire& wire) { wire.cut = true; }), Names{"wiring"});
    EXPECT_EQ(outside([](Wire& wire) { wire.learning_rate = 1; }), Names{"wiring"});
    EXPECT_EQ(outside([](Wire& wire) { wire.decay = 1; }), Names{"wiring"});
    Submission without = shipped;
    std::erase_if(without.brain.wires, [](const Wire& wire) { return wire.weight == 0; });
    EXPECT_EQ(outside_offers(exercise, without), Names{}) << "a wire of weight 0 is no wire";
    std::reverse(without.brain.wires.begin(), without.brain.wires.end());
    EXPECT_EQ(outside_offers(exercise, without), Names{}) << "the order of wires does not count";
}

TEST(Submission, OffersThatCannotBeOneControlAreRefused) {
    const auto told = [](const std::string& offers) {
        return error_of(with("offers = [\"LL=RR\", \"LM\"]", "offers = [" + offers + "]"));
    };
    EXPECT_EQ(told("\"LL=RR\", \"threshold_LL\""), "accepted");
    EXPECT_NE(told("\"LL=LM\"").find("'LL=LM' joins dials of different ranges"), std::string::npos);
    EXPECT_NE(told("\"LL=RR\", \"RR\"").find("'RR' is offered twice"), std::string::npos);
    EXPECT_NE(told("\"LL=LL\"").find("'LL' is offered twice"), std::string::npos);
    EXPECT_NE(told("\"LL\", \"wiring\"]\nchanges = 1\nhint = [").find("'changes' does not count wires"),
              std::string::npos);
}

TEST(Submission, TheFirstVehicleHasTheBrainAndTheSensorsOfItsKind) {
    const auto told = [](const std::string& own) {
        const std::string toml = with("[scene.source.lamp]", own + "\n[scene.source.lamp]");
        const std::string place = "own.toml:" + std::to_string(line_of(toml, own)) + ":";
        const std::string error = error_of(toml);
        EXPECT_EQ(error.rfind(place, 0), 0u) << error;
        return error;
    };
    const std::string brain = told("[scene.vehicle.one.brain]\nLL = 1\n");
    EXPECT_NE(brain.find("set it in [kind.one]"), std::string::npos) << brain;
    const std::string sensors = told("[scene.vehicle.one.sensor.SL]\ny = 1\n");
    EXPECT_NE(sensors.find("set them in [kind.one]"), std::string::npos) << sensors;
}

TEST(Submission, ASettingOfAnAnswerChangesWhatTheStudentMayChange) {
    const std::string set = "\"kind.one.sensor.SL.angle\" = 10";
    const auto told = [&](const std::string& more) {
        const std::string toml = with(set, set + "\n" + more);
        const std::string error = error_of(toml);
        EXPECT_EQ(error.rfind("own.toml:" + std::to_string(line_of(toml, more)) + ":", 0), 0u) << error;
        return error;
    };
    EXPECT_NE(told("\"source.lamp.x\" = 2").find("the student cannot change 'source.lamp.x'"), std::string::npos);
    told("\"vehicle.one.heading\" = 90");
    EXPECT_EQ(error_of(with(set, set + "\n\"kind.one.body.mass\" = 12")), "accepted");
    EXPECT_EQ(error_of(with(set, set + "\n\"source.lamp.x\" = 3")), "accepted") << "the same value";
}

TEST(Submission, PartsThatAreOfferedMayChange) {
    const Exercise exercise = read(with("\"LL=RR\", \"LM\"", "\"sensors\", \"wiring\""));
    EXPECT_EQ(outside_offers(exercise, exercise.wrong[0].submission), Names{});
    EXPECT_EQ(outside_offers(exercise, exercise.wrong[1].submission), Names{});
    Submission fewer = as_shipped(exercise);
    fewer.sensors.pop_back();
    EXPECT_EQ(outside_offers(exercise, fewer), Names{"sensors"}) << "only values of the sensors are offered";
    const Exercise free = read(with("offers = [\"LL=RR\", \"LM\"]\n", ""));
    EXPECT_EQ(outside_offers(free, fewer), Names{});
}

TEST(Submission, DialsThatMoveTogetherAreOneChange) {
    const Exercise exercise = read(text);
    const auto changed = [&](const FourNeurons& four) {
        return changed_controls(exercise, with_brain(exercise, make_graph(four)));
    };
    EXPECT_EQ(changed({.LL = 1.5f, .RR = 1.5f}), 0);
    EXPECT_EQ(changed({.LL = 1, .RR = 1}), 1);
    EXPECT_EQ(changed({.LL = 1, .RR = 1, .LM = 0.5f}), 2);
}

}  // namespace
}  // namespace braitenlab::tests::submission_test
