// The parts of a page of a lecture file in the window: caption, question with counted hands, notes, and drawn marks.
#include <cmath>

#include "desk.h"
#include "ui/panels/cards.h"
#include "ui/widgets/drawn_text.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::lecture_page_test {

using namespace ui;

namespace {

namespace fs = std::filesystem;

const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";

LectureView opened(const std::string& name) {
    auto lecture = load_lecture(shipped / "lectures" / (name + ".toml"), shipped);
    if (!lecture) throw std::runtime_error(lecture.error().text());
    LectureView view{.lecture = std::make_shared<const Lecture>(std::move(*lecture))};
    for (const LecturePage& page : view.lecture->pages) view.hands.emplace_back(page.question.options.size(), 0);
    return view;
}

struct LecturePages : testing::Test {
    Desk desk{1024, 768, 1.4f, true};
    LectureView pages = opened("four-numbers");

    LecturePages() {
        desk.now = snapshot(0);
        desk.view.lecture = true;
        desk.view.pages = &pages;
    }
    void show(int page, int step) {
        pages.page = page, pages.step = step;
        ++desk.view.run_id;
        desk.frame(4);
    }
    bool shows(const std::string& words) const {
        for (const Written& w : desk.written)
            if (w.words.find(words) != std::string::npos) return true;
        return false;
    }
};

bool is_inside(Rect a, Rect b) {
    return a.x >= b.x - 0.5f && a.y >= b.y - 0.5f && a.x + a.w <= b.x + b.w + 0.5f && a.y + a.h <= b.y + b.h + 0.5f;
}
bool overlap(Rect a, Rect b) {
    return a.x < b.x + b.w - 0.5f && b.x < a.x + a.w - 0.5f && a.y < b.y + b.h - 0.5f && b.y < a.y + a.h - 0.5f;
}

// The strings with the words of the shipped lectures.
Strings speaking_in_lectures(const std::string& code) {
    Strings strings = speaking(code);
    const auto words = Strings::load(shipped / "words" / (code + ".toml"));
    EXPECT_TRUE(words);
    for (const char* name : {"four-numbers", "wheels-to-neurons"})
        add_translations(strings, texts_of(*opened(name).lecture), *words);
    return strings;
}

}  // namespace

TEST_F(LecturePages, CaptionAndOptionsFitIntoSmallWindowsInEveryLanguage) {
    for (const char* code : {"en", "de", "es"})
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (std::string(code) != "en") desk.strings = speaking_in_lectures(code);
            pages = opened(name);
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

TEST_F(LecturePages, TheAnswerPushesNoOptionOutOfASmallWindow) {
    for (const char* code : {"en", "de", "es"})
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (std::string(code) != "en") desk.strings = speaking_in_lectures(code);
            pages = opened(name);
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 2);
                const std::size_t options = pages.current().question.options.size();
                if (options == 0) continue;
                SCOPED_TRACE(std::string(code) + " " + name + " " + std::to_string(page + 1));
                ASSERT_TRUE(pages.shows(PagePart::answer));
                for (int& hands : pages.hands[static_cast<std::size_t>(page)]) hands = 12;
                desk.frame(2);
                const std::string last = "lecture.share." + std::to_string(options);
                ASSERT_TRUE(desk.anchors.find(last)) << "the last option is visible without scrolling";
                EXPECT_GT(desk.where(last).h, 15) << "not clipped";
            }
        }
}

