// The progress of a student between two starts of the program.
#include "lab_window.h"

namespace braitenlab::tests::progress_window_test {

TEST(ProgressWindow, KeepsNotesAndThePredictionOfAStudentForTheNextStart) {
    const Home home;
    {
        LabWindow lab({"05-aggressor"}, home.path);
        lab.choose("exercises", "students");
        lab.click("students.name");
        lab.xdotool("type --delay 60 'Ana R'");
        ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["typed"] == "Ana R"; })) << lab.state()["typed"];
        lab.key("Return");
        ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["student"]["name"] == "Ana R"; }));
        lab.key("Escape");
        lab.click("exercise.predict.1");
        lab.click("exercise.note");
        lab.xdotool("type --delay 60 'run 1 was left'");
        ASSERT_TRUE(LabWindow::eventually([&] { return lab.state()["exercise"]["notes"] == "run 1 was left"; }))
            << lab.state()["exercise"]["notes"];
        EXPECT_EQ(lab.state()["mode"], "paused") << "typing is no shortcut";
        lab.key("Escape");
        lab.key("ctrl+q");
        EXPECT_EQ(lab.exit_code(), 0);
    }
    LabWindow lab({"05-aggressor"}, home.path);
    EXPECT_EQ(lab.state()["student"]["name"], "Ana R");
    EXPECT_EQ(lab.state()["student"]["exercises"], 1);
    EXPECT_EQ(lab.state()["exercise"]["notes"], "run 1 was left");
}

}  // namespace braitenlab::tests::progress_window_test
