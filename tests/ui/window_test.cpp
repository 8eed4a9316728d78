#include "ui/window.h"

#include <set>

#include "desk.h"
#include "ui/panels/panels.h"

namespace braitenlab::tests::window_test {

using namespace ui;

struct Size {
    float width, height, scale;
};

namespace {

bool lies_inside(Rect inner, Rect outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.w <= outer.x + outer.w + 0.5f &&
           inner.y + inner.h <= outer.y + outer.h + 0.5f;
}

bool overlap(Rect a, Rect b) { return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h; }

}  // namespace

class WindowAtEverySize : public ::testing::TestWithParam<Size> {};

TEST_P(WindowAtEverySize, KeepsEveryWidgetOfAnExerciseInsideTheWindow) {
    Desk desk(GetParam().width, GetParam().height, GetParam().scale, true);
    desk.open_exercise();
    desk.frame(2);
    desk.panels.exercise.more_open = true;  // where the foot of the card has no room for all buttons
    desk.frame(5);
    for (const char* id : {"button.play",
                           "button.step",
                           "button.reset",
                           "button.follow",
                           "button.wiring",
                           "button.undo",
                           "button.save",
                           "menu.file",
                           "menu.edit",
                           "menu.view",
                           "menu.simulation",
                           "menu.exercises",
                           "menu.lecture",
                           "menu.help",
                           "slider.LL",
                           "slider.LR",
                           "slider.RL",
                           "slider.RR",
                           "button.thresholds",
                           "bias.LM",
                           "bias.RM",
                           "viewport",
                           "exercise.predict",
                           "exercise.predict.1",
                           "exercise.predict.2",
                           "exercise.predict.3",
                           "exercise.step.1",
                           "exercise.step.2",
                           "exercise.step.3",
                           "exercise.hint",
                           "exercise.reset",
                           "button.presets",
                           "mode",
                           "time",
                           "speed"})
        EXPECT_TRUE(desk.anchors.find(id)) << id;
    for (const auto& [id, rect] : desk.anchors.all()) EXPECT_TRUE(lies_inside(rect, desk.layout.window)) << id;
}

TEST_P(WindowAtEverySize, KeepsCardsBarsAndTheSceneApart) {
    Desk desk(GetParam().width, GetParam().height, GetParam().scale, true);
    for (const bool with_exercise : {false, true}) {
        if (with_exercise) desk.open_exercise();
        desk.frame(5);
        std::vector<std::pair<std::string, Rect>> parts{
            {"menu bar", desk.layout.menu_bar}, {"toolbar", desk.layout.toolbar}, {"hint bar", desk.layout.hint_bar}};
        for (const char* id :
             {"card.brain", "card.information", with_exercise ? "card.exercise" : "card.scene", "viewport"})
            parts.emplace_back(id, desk.where(id));
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(overlap(parts[i].second, parts[j].second)) << parts[i].first << " and " << parts[j].first;
        EXPECT_GE(desk.layout.scene.w, 0.25f * GetParam().width);
    }
}

TEST_P(WindowAtEverySize, KeepsTheButtonsOfTheToolbarApart) {
    Desk desk(GetParam().width, GetParam().height, GetParam().scale, true);
    desk.frame(3);
    std::vector<std::pair<std::string, Rect>> row;
    for (const auto& [id, rect] : desk.anchors.all())
        if ((id.starts_with("button.") && id != "button.presets") || id == "mode" || id == "time" || id == "speed")
            row.emplace_back(id, rect);
    for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(overlap(row[i].second, row[j].second)) << row[i].first << " and " << row[j].first;
}

INSTANTIATE_TEST_SUITE_P(Windows, WindowAtEverySize,
                         ::testing::Values(Size{1024, 768, 1}, Size{1280, 800, 1}, Size{2048, 1536, 2},
                                           Size{1920, 1080, 1}));

TEST(Window, AColumnWhoseCardsAreAllFoldedLeavesItsRoomToTheScene) {
    for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1024.0f, 768.0f}, {1280.0f, 800.0f}}) {
        SCOPED_TRACE(width);
        Desk desk(width, height, 1, true);
        desk.frame(5);
        const float between = desk.layout.scene.w;
        const auto fold = [&](std::initializer_list<Card> folded) {
            for (const Card card : folded) desk.panels.card(card).folded = true;
            desk.frame(5);
            for (const char* id : {"card.scene", "card.sensors", "card.brain", "card.information"})
                EXPECT_FALSE(overlap(desk.where(id), desk.where("viewport"))) << id;
        };
        fold({Card::scene, Card::sensors});
        const float without_left = desk.layout.scene.w;
        if (width < 900)
            EXPECT_EQ(without_left, between) << "the brain is in the same column";
        else
            EXPECT_GT(without_left, between + 80);
        fold({Card::brain, Card::information});
        EXPECT_GT(desk.layout.scene.w, without_left + 80);
        desk.panels.card(Card::scene).folded = desk.panels.card(Card::brain).folded = false;
        desk.frame(5);
        EXPECT_EQ(desk.layout.scene.w, between);
    }
}

