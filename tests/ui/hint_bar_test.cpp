#include <algorithm>
#include <string_view>

#include "breeding_on_desk.h"
#include "desk.h"
#include "ui/panels/panels.h"

namespace braitenlab::tests::hint_bar_test {

using namespace ui;

// What the bar says of this hint while the desk's keyboard has its focus.
std::string words_with_keyboard(Desk& desk, std::string_view hint) {
    Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked, {}, 1};
    std::vector<Written> written;
    ui.written = &written;
    ui.keyboard = &desk.panels.keyboard;
    ImGui::NewFrame();
    hint_bar(desk.view, ui, desk.layout.hint_bar, hint);
    ImGui::Render();
    std::string words;
    for (const Written& w : written) words += w.words + " ";
    return words;
}

TEST(HintBar, HasADifferentIconAndColourForEachKind) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        EXPECT_NE(colour_of(NoticeKind::done, p), colour_of(NoticeKind::failure, p));
        EXPECT_NE(colour_of(NoticeKind::notice, p), colour_of(NoticeKind::failure, p));
        EXPECT_NE(colour_of(NoticeKind::done, p), colour_of(NoticeKind::notice, p));
        for (const NoticeKind kind : {NoticeKind::done, NoticeKind::notice, NoticeKind::failure})
            EXPECT_GE(contrast(colour_of(kind, p), p.panel), 4.5f);
    }
    EXPECT_NE(sign_of(NoticeKind::done), sign_of(NoticeKind::failure));
    EXPECT_NE(sign_of(NoticeKind::notice), sign_of(NoticeKind::failure));
}

TEST(HintBar, UsesTheChosenLanguage) {
    const Notice saved{NoticeKind::done, "notice.screenshot", "/tmp/a.png"};
    EXPECT_EQ(text_of(saved, english()), "Picture saved to /tmp/a.png");
    EXPECT_EQ(text_of(saved, speaking("de")), "Bildschirmfoto gespeichert: /tmp/a.png");
    EXPECT_EQ(text_of({NoticeKind::failure, "", "no {} here"}, english()), "no {} here");
}

TEST(HintBar, ShowsSecondsWithTheDecimalMarkOfTheLanguage) {
    const Notice notice{NoticeKind::done, "notice.time_back", "12.5", "", true};
    EXPECT_EQ(text_of(notice, english()), "What came after 12.5 s is there again.");
    EXPECT_EQ(text_of(notice, speaking("de")), "Was nach 12,5 s kam, ist wieder da.");
}

TEST(HintBar, EndsInAnEllipsisIfItDoesNotFit) {
    Desk desk(1280, 800, 1, true);
    desk.view.notice = {NoticeKind::failure, "", std::string(400, 'w')};
    desk.frame(2);
    const Rect bar = desk.where("hint.bar");
    bool found = false;
    for (const Written& w : desk.written) {
        if (!w.words.starts_with("www")) continue;
        found = true;
        EXPECT_LE(w.rect.x + w.rect.w, bar.x + bar.w);
        EXPECT_TRUE(w.words.ends_with("…"));
    }
    EXPECT_TRUE(found);
}

TEST(HintBar, ShowsTheWholeTextUnderThePointerIfItDoesNotFit) {
    Desk desk(1280, 800, 1, true);
    desk.view.notice = {NoticeKind::failure, "", "begin " + std::string(400, 'w') + " end"};
    desk.frame(2);
    const auto reads_end = [&] {
        for (const Written& w : desk.written)
            if (w.words.find("end") != std::string::npos && w.words.find("www") != std::string::npos) return true;
        return false;
    };
    EXPECT_FALSE(reads_end());
    desk.point("hint.bar");
    desk.frame(40);
    EXPECT_TRUE(reads_end());
}

TEST(HintBar, ListsTheKeysOfASliderThatKeysHaveReached) {
    const auto said = [](Desk& desk) {
        desk.frame(2);
        std::string all;
        for (const Written& w : desk.written) all += w.words + " ";
        return all;
    };
    Desk desk(1280, 800, 1, true);
    EXPECT_EQ(said(desk).find("types a number"), std::string::npos);
    desk.key({'1'});
    EXPECT_NE(said(desk).find("types a number"), std::string::npos);
    desk.panels.keyboard.shown = false;
    EXPECT_EQ(said(desk).find("types a number"), std::string::npos) << "the mouse is used";
}

TEST(HintBar, SaysHowToPlayWhileAPausedSliderHasTheFocus) {
    const auto says = [](Desk& desk, std::string_view words) {
        desk.frame(2);
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words.find(words) != w.words.npos; });
    };
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = desk.lesson.attempt.work.outcome_known = true;
    desk.lesson.attempt.answers.prediction = 0;
    desk.key({'1'});
    desk.view.mode = Mode::playing;
    EXPECT_TRUE(says(desk, "types a number"));
    EXPECT_FALSE(says(desk, "·  Reset"));
    desk.view.mode = Mode::paused;
    EXPECT_TRUE(says(desk, "·  Reset")) << "after Reset the run is paused";
    EXPECT_TRUE(says(desk, "types a number"));
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    desk.lesson.standing.changed_since_done = true;
    EXPECT_TRUE(says(desk, "The brain was changed")) << "more urgent than the keys";
}

