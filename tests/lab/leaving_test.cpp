// Leaving a document with unsaved edits.
#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/course/lesson_view.h"
#include "tests/lab/lab_files.h"

namespace braitenlab::tests::leaving_test {
namespace {

struct LeaveRequests : LabFiles {};

TEST_F(LeaveRequests, AsksBeforeItLeavesUnsavedEdits) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    const auto before = lab.document.session.hash();
    const std::string love = (*find_shipped("3a-love")).string();
    ask(OpenRequest{love});
    EXPECT_EQ(lab.document.session.hash(), before);
    ASSERT_TRUE(files.leaving);
    EXPECT_EQ(files.leaving->title, "Vehicle 2a: Coward");
    EXPECT_EQ(files.leaving->next, love);
    ask(LeaveRequest{Leave::stay});
    EXPECT_FALSE(files.leaving);
    EXPECT_EQ(lab.document.session.hash(), before);
    ask(OpenRequest{love});
    ask(LeaveRequest{Leave::discard});
    EXPECT_FALSE(files.leaving);
    EXPECT_EQ(lab.document.name, "3a-love");
}

TEST_F(LeaveRequests, SavesToTheFileOfTheSceneBeforeItLeaves) {
    ask(SaveRequest{"mine", FileKind::scene});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(LeaveRequest{Leave::save});
    EXPECT_EQ(lab.document.name, "3a-love");
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(dials().LR, 1.25f);
}

TEST_F(LeaveRequests, LeavesOnceTheEditsAreSavedUnderAnotherName) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(SaveRequest{"only the brain", FileKind::brain});
    ask(LeaveRequest{Leave::saved});
    EXPECT_TRUE(files.leaving) << "a brain file does not contain the scene: the question opens again";
    EXPECT_EQ(lab.document.name, "2a-coward");
    ask(SaveRequest{"all of it", FileKind::scene});
    ask(LeaveRequest{Leave::saved});
    EXPECT_EQ(lab.document.name, "3a-love");
}

TEST_F(LeaveRequests, DoesNotAskForWhatIsChangedInALectureOnly) {
    handle(lab, Action::lecture);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    EXPECT_TRUE(may_leave(lab, files));
    handle(lab, Action::lecture);
    EXPECT_TRUE(may_leave(lab, files)) << "also after it";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.5f}});
    EXPECT_FALSE(may_leave(lab, files));
    for (int i = 0; i < 2; ++i) {
        handle(lab, Action::lecture);
        handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::RL, 0.25f}});
        EXPECT_FALSE(may_leave(lab, files)) << "there are edits from before it";
    }
    handle(lab, Action::lecture);
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(LeaveRequest{Leave::discard});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::RL, 0.25f}});
    EXPECT_TRUE(may_leave(lab, files)) << "another scene of the same lecture";
}

TEST_F(LeaveRequests, LeavesWithoutUnsavedEditsOrAfterTheUserDiscardsThem) {
    EXPECT_TRUE(may_leave(lab, files)) << "no edits";
    for (int i = 0; i < 100; ++i) tick(lab);
    EXPECT_TRUE(may_leave(lab, files)) << "a run is not an edit";
    handle(lab, EditRequest{TurnDial{{.vehicle = 0}, Dial::LR, 1.25f}});
    EXPECT_FALSE(may_leave(lab, files)) << "the brain of a single vehicle counts too";
    ASSERT_TRUE(files.leaving);
    EXPECT_EQ(files.leaving->next, "");
    ask(LeaveRequest{Leave::stay});
    EXPECT_FALSE(lab.window.exit);
    handle(lab, Action::undo);
    EXPECT_TRUE(may_leave(lab, files)) << "an undone edit does not count";
    handle(lab, Action::redo);
    EXPECT_FALSE(may_leave(lab, files));
    ask(LeaveRequest{Leave::discard});
    EXPECT_TRUE(lab.window.exit);
    EXPECT_TRUE(may_leave(lab, files));
}

TEST_F(LeaveRequests, StaysIfTheEditsCannotBeWritten) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    EXPECT_FALSE(may_leave(lab, files));
    files.save_to = nowhere.string() + ".toml";
    ask(LeaveRequest{Leave::save});
    EXPECT_TRUE(files.leaving);
    EXPECT_FALSE(lab.window.exit);
    EXPECT_TRUE(files.refused);
}

TEST_F(LeaveRequests, AsksBeforeTheEditedBrainOfAnExerciseIsLost) {
    const std::string next = find_shipped("3a-love")->string();
    lab = open("05-aggressor");
    EXPECT_TRUE(may_leave(lab, files));
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    EXPECT_FALSE(may_leave(lab, files));
    ask(OpenRequest{next});
    EXPECT_EQ(lab.document.name, "05-aggressor");
    ASSERT_TRUE(files.leaving);
    EXPECT_EQ(files.leaving->next, next);
    ask(SaveRequest{"mine", FileKind::brain});
    ask(LeaveRequest{Leave::saved});
    EXPECT_EQ(lab.document.name, "3a-love") << "a brain in a file is not lost";
    lab = open("05-aggressor");
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    handle(lab, Action::exercise_reset);
    EXPECT_TRUE(may_leave(lab, files)) << "the brain is as shipped again";
}

TEST_F(LeaveRequests, OpensTheNextExerciseWithoutAQuestionOnceThisOneIsPassed) {
    const OpenRequest next{.path = find_shipped("3a-love")->string(), .next_exercise = true};
    lab = open("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    ask(next);
    EXPECT_TRUE(files.leaving) << "not passed yet";
    ask(LeaveRequest{Leave::stay});
    Jobs jobs;
    const auto grade_is_known = [&] { return lesson_view_of(lab).grade.has_value(); };
    for (int i = 0; i < 60 * 60 && !grade_is_known(); ++i) tick(lab), update_grading(lab, jobs), jobs.finish();
    ASSERT_TRUE(grade_is_known());
    ASSERT_TRUE(lesson_view_of(lab).grade->good);
    ask(OpenRequest{next.path});
    EXPECT_TRUE(files.leaving) << "opened in another way";
    ask(LeaveRequest{Leave::stay});
    ask(next);
    EXPECT_FALSE(files.leaving);
    EXPECT_EQ(lab.document.name, "3a-love");
}

}  // namespace
}  // namespace braitenlab::tests::leaving_test
