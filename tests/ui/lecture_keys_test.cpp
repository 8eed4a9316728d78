// Keys and clicker on the pages of a lecture, and the menu that goes back to it.
#include "lecture_on_desk.h"
#include "ui/panels/actions.h"

namespace braitenlab::tests::lecture_keys_test {

using namespace ui;

namespace {

struct LectureKeys : LectureOnDesk {};

}  // namespace

TEST_F(LectureKeys, PageKeysTurnPagesOnlyWhileALectureFileIsOpen) {
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
    for (const int key : {key::page_down, key::page_up, int{'N'}}) {
        desk.all.clear();
        desk.key({key});
        ASSERT_TRUE(desk.last<NoticeRequest>()) << key;
        EXPECT_EQ(desk.last<NoticeRequest>()->key, "unavailable.no_lecture");
    }
    desk.view.lecture = false;
    desk.key({'N'});
    EXPECT_EQ(desk.actions(), std::vector{Action::new_population});
}

TEST_F(LectureKeys, AKeyOfAClickerTakesTheNumberThatIsTyped) {
    show(0, 0);
    for (const int key : {key::page_down, key::page_up}) {
        desk.panels.sliders.typed = "slider.LL";
        desk.all.clear();
        desk.key({key});
        EXPECT_EQ(desk.actions().size(), 1u);
        EXPECT_TRUE(desk.panels.sliders.commit);
    }
    desk.panels.sliders.typed = "slider.LL";
    desk.all.clear();
    desk.key({'N'});
    EXPECT_TRUE(desk.all.empty()) << "other keys belong to the number";
}

TEST_F(LectureKeys, NoDiagramIsOpenedWhileTheAudienceIsAskedAboutTheBrain) {
    desk.view.pages = nullptr;
    Revealed& revealed = desk.view.settings.revealed;
    for (const Action action : {Action::wiring, Action::watch}) {
        revealed = hidden_until_asked;
        desk.frame();
        EXPECT_EQ(why_unavailable(desk.view, desk.panels, action), "unavailable.diagram_hidden");
        desk.view.settings.watching = true;
        EXPECT_EQ(why_unavailable(desk.view, desk.panels, action), "") << "it can be closed";
        desk.view.settings.watching = false;
        revealed = revealed_after_asking;
        desk.frame();
        EXPECT_EQ(why_unavailable(desk.view, desk.panels, action), "");
    }
}

TEST_F(LectureKeys, F5AsksForTheFirstPage) {
    show(3, 1);
    desk.key({key::f5});
    EXPECT_EQ(desk.actions(), std::vector{Action::first_page});
}

TEST_F(LectureKeys, AClickerBlanksTheWindowAndTheNextKeyOnlyShowsItAgain) {
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
    EXPECT_TRUE(desk.panels.lecture.blank) << "also without pages";
    desk.view.lecture = false;
    desk.frame(2);
    EXPECT_FALSE(desk.panels.lecture.blank);
    desk.key({'B'});
    EXPECT_EQ(desk.actions(), std::vector{Action::birds_eye}) << "without a lecture";
}

TEST_F(LectureKeys, PressedKeysAreInTheBarAndThoseOfThePagesAreNotShown) {
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

TEST_F(LectureKeys, ButtonsBesideThePageNumberDoWhatAClickerDoes) {
    show(1, 0);
    for (const char* each : {"lecture.previous", "lecture.page", "lecture.next"})
        EXPECT_TRUE(is_inside(desk.where(each), desk.layout.toolbar)) << each;
    EXPECT_FALSE(overlap(desk.where("lecture.previous"), desk.where("lecture.page")));
    EXPECT_FALSE(overlap(desk.where("lecture.next"), desk.where("lecture.page")));
    EXPECT_FALSE(overlap(desk.where("lecture.next"), desk.where("lecture.leave")));
    desk.click("lecture.next");
    desk.click("lecture.previous");
    EXPECT_EQ(desk.actions(), (std::vector{Action::next_page, Action::previous_page}));
}

TEST_F(LectureKeys, AButtonRestoresTheCameraAfterItHasMoved) {
    show(1, 0);
    EXPECT_FALSE(desk.anchors.find("lecture.home"));
    desk.view.has_moved_camera = true;
    desk.frame(2);
    EXPECT_TRUE(is_inside(desk.where("lecture.home"), desk.layout.toolbar));
    EXPECT_FALSE(overlap(desk.where("lecture.home"), desk.where("lecture.previous")));
    desk.click("lecture.home");
    EXPECT_EQ(desk.actions(), std::vector{Action::home});
}

TEST_F(LectureKeys, TheMenuGoesBackToTheLectureThatWasLeft) {
    pages.page = 3;
    desk.view.lecture = false;
    desk.view.pages = nullptr;
    desk.frame(2);
    desk.click("menu.lecture");
    EXPECT_FALSE(desk.anchors.find("menu.lecture.resume"));
    desk.key({key::escape});
    desk.view.documents.left_pages = &pages;
    desk.frame(2);
    desk.choose("lecture", "resume");
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_TRUE(desk.last<OpenRequest>()->resume);
    EXPECT_EQ(desk.last<OpenRequest>()->path, pages.lecture->path.string());
}

TEST_F(LectureKeys, BetweenPagesAButtonAndTheKeysOfAClickerGoBackToThePageThatWasLeft) {
    pages.page = 3;
    EXPECT_FALSE(desk.anchors.find("lecture.back"));
    desk.view.pages = nullptr;
    desk.view.documents.left_pages = &pages;
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.frame(3);
        EXPECT_TRUE(desk.says("4")) << language;
        EXPECT_TRUE(desk.says(key_name(Action::previous_page, desk.strings))) << "the key is named";
        EXPECT_TRUE(is_inside(desk.where("lecture.back"), desk.layout.toolbar)) << language;
        EXPECT_FALSE(overlap(desk.where("lecture.back"), desk.where("lecture.leave"))) << language;
    }
    const auto is_asked = [&] {
        const auto* open = desk.last<OpenRequest>();
        const bool asked = open && open->resume && open->path == pages.lecture->path.string();
        desk.all.clear();
        return asked;
    };
    desk.click("lecture.back");
    EXPECT_TRUE(is_asked());
    for (const int key : {key::page_up, key::page_down}) {
        desk.key({key});
        EXPECT_TRUE(is_asked()) << key;
    }
    desk.view.documents.left_pages = nullptr;
    desk.key({key::page_down});
    EXPECT_FALSE(is_asked());
}

// What a key opens is in the window, and nothing is drawn over it.
TEST_F(LectureKeys, TheMapAndTheRobotsAreShownOnEveryPageAlsoBesideADiagram) {
    int diagrams = 0, questions = 0;
    for (const char* lecture : {"four-numbers", "wheels-to-neurons"}) {
        pages = opened_lecture(lecture);
        for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page)
            for (const bool map : {true, false}) {
                SCOPED_TRACE(std::string(lecture) + " " + std::to_string(page + 1) + (map ? ", map" : ", robots"));
                pages.page = page, pages.step = static_cast<int>(pages.lecture->pages[page].steps.size());
                desk.now = first_moment(pages.current());
                desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
                desk.view.settings.watching = pages.shows(PagePart::wiring);
                desk.view.settings.map = desk.view.settings.reality = false;
                ++desk.view.run_id;
                desk.frame(5);
                diagrams += desk.layout.canvas.w > 0, questions += desk.layout.question.w > 0;
                (map ? desk.view.settings.map : desk.view.settings.reality) = true;
                desk.frame(5);
                const char* card = map ? "card.map" : "card.reality";
                ASSERT_TRUE(desk.anchors.find(card));
                EXPECT_TRUE(is_inside(desk.where(card), desk.layout.window));
                EXPECT_FALSE(desk.anchors.find("canvas")) << "it has the room";
                EXPECT_FALSE(desk.anchors.find("lecture.question"));
                EXPECT_FALSE(overlap(desk.where(card), desk.where("viewport")));
            }
    }
    EXPECT_GT(diagrams, 2);
    EXPECT_GT(questions, 2);
}

