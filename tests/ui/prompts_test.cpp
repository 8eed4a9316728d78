#include "ui/prompts.h"

#include "desk.h"

namespace braitenlab::tests {

TEST(Prompts, LeadFromPlayToASliderAndGoAway) {
    Desk desk;
    EXPECT_EQ(next_prompt(desk.view), "button.play");
    desk.view.mode = Mode::playing;
    desk.now.tick = 600;
    desk.now.seconds = 10;
    EXPECT_EQ(next_prompt(desk.view), "slider.LR") << "the selected predator's LL does nothing";
    desk.now.seconds = 20;
    EXPECT_EQ(next_prompt(desk.view), "") << "not for ever";
    desk.now.seconds = 10;
    desk.view.undo_depth = 1;
    EXPECT_EQ(next_prompt(desk.view), "");
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
