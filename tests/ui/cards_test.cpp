#include "ui/panels/cards.h"

#include <algorithm>
#include <set>
#include <vector>

#include "exercise_on_desk.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::cards_test {

using namespace ui;

TEST(Cards, HaveOneRowWithAUniqueAnchorPerCard) {
    std::set<std::string_view> anchors;
    for (const CardTraits& row : cards()) {
        EXPECT_EQ(&traits(row.card), &row);
        EXPECT_TRUE(anchors.insert(row.anchor).second) << row.anchor;
        EXPECT_EQ(row.column != Column::none, row.draw && row.shown) << row.anchor;
    }
    EXPECT_EQ(anchors.size(), card_count);
}

TEST(Cards, AreDrawnWithTheAnchorOfTheirRow) {
    std::set<std::string_view> drawn;
    const auto note = [&](const Desk& desk) {
        for (const CardTraits& row : cards())
            if (desk.anchors.find(row.anchor)) drawn.insert(row.anchor);
    };
    Desk desk(1280, 1400);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->sources.resize(1);
    desk.now.scene = scene;
    desk.now.sources.resize(1);
    desk.view.settings.selection.object = {SceneObjectKind::source, 0};
    desk.panels.charts.open = true;
    desk.view.settings.values = desk.view.settings.map = desk.view.settings.reality = true;
    const insight::Design design;
    desk.view.features.slots.slots[0].design = &design;
    const std::vector<Finding> findings(1);
    desk.view.findings = &findings;
    desk.frame(3);
    note(desk);
    desk.open_exercise();
    desk.view.settings.selection.object = {};
    desk.frame(3);
    note(desk);
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    note(desk);
    for (const CardTraits& row : cards()) EXPECT_TRUE(drawn.count(row.anchor)) << row.anchor;
}

TEST(Cards, NoRowOfTheBrainMovesWhenALampIsSelected) {
    for (const float width : {800.0f, 1280.0f}) {
        Desk desk(width, width == 800 ? 600.0f : 800.0f, 1, true);
        desk.open_exercise();
        desk.lesson.attempt.answers.prediction = 0;
        desk.lesson.attempt.work.has_run = desk.lesson.attempt.work.outcome_known = true;
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.resize(1);
        desk.now.scene = scene;
        desk.now.sources.resize(1);
        desk.frame(8);
        if (width == 800) desk.click("card.brain.fold");
        desk.frame(4);
        std::map<std::string, Rect> before;
        for (const char* id : {"card.brain", "slider.LL", "slider.LR", "slider.RL", "slider.RR"})
            if (const Rect* at = desk.anchors.find(id)) before[id] = *at;
        EXPECT_GE(before.size(), 4u);
        desk.view.settings.selection.object = {SceneObjectKind::source, 0};
        desk.frame(8);
        EXPECT_TRUE(desk.anchors.find("card.thing"));
        for (const auto& [id, was] : before) {
            const Rect* now = desk.anchors.find(id);
            if (!now) continue;
            EXPECT_EQ(now->y, was.y) << id << " " << width;
        }
    }
}

// Shades at the upper and at the lower edges of cards: rectangles that begin or end without opacity.
std::pair<int, int> shades(const Desk& desk) {
    const ImU32 full = paint(palette(desk.view.program.theme).panel);
    const ImU32 none = paint(palette(desk.view.program.theme).panel.with_alpha(0));
    std::pair<int, int> found{};
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const auto& v = data.CmdLists[l]->VtxBuffer;
        for (int i = 0; i + 3 < v.Size; ++i) {
            const auto are = [&](ImU32 above, ImU32 below) {
                return v[i].col == above && v[i + 1].col == above && v[i + 2].col == below && v[i + 3].col == below &&
                       v[i].pos.y == v[i + 1].pos.y;
            };
            found.first += are(full, none), found.second += are(none, full);
        }
    }
    return found;
}

