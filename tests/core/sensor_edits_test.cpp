#include "core/scene/sensor_edits.h"

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"
#include "core/maths/angle.h"
#include "core/scene/scene_file.h"
#include "core/scene/sensor_pairs.h"
#include "core/world/character.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::sensor_edits_test {
namespace {

std::vector<std::string> names_of(const std::vector<Sensor>& sensors) {
    Kind kind;
    kind.sensors = sensors;
    return sensor_names(kind);
}

Scene with_sensors_of_kind(const std::vector<Sensor>& sensors) {
    Scene scene = alone({});
    scene.kinds[0].sensors = sensors;
    return scene;
}

TEST(SensorEdits, AddsAValidPairOrSingleSensorOfEveryChannelUnderAFreeName) {
    for (const ChannelTraits& row : channel_table) {
        std::vector<Sensor> all;
        for (int i = 0; i < 3; ++i) all = with_sensors(all, new_sensors(all, row.value, true));
        const auto pairs = sensor_pairs(all);
        ASSERT_EQ(pairs.size(), 3u) << row.word;
        EXPECT_EQ(pairs[0].sensors.left + "2", pairs[1].sensors.left);
        EXPECT_EQ(pairs[1].channel, row.value);
        for (int i = 0; i < 3; ++i) all = with_sensors(all, new_sensors(all, row.value, false));
        EXPECT_EQ(all.size(), 9u) << row.word;
        const auto error = check_scene(with_sensors_of_kind(all));
        EXPECT_FALSE(error) << error->text();
    }
    EXPECT_EQ(names_of(new_sensors({}, Channel::heat, true)), (std::vector<std::string>{"HL", "HR"}));
    EXPECT_EQ(names_of(new_sensors({{.name = "HR"}}, Channel::heat, true)), (std::vector<std::string>{"HL2", "HR2"}));
    EXPECT_EQ(names_of(new_sensors({}, Channel::energy, false, {"EN"})), std::vector<std::string>{"EN2"});
}

TEST(SensorEdits, NoNameOfANewSensorIsThatOfASlider) {
    for (const ChannelTraits& row : channel_table)
        for (const bool as_pair : {false, true})
            for (const std::string& name : names_of(new_sensors({}, row.value, as_pair))) {
                EXPECT_FALSE(dial_named(name)) << name;
                EXPECT_TRUE(name != "ML" && name != "MR") << name;
            }
}

TEST(SensorEdits, FindsTheOtherSideByNameElseByPosition) {
    EXPECT_EQ(other_side("SL"), "SR");
    EXPECT_EQ(other_side("SR12"), "SL12");
    EXPECT_EQ(other_side("TC"), "");
    EXPECT_EQ(other_side("7"), "");
    Sensor port{.name = "port", .y = 0.2f, .angle = 0.5f}, starboard = mirrored(port);
    starboard.name = "starboard";
    EXPECT_EQ(opposite_of({port, starboard}, "starboard"), "port");
    EXPECT_EQ(opposite_of({port, starboard}, "port"), "starboard");
    starboard.range = 3;
    EXPECT_EQ(opposite_of({port, starboard}, "port"), "");
    EXPECT_EQ(opposite_of({{.name = "SL"}, {.name = "SR", .range = 3}}, "SL"), "SR") << "edited on one side";
}

TEST(SensorEdits, MirrorAddsOrUpdatesTheOtherSide) {
    const Sensor left{.name = "SL", .channel = Channel::smell, .y = 0.2f, .angle = 0.5f, .range = 4};
    const Sensor other{.name = "TC"};
    std::vector<Sensor> sensors = with_mirror_image({left, other}, "SL");
    ASSERT_EQ(names_of(sensors), (std::vector<std::string>{"SL", "SR", "TC"})) << "beside the first";
    EXPECT_EQ(sensors[1].y, -0.2f);
    EXPECT_EQ(sensors[1].angle, -0.5f);
    EXPECT_EQ(sensors[1].range, 4);
    sensors[1].range = 9, sensors[1].y = -0.4f;
    sensors = with_mirror_image(sensors, "SR");
    EXPECT_EQ(sensors[0].range, 9);
    EXPECT_EQ(sensors[0].y, 0.4f);
    EXPECT_EQ(with_mirror_image({other}, "TC"), std::vector{other}) << "it is its own mirror image";
    EXPECT_EQ(names_of(with_mirror_image({{.name = "eye", .y = 0.2f}}, "eye")),
              (std::vector<std::string>{"eye", "eyeR"}));
}

TEST(PresetSensors, AreThoseOfTheShippedScene) {
    for (const Preset& preset : presets()) {
        const auto scene = load_scene(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "scenes" /
                                      (std::string(preset.scene) + ".toml"));
        ASSERT_TRUE(scene) << preset.scene;
        const int named = find_kind(*scene, std::string(preset.name));
        const Kind& kind = scene->kinds[static_cast<std::size_t>(named < 0 ? 0 : named)];
        Kind made;
        made.sensors = preset_sensors(preset);
        for (const Sensor& sensor : made.sensors)
            EXPECT_NE(std::find(kind.sensors.begin(), kind.sensors.end(), sensor), kind.sensors.end())
                << preset.name << " " << sensor.name;
        EXPECT_TRUE(missing_sensors(preset.brain, made).empty()) << preset.name;
        EXPECT_TRUE(lacking_for(kind.sensors, preset).empty()) << preset.name;
    }
}

TEST(PresetSensors, OfAPresetOfTwoEyesWorkOnAnyChannel) {
    const std::vector<Sensor> noses = new_sensors({}, Channel::smell, true);
    std::vector<Sensor> eyes = noses;
    eyes[0].name = "SL", eyes[1].name = "SR";
    EXPECT_TRUE(lacking_for(eyes, *find_preset("2a-coward")).empty());
    EXPECT_EQ(names_of(lacking_for({}, *find_preset("2a-coward"))), (std::vector<std::string>{"SL", "SR"}));
    EXPECT_EQ(names_of(lacking_for(eyes, *find_preset("prey"))), (std::vector<std::string>{"SL", "SR"}));
    EXPECT_EQ(lacking_for(noses, *find_preset("3c-values")).size(), 6u) << "it has NL and NR";
}

TEST(SensorEdits, ASensorOfANameHasTheChannelOfTheName) {
    EXPECT_EQ(sensor_named("HL").channel, Channel::heat);
    EXPECT_LT(sensor_named("HR").y, 0);
    EXPECT_EQ(sensor_named("EN").channel, Channel::energy);
    EXPECT_EQ(sensor_named("QR").channel, Channel::memory);
    EXPECT_EQ(sensor_named("OL").channel, Channel::obstacle);
    EXPECT_EQ(sensor_named("KR3").channel, Channel::vehicle);
    EXPECT_EQ(sensor_named("KR3").name, "KR3");
    EXPECT_EQ(sensor_named("nose").channel, Channel::light);
    EXPECT_EQ(sensor_named("7").name, "7");
    for (const char* name : {"HL", "HR", "UP", "nose", "7", "L", "FL2"})
        EXPECT_FALSE(check_scene(with_sensors_of_kind({sensor_named(name)}))) << name;
}

TEST(SensorEdits, ABrainGetsANodePerSensorAndLosesIdleOnes) {
    const BrainGraph four = make_graph({.LL = 1});
    const BrainGraph more = with_sensor_nodes(four, new_sensors({}, Channel::heat, true));
    ASSERT_EQ(more.nodes.size(), four.nodes.size() + 2);
    EXPECT_FALSE(check_graph(more));
    EXPECT_EQ(with_sensor_nodes(more, new_sensors({}, Channel::heat, true)), more);
    BrainGraph wired = more;
    wired.wires.push_back({.from = find_node(more, "HL")->id, .to = find_node(more, "ML")->id});
    const BrainGraph less = without_idle_sensors(wired, {"HL", "HR", "SL", "SR"});
    EXPECT_TRUE(find_node(less, "HL")) << "it has a wire";
    EXPECT_FALSE(find_node(less, "HR"));
    EXPECT_TRUE(find_node(less, "SR")) << "the sliders set it";
    EXPECT_EQ(without_idle_sensors(more, {"HL", "HR"}), four);
}

}  // namespace
}  // namespace braitenlab::tests::sensor_edits_test