// A card is not scrolled in a lecture. The pages with sliders, each as its exercise begins.
TEST_F(LecturePages, TheCardOfTheBrainIsShownWholeWithItsNamesApart) {
    pages = opened("wheels-to-neurons");
    for (const char* code : {"en", "de", "es"}) {
        desk.strings = speaking(code);
        for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
            const LecturePage& shown = pages.lecture->pages[static_cast<std::size_t>(page)];
            if (!braitenlab::shows(shown, PagePart::sliders, static_cast<int>(shown.steps.size()))) continue;
            SCOPED_TRACE(code + std::string(" ") + std::to_string(page + 1));
            const auto exercise = load_exercise(shown.file);
            ASSERT_TRUE(exercise);
            World::create(exercise->scene, 1)->capture(desk.now);
            desk.lesson.exercise = &*exercise;
            desk.lesson.verdicts.assign(exercise->steps.size(), Verdict{});
            desk.lesson.prediction = 0, desk.lesson.has_run = true;
            desk.view.lesson = &desk.lesson;
            desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
            desk.panels.card(Card::brain).folded = false;
            show(page, static_cast<int>(shown.steps.size()));
            desk.frame(20);
            int texts = 0;
            for (const Written& w : desk.written) {
                if (!overlap(w.rect, desk.where("card.brain"))) continue;
                ++texts;
                EXPECT_FALSE(w.scrolls) << w.words;
                for (const Written& other : desk.written) {
                    const bool same_line = std::fabs(other.rect.y - w.rect.y) < 1 && other.rect.x > w.rect.x;
                    EXPECT_FALSE(same_line && other.rect.x - w.rect.x - w.rect.w < 3)
                        << w.words << " touches " << other.words;
                }
            }
            EXPECT_GT(texts, 8);
        }
        desk.view.lesson = nullptr;
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

// What the lecturer points at is legible from the last row.
TEST(LecturePageType, WeightsNamesAndEquationsAreNotSmallerThanAFiftiethOfTheWindow) {
    for (const auto& [width, height] : {std::pair{1280.0f, 800.0f}, std::pair{1024.0f, 768.0f}})
        for (const char* scene : {"2a-coward", "2b-aggressor", "3a-love", "3b-explorer"}) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(width));
            Desk small{width, height, 1.4f, true};
            small.now = shipped_scene(scene);
            small.view.settings.selection.vehicle = small.now.vehicles.front().id;
            small.view.lecture = small.view.settings.watching = true;
            LectureView own = opened("four-numbers");
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

TEST_F(LecturePages, CountsHandsByButtonAndByTyping) {
    show(1, 0);
    desk.click("lecture.more.2");
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->option, 1);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 1);
    pages.hands[1] = {0, 14, 0};
    desk.frame(2);
    desk.all.clear();
    desk.click("lecture.less.2");
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 13);
    desk.all.clear();
    desk.click("lecture.hands.1");
    desk.type("23");
    desk.frame(3);
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->option, 0);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 23);
    desk.key({'2'});
    EXPECT_TRUE(desk.actions().empty()) << "digits in the field select no slider";
}

TEST_F(LecturePages, RevealsTheAnswerWithItsReasonAtItsStep) {
    show(1, 1);
    const LectureQuestion& asked = pages.current().question;
    EXPECT_FALSE(desk.anchors.find("lecture.right"));
    EXPECT_FALSE(shows(asked.why));
    pages.hands[1] = {3, 12, 1};
    show(1, 2);
    EXPECT_TRUE(desk.anchors.find("lecture.right"));
    EXPECT_TRUE(shows("✓ " + asked.options[1]));
    EXPECT_TRUE(shows(asked.why));
    EXPECT_TRUE(shows("12"));
    EXPECT_FALSE(desk.anchors.find("lecture.more.1"));
}

TEST_F(LecturePages, ShowsThePageNumberAndTheTitleOfTheLecture) {
    show(1, 0);
    EXPECT_TRUE(shows("2/9"));
    EXPECT_TRUE(shows("Four numbers"));
    EXPECT_FALSE(shows("A scene")) << "the title of the scene could tell the answer";
}

TEST_F(LecturePages, ShowsNotesAndTheTimeOnRequestOnly) {
    show(2, 0);
    EXPECT_FALSE(desk.anchors.find("lecture.notes"));
    pages.notes = true, pages.seconds = 245;
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("lecture.notes"));
    EXPECT_TRUE(shows("4:05"));
    EXPECT_TRUE(shows("7:00")) << "the planned end of page 3";
    EXPECT_TRUE(shows("Page Down shows the diagram"));
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

TEST_F(LecturePages, PressedKeysAreInTheBarAndThoseOfThePagesAreNotShown) {
    show(1, 0);
    for (const KeyPress press : {KeyPress{key::page_down}, KeyPress{'N'}, KeyPress{'D'}, KeyPress{key::f5}})
        desk.key(press);
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("lecture.keys"));
    desk.key({' '});
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("lecture.keys"));
    EXPECT_TRUE(is_inside(desk.where("lecture.keys"), desk.layout.toolbar));
    EXPECT_FALSE(overlap(desk.where("lecture.keys"), desk.where("lecture.page")));
}

