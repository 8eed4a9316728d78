#include "core/world/character.h"

#include <algorithm>

#include "runs.h"

namespace braitenlab::tests::character_test {

namespace {

// The tortoise in its scene with this energy.
Snapshot tortoise(float energy) {
    Snapshot now = look(make(shipped_scene("tortoise")));
    const Kind& kind = now.scene->kinds[static_cast<std::size_t>(now.vehicles[0].kind)];
    for (std::size_t i = 0; i < kind.sensors.size(); ++i)
        if (kind.sensors[i].name == "EN")
            now.sensed[static_cast<std::size_t>(now.vehicles[0].first_sensed) + i] = energy;
    return now;
}

}  // namespace

TEST(Character, DiffersForAFedAndAHungryTortoise) {
    const Snapshot fed = tortoise(1), hungry = tortoise(0.1f);
    EXPECT_EQ(character_of(fed, fed.vehicles[0]), Character::orbiting);
    EXPECT_EQ(character_of(hungry, hungry.vehicles[0]), Character::aggressor);
}

TEST(Character, UsesTheReadingsOfSingleSensorsAndOmitsPairs) {
    const Snapshot now = tortoise(0.75f);
    const auto readings = readings_beside_pairs(now, now.vehicles[0]);
    EXPECT_NE(std::find(readings.begin(), readings.end(), Reading{"EN", 0.75f}), readings.end());
    const auto pairs = {"SL", "SR", "QL", "QR"};
    for (const Reading& reading : readings)
        EXPECT_EQ(std::find(pairs.begin(), pairs.end(), reading.sensor), pairs.end()) << reading.sensor;
    EXPECT_TRUE(readings_beside_pairs(look(make(shipped_scene("2a-coward"))), VehicleView{}).empty());
}

TEST(Character, NamesTheResponseToEachPairOfSensors) {
    const Scene scene = shipped_scene("3c-values");
    const auto characters = characters_of(scene.kinds[0].brain, scene.kinds[0]);
    ASSERT_EQ(characters.size(), 5u);
    const std::vector<std::pair<std::string, Character>> expected{{"light", Character::aggressor},
                                                                  {"heat", Character::coward},
                                                                  {"smell", Character::love},
                                                                  {"oxygen", Character::explorer}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(characters[i].pair.name, expected[i].first);
        EXPECT_EQ(characters[i].character, expected[i].second) << name(characters[i].character);
        EXPECT_TRUE(characters[i].is_wired);
    }
    const BrainGraph four = make_graph({.LL = 1, .RR = 1});
    EXPECT_TRUE(characters_of(four, scene.kinds[0])[0].is_wired);
    EXPECT_FALSE(characters_of(four, scene.kinds[0])[1].is_wired) << "the heat sensors are not in this brain";
}

TEST(Character, TheMissingSensorsAreThoseThatTheBrainReadsAndTheVehicleLacks) {
    const Scene values = shipped_scene("3c-values"), coward = shipped_scene("2a-coward");
    const std::vector<std::string> missing = missing_sensors(values.kinds[0].brain, coward.kinds[0]);
    EXPECT_NE(std::find(missing.begin(), missing.end(), "HL"), missing.end());
    EXPECT_EQ(std::find(missing.begin(), missing.end(), "SL"), missing.end());
    EXPECT_TRUE(missing_sensors(values.kinds[0].brain, values.kinds[0]).empty());
}

}  // namespace braitenlab::tests::character_test