TEST(Window, NoTooltipFollowsTheTitlePageUntilThePointerMoves) {
    Desk desk(800, 600, 1, true);
    desk.point(200, 300);
    desk.view.program.title_page = true;
    desk.frame(2);
    desk.view.program.title_page = false;
    desk.frame(5);
    EXPECT_TRUE(desk.panels.tooltips.hidden);
    desk.point(300, 300);
    desk.frame(2);
    EXPECT_FALSE(desk.panels.tooltips.hidden);
}

TEST(Window, FramesTheSceneInAnInsetWhileWiring) {
    Desk desk;
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    EXPECT_GT(desk.layout.canvas.w, 0.5f * desk.layout.window.w);
    EXPECT_FALSE(overlap(desk.layout.canvas, desk.layout.scene));
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.layout.scene));
    EXPECT_FALSE(desk.anchors.find("card.information"));
}

TEST(Window, ShowsTheWiringBesideThePlayingSceneWhileItIsWatched) {
    for (const float width : {1024.0f, 1280.0f, 2560.0f}) {
        Desk desk(width, 1000);
        desk.view.mode = Mode::playing;
        desk.rest();
        EXPECT_FALSE(desk.anchors.find("canvas"));
        desk.click("button.watch");
        EXPECT_NE(std::find_if(desk.all.begin(), desk.all.end(),
                               [](const Request& r) {
                                   const auto* action = std::get_if<Action>(&r);
                                   return action && *action == Action::watch;
                               }),
                  desk.all.end());
        desk.view.settings.watching = true;
        desk.rest();
        const Rect canvas = *desk.anchors.find("canvas"), scene = *desk.anchors.find("viewport");
        const bool is_below = scene.y + scene.h <= canvas.y, is_beside = scene.x + scene.w <= canvas.x;
        EXPECT_NE(is_below, is_beside) << width;
        EXPECT_GT(scene.w, 300) << width;
        EXPECT_GT(scene.h, 200) << width;
        EXPECT_GT(canvas.w, 300) << width;
        EXPECT_GT(canvas.h, 200) << width;
        EXPECT_FALSE(overlap(canvas, desk.where("card.brain"))) << width;
    }
}

TEST(Window, MovesTheBorderOfTheWatchedWiringWithThePointer) {
    Desk desk;
    desk.view.settings.watching = true;
    desk.rest();
    const Rect canvas = *desk.anchors.find("canvas");
    desk.point("canvas.border");
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.point(canvas.x + canvas.w / 2, canvas.y + canvas.h / 2);
    desk.frame(2);
    ASSERT_TRUE(!desk.asked.empty() && std::holds_alternative<CanvasShareRequest>(desk.asked.back()));
    EXPECT_LT(std::get<CanvasShareRequest>(desk.asked.back()).share, desk.view.settings.canvas_share - 0.1f);
    desk.button(0, false);
    desk.frame(2);
    EXPECT_TRUE(desk.asked.empty());
}

TEST(Window, MovesTheBorderOfTheWatchedWiringWithArrowKeys) {
    Desk desk;
    desk.view.settings.watching = true;
    desk.rest();
    const Rect border = desk.where("canvas.border");
    desk.panels.keyboard.focus = "canvas.border";
    desk.key({border.w > border.h ? key::right : key::left});
    desk.frame();
    ASSERT_TRUE(!desk.asked.empty() && std::holds_alternative<CanvasShareRequest>(desk.asked.back()));
    EXPECT_FLOAT_EQ(std::get<CanvasShareRequest>(desk.asked.back()).share, desk.view.settings.canvas_share + 0.05f);
}

TEST(Window, GivesTheKeysOfTheCanvasToTheWatchedWiringAfterAClickOnIt) {
    Desk desk(1600, 1000);
    desk.view.settings.watching = true;
    desk.rest();
    desk.click("wire.LR");
    EXPECT_EQ(desk.panels.keyboard.focus, "canvas");
    desk.all.clear();
    desk.key({key::del});
    desk.frame(2);
    EXPECT_EQ(desk.actions(), std::vector<Action>{}) << "the vehicle is not deleted";
    ASSERT_FALSE(desk.edits().empty());
    desk.key({key::escape});
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "");
}