TEST_F(LecturePages, AClickerBlanksTheWindowAndTheNextKeyOnlyShowsItAgain) {
    for (const int key : {'B', '.'}) {
        show(1, 0);
        desk.all.clear();
        desk.key({key});
        desk.frame(2);
        ASSERT_TRUE(desk.anchors.find("lecture.blank"));
        desk.key({key::page_down});
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("lecture.blank"));
        EXPECT_TRUE(desk.all.empty()) << "the page does not change unseen";
    }
    desk.key({'B'});
    desk.frame(2);
    desk.click("lecture.blank");
    EXPECT_FALSE(desk.anchors.find("lecture.blank"));
    desk.view.pages = nullptr;
    desk.key({'B'});
    EXPECT_TRUE(desk.panels.blank) << "also without pages";
    desk.view.lecture = false;
    desk.frame(2);
    EXPECT_FALSE(desk.panels.blank);
    desk.key({'B'});
    EXPECT_EQ(desk.actions(), std::vector{Action::birds_eye}) << "without a lecture";
}

TEST_F(LecturePages, TheKeyThatBlanksEndsTheTypingOfHands) {
    show(1, 0);
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.key({'.'});
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.blank"));
}

TEST_F(LecturePages, KeysOfSlidersShowNoHiddenBrain) {
    show(1, 0);
    desk.view.settings.revealed.brain = false;
    desk.panels.card(Card::brain).folded = true;
    desk.frame(2);
    desk.key({'1'});
    desk.frame(3);
    EXPECT_TRUE(desk.panels.card(Card::brain).folded);
    desk.panels.card(Card::brain).folded = false;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("slider.LL"));
    EXPECT_TRUE(desk.anchors.find("brain.character"));
}

TEST_F(LecturePages, TheMenuGoesBackToTheLectureThatWasLeft) {
    pages.page = 3;
    desk.view.lecture = false;
    desk.view.pages = nullptr;
    desk.frame(2);
    desk.click("menu.lecture");
    EXPECT_FALSE(desk.anchors.find("menu.lecture.resume"));
    desk.key({key::escape});
    desk.view.left_pages = &pages;
    desk.frame(2);
    desk.choose("lecture", "resume");
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_TRUE(desk.last<OpenRequest>()->resume);
    EXPECT_EQ(desk.last<OpenRequest>()->path, pages.lecture->path.string());
}

TEST_F(LecturePages, F5AsksForTheFirstPage) {
    show(3, 1);
    desk.key({key::f5});
    EXPECT_EQ(desk.actions(), std::vector{Action::first_page});
}

TEST_F(LecturePages, UnfoldsTheSlidersWhereThePageShowsThemAndFoldsThemAfterwards) {
    show(6, 0);
    EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    EXPECT_TRUE(desk.anchors.find("slider.LR"));
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("viewport")));
    show(7, 0);
    EXPECT_TRUE(desk.panels.card(Card::brain).folded);
    EXPECT_FALSE(desk.anchors.find("slider.LR"));
    desk.key({'2'});
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("slider.LR")) << "the lecturer can open them on any page";
}

TEST_F(LecturePages, TheOpenSlidersCoverNeitherTheDiagramNorTheScene) {
    show(6, 0);
    desk.view.settings.watching = true;
    desk.frame(3);
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("canvas")));
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("viewport")));
}

