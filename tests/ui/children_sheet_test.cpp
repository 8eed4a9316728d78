// The sheet of selection by hand (ui/panels/course/children_sheet.cpp).
#include "desk.h"

namespace braitenlab::tests::children_sheet_test {

using namespace ui;

namespace {

// An exercise that offers selection, with nine children that fell after 1, 2, … 9 s.
void open_selection(Desk& desk, int generation = 3) {
    desk.opened.offers = {"selection"};
    desk.opened.prediction = {};
    desk.opened.scene = *snapshot(0).scene;
    desk.opened.scene.arena.edge = Boundary::open;
    desk.open_exercise();
    const StartResult run{1, false, {}, {{0, 0}, {1, 1}}, 5};
    desk.lesson.selection = SelectionView{.generation = generation, .parent = run, .children = {9, run}};
    for (std::size_t i = 0; i < 9; ++i) desk.lesson.selection->children[i].seconds = static_cast<float>(i + 1);
    desk.frame(3);
}

bool is_written(const Desk& desk, const std::string& words) {
    return std::any_of(desk.written.begin(), desk.written.end(),
                       [&](const Written& each) { return each.words.find(words) != std::string::npos; });
}

TEST(ChildrenSheet, TheCardOpensItAndEachPictureChoosesItsChild) {
    Desk desk;
    open_selection(desk);
    desk.click("selection.open");
    ASSERT_TRUE(desk.anchors.find("card.children"));
    EXPECT_TRUE(is_written(desk, "Generation 3 of 12"));
    EXPECT_TRUE(is_written(desk, "fell at 7.0 s"));
    EXPECT_TRUE(is_written(desk, "green frame"));
    EXPECT_FALSE(is_written(desk, "stayed"));
    desk.lesson.selection->children[2].seconds = desk.opened.seconds;
    desk.frame(2);
    EXPECT_TRUE(is_written(desk, "stayed"));
    for (int i = 0; i < 9; ++i) {
        desk.click("selection.child." + std::to_string(i + 1));
        ASSERT_TRUE(desk.last<ChooseChildRequest>());
        EXPECT_EQ(desk.last<ChooseChildRequest>()->child, i);
    }
    desk.click("selection.parent");
    EXPECT_EQ(desk.last<ChooseChildRequest>()->child, -1);
}

TEST(ChildrenSheet, SaysWhatIsNeededAndThatNoChildStaysAsLongAsItsParent) {
    Desk desk(1280, 800, 1, true);
    open_selection(desk);
    desk.opened.needed = 8, desk.opened.starts = 10;
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    EXPECT_TRUE(is_written(desk, "from 8 of 10"));
    desk.lesson.selection->parent->seconds = 9.5f;
    desk.frame(3);
    EXPECT_TRUE(desk.says("No child stays as long as its parent"));
    desk.lesson.selection->children[4].seconds = 10;
    desk.frame(3);
    EXPECT_FALSE(desk.says("No child stays as long as its parent"));
}

TEST(ChildrenSheet, NamesTheMarkOfTheBestChildOnlyAfterAFirstChoiceOrAHint) {
    for (const std::string& language : shipped_codes())
        for (const auto& [generation, hints] : {std::pair{0, 0}, {1, 0}, {0, 1}}) {
            Desk desk(1280, 800, 1, true);
            desk.strings = speaking(language);
            open_selection(desk, generation);
            desk.lesson.attempt.answers.hints_shown = hints;
            desk.panels.sheet = Sheet::children;
            desk.frame(3);
            const std::string_view first = desk.strings("selection.how_first"), later = desk.strings("selection.how");
            const auto end_of = [](std::string_view words) {  // after the last gap
                return std::string(words.substr(words.rfind("{}") + 10, 20));
            };
            const bool is_marked = generation + hints > 0;
            EXPECT_EQ(desk.says(end_of(first)), !is_marked) << language << generation << hints;
            EXPECT_EQ(desk.says(end_of(later)), is_marked) << language << generation << hints;
        }
}

TEST(ChildrenSheet, OneOfTheBestChildrenHasTheFrame) {
    Desk desk(1280, 800, 1, true);
    open_selection(desk);
    desk.panels.sheet = Sheet::children;
    for (const std::size_t i : {1u, 4u, 6u}) desk.lesson.selection->children[i].seconds = 60;
    desk.frame(4);
    EXPECT_EQ(desk.where("selection.framed").x, desk.where("selection.child.2").x);
    EXPECT_EQ(desk.where("selection.framed").y, desk.where("selection.child.2").y);
    desk.lesson.selection->stays = {0, 1, 0, 0, 2, 0, 2, 0, 0};
    desk.frame(2);
    EXPECT_EQ(desk.where("selection.framed").x, desk.where("selection.child.5").x);
    EXPECT_EQ(desk.where("selection.framed").y, desk.where("selection.child.5").y);
}

TEST(ChildrenSheet, NothingMovesAfterAChoice) {
    for (const std::string& language : shipped_codes()) {
        SCOPED_TRACE(language);
        Desk desk(800, 600, 1, true);
        desk.strings = speaking(language);
        open_selection(desk, 0);
        desk.panels.sheet = Sheet::children;
        desk.frame(4);
        const Rect sheet = desk.where("card.children"), parent = desk.where("selection.parent");
        const auto same_places = [&](const char* when) {
            desk.frame(4);
            EXPECT_NEAR(desk.where("card.children").h, sheet.h, 1) << when;
            EXPECT_NEAR(desk.where("card.children").w, sheet.w, 1) << when;
            EXPECT_NEAR(desk.where("selection.parent").y, parent.y, 0.5f) << when;
            EXPECT_NEAR(desk.where("selection.parent").w, parent.w, 0.5f) << when;
        };
        const std::vector<StartResult> children = desk.lesson.selection->children;
        desk.lesson.selection->children.clear();
        same_places("the children run");
        desk.lesson.selection->children = children, desk.lesson.selection->generation = 1;
        same_places("the best has a frame");
        desk.lesson.selection->parent->seconds = 20;
        same_places("the parent is better");
        desk.lesson.selection->generation = 12;
        same_places("no choice is left");
    }
}

TEST(ChildrenSheet, DigitsAndArrowKeysChoose) {
    Desk desk;
    open_selection(desk);
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    desk.key({'7'});
    desk.frame(2);
    ASSERT_TRUE(desk.last<ChooseChildRequest>());
    EXPECT_EQ(desk.last<ChooseChildRequest>()->child, 6);
    for (int i = 0; i < 20 && desk.panels.keyboard.focus != "selection.child.2"; ++i)
        desk.key({key::down}), desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(desk.last<ChooseChildRequest>()->child, 1);
}

TEST(ChildrenSheet, AfterTheLastGenerationNothingCanBeChosenButTakenBack) {
    Desk desk;
    open_selection(desk, 12);
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    desk.key({'7'});
    desk.frame(2);
    desk.click("selection.child.1");
    EXPECT_FALSE(desk.last<ChooseChildRequest>());
    EXPECT_TRUE(is_written(desk, "No choice is left"));
    desk.click("selection.back");
    EXPECT_TRUE(desk.last<EarlierGenerationRequest>());
}

TEST(ChildrenSheet, WatchClosesItAndPlays) {
    Desk desk;
    open_selection(desk);
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    desk.click("selection.watch");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.children"));
    EXPECT_EQ(desk.actions(), std::vector<Action>{Action::play_pause});
}

TEST(ChildrenSheet, ItFitsIntoEachWindowAndShowsWholePictures) {
    for (const std::string& language : shipped_codes())
        for (const auto& [w, h, scale] : {std::tuple{1024.0f, 768.0f, 1.0f},
                                          {1280.0f, 800.0f, 1.0f},
                                          {1920.0f, 1200.0f, 2.0f},
                                          {800.0f, 600.0f, 1.0f},
                                          {1280.0f, 800.0f, 1.25f},
                                          {1920.0f, 1080.0f, 1.0f}}) {
            SCOPED_TRACE(language + " " + std::to_string(w) + " " + std::to_string(scale));
            Desk desk(w, h, scale, true);
            desk.strings = speaking(language);
            open_selection(desk);
            for (StartResult& run : desk.lesson.selection->children) run.seconds = 60, run.passed = true;
            desk.lesson.selection->stays.assign(9, 1);
            desk.panels.sheet = Sheet::children;
            desk.frame(4);
            const Rect sheet = desk.where("card.children");
            for (const char* anchor : {"selection.child.3", "selection.child.9", "selection.parent", "selection.close",
                                       "selection.stays.9"}) {
                const Rect r = desk.where(anchor);
                EXPECT_TRUE(r.x >= sheet.x && r.y >= sheet.y) << anchor;
                EXPECT_TRUE(r.x + r.w <= sheet.x + sheet.w - 8 * scale && r.y + r.h <= sheet.y + sheet.h) << anchor;
            }
            EXPECT_NEAR(desk.where("selection.child.9").h, desk.where("selection.child.1").h, 1) << "not cut";
            EXPECT_EQ(desk.shortened, 0);
            for (const Written& each : desk.written) {
                if (each.words.find("60") == std::string::npos || each.clip.w <= 0) continue;
                const Rect number = desk.where("selection.stays.3");
                EXPECT_FALSE(each.rect.overlaps(number)) << "dots beside the seconds";
                for (const Written& digit : desk.written)
                    EXPECT_FALSE(digit.words.size() == 1 && each.rect.overlaps(digit.rect)) << digit.words;
            }
        }
}

TEST(ChildrenSheet, ChildrenThatStayEquallyLongDifferByOtherStarts) {
    Desk desk(1280, 800, 1, true);
    open_selection(desk);
    desk.panels.sheet = Sheet::children;
    desk.frame(4);
    EXPECT_FALSE(desk.anchors.find("selection.stays.1")) << "the seconds tell them apart";
    for (StartResult& run : desk.lesson.selection->children) run.seconds = 60, run.passed = true;
    desk.lesson.selection->children[0].passed = false, desk.lesson.selection->children[0].seconds = 4;
    desk.lesson.selection->stays = {3, 1, 2, 3, 0, 1, 2, 0, 1};
    desk.frame(4);
    EXPECT_FALSE(desk.anchors.find("selection.stays.1")) << "it fell";
    for (int i = 2; i <= 9; ++i) EXPECT_TRUE(desk.anchors.find("selection.stays." + std::to_string(i))) << i;
    EXPECT_TRUE(desk.says(desk.strings("selection.dots")));
}

TEST(ChildrenSheet, ADigitBeyondTheLastChildAndBackAtTheBeginningDoNothing) {
    Desk desk;
    open_selection(desk, 0);
    desk.lesson.selection->children.resize(5);
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    desk.key({'6'});
    desk.frame(2);
    EXPECT_FALSE(desk.last<ChooseChildRequest>());
    desk.click("selection.back");
    EXPECT_FALSE(desk.last<EarlierGenerationRequest>());
}

TEST(ChildrenSheet, WatchDoesNotStopARunThatPlays) {
    Desk desk;
    open_selection(desk);
    desk.view.mode = Mode::playing;
    desk.panels.sheet = Sheet::children;
    desk.frame(3);
    desk.click("selection.watch");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.children"));
    EXPECT_TRUE(desk.actions().empty());
}

}  // namespace
}  // namespace braitenlab::tests::children_sheet_test
