// Editing the sensors of a kind.
#include <cmath>
#include <set>

#include "desk.h"

namespace braitenlab::tests::sensor_card_test {

using namespace ui;

namespace {

constexpr float degree = 0.017453293f;

// Two eyes looking 35° outwards, and a bumper; the card open.
class SensorDesk : public Desk {
public:
    SensorDesk() : Desk(1280, 1000) {
        auto scene = std::make_shared<Scene>(*now.scene);
        std::vector<Sensor>& sensors = scene->kinds[0].sensors;
        sensors[0].angle = 35 * degree, sensors[1].angle = -35 * degree;
        sensors[0].y = 0.24f, sensors[1].y = -0.24f;
        sensors.push_back({.name = "TC", .channel = Channel::touch});
        now.scene = filed = scene;
        for (const Kind& kind : scene->kinds) now.kind_brains.push_back(std::make_shared<BrainGraph>(kind.brain));
        view.file = filed.get();
        panels.card(Card::sensors).folded = false;
        frame(4);
    }

    std::vector<Sensor> asked_for() const { return commands<SetSensors>().back().sensors; }
    template <class C>
    Found<C> commands() const {
        Found<C> found;
        for (const EditRequest& edit : edits())
            if (const auto* command = std::get_if<C>(&edit.command)) found.push_back(*command);
        return found;
    }
    std::vector<std::string> names_asked_for() const {
        Kind kind;
        kind.sensors = asked_for();
        return sensor_names(kind);
    }
    // Gives the selected vehicle sensors of its own.
    void own_sensors(std::vector<Sensor> sensors) {
        Kind own = now.scene->kinds[0];
        own.sensors = std::move(sensors);
        now.designs = {std::make_shared<Kind>(own)};
        now.vehicles[0].design = 0;
        frame(2);
    }

    std::shared_ptr<const Scene> filed;
};

}  // namespace

TEST(SensorCard, IsFoldedUntilItIsOpened) {
    Desk desk;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("card.sensors"));
    EXPECT_FALSE(desk.anchors.find("sensor.angle"));
    desk.click("card.sensors.fold");
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("sensor.angle"));
}

TEST(SensorCard, ShowsDirectionFieldAndRangeInTheLowColumnOfAnExercise) {
    for (const std::string& code : shipped_codes()) {
        Desk desk(800, 600, 1, true);
        desk.strings = speaking(code);
        desk.open_exercise();
        desk.lesson.attempt.answers.prediction = 0, desk.lesson.attempt.work.has_run = true;
        desk.frame(6);
        desk.click("card.sensors.fold");
        desk.frame(8);
        const Rect card = desk.where("card.sensors");
        for (const char* slider : {"sensor.angle", "sensor.field", "sensor.range"}) {
            const Rect at = desk.where(slider);
            EXPECT_TRUE(at.y >= card.y && at.y + at.h <= card.y + card.h) << slider << " " << code;
            EXPECT_GE(at.w, card.w / 2);
        }
    }
}

TEST(SensorCard, TurnsBothEyesAsMirrorImages) {
    SensorDesk desk;
    desk.type_into("sensor.angle", "60");
    const auto sensors = desk.asked_for();
    EXPECT_NEAR(sensors[0].angle, 60 * degree, 1e-4f);
    EXPECT_NEAR(sensors[1].angle, -60 * degree, 1e-4f);
    EXPECT_EQ(sensors[2], desk.now.scene->kinds[0].sensors[2]) << "the bumper is unchanged";
    EXPECT_EQ(std::get<SetSensors>(desk.edits().back().command).target.kind, 0);
    desk.all.clear();
    desk.type_into("sensor.field", "90");
    EXPECT_NEAR(desk.asked_for()[0].fov, 90 * degree, 1e-4f);
    EXPECT_NEAR(desk.asked_for()[1].fov, 90 * degree, 1e-4f);
}