TEST_F(LecturePages, AllSlidersAreVisibleWithoutScrollingInEveryLanguage) {
    desk.now = shipped_scene("predator-prey");
    for (const char* code : {"en", "de", "es"}) {
        if (std::string(code) != "en") desk.strings = speaking_in_lectures(code);
        show(6, 0);
        desk.view.pages = &pages;
        pages.page = 7;
        desk.frame(2);
        desk.panels.card(Card::brain).folded = false;
        desk.frame(4);
        const Rect card = desk.where("card.brain");
        for (const char* slider : {"slider.LL", "slider.LR", "slider.RL", "slider.RR"}) {
            ASSERT_TRUE(desk.anchors.find(slider)) << slider << " " << code;
            EXPECT_TRUE(is_inside(desk.where(slider), card)) << slider << " " << code;
            EXPECT_GT(desk.where(slider).h, 20) << slider << " " << code;
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

TEST_F(LecturePages, TheSlidersTakeThePlaceOfAnAnsweredQuestion) {
    pages = opened("wheels-to-neurons");
    for (const int page : {1, 5, 6}) {
        SCOPED_TRACE(page + 1);
        show(page, 2);
        EXPECT_TRUE(desk.anchors.find("lecture.question")) << "the answer";
        show(page, 3);
        EXPECT_FALSE(desk.anchors.find("lecture.question"));
        ASSERT_FALSE(desk.panels.card(Card::brain).folded);
        EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("viewport")));
        EXPECT_GT(desk.where("viewport").w, 0.45f * desk.layout.window.w);
        for (const Shown& each : desk.shown)
            if (each.id == "brain.picture") {
                EXPECT_TRUE(is_inside(each.rect, desk.where("card.brain"))) << "whole or not at all";
            }
        desk.panels.card(Card::brain).folded = true;
        desk.frame(3);
        EXPECT_TRUE(desk.anchors.find("lecture.question")) << "the lecturer has folded the card";
    }
}

TEST_F(LecturePages, TheAnswerOfThePageTellsTheOutcomeOfItsExercise) {
    pages = opened("wheels-to-neurons");
    desk.open_exercise();
    show(5, 1);
    EXPECT_TRUE(hides_outcome(desk.view));
    show(5, 2);
    EXPECT_FALSE(hides_outcome(desk.view));
}

TEST_F(LecturePages, PageKeysTurnPagesOnlyWhileALectureFileIsOpen) {
    show(0, 0);
    desk.key({key::page_down});
    EXPECT_EQ(desk.actions(), std::vector{Action::next_page});
    desk.all.clear();
    desk.key({'N'});
    EXPECT_EQ(desk.actions(), std::vector{Action::notes});
    desk.all.clear();
    desk.view.pages = nullptr;
    desk.key({key::page_down});
    desk.key({'N'});
    EXPECT_TRUE(desk.actions().empty()) << "it would end the run that the audience sees";
    desk.view.lecture = false;
    desk.key({'N'});
    EXPECT_EQ(desk.actions(), std::vector{Action::new_population});
}

struct LectureMarks : testing::Test {
    Desk desk{1280, 800, 1, true};
    CameraView camera;

    LectureMarks() {
        desk.view.lecture = true;
        desk.frame(3);
        camera = look({}, desk.now.scene->arena, nullptr, desk.layout.window, desk.layout.scene);
        desk.view.camera_view = &camera;
        desk.frame(2);
    }
    void draw(ImVec2 from, ImVec2 to) {
        desk.point(from.x, from.y);
        desk.frame(2);
        desk.button(0, true);
        desk.frame(2);
        for (int i = 1; i <= 10; ++i) {
            const float t = static_cast<float>(i) / 10;
            desk.point(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
            desk.frame();
        }
        desk.button(0, false);
        desk.frame(2);
    }
};

TEST_F(LectureMarks, DDrawsLinesOnTheFloorUnderThePointer) {
    draw({500, 400}, {600, 450});
    EXPECT_TRUE(desk.panels.marks.lines.empty()) << "drawing is off";
    EXPECT_FALSE(desk.anchors.find("marks.sign"));
    desk.key({'D'});
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("marks.sign"));
    desk.all.clear();
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.marks.lines.size(), 1u);
    ASSERT_TRUE(desk.panels.marks.lines[0].on_floor);
    const auto& line = desk.panels.marks.lines[0].points;
    EXPECT_GE(line.size(), 10u);
    const auto first = project(camera, line.front()), last = project(camera, line.back());
    EXPECT_NEAR(first->x, 500, 1);
    EXPECT_NEAR(first->y, 400, 1);
    EXPECT_NEAR(last->x, 600, 1);
    EXPECT_NEAR(last->y, 450, 1);
    EXPECT_TRUE(desk.all.empty()) << "the mouse does nothing else";
    EXPECT_EQ(desk.panels.scene_input.drag.phase, SceneInputPhase::idle);
}

TEST_F(LectureMarks, ShiftDRemovesThemAndAnotherSceneToo) {
    desk.key({'D'});
    draw({500, 400}, {600, 450});
    draw({500, 300}, {600, 350});
    ASSERT_EQ(desk.panels.marks.lines.size(), 2u);
    desk.key({'D', false, true});
    EXPECT_TRUE(desk.panels.marks.lines.empty());
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.marks.lines.size(), 1u);
    ++desk.view.run_id;
    desk.frame();
    EXPECT_TRUE(desk.panels.marks.lines.empty());
    EXPECT_TRUE(desk.panels.marks.drawing) << "drawing stays on";
}