TEST(Window, KeepsTheLettersOfTheWindowWhileTheWatchedWiringHasTheFocus) {
    Desk desk(1600, 1000);
    desk.view.settings.watching = true;
    desk.rest();
    desk.click("wire.LR");
    desk.all.clear();
    desk.key({'C'});
    desk.key({'F'});
    desk.frame(2);
    EXPECT_TRUE(desk.panels.charts.open);
    EXPECT_EQ(desk.actions(), std::vector{Action::follow});
}

TEST(Window, FitsTheWatchedWiringAgainWhenItsPaneChanges) {
    Desk desk(1280, 800);
    desk.view.settings.watching = true;
    desk.rest();
    desk.panels.charts.open = true;
    desk.rest();
    const Rect canvas = *desk.anchors.find("canvas");
    for (const char* node : {"node.SL", "node.SR", "node.ML", "node.MR"}) {
        ASSERT_TRUE(desk.anchors.find(node)) << node;
        const Rect r = *desk.anchors.find(node);
        EXPECT_TRUE(canvas.contains(r.x + r.w / 2, r.y + r.h / 2)) << node;
    }
}

TEST(Window, SaysHowTheToolIsUsedWhileItDraws) {
    Desk desk(1280, 800, 1, true);
    desk.panels.scene_input.tool = SceneInputTool::tape;
    desk.rest();
    const auto writes = [&](std::string_view key) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == desk.strings(key); });
    };
    EXPECT_TRUE(writes("tools.tape_how"));
    desk.panels.scene_input.tool = SceneInputTool::hand;
    desk.rest();
    EXPECT_FALSE(writes("tools.tape_how"));
}

TEST(Window, ReachesTheWatchedWiringWithTab) {
    Desk desk(1600, 1000);
    desk.view.settings.watching = true;
    desk.rest();
    std::set<std::string> reached;
    desk.key({key::tab, true});  // to the first card
    for (int i = 0; i < 200; ++i) {
        desk.frame();
        desk.key({key::tab});
        reached.insert(desk.panels.keyboard.focus);
    }
    EXPECT_TRUE(reached.contains("canvas.border"));
    EXPECT_TRUE(reached.contains("canvas"));
}

TEST(Window, PlaysAndPausesOnSpaceWithAnyFocus) {
    Desk desk;
    desk.frame(3);
    desk.key({'1'});
    desk.frame();
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LL");
    desk.key({' '});
    desk.frame();
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
}

TEST(Window, PressesTheFocusedButtonWithEnter) {
    Desk desk;
    desk.frame(3);
    desk.panels.keyboard.focus = "button.step";
    desk.key({key::enter});
    desk.frame();
    EXPECT_EQ(desk.actions(), std::vector{Action::step});
}

TEST(Window, MovesTheFocusWithTab) {
    Desk desk;
    desk.frame(3);
    desk.panels.keyboard.focus = "slider.LL";
    desk.key({key::tab});
    desk.frame();
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR");
    desk.key({key::tab, false, true});
    desk.frame();
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LL");
    desk.key({key::escape});
    EXPECT_TRUE(desk.panels.keyboard.focus.empty());
}

TEST(Window, SelectsTheNextVehicleWithTabInTheScene) {
    Desk desk;
    desk.now = snapshot(1);
    desk.frame(3);
    desk.key({key::tab});
    EXPECT_EQ(desk.actions(), std::vector{Action::next_vehicle});
}

TEST(Window, MovesTheFocusIntoTheCardsWithTabIfTheExerciseHidesTheBrainsOfAllOtherVehicles) {
    Desk desk;
    desk.open_exercise();
    desk.now = snapshot(1);
    desk.frame(3);
    desk.key({key::tab});
    EXPECT_EQ(desk.actions(), std::vector{Action::next_vehicle}) << "it hides none";
    desk.all.clear();
    desk.opened.hides = {"prey"};
    desk.key({key::tab});
    desk.frame();
    EXPECT_TRUE(desk.actions().empty());
    EXPECT_FALSE(desk.panels.keyboard.focus.empty());
}

TEST(Window, MovesTheFocusIntoTheCardsWithTabIfThereIsNoOtherVehicle) {
    Desk desk;
    desk.now = snapshot(0);
    desk.frame(3);
    desk.key({key::tab});
    desk.frame();
    EXPECT_FALSE(desk.panels.keyboard.focus.empty());
    EXPECT_TRUE(desk.actions().empty());
    desk.key({key::escape});
    desk.key({key::tab, false, true});
    desk.frame();
    EXPECT_FALSE(desk.panels.keyboard.focus.empty());
    EXPECT_TRUE(desk.actions().empty());
}

