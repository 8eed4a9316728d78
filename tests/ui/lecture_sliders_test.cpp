// The card of the brain on a page of a lecture.
#include <cmath>

#include "core/lesson/exercise_file.h"
#include "lecture_on_desk.h"

namespace braitenlab::tests::lecture_sliders_test {

using namespace ui;

namespace {

struct LectureSliders : LectureOnDesk {};

}  // namespace

// A card is not scrolled in a lecture. The pages with sliders, each as its exercise begins.
TEST_F(LectureSliders, TheCardOfTheBrainIsShownWholeWithItsNamesApart) {
    pages = opened_lecture("wheels-to-neurons");
    for (const std::string& code : shipped_codes()) {
        desk.strings = speaking(code);
        for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
            const LecturePage& shown = pages.lecture->pages[static_cast<std::size_t>(page)];
            if (!braitenlab::shows(shown, PagePart::sliders, static_cast<int>(shown.steps.size()))) continue;
            SCOPED_TRACE(code + " " + std::to_string(page + 1));
            const auto exercise = load_exercise(shown.file);
            ASSERT_TRUE(exercise);
            World::create(exercise->scene, 1)->capture(desk.now);
            desk.lesson.exercise = &*exercise;
            desk.lesson.verdicts.assign(exercise->steps.size(), Verdict{});
            desk.lesson.attempt.answers.prediction = 0, desk.lesson.attempt.work.has_run = true;
            desk.show_lesson();
            desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
            desk.panels.card(Card::brain).folded = false;
            show(page, static_cast<int>(shown.steps.size()));
            desk.frame(20);
            int texts = 0;
            for (const Written& w : desk.written) {
                if (!overlap(w.rect, desk.where("card.brain"))) continue;
                ++texts;
                EXPECT_FALSE(w.scrolls) << w.words;
                EXPECT_LE(w.rect.y + w.rect.h, w.clip.y + w.clip.h) << w.words << " is cut below";
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

TEST_F(LectureSliders, TheButtonsOfTheCardAreShownOnRequestOnly) {
    desk.now = shipped_scene("2b-aggressor");
    show(6, 0);
    desk.frame(3);
    const std::vector<std::string> buttons{"button.presets", "button.drive", "button.mirror", "button.cross",
                                           "button.thresholds"};
    for (const std::string& button : buttons) EXPECT_FALSE(desk.anchors.find(button)) << button;
    EXPECT_TRUE(desk.anchors.find("slider.LR"));
    EXPECT_TRUE(desk.anchors.find("equations"));
    desk.click("button.controls");
    desk.frame(3);
    for (const std::string& button : buttons) EXPECT_TRUE(desk.anchors.find(button)) << button;
    desk.view.lecture = false, desk.view.pages = nullptr;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("button.controls"));
    EXPECT_TRUE(desk.anchors.find("button.presets"));
    desk.view.lecture = true, desk.view.pages = &pages;
    show(6, 0);
    EXPECT_FALSE(desk.anchors.find("button.presets")) << "the next lecture begins without them";
}

TEST_F(LectureSliders, UnfoldsTheSlidersWhereThePageShowsThemAndFoldsThemAfterwards) {
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

TEST_F(LectureSliders, TheOpenSlidersCoverNeitherTheDiagramNorTheScene) {
    show(6, 0);
    desk.view.settings.watching = true;
    desk.frame(3);
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("canvas")));
    EXPECT_FALSE(overlap(desk.where("card.brain"), desk.where("viewport")));
}

TEST_F(LectureSliders, TheSlidersTakeThePlaceOfAnAnsweredQuestion) {
    pages = opened_lecture("wheels-to-neurons");
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

TEST_F(LectureSliders, AllSlidersAreVisibleWithoutScrollingInEveryLanguage) {
    desk.now = shipped_scene("predator-prey");
    for (const std::string& code : shipped_codes()) {
        if (code != "en") desk.strings = speaking_in_lectures(code);
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

TEST_F(LectureSliders, ADigitChoosesASliderAndTellsThatItsNumberIsTypedAfterEnter) {
    show(6, 0);
    desk.view.pages = nullptr;
    desk.frame(2);
    for (const auto& [digit, slider, typed] : {std::tuple{'1', "slider.LL", "1.5"}, {'3', "slider.RL", "0"}}) {
        desk.all.clear();
        desk.key({digit});
        ASSERT_TRUE(desk.last<NoticeRequest>()) << slider;
        EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.slider_chosen");
        desk.frame(3);
        EXPECT_EQ(desk.panels.keyboard.focus, slider);
        desk.key({key::enter});
        desk.frame(2);
        EXPECT_EQ(desk.panels.sliders.typed, slider);
        desk.type(typed);
        desk.key({key::enter});
        desk.frame(2);
        EXPECT_TRUE(desk.panels.sliders.typed.empty()) << "Enter closes it";
    }
    desk.view.lecture = false;
    desk.frame(2);
    desk.all.clear();
    desk.key({'1'});
    EXPECT_FALSE(desk.last<NoticeRequest>()) << "the hints say it";
}

TEST_F(LectureSliders, KeysOfSlidersShowNoHiddenBrain) {
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

}  // namespace braitenlab::tests::lecture_sliders_test
