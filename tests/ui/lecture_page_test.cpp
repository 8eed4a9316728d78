// The parts of a page of a lecture file in the window: caption, diagram, notes, notice and type.
#include <utility>

#include "lecture_on_desk.h"
#include "ui/widgets/drawn_text.h"

namespace braitenlab::tests::lecture_page_test {

using namespace ui;

namespace {

struct LecturePages : LectureOnDesk {};

}  // namespace

TEST_F(LecturePages, CaptionAndOptionsFitIntoSmallWindowsInEveryLanguage) {
    for (const char* code : {"en", "de", "es"})
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (std::string(code) != "en") desk.strings = speaking_in_lectures(code);
            pages = opened_lecture(name);
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 0);
                SCOPED_TRACE(std::string(code) + " " + name + " " + std::to_string(page + 1));
                const Rect caption = desk.where("lecture.caption"), window = desk.layout.window;
                EXPECT_TRUE(is_inside(caption, window));
                int lines = 0;
                for (const Written& w : desk.written)
                    if (is_inside(w.rect, caption)) ++lines;
                EXPECT_TRUE(lines == 1 || lines == 2) << lines;
                EXPECT_FALSE(overlap(caption, desk.where("viewport")));
                const std::size_t options = pages.current().question.options.size();
                if (options == 0) continue;
                EXPECT_FALSE(overlap(desk.where("lecture.question"), desk.where("viewport")));
                const std::string last = "lecture.share." + std::to_string(options);
                ASSERT_TRUE(desk.anchors.find(last)) << "the last option is visible without scrolling";
                EXPECT_GT(desk.where(last).h, 15) << "not clipped";
            }
        }
}

TEST_F(LecturePages, ACaptionThatFitsIntoOneLineOfSmallerTypeHasOneLine) {
    desk.strings = speaking_in_lectures("de");
    int lines_of_all = 0;
    for (int page = 0; page < 9; ++page) {
        show(page, 0);
        for (const Written& w : desk.written) lines_of_all += is_inside(w.rect, desk.where("lecture.caption"));
    }
    EXPECT_LE(lines_of_all, 11);
}

// What the lecturer points at is legible from the last row.
TEST(LecturePageType, WeightsNamesAndEquationsAreNotSmallerThanAFiftiethOfTheWindow) {
    for (const auto& [width, height] : {std::pair{1280.0f, 800.0f}, std::pair{1024.0f, 768.0f}})
        for (const char* scene : {"2a-coward", "2b-aggressor", "3a-love", "3b-explorer"}) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(width));
            Desk small{width, height, 1.4f, true};
            small.now = shipped_scene(scene);
            small.view.settings.selection.vehicle = small.now.vehicles.front().id;
            small.view.lecture = small.view.settings.watching = true;
            LectureView own = opened_lecture("four-numbers");
            own.page = 2, own.step = 2;
            small.view.pages = &own;
            small.frame(4);
            const float least = 0.022f * height;
            for (const char* anchor : {"name.SL", "name.SR", "name.ML", "name.MR", "weight.LL", "weight.LR"})
                EXPECT_GE(small.where(anchor).h, least - 0.5f) << anchor;
            small.view.settings.watching = false;
            small.panels.card(Card::brain).folded = false;
            small.frame(3);
            for (const Written& w : small.written) EXPECT_GE(w.rect.h, least - 0.5f) << w.words;
        }
}

TEST_F(LecturePages, NotesLeaveTheOptionsOfTheQuestionInSightAndScroll) {
    for (const char* code : {"en", "de", "es"})
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (std::string(code) != "en") desk.strings = speaking_in_lectures(code);
            pages = opened_lecture(name);
            pages.notes = true;
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 0);
                SCOPED_TRACE(std::string(code) + " " + name + " " + std::to_string(page + 1));
                const std::size_t options = pages.current().question.options.size();
                const Rect notes = desk.where("lecture.notes");
                EXPECT_TRUE(is_inside(notes, desk.layout.window));
                EXPECT_GT(notes.h, 90) << "three lines";
                for (std::size_t i = 1; i <= options; ++i) {
                    const Rect bar = desk.where("lecture.share." + std::to_string(i));
                    EXPECT_GT(bar.h, 15) << "not clipped";
                    EXPECT_LE(bar.y + bar.h, notes.y) << i;
                }
            }
        }
}