TEST_F(LectureMarks, EscapeEndsDrawingAndTheEndOfTheLectureToo) {
    desk.key({'D'});
    desk.all.clear();
    desk.key({key::escape});
    EXPECT_FALSE(desk.panels.marks.drawing);
    EXPECT_TRUE(desk.all.empty()) << "the lecture goes on";
    desk.key({'D'});
    draw({500, 400}, {600, 450});
    desk.view.lecture = false;
    desk.frame(2);
    EXPECT_FALSE(desk.panels.marks.drawing);
    EXPECT_TRUE(desk.panels.marks.lines.empty());
    desk.key({'D'});
    EXPECT_FALSE(desk.panels.marks.drawing) << "outside a lecture D has another meaning";
}

TEST_F(LecturePages, ACountThatIsTypedCanBeSmallerAndPageKeysEndTyping) {
    show(1, 0);
    pages.hands[1] = {30, 0, 0};
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.type("7");
    desk.frame(3);
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 7);
    ASSERT_TRUE(desk.panels.hands[0].active);
    desk.key({key::page_down});
    EXPECT_EQ(desk.actions(), std::vector{Action::next_page});
    EXPECT_TRUE(desk.panels.keyboard.focus.empty());
    desk.frame(2);
    EXPECT_FALSE(desk.panels.hands[0].active);
}

TEST_F(LecturePages, TheBarOfAnOptionHasTheShareOfAllHands) {
    show(1, 0);
    pages.hands[1] = {3, 12, 1};
    desk.frame(3);
    const Rect bar = desk.where("lecture.share.2");
    float from = 1e9f, to = 0;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l)
        for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer)
            if (bar.contains(v.pos.x, v.pos.y) && v.col == paint(palette(desk.view.theme).accent))
                from = std::min(from, v.pos.x), to = std::max(to, v.pos.x);
    EXPECT_NEAR((to - from) / bar.w, 12.0f / 16, 0.02f);
}

TEST_F(LectureMarks, DDrawsOverTheDiagramAndTheLinesScaleWithTheWindow) {
    desk.now = shipped_scene("2a-coward");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    desk.view.settings.watching = true;
    desk.frame(3);
    const Rect canvas = desk.where("canvas"), label = desk.where("wire.LL");
    desk.key({'D'});
    desk.frame(2);
    desk.all.clear();
    const ImVec2 from{label.x + label.w / 2, label.y + label.h / 2};
    draw(from, {from.x + 40, from.y + 60});
    ASSERT_EQ(desk.panels.marks.lines.size(), 1u);
    EXPECT_TRUE(canvas.contains(from.x, from.y));
    EXPECT_FALSE(desk.panels.marks.lines[0].on_floor);
    EXPECT_TRUE(desk.edits().empty()) << "the weight under the pen is not dragged";
    const maths::vec2 first = desk.panels.marks.lines[0].points.front();
    EXPECT_NEAR(first.x, from.x / 1280, 2e-3);
    EXPECT_NEAR(first.y, from.y / 800, 2e-3);
    ImGui::GetIO().DisplaySize = {640, 400};
    desk.frame(2);
    bool is_drawn = false;
    const ImDrawList& top = *ImGui::GetForegroundDrawList();
    for (const ImDrawVert& v : top.VtxBuffer)
        is_drawn |= std::abs(v.pos.x - from.x / 2) < 8 && std::abs(v.pos.y - from.y / 2) < 8;
    EXPECT_TRUE(is_drawn) << "at half the place in a window of half the size";
}

TEST_F(LectureMarks, ALineThatLeavesTheSceneGoesOnInTheWindow) {
    desk.key({'D'});
    desk.frame(2);
    const Rect scene = desk.layout.scene;
    draw({scene.x + scene.w / 2, scene.y + scene.h - 40}, {scene.x + scene.w / 2, scene.y + scene.h + 30});
    ASSERT_EQ(desk.panels.marks.lines.size(), 2u);
    EXPECT_TRUE(desk.panels.marks.lines[0].on_floor);
    EXPECT_FALSE(desk.panels.marks.lines[1].on_floor);
}

TEST_F(LectureMarks, TheBarCanBeClickedWhileTheMouseDraws) {
    desk.key({'D'});
    desk.frame(2);
    desk.click("button.play");
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
    EXPECT_TRUE(desk.panels.marks.lines.empty());
}

TEST_F(LectureMarks, DDrawsInTheWiringView) {
    desk.view.mode = Mode::wiring;
    desk.frame(2);
    desk.key({'D'});
    desk.frame(2);
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.marks.lines.size(), 1u);
    EXPECT_FALSE(desk.panels.marks.lines[0].on_floor);
}

}  // namespace braitenlab::tests::lecture_page_test
