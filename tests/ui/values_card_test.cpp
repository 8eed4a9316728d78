// Editing the arena, the ecology and the kinds; the seed.
#include <algorithm>
#include <cmath>

#include "desk.h"

namespace braitenlab::tests::values_card_test {

using namespace ui;

namespace {

class ValuesDesk : public Desk {
public:
    explicit ValuesDesk(bool kinds = false) : Desk(1280, 1400) {
        view.settings.values = true;
        panels.values.kinds = kinds;
        auto scene = std::make_shared<Scene>(*now.scene);
        now.scene = filed = scene;
        view.file = filed.get();
        for (const Kind& each : scene->kinds) now.kind_brains.push_back(std::make_shared<BrainGraph>(each.brain));
        frame(4);
    }
    void type_text(const char* field, const char* text) {
        click(field);
        type(text);
        frame(2);
        key({key::enter});
        frame(3);
    }
    // A vehicle of kind 0 with one sensor of its own, 0.4 m before its origin, on a chassis of 1 m.
    void give_own_sensors(VehicleId vehicle) {
        auto scene = std::make_shared<Scene>(*now.scene);
        scene->kinds[0].body.length = 1;
        auto own = std::make_shared<Kind>(scene->kinds[0]);
        own->sensors = {{.name = "own", .x = 0.4f}};
        now.scene = scene;
        now.designs = {own};
        now.vehicles[static_cast<std::size_t>(vehicle)].design = 0;
        frame(2);
    }
    // A frame, after which the edits of kinds are executed, as the lab does.
    void frame_of_lab() {
        frame();
        for (const Request& request : asked) {
            const auto* edit = std::get_if<EditRequest>(&request);
            const auto* to = edit ? std::get_if<EditKind>(&edit->command) : nullptr;
            if (!to) continue;
            auto scene = std::make_shared<Scene>(*now.scene);
            scene->kinds[static_cast<std::size_t>(to->kind)] = to->to;
            now.scene = scene;
        }
    }
    template <class Wanted>
    Wanted last() const {
        return std::get<Wanted>(edits().back().command);
    }

    std::shared_ptr<const Scene> filed;
};

bool asks_for(const Desk& desk, Action action) {
    const auto all = desk.actions();
    return std::find(all.begin(), all.end(), action) != all.end();
}

std::vector<std::uint64_t> seeds(const Desk& desk) {
    std::vector<std::uint64_t> found;
    for (const Request& request : desk.all)
        if (const auto* seed = std::get_if<SeedRequest>(&request)) found.push_back(seed->seed);
    return found;
}

}  // namespace

TEST(ValuesCard, IsHiddenUntilItIsOpenedFromTheSceneCardTheMenuOrByItsKey) {
    Desk desk;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("card.values"));
    desk.click("button.values");
    desk.choose("edit", "values");
    desk.key({'D'});
    const auto all = desk.actions();
    EXPECT_EQ(std::count(all.begin(), all.end(), Action::values), 3);
    desk.view.settings.values = true;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("card.values"));
    desk.click("values.close");
    EXPECT_EQ(desk.actions().back(), Action::values);
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("card.values"));
}

TEST(ValuesCard, EditsTheArena) {
    ValuesDesk desk;
    desk.type_into("arena.width", "35");
    EXPECT_EQ(desk.last<EditArena>().to.width, 35);
    desk.click("arena.edge.3");
    EXPECT_EQ(desk.last<EditArena>().to.edge, Boundary::torus);
    desk.type_into("arena.ambient", "0,4");
    EXPECT_FLOAT_EQ(desk.last<EditArena>().to.ambient, 0.4f);
    desk.type_into("ecology.drain", "0.012");
    EXPECT_FLOAT_EQ(desk.last<EditEcology>().to.drain, 0.012f);
    EXPECT_NE(desk.edits().back().gesture, 0u);
}

TEST(ValuesCard, ShowsTheKindOfTheSelectedVehicle) {
    ValuesDesk desk(true);
    EXPECT_EQ(desk.panels.values.kind, 0);
    desk.view.settings.selection.vehicle = 1;
    desk.frame(2);
    EXPECT_EQ(desk.panels.values.kind, 1);
    desk.click("kind.predator");
    EXPECT_EQ(desk.panels.values.kind, 0) << "until another kind is chosen";
    desk.frame(3);
    EXPECT_EQ(desk.panels.values.kind, 0);
}

