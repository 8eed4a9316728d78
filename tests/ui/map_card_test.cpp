// The card of the map of behaviour: the dot, a click on a cell, the choices and the legend.
#include <algorithm>
#include <cmath>
#include <set>

#include "lecture_on_desk.h"
#include "scene_on_desk.h"
#include "ui/map_look.h"
#include "ui/panels/value_choice.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::map_card_test {

using namespace ui;
using insight::Behaviour;
using insight::MapCell;
using insight::MapCells;
using insight::MapMeasure;

namespace {

struct MapCard : SceneOnDesk {
    MapCells cells{8};
    MapCard() {
        desk.now = snapshot(0);  // a coward: LL = RR = 1.5, LR = RL = 0
        Scene scene = *desk.now.scene;
        scene.sources = {{.name = "lamp", .x = -3, .y = 6}};
        desk.now.scene = std::make_shared<Scene>(scene);
        desk.now.sources = {{0, Channel::light, -3, 6, 1}};
        desk.view.settings.map = true;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x)
                cells.at({x, y}) = MapCell{{.behaviour = y > 3 ? Behaviour::touches : Behaviour::flees,
                                            .closest = 0.5f * static_cast<float>(x)}};
        desk.view.features.map =
            MapView{.cells = &cells, .x = *insight::axis_of("LL=RR"), .y = *insight::axis_of("LR=RL"), .progress = 1};
        desk.frame(4);
    }
    void show(const char* x, const char* y, MapRange across, MapRange up) {
        desk.view.features.map->x = {.path = x, .from = across.from, .to = across.to};
        desk.view.features.map->y = {.path = y, .from = up.from, .to = up.to};
        desk.frame(2);
    }
    // Points at a share of the field, from its lower left corner.
    void point_at(float x, float y) {
        const Rect r = desk.where("map");
        desk.point(r.x + x * r.w, r.y + (1 - y) * r.h);
        desk.frame(2);
    }
    void press(bool down) { desk.button(0, down), desk.frame(2); }
};

}  // namespace

TEST_F(MapCard, HasTheDotOfThePresentBrain) {
    const Rect field = desk.where("map"), dot = desk.where("map.dot");
    // 1.5 of −2 … 2 is index 6.125 of 0 … 7; 0 is 3.5.
    EXPECT_NEAR((dot.x + dot.w / 2 - field.x) / field.w, 6.625f / 8, 0.01f);
    EXPECT_NEAR(1 - (dot.y + dot.h / 2 - field.y) / field.h, 0.5f, 0.01f);
}

TEST_F(MapCard, SaysThatTheKindOfACoarseCellMayChange) {
    EXPECT_FALSE(desk.says("coarse"));
    MapCells coarse{8};
    const auto levels = insight::map_levels(8);
    for (const insight::MapPlace place : levels.front()) coarse.at(place) = cells.at(place);
    desk.view.features.map->cells = &coarse;
    ASSERT_TRUE(coarse.shown({6, 4})) << "the cell of the dot";
    ASSERT_FALSE(coarse.at({6, 4}));
    desk.frame(2);
    EXPECT_TRUE(desk.says("coarse"));
}

TEST_F(MapCard, TellsTheShareThatIsComputedUntilAllIs) {
    for (const std::string& code : shipped_codes())
        for (const bool in_lecture : {false, true}) {
            desk.strings = speaking(code);
            desk.view.lecture = in_lecture;
            const auto says_share = [&](const MapCells& shown, float progress) {
                desk.view.features.map->cells = &shown, desk.view.features.map->progress = progress;
                desk.frame(4);
                const char* percent = code == "en" ? "12.5%" : "12,5 %";
                return desk.says(percent);
            };
            SCOPED_TRACE(code + (in_lecture ? ", lecture" : ""));
            EXPECT_TRUE(says_share(MapCells(8), 0.125f)) << "no cell is known";
            EXPECT_TRUE(says_share(cells, 0.125f)) << "beside the kind of the present brain";
            EXPECT_FALSE(says_share(cells, 1));
        }
}

