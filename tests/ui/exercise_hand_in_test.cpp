// Handing in from the exercise card: the name and the file.
#include "desk.h"

namespace braitenlab::tests::exercise_hand_in_test {

using namespace ui;

TEST(ExerciseHandIn, HandInAsksForANameOnceAndIsThereAfterARun) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.hand_in")) << "before the first run";
    desk.lesson.attempt.work.has_run = true;
    desk.frame(3);
    desk.click("exercise.hand_in");
    desk.frame(3);
    EXPECT_TRUE(desk.all.empty()) << "there is no name";
    ASSERT_TRUE(desk.anchors.find("exercise.student"));
    EXPECT_TRUE(desk.says("Your teacher")) << "why";
    desk.type("Ana P ");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<HandInRequest>(desk.all[0]).student, "Ana P");
    EXPECT_FALSE(desk.anchors.find("exercise.student"));
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 2u) << "the name is known";
    desk.click("exercise.lab_record");
    ASSERT_EQ(desk.all.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<LabRecordRequest>(desk.all[2]));
}

TEST(ExerciseHandIn, ANameTypedAtHandInBecomesTheNameOfTheStudent) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    StudentBook book;
    book.all.push_back({"Bo", {}});
    desk.view.documents.students = &book;
    desk.frame(3);
    desk.click("exercise.hand_in");
    desk.frame(3);
    desk.type("Ana");
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    ASSERT_EQ(desk.all.size(), 2u);
    ASSERT_TRUE(std::holds_alternative<StudentRequest>(desk.all[0]));
    EXPECT_EQ(std::get<StudentRequest>(desk.all[0]).edit, StudentEdit::rename);
    EXPECT_EQ(std::get<StudentRequest>(desk.all[0]).name, "Ana");
    EXPECT_EQ(std::get<HandInRequest>(desk.all[1]).student, "Ana");

    desk.all.clear();
    book.all.push_back({"Ana", {}});
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 1u) << "a name is not taken from another student";
    EXPECT_TRUE(std::holds_alternative<HandInRequest>(desk.all[0]));
}

TEST(ExerciseHandIn, HandInUsesTheNameOfTheNamedStudent) {
    Desk desk;
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.view.documents.student = "Bo";
    desk.frame(3);
    desk.click("exercise.hand_in");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<HandInRequest>(desk.all[0]).student, "Bo");
}

TEST(ExerciseHandIn, TheCardAsksBeforeABetterHandInIsReplaced) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.view.documents.student = "Bo";
    desk.lesson.attempt.work.refused = {HandInRefusal::earlier_is_better, 10, 10};
    desk.frame(3);
    EXPECT_TRUE(desk.says("Your earlier hand-in passed 10 of 10. Replace it?"));
    desk.click("exercise.replace");
    ASSERT_TRUE(desk.last<HandInRequest>());
    EXPECT_EQ(desk.last<HandInRequest>()->earlier, EarlierHandIn::replace);
    EXPECT_EQ(desk.last<HandInRequest>()->student, "Bo");
    desk.click("exercise.keep");
    EXPECT_EQ(desk.last<HandInRequest>()->earlier, EarlierHandIn::keep);
    desk.click("exercise.hand_in");
    EXPECT_EQ(desk.last<HandInRequest>()->earlier, EarlierHandIn::ask);
}

TEST(ExerciseHandIn, TheCardSaysWhyNothingWasHandedIn) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.work.refused.reason = HandInRefusal::outside_offers;
    desk.frame(3);
    EXPECT_TRUE(desk.says("Not handed in: "));
    EXPECT_FALSE(desk.anchors.find("exercise.replace"));
    desk.opened.changes = 2;
    desk.lesson.attempt.work.refused.reason = HandInRefusal::too_many_changes;
    desk.frame(3);
    EXPECT_TRUE(desk.says("at most 2"));
}

TEST(ExerciseHandIn, OnAPageTheWholeNameOfTheFileIsShownInPlaceOfItsPath) {
    Desk desk(800, 600, 1, true);
    desk.view.program.uploads = true;
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.work.written = "05-aggressor-ana-maria-gonzalez.braiten-handin.toml";
    desk.frame(3);
    EXPECT_TRUE(desk.says(desk.lesson.attempt.work.written));
    EXPECT_FALSE(desk.anchors.find("exercise.copy_path"));
    desk.lesson.attempt.work.written = "05-aggressor-ana.html";
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("exercise.open_record"));
}

TEST(ExerciseHandIn, TheFileHandedInIsNamedAndItsPathCanBeCopied) {
    Desk desk(1024, 768, 1, true);
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.copy_path"));
    desk.lesson.attempt.work.written = "/home/ana/Documents/Braitenlab/05-ana.toml";
    desk.frame(3);
    EXPECT_TRUE(desk.says("05-ana.toml"));
    desk.click("exercise.copy_path");
    EXPECT_STREQ(ImGui::GetClipboardText(), desk.lesson.attempt.work.written.c_str());
    desk.lesson.attempt.work.written = "/home/ana/Documents/Braitenlab/05-ana.html";
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("exercise.copy_path"));
    desk.click("exercise.open_record");
    EXPECT_TRUE(desk.last<OpenWrittenRequest>()) << "a lab record is opened";
}

}  // namespace braitenlab::tests::exercise_hand_in_test