TEST(Window, MovesTheFocusFromCardToCardWithControlTab) {
    Desk desk;
    desk.frame(3);
    std::set<std::string> cards;
    for (int i = 0; i < 6; ++i) {
        desk.key({key::tab, true});
        desk.frame();
        cards.insert(desk.panels.keyboard.focus);
    }
    EXPECT_TRUE(cards.count("button.values")) << "the first button of the scene card";
    EXPECT_TRUE(cards.count("button.play"));
    EXPECT_TRUE(cards.count("button.presets"));
}

TEST(Window, FoldsACardToItsHeading) {
    Desk desk;
    desk.frame(3);
    desk.click("card.brain.fold", 0, 0.2f);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("slider.LL"));
    EXPECT_LT(desk.where("card.brain").h, 40);
    desk.key({'2'});  // the key of a slider opens its card
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("slider.LR"));
}

TEST(Window, ListsTheKeysOnF1AndClosesThemOnEscape) {
    Desk desk;
    desk.frame(2);
    desk.key({key::f1});
    desk.frame(2);
    EXPECT_TRUE(lies_inside(desk.where("card.keys"), desk.layout.window));
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.keys"));
    EXPECT_TRUE(desk.actions().empty());
}

TEST(InformationCard, SelectsTheVehicleOfTheClickedEnergyBar) {
    Desk desk(1280, 1000);
    desk.panels.card(Card::information).folded = false;
    desk.frame(3);
    const Rect r = desk.where("info.energy");
    desk.point(r.x + r.w * 0.4f, r.y + 8);
    desk.frame(2);
    desk.button(0, true);
    desk.frame();
    desk.button(0, false);
    desk.frame();
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_GE(std::get<SelectRequest>(desk.all[0]).vehicle, 0);
}

TEST(WindowLayout, TheToolsOfASmallWindowCoverNothingOfTheScene) {
    struct Small {
        float width, height, scale;
    };
    for (const Small w : {Small{800, 600, 1}, {1024, 768, 1}, {1280, 800, 1.25f}, {1280, 800, 1}}) {
        Desk desk(w.width, w.height, w.scale, true);
        desk.open_exercise();
        desk.frame(3);
        const CameraView camera = look({}, desk.now.scene->arena, nullptr, desk.layout.window, desk.layout.scene);
        desk.view.camera_view = &camera;
        desk.frame(3);
        const bool is_corner = w.width / w.scale >= 1200;
        for (const char* id : {"tool.hand", "tool.ruler"}) {
            EXPECT_EQ(overlap(desk.where(id), desk.where("viewport")), is_corner) << w.width << " " << w.scale << id;
            EXPECT_FALSE(overlap(desk.where(id), desk.where("card.brain"))) << w.width;
            EXPECT_FALSE(overlap(desk.where(id), desk.where("card.exercise"))) << w.width;
        }
        EXPECT_GE(desk.layout.scene.h, 0.4f * w.height);
    }
}

TEST(WindowLayout, HasTheToolsBesideFoldedCardsWhereTheSceneIsBelowThem) {
    int beside = 0;
    for (const Size& w : {Size{800, 600, 1}, {1280, 800, 1}, {1600, 1200, fitting_scale(2, {0, 0, 1600, 1200}, false)}})
        for (const bool exercise : {false, true}) {
            Desk desk(w.width, w.height, w.scale, true);
            if (exercise) desk.open_exercise();
            desk.frame(4);
            Camera camera;
            const CameraView sight =
                look(camera, desk.now.scene->arena, nullptr, desk.layout.window, desk.layout.scene);
            desk.view.camera_view = &sight;
            for (const Card card : {Card::brain, Card::information, Card::scene}) desk.panels.card(card).folded = true;
            desk.frame(6);
            const Rect &scene = desk.layout.scene, first = desk.where("tool.hand"), last = desk.where("tool.ruler");
            if (scene.y < desk.layout.right.y + 50 * w.scale) continue;
            ++beside;
            EXPECT_FALSE(overlap(first, scene)) << w.width;
            EXPECT_FALSE(overlap(last, scene)) << w.width;
            for (const char* card : {"card.brain", "card.information", "card.scene", "card.exercise"})
                if (const Rect* at = desk.anchors.find(card)) {
                    EXPECT_FALSE(overlap(first, *at) || overlap(last, *at)) << card << " " << w.width;
                }
        }
    EXPECT_GT(beside, 1);
}

