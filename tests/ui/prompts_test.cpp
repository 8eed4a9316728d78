#include "ui/prompts.h"

#include "desk.h"

namespace braitenlab::tests {

TEST(Prompts, LeadFromPlayToASliderAndGoAway) {
    Desk desk;
    EXPECT_EQ(next_prompt(desk.view), "button.play");
    desk.view.mode = Mode::playing;
    desk.now.tick = 600;
    desk.now.seconds = 5;
    EXPECT_EQ(next_prompt(desk.view), "slider.LR") << "the selected predator's LL does nothing";
    desk.now.seconds = 9;
    EXPECT_EQ(next_prompt(desk.view), "") << "not for ever";
    desk.now.seconds = 5;
    desk.view.undo_depth = 1;
    EXPECT_EQ(next_prompt(desk.view), "");
}

TEST(Prompts, ForgetTheSliderForGoodOnceItWasWatchedOrTurned) {
    Desk desk;
    PromptMemory memory;
    desk.now.seconds = 5;
    EXPECT_EQ(still_wanted(memory, desk.view, "slider.LR"), "slider.LR");
    desk.now.seconds = 9;
    still_wanted(memory, desk.view, "");
    desk.now.seconds = 5;  // after a reset
    EXPECT_EQ(still_wanted(memory, desk.view, "slider.LR"), "");
    EXPECT_EQ(still_wanted(memory, desk.view, "button.play"), "button.play");
    desk.view.opened = "another scene";
    EXPECT_EQ(still_wanted(memory, desk.view, "slider.LR"), "slider.LR");
    desk.view.undo_depth = 1;
    EXPECT_EQ(still_wanted(memory, desk.view, "slider.LR"), "");
}

TEST(Prompts, KeepWhatAHintPointsTo) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.hints_shown = 3;
    desk.view.undo_depth = 1;
    PromptMemory memory;
    EXPECT_EQ(still_wanted(memory, desk.view, "slider.LR"), "slider.LR");
}

TEST(Prompts, AskForAPredictionBeforeTheFirstPlay) {
    Desk desk;
    desk.open_exercise();
    EXPECT_EQ(next_prompt(desk.view), "exercise.predict");
    desk.lesson.prediction = 0;
    EXPECT_EQ(next_prompt(desk.view), "button.play");
}

TEST(Prompts, PointWhereTheNewestHintPoints) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.prediction = 0;
    desk.lesson.has_run = true;
    desk.lesson.hints_shown = 3;
    EXPECT_EQ(next_prompt(desk.view), "slider.LR");
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    EXPECT_EQ(next_prompt(desk.view), "");
}

TEST(Prompts, StandStillWhereMotionIsReduced) {
    Desk desk;
    desk.view.reduce_motion = true;
    desk.view.wall_seconds = 0;
    EXPECT_EQ(pulse(desk.view), 1);
    desk.view.reduce_motion = false;
    EXPECT_NEAR(pulse(desk.view), 0, 1e-6f);
}

}  // namespace braitenlab::tests
