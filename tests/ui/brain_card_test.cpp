// The brain card except its sliders: edits of both sides, its words, and manual driving.
#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "brain_on_desk.h"
#include "core/brain/four_neurons.h"
#include "core/scene/sensor_pairs.h"
#include "ui/wiring/node_text.h"

namespace braitenlab::tests::brain_card_test {

using namespace ui;

TEST(BrainCard, CrossesTheWiresAndMirrorsTheSides) {
    Desk desk;
    desk.now = snapshot(0);
    give(desk, make_graph({.LL = 1.5f, .RR = 0.5f, .LM = 0.1f}));
    const BrainGraph before = *desk.now.brains[0];
    desk.click("button.cross");
    EXPECT_EQ(brain_asked_for(desk), crossed(before));
    desk.all.clear();
    desk.click("button.mirror");
    EXPECT_EQ(brain_asked_for(desk), mirrored(before));
    give(desk, mirrored(before));
    desk.click("button.mirror");
    EXPECT_TRUE(desk.edits().empty()) << "no step of undo for equal sides";
}

TEST(BrainCard, GivesEveryNumberOfASumButTheFirstASign) {
    Desk desk(1280, 800, 1, true);
    desk.now = snapshot(0);
    give(desk, make_graph({.LL = 0.5f, .LM = 0, .RM = 0}));
    desk.frame(3);
    const Rect sums = desk.where("equations");
    const auto count = [&](std::string_view words) {
        return std::count_if(desk.written.begin(), desk.written.end(), [&](const Written& w) {
            return w.words == words && w.rect.x >= sums.x && w.rect.y >= sums.y && w.rect.y < sums.y + sums.h;
        });
    };
    EXPECT_EQ(count("+0.00"), 2) << "LM and RM";
}

TEST(BrainCard, ItsNameDoesNotScrollAndAnotherVehicleBeginsAtItsTop) {
    Desk desk(800, 600, 1, true);  // predators and prey
    desk.frame(4);
    const Rect name = desk.where("brain.character"), slider = desk.where("slider.LL"), card = desk.where("card.brain");
    const auto scroll = [&] {
        desk.point(card.x + card.w / 2, card.y + card.h / 2);
        for (int turn = 0; turn < 4; ++turn) ImGui::GetIO().MouseWheel = -1, desk.frame(2);
        const Rect* now = desk.anchors.find("slider.LL");
        ASSERT_TRUE(!now || now->y < slider.y || now->h < slider.h) << "the card has scrolled";
    };
    scroll();
    EXPECT_EQ(desk.where("brain.character"), name);
    desk.view.settings.selection.vehicle = 3;
    desk.frame(4);
    EXPECT_EQ(desk.where("slider.LL").y, slider.y);
    scroll();
    ++desk.view.run_id;
    desk.frame(4);
    EXPECT_EQ(desk.where("slider.LL").y, slider.y) << "another document";
}

TEST(BrainCard, ItsPictureStaysWhileTheCauseOfATurnChanges) {
    for (const std::string& code : shipped_codes())
        for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1024.0f, 768.0f}}) {
            Desk desk(width, height, 1, true);
            desk.strings = speaking(code);
            desk.now = snapshot(0);
            desk.now.tick = 100;
            desk.view.mode = Mode::playing;
            give(desk, make_graph({.LL = -1.5f, .LR = 0.1f, .RL = 1.5f, .RR = 0.2f, .LM = 0.1f, .RM = 0.1f}));
            std::set<float> pictures, buttons, heights;
            for (const auto& [left, right, speed] :
                 {std::array{0.0f, 0.0f, 1.0f}, {0.4f, 0.2f, 1.0f}, {0.2f, 0.9f, 1.0f}, {0.9f, 0.1f, 0.0f}}) {
                desk.now.sensed = {left, right};
                desk.now.vehicles[0].speed = speed;
                desk.frame(3);
                pictures.insert(desk.where("brain.picture").y);
                if (height > 600) buttons.insert(desk.where("button.why").y);
                heights.insert(desk.panels.card(Card::brain).content);
            }
            EXPECT_EQ(pictures.size(), 1u) << code << " " << width;
            EXPECT_LE(buttons.size(), 1u) << code << " " << width;
            EXPECT_GT(heights.size(), 1u) << "the sentences have several lengths: " << code;
        }
}