TEST(ValuesCard, AddsRenamesAndRemovesKinds) {
    ValuesDesk desk(true);
    desk.type_text("kind.predator.name", "wolf");
    EXPECT_EQ(desk.last<EditKind>().to.name, "wolf");
    EXPECT_EQ(desk.last<EditKind>().kind, 0);
    desk.click("kind.add");
    EXPECT_EQ(desk.last<AddKind>().kind.sensors, desk.now.scene->kinds[0].sensors) << "a copy";
    EXPECT_EQ(desk.last<AddKind>().kind.share, 0);
    desk.all.clear();
    desk.click("kind.prey");
    desk.click("kind.remove");
    EXPECT_TRUE(desk.edits().empty()) << "it has vehicles";
    std::erase_if(desk.now.vehicles, [](const VehicleView& v) { return v.kind == 1; });
    desk.frame(2);
    desk.click("kind.remove");
    EXPECT_EQ(desk.last<RemoveKind>().kind, 1);
}

TEST(ValuesCard, RestoresTheNumberOfVehiclesOfTheFile) {
    ValuesDesk desk(true);
    Scene filed = *desk.now.scene;
    const int kind = desk.now.vehicles[0].kind;
    const std::string name = filed.kinds[static_cast<std::size_t>(kind)].name;
    filed.ecology.population = 0, filed.members.clear();
    filed.starts.assign(7, Start{.kind = name});
    desk.view.file = &filed;
    desk.frame(2);
    desk.click("kind.count", 1);
    EXPECT_EQ(desk.last<SetPopulation>(), (SetPopulation{kind, 7}));
}

TEST(ValuesCard, EditsTheValuesOfAKind) {
    ValuesDesk desk(true);
    desk.type_into("kind.count", "200");
    EXPECT_EQ(desk.last<SetPopulation>(), (SetPopulation{0, 200}));
    desk.click("kind.driver.4");
    EXPECT_EQ(desk.last<EditKind>().to.driver, Driver::wander);
    desk.click("kind.role.1");
    EXPECT_EQ(desk.last<EditKind>().to.role, Role::none);
    desk.click("kind.colour.2");
    EXPECT_EQ(desk.last<EditKind>().to.colour, "#56b4e9");
    desk.click("vehicle.driver.5");
    EXPECT_EQ(desk.last<ChooseDriver>(), (ChooseDriver{0, Driver::parked}));
    EXPECT_FALSE(desk.anchors.find("body.mass"));
    desk.click("values.memory");
    desk.type_into("memory.marks", "12");
    EXPECT_EQ(desk.last<EditKind>().to.memory.marks, 12);
}

TEST(ValuesCard, RenamesAndTintsASelectedVehicleWithAStart) {
    ValuesDesk desk(true);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts = {{"one", "predator"}};
    desk.now.scene = scene;
    desk.now.vehicles[0].start = 0;
    desk.frame(3);
    desk.type_text("vehicle.0.name", "Elsie");
    EXPECT_EQ(desk.last<EditStart>().to.name, "Elsie");
    desk.click("vehicle.colour.3");
    EXPECT_EQ(desk.last<EditStart>().to.colour, "#009e73");
    EXPECT_EQ(desk.last<EditStart>().start, 0);
    desk.lesson.exercise = &desk.opened;
    desk.show_lesson();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("vehicle.name")) << "the steps of an exercise use the names";
    EXPECT_TRUE(desk.anchors.find("vehicle.colour.3"));
}

TEST(ValuesCard, RenamesAndTintsAVehicleOfThePopulation) {
    ValuesDesk desk(true);
    desk.type_text("vehicle.0.name", "Elsie the 1st");
    EXPECT_EQ(desk.last<SetLook>(), (SetLook{0, {"Elsie the 1st", ""}}));
    desk.now.looks = {{0, {"Elsie the 1st", ""}}};
    desk.frame(2);
    desk.click("vehicle.colour.3");
    EXPECT_EQ(desk.last<SetLook>(), (SetLook{0, {"Elsie the 1st", "#009e73"}}));
}

