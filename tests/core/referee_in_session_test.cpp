// The referee as the observer of a session.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/referee.h"
#include "core/session/session.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::referee_in_session_test {
namespace {

std::string state_of(const Referee& referee) { return write_referee_state(referee.state()); }

const Referee& referee_of(const Session& session) { return *session.observer().as<Referee>(); }

// A referee that watches the recorded run once, from its start.
std::string straight(const Exercise& exercise, const Session& session) {
    Referee referee(exercise);
    session.replay(0, {[&](const Snapshot& now) { referee.watch(now); },
                       [&](const Snapshot& now, const Command& command) { referee.watch(now, command); }});
    return state_of(referee);
}

TEST(Referee, JudgesASessionAsAStraightReplayOfItsRecording) {
    const auto exercise = load_exercise(BRAITENLAB_SOURCE "/exercises/guided/05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    int judged = 0, by_hand = 0, done = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        auto session = Session::open(exercise->scene, seed, RunObserver::of(Referee(*exercise)));
        ASSERT_TRUE(session);
        maths::Random chance{seed, 5};
        const auto below = [&](std::uint64_t n) { return chance.next() % n; };
        (void)session->apply(SetBrain{{.kind = 0}, exercise->solution.submission.brain});
        for (int i = 0; i < 20; ++i) {
            const std::uint64_t what = below(10);
            if (what < 4)
                for (std::uint64_t ticks = below(200); ticks > 0; --ticks) session->step();
            if (what == 4) (void)session->apply(TurnDial{{.kind = 0}, Dial::LR, chance.uniform(0, 2)}, below(3));
            if (what == 5 && below(2) == 0) (void)session->apply(any_edit(*session, chance), below(3));
            if (what == 6) (void)session->undo();
            if (what == 7) (void)session->redo();
            if (what == 8) session->seek(below(session->latest() + 1));
            if (what == 9 && below(3) == 0) session->reset(Keep::submission);
            ASSERT_EQ(session->earliest(), 0u);
            const Referee& referee = referee_of(*session);
            ASSERT_EQ(state_of(referee), straight(*exercise, *session)) << "seed " << seed << ", action " << i;
            ++judged, by_hand += referee.by_hand(), done += referee.verdicts()[0].done;
        }
    }
    EXPECT_GT(by_hand, judged / 10);
    EXPECT_LT(by_hand, judged * 9 / 10);
    EXPECT_GT(done, judged / 10);
    EXPECT_LT(done, judged * 9 / 10);
}

// A session of two kinds, the first of which is the subject.
struct TwoKinds {
    Exercise exercise;
    Session session;
    explicit TwoKinds(Exercise of)
        : exercise(std::move(of)),
          session(std::move(*Session::open(exercise.scene, 1, RunObserver::of(Referee(exercise))))) {}
    const Referee& referee() const { return referee_of(session); }
};

TwoKinds two_kinds() {
    Exercise exercise;
    exercise.scene = furnished();
    exercise.scene.starts.resize(2);
    exercise.steps = {{"Drive on", {goals::Runs{5}}}};
    return TwoKinds(std::move(exercise));
}

TEST(Referee, ARunIsAsGivenUntilItGoesOnWithAChangedBrainSensorOrBody) {
    const Scene given = two_kinds().exercise.scene;
    std::vector<Sensor> fewer = given.kinds[0].sensors;
    fewer.pop_back();
    Kind wider = given.kinds[1];
    wider.body = resized(wider.body, 1.2f * wider.body.length, wider.body.width);
    for (const Command& change :
         {Command(TurnDial{{.kind = 1}, Dial::LL, 1.5f}), Command(TurnDial{{.vehicle = 0}, Dial::LR, 0.5f}),
          Command(SetSensors{{.kind = 0}, fewer}), Command(EditKind{1, wider})}) {
        TwoKinds two = two_kinds();
        ASSERT_TRUE(two.referee().as_given());
        for (int i = 0; i < 10; ++i) two.session.step();
        ASSERT_FALSE(two.session.apply(change)) << change.index();
        EXPECT_FALSE(two.referee().as_given()) << change.index();
        two.session.undo();
        EXPECT_TRUE(two.referee().as_given()) << change.index() << ": undone before the run goes on";
        two.session.redo();
        two.session.step();
        two.session.undo();
        two.session.step();
        EXPECT_FALSE(two.referee().as_given()) << change.index() << ": a tick was driven with it";
        two.session.seek(9);
        EXPECT_TRUE(two.referee().as_given()) << change.index() << ": before the change";
        two.session.seek(10);
        EXPECT_FALSE(two.referee().as_given()) << change.index();
        two.session.seek(0);
        EXPECT_TRUE(two.referee().as_given()) << change.index();
    }
}

TEST(Referee, MovedNodesOfAnotherKindsBrainAreNoChangeAndNoHelp) {
    TwoKinds two = two_kinds();
    for (int i = 0; i < 10; ++i) two.session.step();
    ASSERT_FALSE(two.session.apply(
        PlaceNodes{{.kind = 1}, {{two.session.snapshot().kind_brains[1]->nodes.front().id, maths::vec2{3, 4}}}}));
    two.session.step();
    EXPECT_TRUE(two.referee().as_given());
    EXPECT_FALSE(two.referee().by_hand());
}

}  // namespace
}  // namespace braitenlab::tests::referee_in_session_test