TEST(SensorCard, EditsASingleEye) {
    SensorDesk desk;
    desk.click("sensor.SR");
    desk.click("sensor.sides.2");
    desk.type_into("sensor.y", "-0.5");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].y, 0.24f);
    EXPECT_FLOAT_EQ(desk.asked_for()[1].y, -0.5f);
}

TEST(SensorCard, MakesADragOneGesture) {
    SensorDesk desk;
    const Rect r = desk.where("sensor.range");
    const float middle = r.x + 84 + 8 + (r.w - 84 - 56 - 16) * 0.6f;  // 12 of 20 m
    desk.point(middle, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, true);
    for (int i = 0; i < 10; ++i) {
        desk.point(middle - 3.0f * static_cast<float>(i), r.y + r.h / 2);
        desk.frame();
    }
    desk.button(0, false);
    desk.frame(2);
    std::set<std::uint64_t> gestures;
    for (const EditRequest& edit : desk.edits()) gestures.insert(edit.gesture);
    EXPECT_GE(desk.edits().size(), 5u);
    EXPECT_EQ(gestures.size(), 1u);
    EXPECT_LT(desk.asked_for()[0].range, 12);
}

TEST(SensorCard, ChangesShapeAndResponse) {
    SensorDesk desk;
    desk.click("sensor.shape.2");
    EXPECT_EQ(desk.asked_for()[0].shape, SensorShape::triangle);
    EXPECT_EQ(desk.asked_for()[1].shape, SensorShape::triangle);
    desk.click("sensor.response.2");
    EXPECT_EQ(desk.asked_for()[1].response, SensorResponse::boolean);
}

TEST(SensorCard, SetsTheChannelOfBothEyes) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.channel.heat"));
    desk.click("sensor.channel");
    desk.click("sensor.channel.heat");
    const auto sensors = desk.asked_for();
    EXPECT_EQ(sensors[0].channel, Channel::heat);
    EXPECT_EQ(sensors[1].channel, Channel::heat);
    EXPECT_EQ(sensors[2].channel, Channel::touch) << "the bumper keeps its channel";
    EXPECT_NE(desk.edits().back().gesture, 0u) << "a separate step of undo";
    desk.all.clear();
    desk.click("sensor.channel.light");
    EXPECT_TRUE(desk.edits().empty()) << "it senses light already";
}

TEST(SensorCard, KeepsNoiseAndDelayFoldedAndClampsThem) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.noise"));
    desk.click("sensor.more");
    desk.frame(2);
    desk.type_into("sensor.latency", "7");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].latency, 1);
    desk.type_into("sensor.noise", "0,25");
    EXPECT_FLOAT_EQ(desk.asked_for()[1].noise, 0.25f);
}

TEST(SensorCard, SetsTheSamplesAndTheConverterOfBothEyes) {
    SensorDesk desk;
    desk.click("sensor.more");
    desk.frame(2);
    desk.type_into("sensor.interval", "0.05");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].interval, 0.05f);
    EXPECT_FLOAT_EQ(desk.asked_for()[1].interval, 0.05f);
    desk.type_into("sensor.bits", "99");
    EXPECT_EQ(desk.asked_for()[0].bits, 16) << "the most that a converter has";
    desk.type_into("sensor.bits", "9.6");
    EXPECT_EQ(desk.asked_for()[1].bits, 10) << "a whole number";
}

TEST(SensorCard, SetsTheLightThatAPhotocellHalvesAt) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.half_lux")) << "the eyes are not photocells";
    auto measured = std::make_shared<Scene>(*desk.now.scene);
    for (Sensor& sensor : measured->kinds[0].sensors) sensor.response = SensorResponse::photocell;
    desk.now.scene = measured;
    desk.frame(2);
    desk.type_into("sensor.half_lux", "120");
    EXPECT_FLOAT_EQ(desk.asked_for()[0].half_lux, 120);
}