TEST(Cards, ShadeTheEdgesBeyondWhichThereIsMore) {
    Desk desk(1280, 1100, 1, true);
    desk.open_exercise();
    desk.frame(6);
    EXPECT_EQ(shades(desk), (std::pair{0, 0}));
    ImGui::GetIO().DisplaySize = {1280, 575};
    desk.panels.card(Card::brain).folded = true;
    desk.frame(6);
    EXPECT_EQ(shades(desk), (std::pair{0, 1}));
    const Rect card = desk.where("card.exercise");
    desk.point(card.x + card.w / 2, card.y + card.h / 2);
    ImGui::GetIO().MouseWheel = -0.2f;
    desk.frame(4);
    EXPECT_EQ(shades(desk), (std::pair{1, 1}));
}

TEST(Cards, TellThatTheyAreTooLowForAFrameWhenTheirWordsGrow) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.frame(4);
    EXPECT_FALSE(desk.panels.is_unsettled);
    const std::string goal = desk.opened.goal;
    const auto last_line_of_goal = [&] {
        for (const Written& w : desk.written)
            if (w.words.find("END") != std::string::npos) return w.rect;
        return Rect{};
    };
    desk.opened.goal = goal + " " + goal + " " + goal + " END";
    desk.frame();
    EXPECT_TRUE(desk.panels.is_unsettled);
    desk.frame();
    EXPECT_FALSE(desk.panels.is_unsettled);
    const Rect card = desk.where("card.exercise"), line = last_line_of_goal();
    EXPECT_GT(line.h, 0);
    EXPECT_LT(line.y + line.h, card.y + card.h);
    desk.opened.goal = goal;
    desk.frame();
    EXPECT_FALSE(desk.panels.is_unsettled) << "a lower one has room";
    desk.frame(2);
    desk.lesson.attempt.answers.prediction = 1, desk.lesson.attempt.work.has_run = true;
    desk.lesson.grade = graded(std::vector<bool>(10, true), true);
    desk.frame();
    EXPECT_TRUE(desk.panels.is_unsettled);
    desk.frame(2);
    EXPECT_FALSE(desk.panels.is_unsettled);
}

TEST(Cards, AreInTheColumnOfTheirRowInTheOrderOfTheTable) {
    Desk desk(1280, 1400);
    desk.frame(3);
    for (const Column column : {Column::left, Column::right}) {
        const Rect area = column == Column::left ? desk.layout.left : desk.layout.right;
        float end = area.y;
        for (const CardTraits& row : cards()) {
            const Rect* card = row.column == column ? desk.anchors.find(row.anchor) : nullptr;
            if (!card) continue;
            EXPECT_FLOAT_EQ(card->x, area.x) << row.anchor;
            EXPECT_GE(card->y, end) << row.anchor;
            end = card->y + card->h;
        }
        EXPECT_GT(end, area.y);
        EXPECT_LE(end, area.y + area.h + 0.5f);
    }
}

TEST(Cards, StayInTheirColumnWhicheverAreOpen) {
    std::vector<insight::RobotResult> robots(40);
    for (insight::RobotResult& robot : robots) robot.path = {{0, 0, 0}, {1, 1, 0}};
    const insight::RobotsReport report = insight::report_of(robots.front(), robots, false);
    const insight::Design design;
    for (const float height : {640.0f, 800.0f}) {
        Desk desk(1280, height, 1, true);
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.resize(1);
        desk.now.scene = scene;
        desk.now.sources.resize(1);
        desk.view.settings.selection.object = {SceneObjectKind::source, 0};
        desk.view.settings.values = desk.view.settings.map = desk.view.settings.reality = true;
        desk.view.features.slots.slots[0].design = &design;
        desk.view.features.robots = RobotsView{.count = 40, .is_on = true, .report = &report};
        desk.panels.values.kinds = desk.panels.sensors.quality_open = true;
        std::vector<Card> foldable;  // folding others closes them
        for (const Card card : {Card::scene, Card::values, Card::sensors, Card::brain, Card::information})
            foldable.push_back(card);
        for (unsigned open = 0; open < 1U << foldable.size(); ++open) {
            for (std::size_t i = 0; i < foldable.size(); ++i) desk.panels.card(foldable[i]).folded = !(open >> i & 1);
            desk.frame(3);
            for (const Column column : {Column::left, Column::right}) {
                const Rect area = column == Column::left ? desk.layout.left : desk.layout.right;
                float end = area.y;
                for (const CardTraits& row : cards()) {
                    const Rect* card = row.column == column ? desk.anchors.find(row.anchor) : nullptr;
                    if (!card) continue;
                    EXPECT_GE(card->y, end - 0.5f) << row.anchor << " with " << open;
                    EXPECT_GE(card->h, 35.5f) << row.anchor << " with " << open;
                    end = card->y + card->h;
                }
                EXPECT_LE(end, area.y + area.h + 0.5f) << height << " with " << open;
            }
        }
    }
}