TEST(BrainCard, SaysWhereTheShownNumbersHaveAnotherSum) {
    for (const bool adds_up : {false, true}) {
        Desk desk(1280, 1000, 1, true);
        desk.now = snapshot(0);
        give(desk, make_graph({.LL = 1, .LR = 1}));
        const float reading = adds_up ? 0.3f : 0.334f;
        desk.now.sensed = {reading, reading};
        desk.now.vehicles[0].motor = {2 * reading, 0};
        desk.frame(4);
        EXPECT_TRUE(desk.says(adds_up ? "+0.60" : "+0.67"));
        EXPECT_EQ(desk.says("≈"), !adds_up) << "0.33 + 0.33";
    }
}

TEST(BrainCard, EndsTheDragOfASliderWhenItsVehicleIsGone) {
    Desk desk;
    desk.frame(3);
    EXPECT_FALSE(drags_vehicle(desk.panels, 0));
    desk.point("slider.LL");
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.point("slider.LL", 0.55f);
    desk.frame(2);
    EXPECT_FALSE(desk.edits().empty());
    EXPECT_TRUE(drags_vehicle(desk.panels, 0));
    EXPECT_FALSE(drags_vehicle(desk.panels, no_vehicle));
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(3);
    desk.all.clear();
    desk.view.settings.selection.vehicle = 1;  // another one is selected while the button is down
    desk.point(900, 400);
    desk.frame(4);
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_FALSE(drags_vehicle(desk.panels, 1));
    desk.button(0, false);
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty());
}

TEST(BrainCard, KeepsTheSlidersInPlaceWhileTheSentenceChanges) {
    Desk desk(1024, 768, 1, true);
    desk.now = shipped_scene("predator-prey");
    desk.rest();
    const float before = desk.where("slider.LL").y;
    BrainGraph brain = *desk.now.brains[0];
    for (Wire& wire : brain.wires) wire.weight = 0;
    desk.now.kind_brains[0] = std::make_shared<BrainGraph>(brain);
    give(desk, brain);
    EXPECT_FLOAT_EQ(desk.where("slider.LL").y, before) << "no pair of sensors has a wire: there is no sentence";
}

TEST(BrainCard, KeepsTheSlidersInPlaceHoweverLongTheSentenceIs) {
    Desk desk(1024, 768, 1, true);
    desk.strings = speaking("de");
    desk.now = shipped_scene("predator-prey");
    desk.rest();
    const float before = desk.where("slider.LL").y;
    bool has_sentence = false;
    for (const float left : {-1.5f, 0.0f, 1.5f})
        for (const float right : {-1.5f, 0.0f, 1.5f}) {
            BrainGraph brain = *desk.now.brains[0];
            for (std::size_t i = 0; i < brain.wires.size(); ++i) brain.wires[i].weight = i % 2 == 0 ? left : right;
            desk.now.kind_brains[0] = std::make_shared<BrainGraph>(brain);
            give(desk, brain);
            has_sentence |= desk.anchors.find("brain.description") != nullptr;
            EXPECT_FLOAT_EQ(desk.where("slider.LL").y, before) << left << " " << right;
        }
    EXPECT_TRUE(has_sentence);
}

TEST(BrainCard, KeepsTheSlidersInPlaceAtTheFirstEditOfOneVehicle) {
    Desk desk(1280, 800, 1, true);
    desk.now = shipped_scene("predator-prey");
    desk.view.settings.selection.whole_kind = false;
    desk.rest();
    const float before = desk.where("slider.LL").y;
    EXPECT_FALSE(desk.says("brain of its own"));
    BrainGraph brain = *desk.now.brains[0];
    brain.wires[0].weight += 0.5f;
    give(desk, brain);
    EXPECT_TRUE(desk.says("brain of its own"));
    EXPECT_FLOAT_EQ(desk.where("slider.LL").y, before);
}