TEST(SensorCard, OffersTheHalfDistanceOnlyWhereItDecidesAReading) {
    SensorDesk desk;
    desk.panels.sensors.quality_open = true;
    const auto is_offered_for = [&](SensorResponse response, float candela) {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        for (Sensor& sensor : scene->kinds[0].sensors) sensor.response = response;
        scene->sources.assign(1, Source{.candela = candela});
        desk.now.scene = scene;
        desk.now.sources.resize(1);
        desk.frame(3);
        return desk.anchors.find("sensor.half_distance") != nullptr;
    };
    EXPECT_TRUE(is_offered_for(SensorResponse::graded, 0));
    EXPECT_TRUE(is_offered_for(SensorResponse::photocell, 0)) << "the lamp has a strength only";
    EXPECT_FALSE(is_offered_for(SensorResponse::photocell, 500));
    EXPECT_FALSE(is_offered_for(SensorResponse::boolean, 0));
}

TEST(SensorCard, RightClickRestoresTheAngleOfTheFile) {
    SensorDesk desk;
    auto turned = std::make_shared<Scene>(*desk.now.scene);
    turned->kinds[0].sensors[0].angle = 1;
    desk.now.scene = turned;
    desk.frame(2);
    desk.click("sensor.angle", 1);
    EXPECT_NEAR(desk.asked_for()[0].angle, 35 * degree, 1e-4f);
}

TEST(SensorCard, HidesTheNameOfASingleKind) {
    Desk desk(1280, 1000);
    desk.now = snapshot(0);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].name = "aggressor";
    desk.now.scene = scene;
    desk.panels.card(Card::sensors).folded = false;
    desk.frame(4);
    ASSERT_TRUE(desk.anchors.find("sensor.angle"));
    for (const Written& w : desk.written) EXPECT_EQ(w.words.find("ggressor"), std::string::npos) << w.words;
}

TEST(SensorCard, IsEmptyWithoutASelectedVehicle) {
    Desk desk;
    desk.panels.card(Card::sensors).folded = false;
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("card.sensors"));
    EXPECT_FALSE(desk.anchors.find("sensor.angle"));
    EXPECT_FALSE(desk.anchors.find("sensor.add"));
}

TEST(SensorCard, AddsThePairOfAChannelWithItsNodesInEveryBrainOfTheKind) {
    SensorDesk desk;
    desk.now.brains.push_back(std::make_shared<BrainGraph>(make_graph({.LL = 0.7f})));
    desk.now.vehicles[3].brain = 2;
    desk.now.vehicles[3].kind = 0;
    EXPECT_FALSE(desk.anchors.find("sensor.new.heat"));
    desk.click("sensor.add");
    desk.click("sensor.new.heat");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"SL", "SR", "TC", "HL", "HR"}));
    EXPECT_EQ(desk.asked_for()[3].channel, Channel::heat);
    EXPECT_EQ(desk.asked_for()[3].y, -desk.asked_for()[4].y);
    const auto brains = desk.commands<SetBrain>();
    ASSERT_EQ(brains.size(), 2u);
    EXPECT_EQ(brains[0].target, (Target{.kind = 0}));
    EXPECT_EQ(brains[1].target, (Target{.vehicle = 3}));
    EXPECT_EQ(read_dials(brains[1].brain).LL, 0.7f) << "it keeps its own brain";
    for (const SetBrain& each : brains) EXPECT_TRUE(find_node(each.brain, "HR"));
    for (const EditRequest& edit : desk.edits()) EXPECT_EQ(edit.gesture, desk.edits().front().gesture) << "one step";
    EXPECT_EQ(desk.panels.sensors.shown, "HL") << "the new one is chosen";
    EXPECT_FALSE(desk.anchors.find("sensor.new.heat"));
}

TEST(SensorCard, AddsASingleSensorToOneVehicle) {
    SensorDesk desk;
    desk.view.settings.selection.whole_kind = false;
    desk.click("sensor.add");
    desk.click("sensor.new.sides.2");
    desk.click("sensor.new.smell");
    EXPECT_EQ(desk.names_asked_for().back(), "NC");
    EXPECT_EQ(desk.commands<SetSensors>().back().target, (Target{.vehicle = 0}));
    EXPECT_EQ(desk.commands<SetBrain>().back().target, (Target{.vehicle = 0}));
}

