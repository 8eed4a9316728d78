#include "ui/widgets/slider.h"

#include <set>

#include "desk.h"
#include "ui/double_click.h"

namespace braitenlab::tests::slider_test {

using namespace ui;

TEST(Slider, DraggingRequestsTheValueInEveryChangedFrameInOneGesture) {
    Desk desk;
    desk.frame(3);
    const Rect r = desk.where("slider.LL");
    // LL is 0: its knob is in the middle of the track, which lies between the letters and the number.
    const float zero = r.x + 26 + 8 + (r.w - 26 - 46 - 16) / 2;
    desk.point(zero, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty()) << "pressing the knob must not move it";
    for (int i = 1; i <= 10; ++i) {
        desk.point(zero + 3.0f * static_cast<float>(i), r.y + r.h / 2);
        desk.frame();
    }
    desk.button(0, false);
    desk.frame(2);

    const auto edits = desk.edits();
    ASSERT_GE(edits.size(), 8u);
    std::set<std::uint64_t> gestures;
    float last = 0;
    for (const EditRequest& edit : edits) {
        gestures.insert(edit.gesture);
        EXPECT_EQ(turned(edit).dial, Dial::LL);
        EXPECT_GT(turned(edit).value, last);
        last = turned(edit).value;
    }
    EXPECT_EQ(gestures.size(), 1u);
    EXPECT_NE(*gestures.begin(), 0u);
    EXPECT_NEAR(last, 30 / ((r.w - 26 - 46 - 16) / 4), 0.06f);
}

TEST(Slider, SnapsToZero) {
    Desk desk;
    desk.frame(2);
    const Rect r = desk.where("slider.LR");
    desk.point("slider.LR", 0.6f);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    int zeros = 0;
    for (float x = r.x + r.w * 0.6f; x > r.x + r.w * 0.2f; x -= 1) {
        desk.point(x, r.y + r.h / 2);
        desk.frame();
        zeros += !desk.edits().empty() && turned(desk.edits().back()).value == 0;
    }
    EXPECT_GE(zeros, 5) << "zero covers several pixels of the track";
    EXPECT_LE(zeros, 8);
    desk.button(0, false);
}

TEST(Slider, TwoDragsAreTwoGestures) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LL", 0, 0.3f);
    desk.rest();
    desk.click("slider.LL", 0, 0.6f);
    const auto edits = desk.edits();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_NE(edits[0].gesture, edits[1].gesture);
}

TEST(Slider, ChangesTheKindOrTheVehicleByTheScope) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.RR", 0, 0.3f);
    desk.view.settings.selection.whole_kind = false;
    desk.rest();
    desk.click("slider.RR", 0, 0.6f);
    const auto edits = desk.edits();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(turned(edits[0]).target.vehicle, no_vehicle);
    EXPECT_EQ(turned(edits[0]).target.kind, 0);
    EXPECT_EQ(turned(edits[1]).target.vehicle, 0);
}

TEST(Slider, RightClickRestoresTheValueOfTheFile) {
    Desk desk;
    const auto file = desk.now.scene;  // where LR is 1.5
    desk.view.file = file.get();
    BrainGraph edited = *desk.now.brains[0];
    turn(edited, Dial::LR, -0.6f);
    desk.now.brains[0] = std::make_shared<BrainGraph>(edited);
    desk.frame(3);
    desk.click("slider.LR", 1);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_FLOAT_EQ(turned(desk.edits()[0]).value, 1.5f);
    desk.all.clear();
    desk.key({'2'});
    desk.key({key::del});  // the same without a mouse
    desk.frame();
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_FLOAT_EQ(turned(desk.edits()[0]).value, 1.5f);
}

TEST(Slider, DelActsOnItOnlyWhileItShowsTheRing) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LR");
    ASSERT_EQ(desk.panels.keyboard.focus, "slider.LR");
    desk.all.clear();
    desk.key({key::del});
    desk.frame();
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_EQ(desk.actions(), std::vector<Action>{Action::erase}) << "the mouse has used the slider: no ring";
    desk.all.clear();
    desk.key({'2'});
    desk.key({key::del});
    desk.frame();
    EXPECT_EQ(desk.actions(), std::vector<Action>{});
    const bool tells = std::any_of(desk.all.begin(), desk.all.end(), [](const Request& request) {
        const auto* notice = std::get_if<NoticeRequest>(&request);
        return notice && notice->key == "notice.restored";
    });
    EXPECT_TRUE(tells) << "that the vehicle stays, and how it is deleted";
}

TEST(Slider, RightClickSetsZeroWithoutAFile) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LR", 1);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(turned(desk.edits()[0]).dial, Dial::LR);
    EXPECT_EQ(turned(desk.edits()[0]).value, 0);
}

class SliderWithTypedNumber : public ::testing::TestWithParam<std::pair<const char*, float>> {};