TEST(BrainCard, KeepsItsControlsInPlaceWhenTheOutcomeIsKnown) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    BrainGraph brain = *desk.now.brains[0];
    Node& neuron = brain.nodes.emplace_back();  // no character: its parts are told
    neuron.name = "N", neuron.kind = NodeKind::neuron;
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.opened.offers = {"wiring"};
    desk.frame(4);
    const float before = desk.where("button.open_wiring").y;
    desk.lesson.attempt.answers.prediction = 1;
    desk.lesson.attempt.work.has_run = true;
    desk.frame(4);
    EXPECT_EQ(desk.where("button.open_wiring").y, before);
}

TEST(BrainCard, SaysOnceWhatSeveralPairsDo) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    Kind& kind = scene->kinds[0];
    const auto node = [&](std::string_view name) {
        return std::find_if(kind.brain.nodes.begin(), kind.brain.nodes.end(),
                            [&](const Node& each) { return each.name == name; })
            ->id;
    };
    const auto wire_from = [&](std::string_view name) {
        return std::find_if(kind.brain.wires.begin(), kind.brain.wires.end(),
                            [from = node(name)](const Wire& each) { return each.from == from && each.weight != 0; });
    };
    for (Sensor& sensor : kind.sensors)
        if (sensor.channel == Channel::heat) sensor.channel = Channel::light;
    for (const auto& [heat, light] : {std::pair("HL", "SL"), std::pair("HR", "SR")})
        wire_from(heat)->to = wire_from(light)->to, wire_from(heat)->weight = wire_from(light)->weight;
    for (auto& brain : desk.now.brains) brain = std::make_shared<BrainGraph>(kind.brain);
    desk.now.scene = scene;
    desk.rest();
    EXPECT_TRUE(desk.says("attacks light, loves smell, lingers at oxygen and moves on"));
    EXPECT_FALSE(desk.says("attacks light, attacks light"));
}

TEST(BrainCard, SetsTheWiresOfTheChosenPair) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    desk.rest();
    EXPECT_TRUE(desk.says("attacks light, flees heat, loves smell, lingers at oxygen and moves on"));
    desk.click("pair.heat");
    const auto chosen = std::find_if(desk.all.begin(), desk.all.end(),
                                     [](const Request& r) { return std::holds_alternative<PairRequest>(r); });
    ASSERT_NE(chosen, desk.all.end());
    EXPECT_EQ(std::get<PairRequest>(*chosen).name, "heat");
    desk.view.settings.selection.pair = "heat";
    desk.all.clear();
    desk.rest();
    desk.click("button.cross");
    const SensorPair heat{"HL", "HR"};
    EXPECT_EQ(read_dials(brain_asked_for(desk), heat).RL, read_dials(*desk.now.brains[0], heat).LL);
    EXPECT_EQ(read_dials(brain_asked_for(desk)), read_dials(*desk.now.brains[0])) << "the eyes keep their wires";
    desk.all.clear();
    desk.point("slider.LR", 0.55f);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_EQ(turned(desk.edits()[0]).pair, heat);
}

TEST(BrainCard, SaysThatAVehicleHasABrainOfItsOwn) {
    Desk desk;
    desk.now = shipped_scene("predator-prey");
    desk.rest();
    EXPECT_FALSE(desk.says("brain of its own"));
    desk.now.brains.push_back(std::make_shared<BrainGraph>(make_graph({.LL = 1})));
    desk.now.vehicles[0].brain = static_cast<int>(desk.now.brains.size()) - 1;
    desk.rest();
    EXPECT_TRUE(desk.says("brain of its own"));
    desk.view.settings.selection.vehicle = 1;
    desk.rest();
    EXPECT_FALSE(desk.says("brain of its own"));
}

TEST(BrainCard, KeepsTheChoiceOfPairsWhenABreedingHasTurnedTheEyes) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    auto bred = std::make_shared<Scene>(*desk.now.scene);
    for (Sensor& sensor : bred->kinds[0].sensors)
        if (sensor.name == "SL") sensor.angle += 0.4f;
    desk.now.scene = bred;
    desk.rest();
    ASSERT_TRUE(desk.anchors.find("pair.light")) << "no mirror images any more";
    ASSERT_TRUE(desk.anchors.find("pair.heat"));
    desk.point("pair.light");
    desk.frame(60);
    EXPECT_TRUE(desk.says("no mirror images of each other"));
    desk.click("pair.light");
    ASSERT_TRUE(desk.last<PairRequest>());
    EXPECT_EQ(chosen_pair(bred->kinds[0], desk.last<PairRequest>()->name), SensorPair{});
}