TEST_F(LecturePages, TheDiagramTakesThePlaceOfAnAnsweredQuestion) {
    desk.now = shipped_scene("2b-aggressor");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    show(3, 2);
    EXPECT_TRUE(desk.anchors.find("lecture.question"));
    desk.view.settings.watching = true;
    show(3, 3);
    EXPECT_FALSE(desk.anchors.find("lecture.question"));
    EXPECT_FALSE(overlap(desk.where("canvas"), desk.where("viewport")));
    for (const char* node : {"name.SL", "name.SR", "name.ML", "name.MR"})
        EXPECT_TRUE(is_inside(desk.where(node), desk.where("canvas"))) << node;
    desk.view.settings.watching = false;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.question")) << "the lecturer has hidden the diagram";
}

TEST_F(LecturePages, ShowsThePageNumberAndTheTitleOfTheLecture) {
    show(1, 0);
    EXPECT_TRUE(desk.says("2/9"));
    EXPECT_TRUE(desk.says("Four numbers"));
    EXPECT_FALSE(desk.says("A scene")) << "the title of the scene could tell the answer";
}

TEST_F(LecturePages, ShowsNotesAndTheTimeOnRequestOnly) {
    show(2, 0);
    EXPECT_FALSE(desk.anchors.find("lecture.notes"));
    pages.notes = true, pages.seconds = 245;
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("lecture.notes"));
    EXPECT_TRUE(desk.says("4:05"));
    EXPECT_TRUE(desk.says("7:00")) << "the planned end of page 3";
    EXPECT_TRUE(desk.says("Page Down shows the diagram"));
    for (int page = 0; page < 9; ++page) {
        show(page, 0);
        const Rect notes = desk.where("lecture.notes");
        EXPECT_TRUE(is_inside(notes, desk.layout.window));
        EXPECT_FALSE(overlap(notes, desk.where("viewport"))) << "they cover nothing";
        if (desk.anchors.find("lecture.question")) {
            EXPECT_FALSE(overlap(notes, desk.where("lecture.question")));
        }
        for (const Written& w : desk.written) {
            if (!overlap(w.rect, notes) || !is_visible(w)) continue;
            EXPECT_TRUE(is_inside(w.rect, notes)) << w.words;
        }
    }
}

TEST_F(LecturePages, NotesTakeThePlaceOfTheValues) {
    show(2, 2);
    ASSERT_TRUE(desk.anchors.find("lecture.left"));
    const float before = desk.where("viewport").h;
    pages.notes = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("lecture.left"));
    EXPECT_GT(desk.where("viewport").h, 0.6f * before) << "the scene keeps most of its height";
    pages.notes = false;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.left"));
}

TEST_F(LecturePages, ANoticeIsInTheBarAndCoversNothing) {
    show(2, 2);
    ASSERT_TRUE(desk.anchors.find("lecture.left"));
    desk.view.notice = {NoticeKind::failure, "",
                        std::string(30, 'a') + std::string(" and more words to read") +
                            " in this long notice that takes two lines of the bar"};
    desk.frame(2);
    EXPECT_TRUE(is_inside(desk.where("hint.bar"), desk.layout.toolbar));
    EXPECT_TRUE(desk.anchors.find("lecture.left")) << "the values stay";
    int lines = 0;
    for (const Written& w : desk.written)
        if (is_inside(w.rect, desk.where("hint.bar"))) ++lines;
    EXPECT_EQ(lines, 2);
}

}  // namespace braitenlab::tests::lecture_page_test