TEST(ValuesCard, ScalesWheelsAndEyesWithTheBodyInOneGesture) {
    ValuesDesk desk(true);
    desk.click("values.body");
    desk.type_into("body.length", "0,05");
    const auto asked = desk.edits();
    ASSERT_GE(asked.size(), 2u);
    const auto& kind = std::get<EditKind>(asked[asked.size() - 2].command);
    const auto& sensors = std::get<SetSensors>(asked.back().command).sensors;
    EXPECT_FLOAT_EQ(kind.to.body.length, 0.05f);
    EXPECT_NEAR(kind.to.body.wheels[2].x, 0.019f, 1e-5f);
    EXPECT_NEAR(sensors[0].x, desk.now.scene->kinds[0].sensors[0].x * 0.05f, 1e-5f);
    EXPECT_EQ(asked.back().gesture, asked[asked.size() - 2].gesture);
    desk.type_into("body.top_speed", "0.05");
    EXPECT_FLOAT_EQ(desk.last<EditKind>().to.body.top_speed, 0.05f);
}

TEST(ValuesCard, SetsTheTrackAndTheRadiusOfTheDrivenWheelsAlone) {
    ValuesDesk desk(true);
    desk.click("values.body");
    desk.type_into("body.track", "35 cm");
    const Body before = desk.now.scene->kinds[0].body;
    Body to = desk.last<EditKind>().to.body;
    EXPECT_FLOAT_EQ(to.wheels[0].y, 0.175f);
    EXPECT_FLOAT_EQ(to.wheels[1].y, -0.175f);
    EXPECT_EQ(to.wheels[2], before.wheels[2]) << "a castor stays";
    EXPECT_EQ(to.width, before.width);
    EXPECT_EQ(to.wheels[0].radius, before.wheels[0].radius);
    desk.type_into("body.wheel_radius", "33.5 mm");
    to = desk.last<EditKind>().to.body;
    EXPECT_FLOAT_EQ(to.wheels[0].radius, 0.0335f);
    EXPECT_EQ(to.wheels[2].radius, before.wheels[2].radius);
}

TEST(ValuesCard, ChangesTheOwnSensorsOfVehiclesTogetherWithThoseOfTheirKind) {
    ValuesDesk desk(true);
    desk.give_own_sensors(3);
    desk.click("values.body");
    desk.type_into("body.length", "0,5");
    auto asked = desk.edits();
    ASSERT_GE(asked.size(), 3u);
    EXPECT_EQ(std::get<SetSensors>(asked[asked.size() - 2].command).target, (Target{.kind = 0}));
    auto own = std::get<SetSensors>(asked.back().command);
    EXPECT_EQ(own.target, (Target{.vehicle = 3}));
    ASSERT_EQ(own.sensors.size(), 1u);
    EXPECT_EQ(own.sensors[0].name, "own");
    EXPECT_FLOAT_EQ(own.sensors[0].x, 0.2f) << "in the middle of the front half of the chassis";
    EXPECT_EQ(asked.back().gesture, asked[asked.size() - 2].gesture);
    desk.click("values.body");
    desk.click("values.realism");
    desk.type_into("realism.noise", "0.2");
    own = desk.last<SetSensors>();
    EXPECT_EQ(own.target, (Target{.vehicle = 3}));
    ASSERT_EQ(own.sensors.size(), 1u);
    EXPECT_FLOAT_EQ(own.sensors[0].noise, 0.2f);
    EXPECT_FLOAT_EQ(own.sensors[0].x, 0.4f) << "other values stay";
}

TEST(ValuesCard, KeepsATypedNameWhenASliderTakesThePressThatLeavesTheField) {
    ValuesDesk desk(true);
    desk.click("values.body");
    const float mass = desk.now.scene->kinds[0].body.mass;
    desk.click("kind.predator.name");
    desk.type("wolf");
    desk.frame(2);
    desk.point("body.mass", 0.7f);
    desk.button(0, true);
    for (int i = 0; i < 4; ++i) desk.frame_of_lab();
    desk.button(0, false);
    for (int i = 0; i < 2; ++i) desk.frame_of_lab();
    EXPECT_EQ(desk.now.scene->kinds[0].name, "wolf");
    EXPECT_NE(desk.now.scene->kinds[0].body.mass, mass);
}

TEST(ValuesCard, GivesTheKeysBackWhenAFieldIsNoLongerDrawn) {
    ValuesDesk desk(true);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts = {{"one", "predator"}};
    desk.now.scene = scene;
    desk.now.vehicles[0].start = 0;
    desk.frame(3);
    desk.click("vehicle.0.name");
    desk.type("Elsie");
    desk.frame(2);
    desk.key({' '});
    EXPECT_FALSE(asks_for(desk, Action::play_pause)) << "it is typed";
    desk.now.vehicles.erase(desk.now.vehicles.begin());
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(2);
    desk.key({' '});
    EXPECT_TRUE(asks_for(desk, Action::play_pause));
    EXPECT_TRUE(desk.edits().empty()) << "the vehicle no longer exists";
}