TEST(BrainCard, HasNoChoiceOfPairsForTwoSensors) {
    Desk desk;
    desk.now = shipped_scene("2a-coward");
    desk.rest();
    EXPECT_FALSE(desk.anchors.find("pair.light"));
    EXPECT_TRUE(desk.says("coward"));
}

TEST(BrainCard, NamesTheSensorsThatTheVehicleLacks) {
    Desk desk;
    desk.now = shipped_scene("2a-coward");
    desk.rest();
    EXPECT_FALSE(desk.says("does not have"));
    give(desk, *shipped_scene("3c-values").brains[0]);
    EXPECT_TRUE(desk.says("Reads Heat left"));
    EXPECT_TRUE(desk.says("does not have"));
}

TEST(BrainCard, SaysWhatAnExplorerDoesInTheWordsOfItsChannel) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    for (Sensor& sensor : scene->kinds[0].sensors)
        if (sensor.channel == Channel::oxygen) sensor.channel = Channel::obstacle;
    desk.now.scene = scene;
    desk.rest();
    EXPECT_TRUE(desk.says("slows near obstacles and turns away"));
    desk.strings = speaking("de");
    desk.frame(2);
    EXPECT_TRUE(desk.says("bremst vor Hindernissen und dreht ab"));
}

TEST(BrainCard, ShowsTheNameOfTheVehicleIfAPersonGaveOne) {
    Desk desk;
    desk.view.settings.selection.vehicle = 0;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Predator 1"));
    EXPECT_FALSE(desk.says("Predator 1 · "));
    desk.now.looks = {{0, {"Elsie", ""}}};
    desk.frame(2);
    EXPECT_TRUE(desk.says("Predator 1 · Elsie"));
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts = {{"on_ice", "predator"}};
    desk.now.scene = scene;
    desk.now.vehicles[0].start = 0;
    desk.frame(2);
    EXPECT_TRUE(desk.says("Predator 1 · on ice"));
    for (const char* given : {"one", "predator", "predator-12"}) {
        scene->starts[0].name = given;
        desk.frame(2);
        EXPECT_FALSE(desk.says("Predator 1 · ")) << given;
    }
    scene->starts[0].name = "predator-xy";
    desk.frame(2);
    EXPECT_TRUE(desk.says("Predator 1 · predator-xy"));
}

TEST(BrainCard, CallsTheWheelsAlikeByTheRuleOfTheCallout) {
    Desk desk(1280, 900, 1, true);
    desk.now = snapshot(0);
    const auto said = [&](std::string_view words) {
        desk.frame(3);
        for (const Written& w : desk.written)
            if (w.words.find(words) != std::string::npos) return true;
        return false;
    };
    desk.now.vehicles[0].motor = {0.21f, 0.19f};
    EXPECT_FALSE(said("Both wheels alike"));
    EXPECT_TRUE(said("Left wheel faster"));
    desk.now.vehicles[0].motor = {0.1949f, 0.1851f};  // 0.19 and 0.19, and faster by 0.01
    EXPECT_TRUE(said("Left wheel faster"));
    desk.now.vehicles[0].motor = {0.1949f, 0.1951f};  // 0.19 and 0.20, and faster by 0.00
    EXPECT_TRUE(said("Both wheels alike"));
}