TEST_P(SliderWithTypedNumber, ClampsToTheRange) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LL", 0, 0.95f);  // on the number
    ASSERT_EQ(desk.panels.sliders.typed, "slider.LL");
    desk.type(GetParam().first);
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_FLOAT_EQ(turned(desk.edits()[0]).value, GetParam().second);
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
}

TEST(Slider, TabTakesTheTypedNumberAndGoesToTheNextSlider) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LL", 0, 0.95f);
    desk.type("0.75");
    desk.frame(2);
    desk.key({key::tab});
    desk.frame(3);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_FLOAT_EQ(turned(desk.edits()[0]).value, 0.75f);
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR");
}

INSTANTIATE_TEST_SUITE_P(Numbers, SliderWithTypedNumber,
                         ::testing::Values(std::pair{"0.75", 0.75f}, std::pair{"9", 2.0f}, std::pair{"-7.5", -2.0f},
                                           std::pair{"0,5", 0.5f}));

class SliderWithInvalidText : public ::testing::TestWithParam<const char*> {};

TEST_P(SliderWithInvalidText, KeepsItsValue) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LR", 0, 0.95f);
    desk.type(GetParam());
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
}

INSTANTIATE_TEST_SUITE_P(Words, SliderWithInvalidText, ::testing::Values("-", "1.2.3", "+-", "nan", "inf"));

TEST(Slider, KeepsATypedNumberBetweenTwoStepsAndShowsIt) {
    Desk desk;
    desk.frame(3);
    desk.type_into("slider.LL", "0.0045");
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_FLOAT_EQ(turned(desk.edits()[0]).value, 0.0045f);
    BrainGraph brain = *desk.now.brains[0];
    turn(brain, Dial::LL, 0.0045f);
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.frame(2);
    const auto shows = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& text) { return text.words == words; });
    };
    EXPECT_TRUE(shows("+0.0045"));
    desk.rest();
    desk.type_into("slider.LL", "0.0046");
    EXPECT_FLOAT_EQ(turned(desk.edits().back()).value, 0.0046f) << "also a small change";
}

TEST(Slider, DoesNotRoundAComputedNumberThatIsOpenedAndLeft) {
    Desk desk;
    BrainGraph brain = *desk.now.brains[0];
    turn(brain, Dial::LL, 0.4378219f);
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.frame(3);
    desk.click("slider.LL", 0, 0.97f);
    EXPECT_STREQ(desk.panels.sliders.text, "0.44");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_TRUE(desk.panels.sliders.typed.empty());
    EXPECT_TRUE(desk.edits().empty());
}

TEST(Slider, RestoresAValueOfTheFileBetweenTwoSteps) {
    Desk desk;
    Scene filed = *desk.now.scene;
    turn(filed.kinds[0].brain, Dial::LR, 0.125f);
    desk.view.file = &filed;
    desk.frame(3);
    desk.click("slider.LR", 1);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(turned(desk.edits()[0]).value, 0.125f);
}

TEST(Slider, APressBesideAnOpenNumberReachesTheWidgetUnderThePointer) {
    for (const char* other : {"slider.LR", "slider.LL", "button.play"}) {  // drawn after, in the same row, and before
        Desk desk;
        desk.frame(3);
        desk.click("slider.RL", 0, 0.97f);
        ASSERT_EQ(desk.panels.sliders.typed, "slider.RL");
        desk.type("0.7");
        desk.frame(2);
        desk.all.clear();
        desk.point(other, 0.6f);
        desk.frame(2);
        desk.button(0, true);
        desk.frame();
        desk.button(0, false);
        desk.frame(3);
        bool takes_number = false, takes_press = !desk.actions().empty();
        for (const EditRequest& edit : desk.edits()) {
            takes_number |= turned(edit).dial == Dial::RL && turned(edit).value == 0.7f;
            takes_press |= turned(edit).dial != Dial::RL;
        }
        EXPECT_TRUE(takes_number) << other;
        EXPECT_TRUE(takes_press) << other;
    }
}

TEST(Slider, SaysWhyATypedTextIsRefused) {
    Desk desk;
    desk.view.settings.values = desk.panels.values.kinds = desk.panels.values.body_open = true;
    desk.panels.card(Card::scene).folded = true;
    desk.frame(3);
    desk.type_into("body.top_speed", "35 kg");
    EXPECT_TRUE(desk.edits().empty());
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.no_number_in");
    EXPECT_EQ(desk.last<NoticeRequest>()->words, "35 kg");
    EXPECT_EQ(desk.last<NoticeRequest>()->more, "m/s");
    desk.rest();
    desk.type_into("body.top_speed", "35 cm/s");
    ASSERT_FALSE(desk.edits().empty());
    EXPECT_FLOAT_EQ(std::get<EditKind>(desk.edits().back().command).to.body.top_speed, 0.35f);
    desk.rest();
    desk.all.clear();
    desk.type_into("slider.LL", "fast");
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.no_number");
}