TEST(Cards, AreCutFromTheLargestDown) {
    const auto cut = [](std::vector<float> heights, float room) {
        cut_to_fit(heights, 36, room);
        return heights;
    };
    EXPECT_EQ(cut({36, 250, 400}, 700), (std::vector<float>{36, 250, 400})) << "all fit";
    EXPECT_EQ(cut({36, 250, 400}, 586), (std::vector<float>{36, 250, 300})) << "the largest is cut";
    EXPECT_EQ(cut({400, 36, 250}, 436), (std::vector<float>{200, 36, 200})) << "then the two largest";
    EXPECT_EQ(cut({300, 300}, 50), (std::vector<float>{36, 36})) << "each keeps its heading";
}

TEST(Cards, AreOpenAtFirstOnlyForTheStoryAndTheBrain) {
    Desk desk(1920, 1200, 1, true);
    desk.frame(5);
    for (const CardTraits& row : cards()) {
        const Rect* card = desk.anchors.find(row.anchor);
        if (!card) continue;
        const bool opens = row.card == Card::scene || row.card == Card::brain;
        EXPECT_EQ(card->h > 60, opens) << row.anchor;
    }
}

TEST(Cards, FoldInALowColumnUntilTheUserOpensThem) {
    Desk desk(1280, 640, 1, true);
    desk.panels.card(Card::information).folded = false;  // as remembered from a higher window
    desk.frame(5);
    ASSERT_TRUE(traits(Card::information).folds_when_cramped);
    ASSERT_LT(desk.where("card.information").h, 60) << "there is no room for both cards";
    EXPECT_FALSE(desk.panels.card(Card::information).folded) << "only folded while it is drawn";
    desk.click("card.information.fold");
    desk.frame(3);
    EXPECT_TRUE(desk.panels.card(Card::information).opened_by_user);
    EXPECT_GT(desk.where("card.information").h, 100);
}

// Whether this text is drawn inside the widget with this anchor.
bool writes(const Desk& desk, std::string_view anchor, std::string_view beginning) {
    const Rect area = desk.where(std::string(anchor));
    return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
        return w.words.starts_with(beginning) && area.contains(w.rect.x, w.rect.y);
    });
}

TEST(Cards, TheExerciseIsReadBesideItsDiagramInAnyWindow) {
    for (const float width : {1024.0f, 1280.0f})
        for (const bool is_watched : {false, true}) {
            Desk desk(width, 768, 1, true);
            desk.open_exercise();
            desk.view.mode = is_watched ? Mode::playing : Mode::wiring;
            desk.view.settings.watching = is_watched;
            desk.frame(6);
            const Rect card = desk.where("card.exercise"), hint = desk.where("exercise.hint");
            EXPECT_TRUE(writes(desk, "card.exercise", "Wire this vehicle")) << width;
            EXPECT_LE(hint.y + hint.h, card.y + card.h);
            EXPECT_GE(card.h, 240);
            EXPECT_GE(desk.where("card.brain").y, width < 1200 ? card.y + card.h : card.y) << "below it or beside it";
        }
}

TEST(Cards, TheBrainBelowTheExerciseOpensByAClickWhereItHasNoRoom) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.view.mode = Mode::wiring;
    desk.frame(6);
    ASSERT_LT(desk.where("card.brain").h, 60);
    desk.click("card.brain.fold");
    desk.frame(4);
    EXPECT_GE(desk.where("card.brain").h, 139);
    EXPECT_GT(desk.where("card.exercise").h, 200);
}