TEST(BrainCard, SaysThatItDrivesBackAndThatSomethingIsInItsWay) {
    Desk desk(1280, 800, 1, true);
    const auto drive = [&](const FourNeurons& dials, float speed) {
        desk.now = snapshot(0);
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->kinds[0].brain = make_graph(dials);
        desk.now.scene = scene;
        desk.now.brains[0] = std::make_shared<BrainGraph>(scene->kinds[0].brain);
        desk.now.vehicles[0].motor = {dials.LM, dials.RM};
        desk.now.neurons = {dials.LM, dials.RM};
        desk.now.vehicles[0].speed = speed;
        desk.now.tick = 100;
        desk.view.mode = Mode::playing;
        desk.frame(3);
    };
    drive({.LM = 0.5f, .RM = 0.5f}, 1);
    EXPECT_TRUE(desk.says("Both wheels alike: straight on."));
    drive({.LM = -0.5f, .RM = -0.5f}, -1);
    EXPECT_TRUE(desk.says("Both wheels alike: straight back."));
    drive({.LM = -0.5f, .RM = -0.5f}, 0);
    EXPECT_TRUE(desk.says("something is in its way"));
    desk.view.mode = Mode::paused;
    desk.frame(3);
    EXPECT_TRUE(desk.says("something is in its way")) << "in a pause, too";
    desk.now.is_preview = true;
    desk.frame(3);
    EXPECT_FALSE(desk.says("something is in its way")) << "an edit in a pause: it has not tried yet";
    drive({.LM = 0.5f, .RM = 0.2f}, 1);
    EXPECT_TRUE(desk.says("Left wheel faster"));
    drive({.LM = 0.5f, .RM = 0.2f}, 0);
    EXPECT_TRUE(desk.says("Something is in its way")) << "it does not turn either";
    EXPECT_FALSE(desk.says("Left wheel faster"));
}

TEST(BrainCard, NamesAnEyeByItsSymbolWhereItsNameHasNoRoomAndCoversNoNameWithItsButton) {
    for (const float width : {800.0f, 1024.0f, 1280.0f}) {
        Desk desk(width, 800, 1, true);
        desk.now = snapshot(0);
        desk.frame(3);
        EXPECT_TRUE(desk.says("SR\n")) << "a short name stays";
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->kinds[0].sensors[0] = {.name = "greenL", .channel = Channel::green, .y = 0.2f};
        scene->kinds[0].sensors[1] = {.name = "greenR", .channel = Channel::green, .y = -0.2f};
        BrainGraph brain = scene->kinds[0].brain;
        find_node(brain, "SL")->name = "greenL", find_node(brain, "SR")->name = "greenR";
        scene->kinds[0].brain = brain;
        desk.now.scene = scene;
        desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
        desk.frame(3);
        const Rect button = desk.where("button.watch"), picture = desk.where("brain.picture");
        int named = 0;
        for (const Written& w : desk.written) {
            const bool in_picture = picture.contains(w.rect.x + 1, w.rect.y + 1);
            const bool is_icon = static_cast<unsigned char>(w.words[0]) == 0xEF && w.words.size() == 3;
            if (!in_picture || is_icon) continue;
            named += w.words.ends_with("L") || w.words.ends_with("R");
            EXPECT_FALSE(button.overlaps(w.rect)) << w.words;
            EXPECT_LE(w.rect.x + w.rect.w, picture.x + picture.w) << w.words;
        }
        EXPECT_GE(named, 4) << width << ": both eyes and both motors";
    }
}

TEST(BrainCard, ShowsTheReadingOfAMaskedEyeAsItsPictureDoes) {
    Desk desk(1280, 1000);
    BrainGraph brain = make_graph({.LR = 1, .RL = 1});
    find_wire(brain, 0, 3)->threshold = 0.9f;
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.frame(3);
    const auto is_written = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == words; });
    };
    EXPECT_TRUE(is_written("0.40 < θ"));
    EXPECT_TRUE(is_written("0.20·1.00"));
}

TEST(BrainCard, ExplainsTheSensorThatDecides) {
    Desk desk(1280, 900, 1, true);
    desk.now = snapshot(0);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    Sensor obstacle;
    obstacle.name = "OL", obstacle.channel = Channel::obstacle;
    scene->kinds[0].sensors.push_back(obstacle);
    BrainGraph brain = make_graph({});
    Node node;
    node.id = 20, node.name = "OL", node.kind = NodeKind::sensor;
    brain.nodes.push_back(node);
    brain.wires.push_back({.from = 20, .to = find_node(brain, "ML")->id, .weight = 1});
    desk.now.scene = scene;
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.now.sensed = {0, 0, 0.5f};
    desk.now.neurons = {0.5f, 0};
    desk.now.vehicles[0].motor = {0.5f, 0};
    desk.frame(3);
    bool said = false;
    for (const Written& w : desk.written) said |= w.words.find("Obstacles = +0.50") != std::string::npos;
    EXPECT_TRUE(said);
}