TEST_F(LectureKeys, TheKeyOfTheDiagramClosesTheMapThatHasItsRoom) {
    show(1, 2);
    desk.view.settings.watching = desk.view.settings.map = true;
    desk.frame(3);
    ASSERT_EQ(desk.layout.canvas.w, 0);
    EXPECT_EQ(switched_on(desk.view, desk.panels, Action::watch), false);
    desk.key({'W', false, true});
    EXPECT_EQ(desk.actions(), std::vector{Action::map}) << "the diagram is watched already";
    desk.all.clear();
    desk.view.settings.watching = false;
    desk.frame(2);
    desk.key({'W', false, true});
    EXPECT_EQ(desk.actions(), (std::vector{Action::map, Action::watch}));
}

TEST_F(LectureKeys, AKeyOfAnImpossibleActionSaysWhy) {
    desk.view.settings.selection.vehicle = no_vehicle;
    show(1, 2);
    for (const auto& [press, why] : {std::pair{KeyPress{'M'}, "unavailable.no_vehicle"},
                                     {KeyPress{'Q'}, "unavailable.no_vehicle"},
                                     {KeyPress{'G'}, "unavailable.no_vehicle"},
                                     {KeyPress{'Y'}, "unavailable.no_vehicle"},
                                     {KeyPress{'F'}, "unavailable.no_vehicle"},
                                     {KeyPress{'Z', true}, "unavailable.undo"},
                                     {KeyPress{','}, "unavailable.earliest"},
                                     {KeyPress{'C'}, "unavailable.in_lecture"}}) {
        desk.all.clear();
        desk.key(press);
        const auto* notice = desk.last<NoticeRequest>();
        ASSERT_TRUE(notice) << why;
        EXPECT_EQ(notice->key, why);
        EXPECT_TRUE(desk.actions().empty()) << why;
    }
}

TEST_F(LectureKeys, TheKeyThatRemovesLinesSaysThatThereAreNone) {
    show(1, 0);
    desk.key({'D', false, true});
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "unavailable.no_marks");
    desk.all.clear();
    desk.panels.lecture.marks.lines.emplace_back();
    desk.key({'D', false, true});
    EXPECT_TRUE(desk.all.empty());
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty());
}

TEST_F(LectureKeys, XWalksThroughTheDiagramBesideTheScene) {
    show(1, 0);
    desk.view.pages = nullptr;
    desk.view.settings.watching = true;
    desk.frame(4);
    desk.all.clear();
    desk.key({'X'});
    EXPECT_TRUE(desk.actions().empty()) << "it is a key of the diagram";
    desk.frame(3);
    EXPECT_EQ(desk.panels.canvas.selection.nodes.size(), 1u);
    EXPECT_TRUE(desk.anchors.find("canvas.sum"));
    desk.view.settings.watching = false;
    desk.frame(2);
    desk.key({'X'});
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "unavailable.no_diagram") << "it selects no lamp";
}

TEST_F(LectureKeys, AskFirstIsAKeyOfTheLectureThatTheAudienceDoesNotSee) {
    show(1, 0);
    desk.key({'F', false, true});
    EXPECT_EQ(desk.actions(), std::vector{Action::ask_first});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("lecture.keys"));
    desk.view.settings.revealed = hidden_until_asked;
    EXPECT_EQ(switched_on(desk.view, desk.panels, Action::ask_first), true);
}

}  // namespace braitenlab::tests::lecture_keys_test