TEST(SensorCard, AddsTheFirstSensorOfAVehicleWithoutSensors) {
    SensorDesk desk;
    desk.own_sensors({});
    EXPECT_FALSE(desk.anchors.find("sensor.angle"));
    EXPECT_FALSE(desk.anchors.find("sensor.remove"));
    desk.click("sensor.add");
    desk.click("sensor.new.light");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"SL", "SR"}));
    EXPECT_TRUE(desk.commands<SetBrain>().empty()) << "the brain has these nodes";
}

TEST(SensorCard, RemovesBothSidesOrTheChosenOne) {
    SensorDesk desk;
    desk.click("sensor.remove");
    EXPECT_EQ(desk.names_asked_for(), std::vector<std::string>{"TC"});
    desk.click("sensor.sides.2");
    desk.click("sensor.remove");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"SR", "TC"}));
}

TEST(SensorCard, MirrorsASensorAndOffersItOnlyWhereItHasASide) {
    SensorDesk desk;
    desk.own_sensors({{.name = "NL", .channel = Channel::smell, .y = 0.2f, .angle = 0.5f}});
    desk.click("sensor.mirror");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"NL", "NR"}));
    EXPECT_EQ(desk.asked_for()[1].angle, -0.5f);
    desk.own_sensors({{.name = "TC", .channel = Channel::touch}});
    EXPECT_FALSE(desk.anchors.find("sensor.mirror"));
}

TEST(SensorCard, ShowsOwnSensorsAndGivesThoseOfTheKindAgain) {
    SensorDesk desk;
    EXPECT_FALSE(desk.anchors.find("sensor.as_kind"));
    desk.own_sensors({{.name = "NL", .channel = Channel::smell}});
    EXPECT_TRUE(desk.anchors.find("sensor.NL"));
    EXPECT_FALSE(desk.anchors.find("sensor.SL"));
    desk.click("sensor.as_kind");
    EXPECT_EQ(desk.asked_for(), desk.now.scene->kinds[0].sensors);
    EXPECT_EQ(desk.commands<SetSensors>().back().target, (Target{.vehicle = 0})) << "also while edits are for the kind";
}

TEST(SensorCard, ChoosesWhoseSensorsItChanges) {
    SensorDesk desk;
    desk.click("sensor.scope.1");
    ASSERT_FALSE(desk.all.empty());
    EXPECT_FALSE(std::get<ScopeRequest>(desk.all.back()).whole_kind);
}

TEST(SensorCard, RenamesASensorWithTheWiresThatReadIt) {
    SensorDesk desk;
    const auto notices = [&] {
        std::vector<NoticeRequest> found;
        for (const Request& request : desk.all)
            if (const auto* notice = std::get_if<NoticeRequest>(&request)) found.push_back(*notice);
        return found;
    };
    const auto rename = [&](const char* to) {
        desk.all.clear();
        desk.click("sensor.SL.name");
        desk.type(to);
        desk.frame(2);
        desk.key({key::enter});
        desk.frame(3);
    };
    const BrainGraph before = *desk.now.kind_brains[0];
    rename("ear");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"ear", "SR", "TC"}));
    const auto brains = desk.commands<SetBrain>();
    ASSERT_EQ(brains.size(), 1u);
    ASSERT_TRUE(find_node(brains[0].brain, "ear"));
    EXPECT_FALSE(find_node(brains[0].brain, "SL"));
    EXPECT_EQ(brains[0].brain.wires, before.wires);
    std::set<std::uint64_t> gestures;
    for (const EditRequest& edit : desk.edits()) gestures.insert(edit.gesture);
    EXPECT_EQ(gestures.size(), 1u) << "one step of undo";
    for (const char* taken : {"SR", "ML"}) {
        rename(taken);
        EXPECT_TRUE(desk.edits().empty());
        ASSERT_EQ(notices().size(), 1u) << taken;
        EXPECT_EQ(notices()[0].key, "notice.name_taken");
        EXPECT_EQ(notices()[0].words, taken);
    }
    rename("left ear");
    EXPECT_TRUE(desk.edits().empty());
    ASSERT_EQ(notices().size(), 1u);
    EXPECT_EQ(notices()[0].key, "notice.bad_name");
    desk.lesson.exercise = &desk.opened;
    desk.show_lesson();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("sensor.SL.name")) << "hints of an exercise use the names";
}