TEST_F(MapCard, InALectureTheLegendIsBesideTheField) {
    desk.view.lecture = true;
    desk.frame(4);
    const Rect field = desk.where("map");
    const auto legend = std::find_if(desk.written.begin(), desk.written.end(), [&](const Written& written) {
        return written.words == "flees" && written.rect.x > field.x + field.w;
    });
    ASSERT_NE(legend, desk.written.end());
    EXPECT_LT(legend->rect.y, field.y + field.h);
}

TEST_F(MapCard, InALectureTheFieldIsLargeAlsoBesideTwoBrainsAndOpenSliders) {
    desk.view.lecture = true;
    const insight::Design stored{};
    for (const bool has_brains : {false, true})
        for (const bool has_sliders : {false, true}) {
            desk.view.features.slots.slots[0].design = has_brains ? &stored : nullptr;
            desk.view.features.slots.slots[1].design = has_brains ? &stored : nullptr;
            desk.panels.card(Card::brain).folded = !has_sliders;
            desk.frame(6);
            const Rect field = desk.where("map"), window = desk.layout.window;
            EXPECT_GE(field.w, (has_sliders ? 0.36f : 0.5f) * window.h) << has_brains << has_sliders;
            EXPECT_GE(desk.layout.scene.w, 0.24f * window.w);
            EXPECT_FALSE(overlap(desk.where("card.map"), desk.layout.scene));
            EXPECT_FALSE(has_sliders && overlap(desk.layout.scene, desk.where("card.brain")));
        }
}

TEST_F(MapCard, SaysThatABrainWithDifferentWeightsIsNotInTheMap) {
    for (const bool lecture : {false, true}) {
        desk.view.lecture = lecture;
        BrainGraph brain = *desk.now.brains[0];
        turn(brain, Dial::RR, 1.5f);
        desk.now.brains[0] = std::make_shared<const BrainGraph>(brain);
        desk.frame(4);
        EXPECT_FALSE(desk.says("the map has both equal"));
        turn(brain, Dial::RR, 0);
        desk.now.brains[0] = std::make_shared<const BrainGraph>(brain);
        desk.frame(4);
        EXPECT_TRUE(desk.says("LL 1.50"));
        EXPECT_TRUE(desk.says("RR 0.00"));
        EXPECT_TRUE(desk.says("both equal") || desk.says("has both")) << "broken into lines";
        for (const Written& w : desk.written) {  // the kind of a cell that is not its own is in the legend only
            const bool is_below = w.rect.y > desk.where("map").y + desk.where("map").h;
            EXPECT_FALSE(w.words == "flees" && is_below && lecture);
        }
    }
}

TEST_F(MapCard, InALectureTheMapHasTheRoomOfTheBrainsCard) {
    desk.view.lecture = true, desk.view.settings.map = false;
    desk.frame(3);
    for (const bool folded : {true, false}) {
        desk.panels.card(Card::brain).folded = folded;
        desk.frame(2);
        desk.view.settings.map = true;
        desk.frame(3);
        EXPECT_TRUE(desk.panels.card(Card::brain).folded);
        desk.view.settings.map = false;
        desk.frame(3);
        EXPECT_EQ(desk.panels.card(Card::brain).folded, folded) << "as before";
    }
}

TEST_F(MapCard, DraggingTheDotTurnsTheDialsOfBothAxesInOneUndoStep) {
    desk.point("map.dot");
    desk.frame(2);
    press(true);
    EXPECT_TRUE(desk.edits().empty());
    point_at(0.25f, 0.75f);
    point_at(0.0625f, 0.9375f);  // the middle of the first column and the last row
    press(false);
    ASSERT_GE(desk.edits().size(), 4u);
    std::set<Dial> dials;
    for (const EditRequest& edit : desk.edits()) {
        dials.insert(turned(edit).dial);
        EXPECT_EQ(edit.gesture, desk.edits().front().gesture);
        EXPECT_NE(edit.gesture, 0u);
    }
    EXPECT_EQ(dials, (std::set{Dial::LL, Dial::RR, Dial::LR, Dial::RL}));
    EXPECT_FLOAT_EQ(turned(desk.edits().back()).value, 2);
    const std::size_t before = desk.edits().size();
    point_at(0.5f, 0.5f);
    EXPECT_EQ(desk.edits().size(), before) << "released";
}