TEST(WindowLayout, HasTheCardsOfAnUprightWindowBelowTheSceneAndTheDiagram) {
    for (const bool exercise : {false, true})
        for (const Mode mode : {Mode::paused, Mode::wiring}) {
            Desk desk(512, 1024, 1, true);
            if (exercise) desk.open_exercise();
            desk.view.mode = mode;
            desk.frame(6);
            const WindowLayout& l = desk.layout;
            const Rect above = mode == Mode::wiring ? l.canvas : l.scene;
            EXPECT_GE(l.right.y, above.y + above.h);
            EXPECT_GE(l.right.w, 280);
            for (const Rect& part : {l.scene, l.right, l.timeline, l.tools, l.canvas})
                EXPECT_TRUE(part.x >= 0 && part.x + part.w <= 512 && part.y + part.h <= l.hint_bar.y);
            EXPECT_TRUE(desk.anchors.find("card.brain.fold"));
            EXPECT_EQ(desk.anchors.find("card.exercise.fold") != nullptr, exercise);
        }
    EXPECT_EQ(fitting_scale(2, {0, 0, 512, 1024}, false), 1.25f) << "its type can be larger";
}

TEST(WindowLayout, FoldsWhatHasNoRoomInAnUprightWindowAndOpensWhatIsPressed) {
    Desk desk(512, 1024, 1, true);
    desk.view.program.touch = true, desk.view.program.finger = 56;
    desk.open_exercise();
    desk.frame(6);
    EXPECT_FALSE(desk.panels.card(Card::exercise).folded);
    EXPECT_TRUE(desk.panels.card(Card::brain).folded);
    desk.click("card.brain.fold");
    desk.frame(6);
    EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    EXPECT_TRUE(desk.panels.card(Card::exercise).folded);
    EXPECT_GT(desk.where("card.brain").h, 200);
}

TEST(WindowLayout, LimitsTheScaleToWhatFitsIntoTheWindow) {
    EXPECT_EQ(fitting_scale(1, {0, 0, 1024, 768}, false), 1);
    EXPECT_EQ(fitting_scale(3, {0, 0, 1024, 768}, false), 1);
    EXPECT_EQ(fitting_scale(3, {0, 0, 3840, 2160}, false), 3);
    EXPECT_EQ(fitting_scale(3, {0, 0, 1920, 1200}, false), 2) << "in steps of an eighth";
    EXPECT_EQ(fitting_scale(0.75f, {0, 0, 1024, 768}, false), 0.75f);
    EXPECT_EQ(fitting_scale(4.2f, {0, 0, 1024, 768}, true), 1.375f) << "a lecture has larger type";
    EXPECT_EQ(fitting_scale(1, {0, 0, 800, 600}, false), 1);
    EXPECT_EQ(fitting_scale(1, {0, 0, 640, 400}, false), 0.625f) << "what does not fit has smaller type";
    EXPECT_EQ(fitting_scale(1, {0, 0, 320, 240}, false), 0.625f) << "which is legible";
}

TEST(WindowLayout, AWindowThatIsTooSmallForAnyTypeAsksForRoom) {
    for (const bool is_small : {true, false}) {
        Desk desk(is_small ? 320 : 640, is_small ? 240 : 400, 0.625f, true);
        desk.frame(3);
        std::string all;
        for (const Written& w : desk.written) all += w.words + " ";
        EXPECT_EQ(all.find(std::string(desk.strings("window.too_small"))) != std::string::npos, is_small);
    }
}

TEST(InformationCard, ShowsAnyNumberOfVehicles) {
    Desk desk(1280, 1000);
    desk.panels.card(Card::information).folded = false;
    desk.now = snapshot(700);
    desk.frame(5);
    EXPECT_TRUE(lies_inside(desk.where("card.information"), desk.layout.window));
}

TEST(Window, ACardThatIsAskedForTakesTheRoomOfTheWatchedDiagramInANarrowWindow) {
    for (const float width : {1280.0f, 1920.0f}) {
        Desk desk(width, 800, 1, true);
        desk.now = shipped_scene("2a-coward");
        desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
        desk.view.settings.watching = true;
        desk.frame(3);
        ASSERT_TRUE(desk.anchors.find("canvas"));
        for (const char* card : {"card.map", "card.values", "card.reality"}) {
            ViewSettings& shown = desk.view.settings;
            const std::string_view name = card;
            shown.map = name == "card.map", shown.values = name == "card.values",
            shown.reality = name == "card.reality";
            desk.frame(3);
            EXPECT_TRUE(desk.anchors.find(card)) << card << " at " << width;
            EXPECT_EQ(desk.anchors.find("canvas") != nullptr, width > 1600) << card;
        }
    }
}

}  // namespace braitenlab::tests::window_test