TEST(SensorCard, NamesASensorByChannelAndSideUnlessAPersonNamedIt) {
    const std::vector<Sensor> sensors{{.name = "OL", .channel = Channel::obstacle, .y = 0.2f},
                                      {.name = "OR2", .channel = Channel::obstacle, .y = -0.2f},
                                      {.name = "EN", .channel = Channel::energy},
                                      {.name = "SL", .y = 0.2f},
                                      {.name = "TL", .y = 0.1f},
                                      {.name = "ear", .channel = Channel::smell}};
    const auto labels = [&](const char* language) {
        Desk desk;
        desk.strings = speaking(language);
        desk.frame(2);
        Anchors anchors;
        Outbox outbox;
        const Ui ui{desk.strings, {}, {}, 1, anchors, outbox};
        std::vector<std::string> found;
        for (const Sensor& sensor : sensors) found.push_back(sensor_label(ui, sensors, sensor));
        return found;
    };
    EXPECT_EQ(labels("en"), (std::vector<std::string>{"Obstacles left", "Obstacles right 2", "Its energy",
                                                      "Light left (SL)", "Light left (TL)", "ear"}));
    EXPECT_EQ(labels("de")[0], "Hindernisse links");
}

TEST(BrainCard, AddsTheSensorsThatTheBrainReads) {
    SensorDesk desk;
    desk.own_sensors({{.name = "SL", .channel = Channel::smell}});
    desk.click("brain.add_sensors");
    EXPECT_EQ(desk.names_asked_for(), (std::vector<std::string>{"SL", "SR"}));
    EXPECT_EQ(desk.asked_for()[0].channel, Channel::smell) << "those it has are unchanged";
    EXPECT_EQ(desk.asked_for()[1], desk.now.scene->kinds[0].sensors[1]) << "that of its kind";
    EXPECT_TRUE(desk.commands<SetBrain>().empty());
}

TEST(PresetsMenu, OffersTheSensorsOfAPresetThatTheVehicleLacks) {
    for (const char* answer : {"preset.with_sensors", "preset.brain_only", "preset.back"}) {
        SensorDesk desk;
        desk.click("button.presets");
        desk.click("preset.3c-values");
        EXPECT_TRUE(desk.edits().empty()) << "it asks first";
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("preset.2a-coward"));
        desk.click(answer);
        desk.frame(2);
        const auto brains = desk.commands<SetBrain>();
        EXPECT_EQ(brains.size(), answer == std::string("preset.back") ? 0u : 1u);
        for (const SetBrain& each : brains) EXPECT_TRUE(find_node(each.brain, "AL"));
        EXPECT_EQ(desk.commands<SetSensors>().size(), answer == std::string("preset.with_sensors") ? 1u : 0u);
        EXPECT_EQ(desk.anchors.find("preset.2a-coward") != nullptr, answer == std::string("preset.back"));
        if (answer != std::string("preset.with_sensors")) continue;
        EXPECT_EQ(desk.names_asked_for().size(), 9u) << "eight of the preset and the bumper";
        EXPECT_EQ(desk.edits().front().gesture, desk.edits().back().gesture) << "one step of undo";
    }
}

TEST(PresetsMenu, DoesNotAskWhereTheVehicleHasTheSensors) {
    SensorDesk desk;
    desk.click("button.presets");
    desk.click("preset.2b-aggressor");
    EXPECT_EQ(desk.commands<SetBrain>().size(), 1u);
    EXPECT_TRUE(desk.commands<SetSensors>().empty());
}

}  // namespace braitenlab::tests::sensor_card_test