TEST_F(MapCard, AClickTakesTheValuesOfTheCellInOneUndoStep) {
    point_at(0.3f, 0.8f);
    press(true);
    EXPECT_TRUE(desk.edits().empty());
    press(false);
    ASSERT_EQ(desk.edits().size(), 4u);
    for (const EditRequest& edit : desk.edits()) {
        const bool is_x = turned(edit).dial == Dial::LL || turned(edit).dial == Dial::RR;
        EXPECT_FLOAT_EQ(turned(edit).value, -2 + 4.0f / 7 * (is_x ? 2 : 6));
        EXPECT_EQ(edit.gesture, desk.edits().front().gesture);
    }
    const std::uint64_t gesture = desk.edits().front().gesture;
    press(true);
    press(false);
    EXPECT_NE(desk.edits().back().gesture, gesture) << "another click is another step";
}

TEST_F(MapCard, APressThatLeavesTheCellTakesNothing) {
    point_at(0.3f, 0.8f);
    press(true);
    point_at(0.7f, 0.2f);
    press(false);
    EXPECT_TRUE(desk.edits().empty());
}

TEST_F(MapCard, NamesTheKindUnderThePointerAndElseThatOfTheBrain) {
    EXPECT_TRUE(desk.says("Now:"));
    point_at(0.3f, 0.8f);
    ASSERT_TRUE(desk.panels.map.hovered);
    EXPECT_EQ(*desk.panels.map.hovered, (insight::MapPlace{2, 6}));
    EXPECT_TRUE(desk.says("LL = RR \u22120.86, LR = RL 1.43"));
    desk.point(5, 5);
    desk.frame(2);
    EXPECT_FALSE(desk.panels.map.hovered);
}

TEST_F(MapCard, HasALegendOfEveryKindOrOfTheNumbers) {
    for (const auto& row : insight::behaviour_table)
        EXPECT_TRUE(desk.says(desk.strings("map.kind." + std::string(row.word)))) << row.word;
    desk.view.features.map->measure = MapMeasure::closest;
    desk.frame(2);
    EXPECT_FALSE(desk.says(desk.strings("map.kind.circles")));
    EXPECT_TRUE(desk.says("3.5 m"));
}

TEST(MapLegend, ShowsWholeWordsInEveryLanguageAndInALecture) {
    for (const std::string& language : shipped_codes())
        for (const bool lecture : {false, true}) {
            Desk desk(1024, 768, lecture ? 1.4f : 1.0f, true);
            desk.strings = speaking(language);
            MapCells cells{8};
            int i = 0;
            for (const auto& row : insight::behaviour_table) cells.at({i++ % 8, 0}) = MapCell{{.behaviour = row.value}};
            desk.now = snapshot(0);
            desk.view.lecture = lecture, desk.view.settings.map = true;
            desk.view.features.map = MapView{
                .cells = &cells, .x = *insight::axis_of("LL=RR"), .y = *insight::axis_of("LR=RL"), .progress = 1};
            desk.frame(5);
            std::string all;
            for (const Written& written : desk.written) all += written.words + "\n";
            for (const auto& row : insight::behaviour_table) {
                const std::string words(desk.strings("map.kind." + std::string(row.word)));
                EXPECT_NE(all.find(words), std::string::npos) << language << ": " << words;
            }
        }
}

TEST_F(MapCard, OffersAxesAndMeasures) {
    desk.click("map.x");
    desk.click("map.x.LM=RM");
    ASSERT_TRUE(desk.last<MapRequest>());
    EXPECT_EQ(desk.last<MapRequest>()->x, "LM=RM");
    desk.click("map.measure");
    desk.click("map.measure.closest");
    EXPECT_EQ(desk.last<MapRequest>()->measure, MapMeasure::closest);
    desk.click("map.measure");
    desk.click("map.seeds.5");
    EXPECT_EQ(desk.last<MapRequest>()->seeds, 5);
}