TEST(LabView, FindsAKindOfTheFileByItsName) {
    ValuesDesk desk;
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds.erase(scene->kinds.begin());
    desk.now.scene = scene;
    VehicleView prey = desk.now.vehicles[1];
    prey.kind = 0;
    ASSERT_TRUE(filed_kind(desk.view, prey));
    EXPECT_EQ(filed_kind(desk.view, prey)->name, "prey");
    scene->kinds[0].name = "renamed";
    EXPECT_FALSE(filed_kind(desk.view, prey));
}

TEST(ValuesCard, GroupsTheValuesOfRealism) {
    ValuesDesk desk(true);
    desk.click("values.realism");
    desk.type_into("body.mismatch", "0.1");
    EXPECT_FLOAT_EQ(desk.last<EditKind>().to.body.mismatch, 0.1f);
    desk.type_into("realism.noise", "0.2");
    for (const Sensor& sensor : desk.last<SetSensors>().sensors) EXPECT_FLOAT_EQ(sensor.noise, 0.2f);
    desk.type_into("realism.latency", "0.3");
    for (const Sensor& sensor : desk.last<SetSensors>().sensors) EXPECT_FLOAT_EQ(sensor.latency, 0.3f);
    desk.type_into("realism.ambient", "0.25");
    EXPECT_FLOAT_EQ(desk.last<EditArena>().to.ambient, 0.25f);
}

TEST(ValuesCard, EditsTheLampsThatAKindCarries) {
    ValuesDesk desk(true);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].lamps = {{.name = "lamp"}};
    desk.now.scene = scene;
    desk.click("values.lamps");
    desk.type_into("lamp.1.strength", "0.4");
    EXPECT_FLOAT_EQ(desk.last<EditKind>().to.lamps[0].strength, 0.4f);
    desk.click("lamp.1.channel.5");
    EXPECT_EQ(desk.last<EditKind>().to.lamps[0].channel, Channel::heat);
    EXPECT_FALSE(desk.anchors.find("lamp.1.channel.8")) << "only what a source can give off";
    desk.click("lamp.add");
    ASSERT_EQ(desk.last<EditKind>().to.lamps.size(), 2u);
    EXPECT_EQ(desk.last<EditKind>().to.lamps[1].name, "lamp-2");
    desk.click("lamp.1.remove");
    EXPECT_TRUE(desk.last<EditKind>().to.lamps.empty());
}

TEST(ValuesCard, EditsThePointsOfAPath) {
    ValuesDesk desk(true);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].waypoints = {{1, 2}, {3, 4}};
    desk.now.scene = scene;
    desk.click("values.path");
    desk.type_into("waypoint.2.x", "-5");
    EXPECT_EQ(desk.last<EditKind>().to.waypoints, (std::vector<Waypoint>{{1, 2}, {-5, 4}}));
    desk.click("waypoint.1.remove");
    EXPECT_EQ(desk.last<EditKind>().to.waypoints, (std::vector<Waypoint>{{3, 4}}));
    desk.click("waypoint.add");
    EXPECT_EQ(desk.last<EditKind>().to.waypoints.size(), 3u);
}

TEST(Seed, GivesTheKeysBackWhenItsCardIsFolded) {
    Desk desk;
    desk.frame(3);
    desk.click("seed");
    desk.type("12");
    desk.frame(2);
    desk.panels.card(Card::scene).folded = true;
    desk.frame(3);
    desk.key({' '});
    EXPECT_TRUE(asks_for(desk, Action::play_pause));
}

TEST(Seed, IsShownTypedAndReplacedByOneClick) {
    Desk desk;
    desk.now.seed = 7;
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("seed"));
    EXPECT_EQ(desk.panels.values.seed.text, "7");
    desk.click("seed");
    desk.type("1234567890123456789");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_EQ(seeds(desk), (std::vector<std::uint64_t>{1234567890123456789u}));
    desk.click("seed");
    desk.type("many");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_EQ(seeds(desk).size(), 1u) << "no number";
    desk.click("button.another_start");
    EXPECT_TRUE(asks_for(desk, Action::another_start));
    desk.click("button.same_start");
    EXPECT_TRUE(asks_for(desk, Action::reset));
    desk.key({'R', false, true});
    const auto all = desk.actions();
    EXPECT_EQ(std::count(all.begin(), all.end(), Action::another_start), 2);
}

}  // namespace braitenlab::tests::values_card_test
