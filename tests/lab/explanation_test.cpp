// The cause of the selected vehicle's turn while it is shown.
#include "app/features/explanation.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::explanation_test {
namespace {

struct Explanation : testing::Test {
    Lab lab = opened_lab("2b-aggressor");

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick(lab), update_explanation(lab.explanation, lab);
    }
    const insight::Why* why() const { return view_of(lab).features.why; }
};

TEST_F(Explanation, IsShownByItsActionForTheDisplayedTick) {
    run(50);
    EXPECT_FALSE(why());
    handle(lab, Action::why);
    ASSERT_TRUE(why());
    EXPECT_EQ(why()->tick, 50u);
    run(1);
    EXPECT_EQ(why()->tick, 51u);
    handle(lab, SeekRequest{20});
    update_explanation(lab.explanation, lab);
    EXPECT_EQ(why()->tick, 20u);
    handle(lab, Action::why);
    EXPECT_FALSE(why());
}

TEST_F(Explanation, AtAPointOfTheTrailGoesToThatMomentAndPauses) {
    handle(lab, Action::play_pause);
    run(60);
    const std::vector<Pose>* path = view_of(lab).features.path;
    ASSERT_TRUE(path);
    ASSERT_EQ(path->size(), 60u) << "one pose per tick before this one";
    const Pose then = (*path)[25];
    handle(lab, WhyRequest{25});
    ASSERT_TRUE(why());
    EXPECT_EQ(why()->tick, 25u);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    const VehicleView& now = lab.document.session.snapshot().vehicles[0];
    EXPECT_EQ(now.x, then.x);
    EXPECT_EQ(now.y, then.y);
    handle(lab, WhyRequest{40});
    ASSERT_TRUE(why()) << "a second click does not switch it off";
    EXPECT_EQ(why()->tick, 40u);
}

TEST_F(Explanation, ChangesItsNumbersTenTimesASecondWhilePlaying) {
    handle(lab, Action::why);
    handle(lab, Action::play_pause);
    run(5);
    EXPECT_EQ(why()->tick, 0u);
    run(1);
    EXPECT_EQ(why()->tick, 6u);
}

// The parts of a brain with neurons are the same, whether the ticks before were recorded or are repeated.
TEST_F(Explanation, OfABrainWithNeuronsIsTheSameAfterTimeTravel) {
    lab = opened_lab("5-logic");
    handle(lab, Action::why);
    run(200);
    ASSERT_TRUE(why());
    const insight::Why recorded = *why();
    EXPECT_EQ(recorded.ticks, insight::silenced_ticks);
    run(30);
    handle(lab, SeekRequest{200});
    update_explanation(lab.explanation, lab);
    ASSERT_TRUE(why());
    EXPECT_EQ(why()->ticks, recorded.ticks);
    ASSERT_EQ(why()->sensors.size(), recorded.sensors.size());
    for (std::size_t i = 0; i < recorded.sensors.size(); ++i)
        EXPECT_EQ(why()->sensors[i].value, recorded.sensors[i].value) << recorded.sensors[i].sensor;
}

TEST_F(Explanation, IsRefusedWhileTheExerciseHidesTheOutcomeAndWhileAUserDrives) {
    lab = opened_lab("05-aggressor");
    handle(lab, Action::why);
    EXPECT_FALSE(why());
    EXPECT_EQ(lab.notice.key, "unavailable.why");
    lab = opened_lab("2b-aggressor");
    handle(lab, Action::drive);
    handle(lab, Action::why);
    EXPECT_FALSE(why());
}

}  // namespace
}  // namespace braitenlab::tests::explanation_test