TEST_F(MapCard, OffersValuesOfBrainBodyAndSceneInGroups) {
    desk.click("map.x");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("map.x.LM=RM")) << "the group of the present value";
    desk.click("map.x.group.2");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("map.x.LM=RM"));
    desk.click("map.x.sensor.angle");
    ASSERT_TRUE(desk.last<MapRequest>());
    EXPECT_EQ(desk.last<MapRequest>()->x, "sensor.angle");
    desk.click("map.y");
    desk.click("map.y.group.3");
    desk.click("map.y.source.lamp.strength");
    EXPECT_EQ(desk.last<MapRequest>()->y, "source.lamp.strength");
}

TEST_F(MapCard, TheDotOfSensorAndLampSetsThemInOneUndoStep) {
    show("sensor.angle", "source.lamp.x", {0, 90}, {-9, 9});
    const Rect field = desk.where("map"), dot = desk.where("map.dot");
    const float eye = maths::degrees(desk.now.scene->kinds[0].sensors[0].angle);
    EXPECT_NEAR((dot.x + dot.w / 2 - field.x) / field.w, (eye / 90 * 7 + 0.5f) / 8, 0.01f);
    EXPECT_NEAR(1 - (dot.y + dot.h / 2 - field.y) / field.h, (6.0f / 18 * 7 + 0.5f) / 8, 0.01f);  // the lamp is at −3
    desk.point("map.dot");
    desk.frame(2);
    press(true);
    point_at(0.96f, 0.96f);  // beyond the middle of the last cell it is the end of the axis
    press(false);
    const auto sensors = commands<SetSensors>();
    const auto lamps = commands<EditSource>();
    ASSERT_FALSE(sensors.empty());
    ASSERT_FALSE(lamps.empty());
    EXPECT_FLOAT_EQ(sensors.back().sensors[0].angle, maths::radians(90));
    EXPECT_FLOAT_EQ(sensors.back().sensors[1].angle, maths::radians(-90)) << "mirrored";
    EXPECT_EQ(lamps.back().to.x, 9);
    for (const EditRequest& edit : desk.edits()) EXPECT_EQ(edit.gesture, desk.edits().front().gesture);
    EXPECT_NE(desk.edits().front().gesture, 0u);
}

TEST_F(MapCard, TheEndsOfAnAxisCanBeTyped) {
    show("body.mass", "LR=RL", {2, 20}, {-2, 2});
    desk.click("map.x");
    desk.frame(2);
    desk.type_into("map.x.to", "40");
    ASSERT_TRUE(desk.last<MapRequest>() && desk.last<MapRequest>()->x_range);
    EXPECT_EQ(desk.last<MapRequest>()->x_range->from, 2);
    EXPECT_EQ(desk.last<MapRequest>()->x_range->to, 40);
}