TEST(BrainCard, DescribesABrainOfLogicByItsParts) {
    Desk desk;
    desk.now = shipped_scene("5-logic");
    desk.rest();
    EXPECT_TRUE(desk.says("· neurons "));
    EXPECT_FALSE(desk.says("indifferent"));
}

TEST(BrainCard, ShowsAllNeuronsAndWiresInItsPicture) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("5-logic");
    desk.rest();
    const BrainGraph& brain = *desk.now.brains[0];
    const Rect picture = desk.where("brain.picture");
    for (const Node& node : brain.nodes) {
        ASSERT_TRUE(desk.anchors.find("lesion." + node.name)) << node.name;
        const Rect part = desk.where("lesion." + node.name);
        EXPECT_TRUE(picture.contains(part.x, part.y) && picture.contains(part.x + part.w, part.y + part.h))
            << node.name;
    }
    for (const Wire& wire : brain.wires) {
        if (wire.weight == 0) continue;
        const std::string name = wire_name(brain, {wire.from, wire.to});
        EXPECT_TRUE(desk.anchors.find("lesion." + name)) << name;
    }
}

TEST(BrainCard, FoldsTheThresholdsUntilOneIsUsed) {
    Desk desk;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("threshold.LL"));
    const float folded = desk.where("slider.LL").w;
    desk.click("button.thresholds");
    desk.rest();
    EXPECT_TRUE(desk.anchors.find("threshold.LL"));
    EXPECT_LT(desk.where("slider.LL").w, folded - 60) << "the weights give them room";
    desk.click("button.thresholds");
    desk.rest();
    EXPECT_FALSE(desk.anchors.find("threshold.LL"));
    desk.now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LR = 1, .threshold_LR = 0.2f}));
    desk.rest();
    EXPECT_TRUE(desk.anchors.find("threshold.LL")) << "a threshold that has an effect is always shown";
}

TEST(BrainCard, RequestsManualDrivingByButtonAndKey) {
    Desk desk;
    desk.frame(3);
    desk.click("button.drive");
    desk.key({'G'});
    EXPECT_EQ(desk.actions(), (std::vector{Action::drive, Action::drive}));
}

TEST(BrainCard, SteersWhileTheStickIsHeldAndStopsWhenItIsReleased) {
    Desk desk(1280, 1000);
    desk.now.vehicles[0].driver = Driver::manual;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("equations")) << "its brain is not used";
    const Rect r = desk.where("drive.stick");
    desk.point("drive.stick");
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.point(r.x + r.w / 2, r.y);
    desk.frame(2);
    desk.point(r.x + r.w, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, false);
    desk.frame(3);
    std::vector<Steer> steered;
    for (const EditRequest& edit : desk.edits()) steered.push_back(std::get<Steer>(edit.command));
    ASSERT_GE(steered.size(), 3u);
    EXPECT_EQ(steered.back(), (Steer{0, 0, 0}));
    EXPECT_EQ(steered[steered.size() - 3], (Steer{0, 1, 1})) << "up is straight ahead";
    const Steer right = steered[steered.size() - 2];
    EXPECT_GT(right.left, 0) << "a turn to the right drives the left wheel";
    EXPECT_FLOAT_EQ(right.right, -right.left);
}

TEST(BrainCard, ReturnsTheControlToTheBrain) {
    Desk desk(1280, 1000);
    desk.now.vehicles[0].driver = Driver::wander;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("drive.stick"));
    desk.click("drive.back");
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(std::get<ChooseDriver>(desk.edits()[0].command), (ChooseDriver{0, Driver::brain}));
}

TEST(BrainCard, SwitchesBetweenOneVehicleAndItsKind) {
    Desk desk;
    desk.frame(3);
    desk.click("scope.1");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_FALSE(std::get<ScopeRequest>(desk.all[0]).whole_kind);
}

TEST(BrainCard, ShowsNoScopeIfTheKindHasOneVehicle) {
    Desk desk;
    desk.now = snapshot(0);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("scope.1"));
}

