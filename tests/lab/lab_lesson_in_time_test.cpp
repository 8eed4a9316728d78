// The referee of an open exercise in time: help, going back, undo, bookmarks.
#include <vector>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_edits.h"
#include "app/lab_requests.h"
#include "tests/lab/lesson_in_lab.h"

namespace braitenlab::tests::lab_lesson_in_time_test {
namespace {

std::vector<bool> done(const Lab& lab) {
    std::vector<bool> all;
    for (const Verdict& verdict : lab.document.lesson->view.verdicts) all.push_back(verdict.done);
    return all;
}

bool by_hand(const Lab& lab) { return lab.document.lesson->view.by_hand; }

TEST(LabLesson, AnObstacleOrAVehicleAddedBeforeTheFirstTickMakesARunByHand) {
    for (const Command& help :
         {Command(AddObstacle{}), Command(AddVehicle{}), Command(AddVehicle{0, Pose{-6, -6, 0}})}) {
        Lab lab = aggressor();
        ASSERT_TRUE(apply(lab, help));
        EXPECT_TRUE(by_hand(lab)) << help.index();
        handle(lab, Action::undo);
        EXPECT_FALSE(by_hand(lab)) << help.index();
        handle(lab, Action::redo);
        run(lab, 10);
        EXPECT_TRUE(by_hand(lab)) << help.index();
        handle(lab, Action::undo);
        run(lab, 10);
        EXPECT_TRUE(by_hand(lab)) << help.index() << ": it was in the scene for ten ticks";
    }
}

TEST(LabLesson, TheRefereeGoesBackInTime) {
    Lab lab = solved_exercise();
    std::vector<std::vector<Verdict>> then;
    for (int i = 0; i < 700; ++i) then.push_back(lab.document.lesson->view.verdicts), tick(lab);
    for (const std::uint64_t at : {650u, 600u, 599u, 301u, 300u, 299u, 2u, 699u}) {
        handle(lab, SeekRequest{at});
        const auto& now = lab.document.lesson->view.verdicts;
        for (std::size_t i = 0; i < now.size(); ++i) {
            EXPECT_EQ(now[i].done, then[at][i].done) << at;
            EXPECT_EQ(now[i].measures, then[at][i].measures) << at;
        }
    }
}

TEST(LabLesson, AStepThatWasDoneBeforeTheRecordedMinuteStaysDone) {
    Lab lab = solved_exercise();
    run(lab, 1200);
    ASSERT_EQ(done(lab), std::vector<bool>(3, true));
    run(lab, 5000);
    ASSERT_GT(lab.document.session.earliest(), 1200u);
    handle(lab, SeekRequest{lab.document.session.earliest()});
    EXPECT_EQ(done(lab), std::vector<bool>(3, true));
}

TEST(LabLesson, HelpInTheRecordedPastIsDetectedAgainInAReplay) {
    Lab lab = aggressor();
    run(lab, 100);
    handle(lab, EditRequest{MoveVehicle{lab.view.selection.vehicle, 0, 0, 0}});
    run(lab, 100);
    handle(lab, SeekRequest{50});
    EXPECT_FALSE(by_hand(lab));
    run(lab, 49);
    EXPECT_FALSE(by_hand(lab));
    run(lab, 1);
    EXPECT_TRUE(by_hand(lab));
    run(lab, 30);
    EXPECT_TRUE(by_hand(lab));
}

TEST(LabLesson, HelpInThePastIsDroppedWhenItsUndoRestoresTheFuture) {
    for (const std::uint64_t at : {20u, 300u}) {  // 300: a keyframe
        for (const int moves : {1, 600}) {        // 600: more commands than a keyframe holds
            Lab lab = solved_exercise();
            run(lab, 700);
            const auto then = lab.document.lesson->view.verdicts;
            ASSERT_TRUE(then[0].done);
            handle(lab, SeekRequest{at});
            for (int i = 0; i < moves; ++i)
                handle(lab, EditRequest{MoveSource{0, 5 + 0.001f * static_cast<float>(i), 5}, 7});
            EXPECT_TRUE(by_hand(lab));
            handle(lab, Action::undo);
            ASSERT_EQ(lab.document.session.latest(), 700u);
            EXPECT_FALSE(by_hand(lab)) << moves << " moves at tick " << at;
            handle(lab, SeekRequest{700});
            for (std::size_t i = 0; i < then.size(); ++i) {
                const Verdict& now = lab.document.lesson->view.verdicts[i];
                EXPECT_EQ(now.done, then[i].done) << moves << " moves at tick " << at << ", step " << i;
                EXPECT_EQ(now.measures, then[i].measures) << moves << " moves at tick " << at << ", step " << i;
            }
        }
    }
}

TEST(LabLesson, AStepThatWasDoneStaysDoneAfterAnUndoThatMadeAKeyframe) {
    Lab lab = solved_exercise();
    run(lab, 310);
    for (int i = 0; i < 511; ++i)
        handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.001f * static_cast<float>(i)}, 7});
    handle(lab, Action::undo);
    ASSERT_EQ(lab.document.session.keyframe_before(310), 310u);
    const auto then = lab.document.lesson->view.verdicts;
    ASSERT_TRUE(then[0].done);
    run(lab, 100);
    handle(lab, SeekRequest{310});
    for (std::size_t i = 0; i < then.size(); ++i) {
        EXPECT_EQ(lab.document.lesson->view.verdicts[i].done, then[i].done) << i;
        EXPECT_EQ(lab.document.lesson->view.verdicts[i].measures, then[i].measures) << i;
    }
}

TEST(LabLesson, ABookmarkOfAnotherRunRestoresItsDoneSteps) {
    Lab lab = solved_exercise();
    run(lab, 1000);
    const auto then = done(lab);
    ASSERT_TRUE(then[0]);
    handle(lab, Action::set_bookmark);
    handle(lab, Action::reset);
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->scene.kinds[0].brain}});
    run(lab, 1100);
    ASSERT_FALSE(done(lab)[0]);
    handle(lab, Action::last_bookmark);
    EXPECT_EQ(lab.document.session.snapshot().tick, 1000u);
    EXPECT_EQ(done(lab), then);
}

// A drag of a lamp in a paused run gives more commands than a keyframe holds.
TEST(LabLesson, HelpWhoseCommandsMadeAKeyframeIsStillHelpAfterGoingBack) {
    Lab lab = aggressor();
    run(lab, 100);
    for (int i = 0; i < 600; ++i) handle(lab, EditRequest{MoveSource{0, 1 + 0.001f * static_cast<float>(i), 1}, 7});
    run(lab, 100);
    for (const std::uint64_t at : {150u, 100u}) {
        handle(lab, SeekRequest{at});
        EXPECT_TRUE(by_hand(lab)) << at;
    }
    handle(lab, SeekRequest{99});
    EXPECT_FALSE(by_hand(lab));
}

}  // namespace
}  // namespace braitenlab::tests::lab_lesson_in_time_test
