#include "app/course/together.h"

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/jobs/jobs.h"
#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::together_test {
namespace {

Lab passed_exercise(Jobs& jobs) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    for (int i = 0; i < 60 * 20 && !referee_of(lab.document).passed(); ++i) tick(lab);
    update_grading(lab, jobs);
    jobs.finish();
    update_grading(lab, jobs);
    return lab;
}

TEST(Together, RunsEachStartAsItWasGraded) {
    Jobs jobs{0};
    Lab lab = passed_exercise(jobs);
    handle(lab, TogetherRequest{});
    ASSERT_TRUE(lab.together);
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    ASSERT_EQ(view_of(lab).now->vehicles.size(), 10u);
    for (int i = 0; i < 10 * path_ticks; ++i) tick(lab);
    const Snapshot& now = *view_of(lab).now;
    EXPECT_EQ(now.tick, 10u * path_ticks);
    const Grade grade = *lesson_view_of(lab).grade;
    for (std::size_t i = 0; i < 10; ++i) {
        ASSERT_GT(grade.starts[i].path.size(), 10u);
        EXPECT_FLOAT_EQ(now.vehicles[i].x, grade.starts[i].path[10].x) << i;
        EXPECT_FLOAT_EQ(now.vehicles[i].y, grade.starts[i].path[10].y) << i;
        EXPECT_TRUE(i == 0 || now.vehicles[i].id > now.vehicles[i - 1].id);
    }
}

TEST(Together, GivesEachVehicleItsOwnReadings) {
    Jobs jobs{0};
    Lab lab = passed_exercise(jobs);
    handle(lab, TogetherRequest{});
    for (int i = 0; i < 30; ++i) tick(lab);
    const Snapshot& now = *view_of(lab).now;
    Snapshot alone;
    lab.together->worlds[7].capture(alone);
    const VehicleView &one = alone.vehicles[0], &shown = now.vehicles[7];
    EXPECT_FLOAT_EQ(now.sensed[static_cast<std::size_t>(shown.first_sensed)],
                    alone.sensed[static_cast<std::size_t>(one.first_sensed)]);
    EXPECT_FLOAT_EQ(now.neurons[static_cast<std::size_t>(shown.first_neuron)],
                    alone.neurons[static_cast<std::size_t>(one.first_neuron)]);
    EXPECT_EQ(*now.brains[static_cast<std::size_t>(shown.brain)], *alone.brains[static_cast<std::size_t>(one.brain)]);
}

TEST(Together, EndsWithTheExerciseAsItWasPassed) {
    Jobs jobs{0};
    Lab lab = passed_exercise(jobs);
    const std::uint64_t hash = lab.document.session.hash();
    const auto edits = lab.document.edits;
    for (const Request& last : {Request(TogetherRequest{false}), Request(Action::cancel)}) {
        handle(lab, TogetherRequest{});
        for (int i = 0; i < 60; ++i) tick(lab);
        handle(lab, SelectRequest{5});
        handle(lab, last);
        update_grading(lab, jobs);
        EXPECT_FALSE(lab.together);
        EXPECT_FALSE(lesson_view_of(lab).together);
        EXPECT_EQ(lab.document.session.hash(), hash);
        EXPECT_EQ(lab.document.edits, edits);
        EXPECT_TRUE(lesson_view_of(lab).grade && lesson_view_of(lab).grade->good);
        EXPECT_EQ(lab.playback.mode, Mode::paused);
    }
}

TEST(Together, EndsBeforeAnEditAndStaysForTheCamera) {
    Jobs jobs{0};
    Lab lab = passed_exercise(jobs);
    handle(lab, TogetherRequest{});
    handle(lab, Action::birds_eye);
    handle(lab, Action::play_pause);
    EXPECT_TRUE(lab.together);
    handle(lab, Action::reset);
    EXPECT_TRUE(lab.together) << "again from the starts";
    EXPECT_EQ(view_of(lab).now->tick, 0u);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LL, 0.4f}});
    EXPECT_FALSE(lab.together);
    EXPECT_EQ(view_of(lab).now->vehicles.size(), 1u);
}

TEST(Together, NeedsAPassedExercise) {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, TogetherRequest{});
    EXPECT_FALSE(lab.together);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    Lab scene = opened_lab("2a-coward");
    handle(scene, TogetherRequest{});
    EXPECT_FALSE(scene.together);
}

TEST(Together, NumbersWhatBelongsToAVehicleAsTheVehicle) {
    Snapshot one, two;
    one.vehicles = {{.id = 0}, {.id = 3}};
    two.vehicles = {{.id = 0}, {.id = 1}};
    two.looks = {{.vehicle = 1, .look = {}}};
    two.marks = {{.owner = 1}};
    two.bites = {{.one = 0, .other = 1}};
    two.strikes = {{.vehicle = 1}};
    const Snapshot all = merged({one, two});
    ASSERT_EQ(all.vehicles.size(), 4u);
    EXPECT_EQ(all.vehicles[2].id, 4u);
    EXPECT_EQ(all.vehicles[3].id, 5u);
    EXPECT_EQ(all.looks.at(0).vehicle, 5u);
    EXPECT_EQ(all.marks.at(0).owner, 5u);
    EXPECT_EQ(all.bites.at(0).one, 4u);
    EXPECT_EQ(all.bites.at(0).other, 5u);
    EXPECT_EQ(all.strikes.at(0).vehicle, 5u);
}

TEST(Together, RunsAtMostTenStarts) {
    const Lab lab = opened_lab("05-aggressor");
    const Exercise& exercise = *lab.document.lesson->exercise;
    Grade grade;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) grade.starts.push_back({.seed = seed});
    EXPECT_EQ(begin_together(exercise, exercise.solution.submission, grade).worlds.size(), most_together);
}

}  // namespace
}  // namespace braitenlab::tests::together_test
