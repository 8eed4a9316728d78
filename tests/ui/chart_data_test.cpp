#include "ui/panels/charts/chart_data.h"

#include <algorithm>
#include <cmath>

#include "desk.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::tests::history_test {

using namespace ui;

namespace {

void pass(Desk& desk, History& history, std::uint64_t tick) {
    desk.now.tick = tick;
    record(history, desk.view);
}

}  // namespace

TEST(ChartData, TakesOneSamplePerPeriodAndDropsTheOldest) {
    Desk desk;
    History history;
    for (std::uint64_t tick = 0; tick < 6000; ++tick) {
        pass(desk, history, tick);
        record(history, desk.view);
        if (tick == 8) {
            EXPECT_EQ(history.signals.size(), 3u);
        }
    }
    EXPECT_EQ(history.signals.size(), History::signal_samples);
    EXPECT_FLOAT_EQ(history.signals.back().sensors[0], 0.4f);
    EXPECT_FLOAT_EQ(history.signals.back().motors[1], 0.5f);
    EXPECT_NEAR(history.signals.back().seconds, 99.95, 1e-6);
    EXPECT_EQ(history.population.size(), 100u);
}

TEST(ChartData, RestartsForANewRunAndForAnotherVehicle) {
    Desk desk;
    History history;
    pass(desk, history, 600);
    desk.view.settings.selection.vehicle = 1;
    pass(desk, history, 700);
    EXPECT_EQ(history.signals.size(), 1u);
    EXPECT_EQ(history.population.size(), 2u);
    pass(desk, history, 0);
    EXPECT_EQ(history.population.size(), 1u);
}

TEST(ChartData, DropsOnlySamplesAfterTheNewTime) {
    Desk desk;
    History history;
    for (std::uint64_t tick = 0; tick <= 600; ++tick) pass(desk, history, tick);
    const auto whole = history.signals.size();
    pass(desk, history, 300);
    EXPECT_EQ(history.population.back().seconds, 5);
    EXPECT_EQ(history.signals.size(), (whole - 1) / 2 + 1);
    EXPECT_EQ(history.signals.front().seconds, 0);
    for (std::uint64_t tick = 300; tick <= 600; ++tick) pass(desk, history, tick);
    EXPECT_EQ(history.signals.size(), whole) << "recording continues from this time";
}

TEST(ChartData, RestartsForAnotherSceneAtTheSameTime) {
    Desk desk;
    History history;
    pass(desk, history, 0);
    desk.now = snapshot(0);  // one vehicle, neither predator nor prey
    ++desk.view.run_id;
    pass(desk, history, 0);
    ASSERT_EQ(history.population.size(), 1u);
    EXPECT_EQ(history.population.back().count, (std::array{0, 0, 1}));
}

TEST(ChartData, FollowsEditsAtThePresentTick) {
    Desk desk;
    History history;
    pass(desk, history, 0);
    desk.now.vehicles.pop_back();
    desk.now.sensed = std::vector<float>(desk.now.sensed.size(), 0.7f);
    pass(desk, history, 0);
    ASSERT_EQ(history.population.size(), 1u);
    EXPECT_EQ(history.population.back().count[1], 7);
    ASSERT_EQ(history.signals.size(), 1u);
    EXPECT_FLOAT_EQ(history.signals.back().sensors[0], 0.7f);
}

TEST(ChartData, ShowsTheSignalsOfTheChosenPairWithItsPast) {
    Desk desk;
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    std::vector<Sensor>& sensors = scene->kinds[0].sensors;
    for (const float side : {1.0f, -1.0f}) {
        Sensor& eye = sensors[side > 0 ? 0 : 1];
        eye.y = 0.2f * side, eye.angle = 0.5f * side;
        Sensor skin = eye;
        skin.channel = Channel::heat;
        skin.name = side > 0 ? "HL" : "HR";
        sensors.push_back(skin);
    }
    desk.now.scene = scene;
    desk.now.sensed.assign(desk.now.sensed.size() + 4, 0.4f);
    desk.now.sensed[2] = 0.9f;
    History history;
    pass(desk, history, 0);
    pass(desk, history, 60);
    EXPECT_EQ(shown_signals(history, desk.view).names, (std::array<std::string, 4>{"SL", "SR", "ML", "MR"}));
    desk.view.settings.selection.pair = "heat";
    pass(desk, history, 63);
    const ShownSignals heat = shown_signals(history, desk.view);
    const std::string flame(wiring::channel_symbol(Channel::heat));
    EXPECT_EQ(heat.names, (std::array<std::string, 4>{flame + "L", flame + "R", "ML", "MR"}));
    ASSERT_EQ(history.signals.size(), 3u) << "the samples before the choice stay";
    EXPECT_FLOAT_EQ(heat.value(history.signals[0], 0), 0.9f);
    EXPECT_FLOAT_EQ(heat.value(history.signals[0], 3), 0.5f);
    EXPECT_NE(signals_csv(history).find("sensor_SL,sensor_SR,sensor_HL,sensor_HR,left"), std::string::npos);
    scene = std::make_shared<Scene>(*scene);
    scene->kinds[0].sensors.pop_back();
    desk.now.scene = scene;
    pass(desk, history, 66);
    EXPECT_EQ(history.signals.size(), 1u) << "of other sensors";
}