TEST(HintBar, NamesNoKeyToAFinger) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1280, 800, 1, true);
        desk.strings = speaking(language);
        const std::string key = key_name(Action::play_pause, desk.strings);
        const auto has_key = [&] {
            desk.frame(3);
            const Rect bar = desk.where("hint.bar");
            return std::any_of(desk.written.begin(), desk.written.end(),
                               [&](const Written& w) { return bar.contains(w.rect.x, w.rect.y) && w.words == key; });
        };
        for (const Mode mode : {Mode::paused, Mode::playing}) {
            desk.view.mode = mode;
            desk.view.program.touch = false;
            EXPECT_TRUE(has_key()) << language;
            desk.view.program.touch = true;
            EXPECT_FALSE(has_key()) << language;
        }
    }
}

TEST(HintBar, SaysWhileTheMouseDragsASliderHowItMovesFinely) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language);
        desk.frame(3);
        const auto says = [&] {
            const Rect bar = desk.where("hint.bar");
            return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
                return bar.contains(w.rect.x, w.rect.y) && w.words == desk.strings("key.shift");
            });
        };
        EXPECT_FALSE(says()) << language;
        desk.point("slider.LL", 0.5f);
        desk.frame(2);
        desk.button(0, true);
        desk.frame(2);
        EXPECT_TRUE(says()) << language;
        desk.button(0, false);
        desk.frame(2);
        EXPECT_FALSE(says()) << language;
    }
}

TEST(HintBar, NamesNoKeyWhileATextIsTypedAndSaysWhatEnterDoesInTheNameOfAHandIn) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1280, 800, 1, true);
        desk.strings = speaking(language);
        desk.open_exercise();
        desk.frame(2);
        const auto types_in = [&](const char* field) {
            desk.panels.keyboard.focus = field;
            desk.panels.keyboard.text = TextInput::open;
            return words_with_keyboard(desk, "hint.passed");
        };
        const std::string caps = key_name(Action::press, desk.strings);
        EXPECT_EQ(types_in("exercise.note.text").find(caps), std::string::npos) << language;
        EXPECT_NE(types_in("exercise.student").find(desk.strings("exercise.student_how").substr(0, 12)),
                  std::string::npos)
            << language;
    }
}

TEST(HintBar, TellsHowFarABreedingIsWhoseSheetIsClosed) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1280, 800, 1, true);
        desk.strings = speaking(language);
        const BredOnDesk bred(3);
        desk.view.features.breeding = {.shipped = &bred.shipped, .base = bred.base, .state = &bred.state};
        desk.frame(3);
        EXPECT_FALSE(desk.anchors.find("hint.breeding")) << language;
        desk.view.features.breeding.runs = true;
        desk.frame(3);
        ASSERT_TRUE(desk.anchors.find("hint.breeding")) << language;
        const Rect bar = desk.where("hint.bar"), at = desk.where("hint.breeding");
        EXPECT_LE(at.x + at.w, bar.x + bar.w);
        desk.view.notice = {NoticeKind::done, "files.saved", std::string(300, 'a')};
        desk.frame(3);
        for (const Written& w : desk.written)
            if (bar.contains(w.rect.x, w.rect.y) && w.rect.x < at.x) {
                EXPECT_LE(w.rect.x + w.rect.w, at.x + 1) << w.words;
            }
    }
}

// The slider that pulses is the prompt's; the hint names the key that focuses this one.
TEST(HintBar, NamesTheKeyOfTheSliderThatPulses) {
    Desk desk(1280, 800, 1, true);
    desk.frame(2);  // the bar has its width
    for (const auto& [slider, key] : {std::pair{"slider.LL", "1"}, {"slider.RL", "3"}, {"curve.peak", "Ctrl+Tab"}}) {
        desk.show_hint("hint.turn_slider", slider);
        std::vector<std::string> caps;
        for (const Written& w : desk.written) caps.push_back(w.words);
        EXPECT_NE(std::find(caps.begin(), caps.end(), key), caps.end()) << slider;
    }
}

TEST(HintBar, NamesTheKeyThatEndsManualDrivingAndDriverView) {
    const auto said = [](Desk& desk) {
        desk.frame(2);
        std::string all;
        for (const Written& w : desk.written) all += w.words + " ";
        return all;
    };
    Desk desk(1280, 800, 1, true);
    EXPECT_EQ(said(desk).find("gives the wheel back"), std::string::npos);
    desk.now.vehicles[0].driver = Driver::manual;
    EXPECT_NE(said(desk).find("gives the wheel back"), std::string::npos) << "before any other hint";
    desk.view.settings.camera.mode = CameraMode::driver;
    EXPECT_NE(said(desk).find("leaves them"), std::string::npos);
    desk.now.vehicles[0].driver = Driver::brain;
    EXPECT_NE(said(desk).find("leaves them"), std::string::npos);
    EXPECT_EQ(said(desk).find("gives the wheel back"), std::string::npos);
}

}  // namespace braitenlab::tests::hint_bar_test