TEST(BrainCard, ShowsTheNameOfTheWiringOncePerBrain) {
    Desk desk;
    desk.frame(3);
    EXPECT_EQ(desk.panels.brain.recognised.brain, desk.now.brains[0]);
    EXPECT_EQ(desk.panels.brain.recognised.single, Character::aggressor);
    desk.view.settings.selection.vehicle = 1;
    desk.frame();
    EXPECT_EQ(desk.panels.brain.recognised.single, Character::coward);
}

TEST(BrainCard, SetsAClassicBrainFromItsPresets) {
    Desk desk;
    desk.frame(3);
    desk.click("button.presets");
    desk.click("preset.3a-love");
    ASSERT_EQ(desk.edits().size(), 1u);
    const auto set = std::get<SetBrain>(desk.edits()[0].command);
    EXPECT_FLOAT_EQ(read_dials(set.brain).LL, -1);
    EXPECT_NE(desk.edits()[0].gesture, 0u);
}

TEST(BrainCard, AsksForAClickOnAVehicleOnlyWhereThereIsOne) {
    for (const Mode mode : {Mode::paused, Mode::playing, Mode::wiring}) {
        Desk desk(800, 600, 1, true);
        desk.view.mode = mode;
        desk.view.settings.selection.vehicle = no_vehicle;
        const auto said = [&](std::string_view key) {
            std::string all;
            for (const Written& each : desk.written) all += each.words + ' ';
            const std::string words(desk.strings(key).substr(0, 20));
            return all.find(words) != std::string::npos;
        };
        desk.frame(3);
        EXPECT_TRUE(said("brain.no_vehicle"));
        EXPECT_FALSE(said("brain.empty_scene"));
        desk.now.vehicles.clear();
        desk.view.settings.sensors = false;
        desk.frame(3);
        EXPECT_TRUE(said("brain.empty_scene"));
        EXPECT_TRUE(said("hint.empty_scene"));
        for (const char* key : {"brain.no_vehicle", "hint.no_vehicle", "hint.wiring"}) EXPECT_FALSE(said(key)) << key;
        for (const Written& each : desk.written)
            EXPECT_TRUE(each.rect.x >= 0 && each.rect.x + each.rect.w <= 801) << each.words;
    }
}

TEST(BrainCard, HasNoSlidersWithoutASelectedVehicle) {
    Desk desk;
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("slider.LL"));
    EXPECT_TRUE(desk.anchors.find("card.brain"));
}

TEST(BrainCard, ANeuronMovesNoSlider) {
    Desk desk(800, 600, 1, true);
    desk.now = snapshot(0);
    desk.frame(4);
    const float before = desk.where("slider.LL").y;
    auto brain = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    Node neuron;
    neuron.id = 40, neuron.kind = NodeKind::neuron, neuron.name = "N1";
    brain->nodes.push_back(neuron);
    brain->wires.push_back({.from = brain->nodes.front().id, .to = 40, .weight = 1});
    desk.now.brains[0] = brain;
    desk.now.neurons.push_back(0), desk.now.vehicles[0].neuron_count = 3;
    desk.frame(4);
    EXPECT_EQ(desk.where("slider.LL").y, before);
}

TEST(BrainCard, ExplainsTheWheelsAboveThePictureWhereThatHasNoRoom) {
    Desk desk(800, 600, 1, true);
    desk.now = shipped_scene("predator-prey");
    desk.frame(8);
    const Rect sums = desk.where("equations");
    const auto cause = std::find_if(desk.written.begin(), desk.written.end(),
                                    [](const Written& each) { return each.words.starts_with("Both wheels"); });
    ASSERT_NE(cause, desk.written.end());
    EXPECT_GE(cause->rect.y, sums.y + sums.h);
    EXPECT_LE(cause->rect.y + cause->rect.h, cause->clip.y + cause->clip.h) << "without scrolling";
}

TEST(BrainCard, ShowsItsPictureWholeInTheSmallestWindow) {
    for (const std::string& code : shipped_codes()) {
        Desk desk(800, 600, 1, true);
        desk.strings = speaking(code);
        desk.now = shipped_scene("2a-coward");
        desk.frame(6);
        EXPECT_GE(desk.where("brain.picture").h, 84) << code << ": an anchor is what is in sight";
    }
}

}  // namespace braitenlab::tests::brain_card_test