TEST(Slider, SaysThatATypedNumberIsLimitedToTheRange) {
    Desk desk;
    const auto limits_shown = [&](const char* number) {
        desk.all.clear();
        desk.type_into("slider.LL", number);
        std::vector<std::string> found;
        for (const Request& request : desk.all)
            if (const auto* notice = std::get_if<NoticeRequest>(&request)) found = {notice->words, notice->more};
        return found;
    };
    desk.frame(3);
    EXPECT_EQ(limits_shown("7"), (std::vector<std::string>{"−2.00", "+2.00"}));
    EXPECT_EQ(turned(desk.edits().back()).value, 2);
    EXPECT_TRUE(limits_shown("1.5").empty());
    EXPECT_TRUE(limits_shown("2").empty());
    desk.point("slider.LL", 0.5f);
    desk.frame(60);
    EXPECT_TRUE(std::any_of(desk.written.begin(), desk.written.end(), [](const Written& text) {
        return text.words.find("−2.00 to +2.00") != std::string::npos;
    })) << "in the tooltip";
}

TEST(Slider, DoubleClickOnTheTrackOpensTheNumberAndKeepsTheValue) {
    Desk desk;
    desk.frame(3);
    const auto press = [&] {
        desk.button(0, true);
        desk.frame();
        // Applies the edit between two frames, as the app does.
        for (const EditRequest& edit : desk.edits()) {
            BrainGraph brain = *desk.now.brains[0];
            turn(brain, turned(edit).dial, turned(edit).value);
            desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
        }
        desk.button(0, false);
        desk.frame();
    };
    desk.point("slider.LL", 0.6f);
    desk.frame(2);
    press();
    EXPECT_NE(read_dials(*desk.now.brains[0]).LL, 0) << "a click on the track moves the knob";
    press();
    EXPECT_EQ(desk.panels.sliders.typed, "slider.LL");
    EXPECT_STREQ(desk.panels.sliders.text, "0.00");
    const auto edits = desk.edits();
    EXPECT_EQ(turned(edits.back()).value, 0);
    EXPECT_EQ(edits.back().gesture, edits.front().gesture) << "one step, which ends at the first value";
}

TEST(Slider, ASlowDoubleClickAnywhereOnTheRowOpensTheNumber) {
    for (const float share : {0.3f, 0.6f, 0.97f}) {
        Desk desk;
        desk.frame(3);
        desk.point("slider.LL", share);
        desk.frame(2);
        for (const int pause : {24, 3}) {
            desk.button(0, true);
            desk.frame(2);
            desk.button(0, false);
            desk.frame(pause);
        }
        EXPECT_EQ(desk.panels.sliders.typed, "slider.LL") << share;
        EXPECT_EQ(desk.panels.keyboard.text, TextInput::open) << share;
    }
}

TEST(Slider, TheBiasesHaveRowsOfTheirOwn) {
    Desk desk;
    desk.panels.brain.thresholds_open = true;
    desk.frame(3);
    EXPECT_LT(desk.where("bias.LM").y, desk.where("bias.RM").y);
    EXPECT_GT(desk.where("bias.LM").w, desk.where("slider.LL").w);
}

TEST(DoubleClick, ItsPressesAreHalfASecondApartAtMost) {
    DoubleClick clicks;
    EXPECT_FALSE(clicks.press(1, 10, 10));
    EXPECT_TRUE(clicks.press(1.4, 14, 10));
    EXPECT_FALSE(clicks.press(1.6, 14, 10)) << "the third press begins another one";
    EXPECT_TRUE(clicks.press(1.7, 14, 10));
    EXPECT_FALSE(clicks.press(2, 10, 10));
    EXPECT_FALSE(clicks.press(2.6, 10, 10)) << "too slow";
    EXPECT_FALSE(clicks.press(2.7, 40, 10)) << "elsewhere";
}

TEST(Slider, EscapeKeepsTheNumber) {
    Desk desk;
    desk.panels.brain.thresholds_open = true;
    desk.frame(3);
    desk.click("threshold.RL", 0, 0.95f);
    ASSERT_EQ(desk.panels.sliders.typed, "threshold.RL");
    desk.type("0.9");
    desk.frame(2);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty());
    EXPECT_TRUE(desk.actions().empty()) << "Esc must not reach the lab while a number is typed";
}

TEST(Slider, TypingEndsWhereTheSliderIsGone) {
    for (const bool folds : {false, true}) {
        Desk desk;
        desk.frame(3);
        desk.click("slider.LL", 0, 0.95f);
        ASSERT_EQ(desk.panels.sliders.typed, "slider.LL");
        if (folds)
            desk.panels.card(Card::brain).folded = true;
        else
            desk.view.settings.selection = {};  // as after the death of the vehicle
        desk.frame(4);
        ASSERT_FALSE(desk.anchors.find("slider.LL"));
        desk.key({'='});
        EXPECT_EQ(desk.actions(), std::vector{Action::faster});
    }
}