bool is_open(const Desk& desk, Card which) { return !desk.panels.cards[static_cast<std::size_t>(which)].folded; }

TEST(Cards, OfASmallWindowAreInOneColumnAndTheSceneHasMostOfTheWidth) {
    for (const std::string& code : shipped_codes())
        for (const bool exercise : {false, true})
            for (const Card opened : {Card::brain, Card::sensors, Card::information}) {
                Desk desk(800, 600, 1, true);
                desk.strings = speaking(code);
                if (exercise) desk.open_exercise();
                desk.frame(6);
                const Rect scene = desk.layout.scene;
                EXPECT_GE(scene.w * scene.h, 0.36f * 800 * 600);
                if (!is_open(desk, opened)) desk.click(std::string(traits(opened).anchor) + ".fold");
                desk.frame(4);
                EXPECT_TRUE(is_open(desk, opened)) << traits(opened).anchor;
                EXPECT_EQ(desk.layout.scene, scene) << "the scene rests";
                float end = desk.layout.right.y;
                for (const CardTraits& row : cards()) {
                    const Rect* card = desk.anchors.find(row.anchor);
                    if (!card) continue;
                    EXPECT_TRUE(inside(*card, desk.layout.right)) << row.anchor;
                    if (is_open(desk, row.card)) {
                        EXPECT_EQ(card->y, end) << row.anchor;
                        end = card->y + card->h + 12;
                    } else {
                        EXPECT_GT(card->y, desk.where(traits(opened).anchor).y) << row.anchor;
                    }
                }
            }
}

TEST(Cards, OfASmallWindowGiveWayToWhatIsOpenedAndComeBack) {
    Desk desk(800, 600, 1, true);
    desk.open_exercise();
    predict_and_run(desk, 0);
    desk.frame(6);
    ASSERT_TRUE(is_open(desk, Card::exercise) && !is_open(desk, Card::brain));
    desk.click("card.brain.fold");
    desk.frame(4);
    EXPECT_TRUE(is_open(desk, Card::brain) && !is_open(desk, Card::exercise));
    EXPECT_TRUE(desk.says("0/3")) << "the folded exercise counts its steps";
    for (bool ViewSettings::*const shown : {&ViewSettings::map, &ViewSettings::values}) {
        desk.view.settings.*shown = true;
        desk.frame(4);
        EXPECT_TRUE(is_open(desk, shown == &ViewSettings::map ? Card::map : Card::values));
        EXPECT_FALSE(is_open(desk, Card::brain));
        desk.view.settings.*shown = false;
        desk.frame(4);
        EXPECT_TRUE(is_open(desk, Card::brain)) << "it gave way to what was asked for";
    }
}

TEST(Cards, OfASmallWindowTheExerciseOpensWhenThereIsNewsOfIt) {
    const char* const news[]{"a hint", "the outcome", "the grade", "another exercise"};
    for (int which = 0; which < 4; ++which) {
        Desk desk(800, 600, 1, true);
        desk.open_exercise();
        predict_and_run(desk, 0);
        desk.frame(6);
        desk.click("card.brain.fold");
        desk.frame(4);
        ASSERT_FALSE(is_open(desk, Card::exercise)) << news[which];
        if (which == 0) desk.lesson.attempt.answers.hints_shown = 1;
        if (which == 1) desk.lesson.attempt.work.outcome_known = true;
        if (which == 2) desk.lesson.grade = graded({true, false}, false);
        if (which == 3) desk.opened.id = "06-love";
        desk.point(300, 300);
        desk.button(0, true);
        desk.frame(4);
        if (which < 3) {
            EXPECT_FALSE(is_open(desk, Card::exercise)) << news[which] << ", while a slider is held";
        }
        desk.button(0, false);
        desk.frame(4);
        EXPECT_TRUE(is_open(desk, Card::exercise)) << news[which];
        desk.rest();
        desk.click("card.brain.fold");
        desk.frame(6);
        EXPECT_FALSE(is_open(desk, Card::exercise)) << news[which] << " is seen";
    }
}