TEST(MapAxes, HaveTheirNumbersAtBothEndsBesideTheFieldAndTheName) {
    struct Size {
        float width, height, scale;
        bool lecture;
    };
    for (const Size& size : {Size{1024, 768, 1, false},
                             {1600, 900, 1, false},
                             {1024, 768, 1.375f, true},
                             {1280, 800, 1.4f, true},
                             {2560, 1440, 2, true}})
        for (const std::string& language : shipped_codes())
            for (const char* path : {"LL=RR", "LR=RL"}) {
                SCOPED_TRACE(language + " at " + std::to_string(size.width) + ", scale " + std::to_string(size.scale) +
                             ", " + path);
                Desk desk(size.width, size.height, size.scale, true);
                MapCells cells{8};
                desk.now = snapshot(0);
                desk.strings = speaking(language);
                desk.view.lecture = size.lecture, desk.view.settings.map = true;
                desk.view.features.map = MapView{
                    .cells = &cells, .x = *insight::axis_of(path), .y = *insight::axis_of("LM=RM"), .progress = 1};
                desk.view.features.map->x.from = -1.25f, desk.view.features.map->y.to = 2.5f;
                desk.frame(5);
                const Rect field = desk.where("map"), card = desk.where("card.map");
                const Rect low = desk.where("map.x.low"), high = desk.where("map.x.high"), name = desk.where("map.x");
                EXPECT_NEAR(low.x, field.x, 1);
                EXPECT_GE(high.x + high.w, field.x + field.w - 1);
                EXPECT_LE(high.x + high.w, card.x + card.w);
                for (const Rect& end : {low, high}) EXPECT_GE(end.y, field.y + field.h);
                EXPECT_LT(low.x + low.w, name.x);
                EXPECT_GT(high.x, name.x + name.w);
                const Rect bottom = desk.where("map.y.low"), top = desk.where("map.y.high");
                EXPECT_NEAR(top.y, field.y, 1);
                EXPECT_NEAR(bottom.y + bottom.h, field.y + field.h, 1);
                for (const Rect& end : {bottom, top}) {
                    EXPECT_LT(end.x + end.w, field.x);
                    EXPECT_GE(end.x, card.x);
                    EXPECT_GE(end.y, desk.where("map.y").y + desk.where("map.y").h);
                }
                const auto says = [&](std::string_view words, Rect at) {
                    return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
                        return w.words == words && std::fabs(w.rect.x - at.x) < 1 && std::fabs(w.rect.y - at.y) < 1;
                    });
                };
                const std::string point = language == "en" ? "." : ",";
                EXPECT_TRUE(says("\u22121" + point + "25", low));
                EXPECT_TRUE(says("2" + point + "5", top));
            }
}

TEST(MapCardInANarrowWindow, TheSlidersOfAnAxisHaveRoomForTheirWords) {
    const Desk narrow(1024, 768, 1, true);
    Anchors anchors;
    for (const std::string& language : shipped_codes()) {
        const Strings strings = speaking(language);
        Outbox asked;
        Ui ui{strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, anchors, asked, {}, 1};
        for (const bool is_from : {true, false}) {
            const SliderLook look = end_look(ui, insight::AxisValue{}, is_from, 0);
            EXPECT_GT(look.words_width, text_width(ui, Face::text, look.words) + 6) << look.words;
        }
    }
}

TEST_F(MapCard, ItsButtonAndKeyAskForTheMap) {
    desk.click("button.map");
    desk.key({'M'});
    EXPECT_EQ(desk.actions(), (std::vector{Action::map, Action::map}));
}

TEST(MapLook, DiffersByMarkAndColourForEachKind) {
    std::set<std::array<std::uint8_t, mark_size>> marks;
    std::set<float> greys;
    for (const auto& row : insight::behaviour_table) {
        EXPECT_EQ(look_of(row.value).value, row.value);
        marks.insert(look_of(row.value).mark);
        const MapColour c = look_of(row.value).colour;
        greys.insert(c.r + 10 * c.g + 100 * c.b);
    }
    EXPECT_EQ(marks.size(), insight::behaviour_count);
    EXPECT_EQ(greys.size(), insight::behaviour_count);
}

TEST(MapLook, OfACellIsPalerTheFewerRunsAgreeAndTheScaleGetsLighter) {
    const insight::Outcome flees{.behaviour = Behaviour::flees};
    const MapColour all = cell_colour(flees, 1, MapMeasure::behaviour, {}, {1, 1, 1});
    const MapColour some = cell_colour(flees, 0.4f, MapMeasure::behaviour, {}, {1, 1, 1});
    EXPECT_EQ(all.g, look_of(Behaviour::flees).colour.g);
    EXPECT_GT(some.r, all.r);
    EXPECT_LT(scale_colour(0).g, scale_colour(0.5f).g);
    EXPECT_LT(scale_colour(0.5f).g, scale_colour(1).g);
}

}  // namespace braitenlab::tests::map_card_test