TEST(ChartData, RecordsNeuronsAndLearnedWeightsAndRestartsForAnotherBrain) {
    Desk desk;
    desk.now = shipped_scene("7-mnemotrix");
    desk.rest();
    History& history = desk.panels.charts.history;
    const auto names = history.brain_values;
    ASSERT_FALSE(names.empty());
    const auto learned =
        std::find_if(names.begin(), names.end(), [](auto& name) { return name.find('>') != name.npos; });
    ASSERT_NE(learned, names.end());
    ASSERT_FALSE(history.signals.empty());
    EXPECT_EQ(history.signals.back().brain.size(), names.size());
    EXPECT_NE(signals_csv(history).find("neuron_" + names.front()), std::string::npos);
    EXPECT_NE(signals_csv(history).find("learned_" + *learned), std::string::npos);
    desk.now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = 1}));
    desk.now.tick = 6;
    desk.frame();
    EXPECT_TRUE(history.brain_values.empty());
    EXPECT_EQ(history.signals.size(), 1u);
}

TEST(ChartData, KeepsAPulseOfANeuronBetweenTwoSamples) {
    Desk desk;
    desk.now = shipped_scene("5-logic");
    History history;
    pass(desk, history, 0);
    const auto first = static_cast<std::size_t>(desk.now.vehicles[0].first_neuron);
    desk.now.neurons[first] = 1;
    pass(desk, history, 1);
    desk.now.neurons[first] = 0;
    pass(desk, history, 2);
    pass(desk, history, 3);
    pass(desk, history, 6);
    ASSERT_EQ(history.signals.size(), 3u);
    const auto& pulse = history.signals[1].brain;
    EXPECT_NE(std::find(pulse.begin(), pulse.end(), 1.0f), pulse.end());
    const auto& after = history.signals[2].brain;
    EXPECT_EQ(std::find(after.begin(), after.end(), 1.0f), after.end());
}

TEST(ChartData, KeepsNumbersAndMeanEnergiesOfEachSide) {
    Desk desk;  // 4 predators, 8 prey
    for (VehicleView& v : desk.now.vehicles) v.energy = v.role == Role::predator ? 0.5f : 0.25f;
    desk.now.vehicles[0].energy = 0.1f;
    History history;
    pass(desk, history, 0);
    const History::Population& p = history.population.back();
    EXPECT_EQ(p.count, (std::array{4, 8, 0}));
    EXPECT_FLOAT_EQ(p.energy[0], 0.4f);
    EXPECT_FLOAT_EQ(p.energy[1], 0.25f);
    EXPECT_TRUE(std::isnan(p.energy[2]));
}

TEST(ChartData, MeasuresTheLongestTimeWithEnoughVehiclesOfARole) {
    Desk desk;  // 4 predators, 8 prey
    History history;
    const auto seconds = [&](std::uint64_t from, std::uint64_t to) {
        for (std::uint64_t t = from; t <= to; ++t) pass(desk, history, 60 * t);
    };
    EXPECT_EQ(longest_time_with(history, Role::prey, 8), 0) << "no sample";
    seconds(0, 5);
    EXPECT_EQ(longest_time_with(history, Role::prey, 8), 5);
    EXPECT_EQ(longest_time_with(history, Role::prey, 9), 0);
    EXPECT_EQ(longest_time_with(history, Role::predator, 5), 0);
    VehicleView& eaten = desk.now.vehicles.back();
    ASSERT_EQ(std::exchange(eaten.role, Role::predator), Role::prey);
    seconds(6, 7);
    EXPECT_EQ(longest_time_with(history, Role::predator, 5), 1);
    eaten.role = Role::prey;
    seconds(8, 11);
    EXPECT_EQ(longest_time_with(history, Role::prey, 8), 5) << "the longer part, not the sum";
    seconds(12, 15);
    EXPECT_EQ(longest_time_with(history, Role::prey, 8), 7);
}

TEST(ChartData, ExportsOneRowPerSampleBelowTheHeader) {
    Desk desk;
    History history;
    pass(desk, history, 0);
    pass(desk, history, 60);
    EXPECT_EQ(signals_csv(history),
              "seconds,sensor_SL,sensor_SR,left,right\n"
              "0.00000,0.40000,0.20000,0.30000,0.50000\n1.00000,0.40000,0.20000,0.30000,0.50000\n");
    EXPECT_EQ(population_csv(history),
              "seconds,predators,prey,others,energy_predators,energy_prey,energy_others\n"
              "0.00000,4,8,0,1.00000,1.00000,\n1.00000,4,8,0,1.00000,1.00000,\n");
}

TEST(ChartData, NamesEveryVehicleAndQuotesSpecialCharacters) {
    Desk desk;
    desk.now = snapshot(0);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].name = "a \"shy\", slow one";
    desk.now.scene = scene;
    desk.now.vehicles[0].energy = 0.5f;
    EXPECT_EQ(energies_csv(desk.now), "id,kind,role,energy\n0,\"a \"\"shy\"\", slow one\",other,0.50000\n");
}

}  // namespace braitenlab::tests::history_test