TEST(Slider, ADragEndsWhereTheSliderIsGone) {
    Desk desk;
    desk.frame(3);
    desk.point("slider.LL", 0.5f);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    ASSERT_EQ(desk.panels.sliders.dragged, "slider.LL");
    desk.view.settings.selection = {};
    desk.frame(2);
    desk.button(0, false);
    desk.frame(4);
    EXPECT_EQ(desk.panels.sliders.dragged, "");
}

TEST(Slider, BlocksShortcutsWhileANumberIsTyped) {
    Desk desk;
    desk.frame(3);
    desk.click("slider.LL", 0, 0.95f);
    for (const int pressed : {int{' '}, int{'.'}, int{'-'}, int{'N'}, key::tab}) desk.key({pressed});
    desk.frame(2);
    EXPECT_TRUE(desk.actions().empty());
}

TEST(Slider, KeysChangeTheFocusedSliderByATwentiethAndWithShiftByAHundredth) {
    Desk desk;
    desk.frame(3);
    desk.key({'3'});
    desk.key({key::right});
    desk.frame();
    desk.key({key::left, false, true});
    desk.frame();
    const auto edits = desk.edits();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(turned(edits[0]).dial, Dial::RL);
    EXPECT_FLOAT_EQ(turned(edits[0]).value, 1.55f);
    EXPECT_FLOAT_EQ(turned(edits[1]).value, 1.49f);
    EXPECT_EQ(edits[0].gesture, edits[1].gesture) << "quick presses are one step of undo";
}

TEST(Slider, TellsForASecondThatKeysHaveChangedIt) {
    Desk desk;
    desk.frame(3);
    EXPECT_EQ(gesture_by_keys(desk.panels.sliders, desk.view.wall_seconds), 0u);
    desk.key({'3'});
    desk.key({key::right});
    desk.frame();
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_EQ(gesture_by_keys(desk.panels.sliders, desk.view.wall_seconds), desk.edits()[0].gesture);
    desk.frame(70);
    EXPECT_EQ(gesture_by_keys(desk.panels.sliders, desk.view.wall_seconds), 0u);
    desk.type_into("slider.LL", "1.2");
    EXPECT_EQ(gesture_by_keys(desk.panels.sliders, desk.view.wall_seconds), desk.edits().back().gesture) << "typed";
    desk.frame(70);
    desk.click("slider.LL", 0, 0.3f);
    EXPECT_EQ(gesture_by_keys(desk.panels.sliders, desk.view.wall_seconds), 0u) << "a drag is not by keys";
}

TEST(Slider, DigitsFocusTheSlidersThatTheExerciseOffersFromTopToBottom) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true, desk.lesson.at_start = false;
    desk.lesson.attempt.answers.prediction = 0;
    desk.opened.offers = {"LL=RR", "LM=RM"};
    desk.frame(3);
    desk.key({'2'});
    EXPECT_EQ(desk.panels.keyboard.focus, "bias.LM");
    desk.key({'1'});
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LL");
    EXPECT_FALSE(desk.last<NoticeRequest>());
    desk.key({'4'});
    ASSERT_TRUE(desk.last<NoticeRequest>()) << "there are two";
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.no_such_slider");
    EXPECT_EQ(desk.last<NoticeRequest>()->words, "4");
    EXPECT_EQ(desk.last<NoticeRequest>()->more, "LL = RR, LM = RM");
    desk.opened.offers = {"wiring"};
    desk.frame(3);
    desk.key({'4'});
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.no_slider_offered");
    desk.lesson.attempt.work.free_play = true;
    desk.frame(3);
    desk.key({'4'});
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.RR");
}

TEST(Slider, EveryDialHasASlider) {
    Desk desk;
    desk.panels.brain.thresholds_open = true;
    desk.frame(3);
    for (const char* id : {"slider.LL", "slider.LR", "slider.RL", "slider.RR", "threshold.LL", "threshold.LR",
                           "threshold.RL", "threshold.RR", "bias.LM", "bias.RM"}) {
        desk.all.clear();
        desk.rest();
        desk.click(id, 1);
        const bool is_zero = std::string(id).starts_with("threshold") || std::string(id) == "slider.LL" ||
                             std::string(id) == "slider.RR";
        EXPECT_EQ(desk.edits().size(), is_zero ? 0u : 1u) << id;
        desk.all.clear();
        desk.rest();
        desk.click(id, 0, 0.3f);
        EXPECT_EQ(desk.edits().size(), 1u) << id;
    }
}

}  // namespace braitenlab::tests::slider_test
