#include "app/course/lab_children.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_children_test {
namespace {

// The lab in exercise 20 with the runs of its first children.
struct Selected {
    Lab lab = opened_lab("20-selection");
    Jobs jobs{0};

    Selected() { wait(); }
    SelectionView view() const { return *lesson_view_of(lab).selection; }
    BrainGraph brain() const { return *lab.document.session.snapshot().kind_brains[0]; }
    void wait() {
        for (int job = 0; job < 2; ++job) {  // at the shown start, then at other ones
            update_children(lab, jobs);
            jobs.finish();
        }
        update_children(lab, jobs);
    }
    void choose(int child) {
        handle(lab, ChooseChildRequest{child});
        wait();
    }
    int longest() const {
        const auto children = view().children;
        return static_cast<int>(
            std::max_element(children.begin(), children.end(),
                             [](const StartResult& a, const StartResult& b) { return a.seconds < b.seconds; }) -
            children.begin());
    }
};

TEST(LabChildren, ShowsTheRunsOfNineChildrenFromTheStartThatPlayShows) {
    Selected s;
    ASSERT_EQ(s.view().children.size(), 9u);
    ASSERT_TRUE(s.view().parent);
    EXPECT_EQ(s.view().generation, 0);
    const std::vector<maths::vec2> path = s.view().parent->path;
    for (int i = 0; i < path_ticks; ++i) tick(s.lab);
    const VehicleView& now = s.lab.document.session.snapshot().vehicles[0];
    EXPECT_EQ(now.x, path[1].x);
    EXPECT_EQ(now.y, path[1].y);
}

TEST(LabChildren, NoChildRunsAtOtherStartsWhileTheShownStartTellsThemApart) {
    Selected s;
    const Lesson& lesson = *s.lab.document.lesson;
    int told_apart = 0;
    for (int generation = 0; generation < 4; ++generation, s.choose(0)) {
        const SelectionView view = s.view();
        const auto stay = std::count_if(view.children.begin(), view.children.end(),
                                        [&](const StartResult& run) { return !has_fallen(*lesson.exercise, run); });
        EXPECT_EQ(view.stays.empty(), stay < 2) << generation;
        EXPECT_FALSE(lesson.selecting->job.active()) << generation;
        told_apart += stay < 2;
    }
    EXPECT_GT(told_apart, 0);
}

TEST(LabChildren, EachChildThatStaysRunsAtOtherStarts) {
    Selected s;
    for (int generation = 0; generation < 6; ++generation) s.choose(s.longest());
    const SelectionView view = s.view();
    ASSERT_EQ(view.stays.size(), 9u);
    const Lesson& lesson = *s.lab.document.lesson;
    const std::vector<BrainGraph> brains = children_of(*lesson.exercise, lesson.selecting->parents.back());
    int all = 0;
    for (std::size_t child = 0; child < 9; ++child) {
        int stays = 0;
        const bool stays_here = !has_fallen(*lesson.exercise, view.children[child]);
        for (int i = 1; stays_here && i <= other_starts; ++i) {
            const auto run = try_start(*lesson.exercise, with_brain(*lesson.exercise, brains[child]),
                                       lesson.selecting->start + static_cast<std::uint64_t>(i));
            stays += !has_fallen(*lesson.exercise, run);
        }
        EXPECT_EQ(view.stays[child], stays) << child;
        all += stays;
    }
    EXPECT_GT(all, 0);
}

TEST(LabChildren, TheChosenChildGivesTheVehicleItsBrainAndHasChildrenItself) {
    Selected s;
    const BrainGraph shipped = s.brain();
    const std::vector<maths::vec2> path = s.view().children[4].path;
    s.choose(4);
    EXPECT_NE(s.brain(), shipped);
    EXPECT_EQ(s.view().generation, 1);
    EXPECT_EQ(s.view().parent->path, path) << "what was chosen is the parent now";
    EXPECT_EQ(s.lab.document.session.snapshot().tick, 0u) << "Play shows it from the start";
    s.choose(-1);
    EXPECT_EQ(s.view().generation, 2) << "the same parent has other children";
    EXPECT_EQ(s.view().parent->path, path);
}

TEST(LabChildren, UndoAndBackTakeAChoiceBack) {
    Selected s;
    const BrainGraph shipped = s.brain();
    const std::vector<maths::vec2> path = s.view().children[0].path;
    s.choose(2);
    handle(s.lab, Action::undo);
    s.wait();
    EXPECT_EQ(s.brain(), shipped);
    EXPECT_EQ(s.view().generation, 0);
    EXPECT_EQ(s.view().children[0].path, path) << "the same children";
    s.choose(2);
    s.choose(3);
    handle(s.lab, EarlierGenerationRequest{});
    s.wait();
    EXPECT_EQ(s.view().generation, 1);
    handle(s.lab, EarlierGenerationRequest{});
    handle(s.lab, EarlierGenerationRequest{});
    s.wait();
    EXPECT_EQ(s.view().generation, 0);
    EXPECT_EQ(s.brain(), shipped);
}

TEST(LabChildren, RedoBringsTheUndoneGenerationsBack) {
    Selected s;
    s.choose(2);
    s.choose(3);
    const std::vector<maths::vec2> path = s.view().children[0].path;
    handle(s.lab, Action::undo);
    s.wait();
    handle(s.lab, Action::undo);
    s.wait();
    ASSERT_EQ(s.view().generation, 0);
    handle(s.lab, Action::redo);
    s.wait();
    EXPECT_EQ(s.view().generation, 1);
    handle(s.lab, Action::redo);
    s.wait();
    EXPECT_EQ(s.view().generation, 2);
    EXPECT_EQ(s.view().children[0].path, path) << "the same children";
}

TEST(LabChildren, NothingIsChosenBeforeTheRunsAreKnownAndAfterTheLastGeneration) {
    Selected s;
    handle(s.lab, ChooseChildRequest{9});
    EXPECT_EQ(s.view().generation, 0) << "no such child";
    handle(s.lab, ChooseChildRequest{0});
    handle(s.lab, ChooseChildRequest{0});
    handle(s.lab, ChooseChildRequest{-1});
    EXPECT_EQ(s.view().generation, 1) << "its children have not run yet";
    s.wait();
    for (int i = 0; i < 20; ++i) s.choose(0);
    EXPECT_EQ(s.view().generation, 12);
}

TEST(LabChildren, StartOverBeginsWithOtherChildren) {
    Selected s;
    const std::vector<maths::vec2> path = s.view().children[0].path;
    s.choose(0);
    handle(s.lab, Action::exercise_reset);
    s.wait();
    EXPECT_EQ(s.view().generation, 0);
    ASSERT_EQ(s.view().children.size(), 9u);
    EXPECT_NE(s.view().children[0].path, path);
}

TEST(LabChildren, UndoOfStartOverBringsTheGenerationsBack) {
    Selected s;
    s.choose(2);
    s.choose(3);
    const BrainGraph brain = s.brain();
    const std::vector<maths::vec2> path = s.view().children[0].path;
    handle(s.lab, Action::exercise_reset);
    s.wait();
    ASSERT_EQ(s.view().generation, 0);
    handle(s.lab, Action::undo);
    s.wait();
    EXPECT_EQ(s.view().generation, 2);
    EXPECT_EQ(s.brain(), brain);
    EXPECT_EQ(s.view().children[0].path, path) << "the same children";
    handle(s.lab, EarlierGenerationRequest{});
    s.wait();
    EXPECT_EQ(s.view().generation, 1);
}

TEST(LabChildren, AnExerciseWithoutSelectionHasNone) {
    Lab lab = opened_lab("05-aggressor");
    Jobs jobs(0);
    update_children(lab, jobs);
    EXPECT_FALSE(lesson_view_of(lab).selection);
    handle(lab, ChooseChildRequest{0});
    handle(lab, EarlierGenerationRequest{});
    EXPECT_EQ(lab.document.session.undo_depth(), 0);
}

TEST(LabChildren, ChoosingTheLongestSurvivorPassesTheExercise) {
    Selected s;
    while (s.view().generation < 12 && !has_passed(*s.lab.document.lesson)) {
        s.choose(s.longest());
        if (s.view().parent->seconds < 59) continue;
        for (int i = 0; i < 60 * 60 + 1; ++i) tick(s.lab);
        update_grading(s.lab, s.jobs);
        s.jobs.finish();
        update_grading(s.lab, s.jobs);
    }
    EXPECT_TRUE(has_passed(*s.lab.document.lesson));
    EXPECT_FALSE(lesson_view_of(s.lab).standing.outside_offers);
}

TEST(LabChildren, AnotherStartShowsTheRunsFromThere) {
    Selected s;
    const std::vector<maths::vec2> path = s.view().parent->path;
    handle(s.lab, Action::another_start);
    s.wait();
    ASSERT_TRUE(s.view().parent);
    EXPECT_NE(s.view().parent->path, path);
    const VehicleView& now = s.lab.document.session.snapshot().vehicles[0];
    EXPECT_EQ(now.x, s.view().parent->path[0].x);
    EXPECT_EQ(now.y, s.view().parent->path[0].y);
}

}  // namespace
}  // namespace braitenlab::tests::lab_children_test