TEST(Cards, OfASmallWindowAClickDoesNotOpenWhatHasJustReplacedTheHeadingBelowIt) {
    for (const bool by_itself : {false, true}) {
        Desk desk(800, 600, 1, true);
        desk.open_exercise();
        predict_and_run(desk, 0);
        desk.frame(6);
        desk.click("card.brain.fold");
        desk.frame(2);
        ASSERT_TRUE(is_open(desk, Card::brain) && !is_open(desk, Card::exercise));
        if (by_itself) {
            desk.rest();
            const Rect heading = desk.where("card.exercise.fold");
            desk.point(300, 300);
            desk.lesson.grade = graded({true, false}, false);
            desk.frame(2);
            desk.point(heading.x + heading.w / 2, heading.y + heading.h / 2);
        }
        desk.frame();
        const ImVec2 pointer = ImGui::GetIO().MousePos;
        const auto below = std::find_if(cards().begin(), cards().end(), [&](const CardTraits& row) {
            const Rect* at = desk.anchors.find(std::string(row.anchor) + ".fold");
            return at && at->contains(pointer.x, pointer.y);
        });
        ASSERT_TRUE(below != cards().end() && !is_open(desk, below->card));
        for (const bool waits : {false, true}) {
            if (waits) desk.rest();
            desk.button(0, true);
            desk.frame(2);
            desk.button(0, false);
            desk.frame(2);
            EXPECT_EQ(is_open(desk, below->card), waits) << below->anchor;
        }
    }
}

TEST(Cards, TheExerciseThatIsOpenedShowsItsCardThoughThatOfTheLastOneIsFolded) {
    for (const float width : {800.0f, 1280.0f}) {
        Desk desk(width, width == 800 ? 600.0f : 800.0f, 1, true);
        desk.open_exercise();
        desk.frame(6);
        desk.click("card.exercise.fold");
        desk.rest();
        ASSERT_FALSE(is_open(desk, Card::exercise)) << width;
        desk.opened.id = "06-love";
        desk.frame(4);
        EXPECT_TRUE(is_open(desk, Card::exercise)) << width;
        desk.click("card.exercise.fold");
        desk.rest();
        EXPECT_FALSE(is_open(desk, Card::exercise)) << width << ": it can be folded";
    }
}

TEST(Cards, OfASmallWindowTheBrainStaysOpenAfterAnOutcomeWithoutAnAnswer) {
    Desk desk(800, 600, 1, true);
    desk.open_exercise();
    predict_and_run(desk, -1);
    desk.lesson.attempt.work.outcome_known = true;
    desk.frame(6);
    ASSERT_TRUE(is_open(desk, Card::exercise));
    desk.click("card.brain.fold");
    desk.frame(6);
    EXPECT_TRUE(is_open(desk, Card::brain) && !is_open(desk, Card::exercise));
}

TEST(Cards, ACardBelowTheExerciseGrowsWhenItUnfolds) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.answers.prediction = 0, desk.lesson.attempt.work.has_run = true;
    const insight::Design design;
    auto& slots = desk.view.features.slots;
    for (SlotView& slot : slots.slots) slot.design = &design;
    desk.frame(8);
    const float before = desk.where("card.slots").h;
    static const insight::CompareNumbers a{0.4f, 5.3f, 0.5f, 27.4f, 13}, b{13.1f, INFINITY, 19.5f, 112.2f, NAN};
    slots.seconds = 30, slots.slots[0].numbers = &a, slots.slots[1].numbers = &b;  // compared
    desk.frame(8);
    const Rect card = desk.where("card.slots");
    EXPECT_GT(card.h, before + 60) << "the table has its room";
    for (const Written& each : desk.written) {
        if (each.words.find("112") == std::string::npos) continue;
        EXPECT_LE(each.rect.y + each.rect.h, card.y + card.h);
    }
}

}  // namespace braitenlab::tests::cards_test
