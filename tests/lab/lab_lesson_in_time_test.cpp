// The referee of an open exercise in time: help, going back, undo, bookmarks.
#include <vector>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_edits.h"
#include "app/lab_requests.h"
#include "core/maths/random.h"
#include "tests/lab/lesson_in_lab.h"

namespace braitenlab::tests::lab_lesson_in_time_test {
namespace {

std::vector<bool> done(const Lab& lab) {
    std::vector<bool> all;
    for (const Verdict& verdict : lesson_view_of(lab).verdicts) all.push_back(verdict.done);
    return all;
}

bool by_hand(const Lab& lab) { return lesson_view_of(lab).by_hand; }

TEST(LabLesson, AnObstacleOrAVehicleAddedBeforeTheFirstTickMakesARunByHand) {
    for (const Command& help :
         {Command(AddObstacle{}), Command(AddVehicle{}), Command(AddVehicle{0, Pose{-6, -6, 0}})}) {
        Lab lab = aggressor();
        ASSERT_TRUE(braitenlab::apply(lab, help));
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
    for (int i = 0; i < 700; ++i) then.push_back(lesson_view_of(lab).verdicts), tick(lab);
    for (const std::uint64_t at : {650u, 600u, 599u, 301u, 300u, 299u, 2u, 699u}) {
        handle(lab, SeekRequest{at});
        const auto& now = lesson_view_of(lab).verdicts;
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
            const auto then = lesson_view_of(lab).verdicts;
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
                const Verdict now = lesson_view_of(lab).verdicts[i];
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
    const auto then = lesson_view_of(lab).verdicts;
    ASSERT_TRUE(then[0].done);
    run(lab, 100);
    handle(lab, SeekRequest{310});
    for (std::size_t i = 0; i < then.size(); ++i) {
        EXPECT_EQ(lesson_view_of(lab).verdicts[i].done, then[i].done) << i;
        EXPECT_EQ(lesson_view_of(lab).verdicts[i].measures, then[i].measures) << i;
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

// The lab tells the referee nothing: whatever it does with the session, the verdict is that of the recorded run.
TEST(LabLesson, TheVerdictIsThatOfAStraightReplayWhateverTheLabDoes) {
    int by_hand = 0, judged = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Lab lab = solved_exercise();
        maths::Random chance{seed, 3};
        const auto below = [&](std::uint64_t n) { return chance.next() % n; };
        const auto lr = [&] { return chance.uniform(0, 2); };
        for (int i = 0; i < 15; ++i) {
            const std::uint64_t what = below(10);
            if (what < 3) run(lab, static_cast<int>(below(200)));
            if (what == 3) handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, lr()}, 7 + below(2)});
            if (what == 4 && below(3) == 0) handle(lab, EditRequest{MoveSource{0, chance.uniform(-4, 4), 2}});
            if (what == 5) handle(lab, below(2) == 0 ? Action::undo : Action::redo);
            if (what == 6) handle(lab, SeekRequest{below(lab.document.session.latest() + 1)});
            if (what == 7) handle(lab, below(2) == 0 ? Action::reset : Action::exercise_reset);
            if (what == 8) handle(lab, Action::return_run);
            if (what == 9) handle(lab, Action::step_back);
            const Session& session = lab.document.session;
            ASSERT_EQ(session.earliest(), 0u);
            Referee straight(*lab.document.lesson->exercise);
            session.replay(0, {[&](const Snapshot& now) { straight.watch(now); },
                               [&](const Snapshot& now, const Command& command) { straight.watch(now, command); }});
            ASSERT_EQ(write_referee_state(referee_of(lab.document).state()), write_referee_state(straight.state()))
                << "seed " << seed << ", action " << i << ": " << what;
            ++judged, by_hand += straight.by_hand();
        }
    }
    EXPECT_GT(by_hand, judged / 20);
    EXPECT_LT(by_hand, judged / 2);
}

}  // namespace
}  // namespace braitenlab::tests::lab_lesson_in_time_test
