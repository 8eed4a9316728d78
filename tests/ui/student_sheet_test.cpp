#include "desk.h"

namespace braitenlab::tests::student_sheet_test {

using namespace ui;

namespace {

struct StudentSheet : testing::Test {
    Desk desk{1280, 800, 1, true};
    StudentBook students;

    StudentSheet() {
        students.all.push_back({"Anna", {{"01-drive", {.passed = true}}}});
        desk.view.documents.students = &students;
        desk.frame(2);
        desk.choose("exercises", "students");
        desk.frame(3);
    }
    void type(const char* text) {
        desk.click("students.name");
        desk.type(text);
        desk.frame(3);
    }
    const StudentRequest& asked() const {
        const auto* request = desk.last<StudentRequest>();
        if (!request) throw std::runtime_error("nothing asked");
        return *request;
    }
};

}  // namespace

TEST_F(StudentSheet, ChoosesAStudent) {
    ASSERT_TRUE(desk.anchors.find("card.students"));
    desk.click("students.2");
    EXPECT_EQ(asked().edit, StudentEdit::choose);
    EXPECT_EQ(asked().index, 1u);
    desk.all.clear();
    desk.click("students.1");
    EXPECT_FALSE(desk.last<StudentRequest>()) << "is the present one";
}

TEST_F(StudentSheet, AddsAndRenamesByATypedName) {
    desk.click("students.add");
    EXPECT_FALSE(desk.last<StudentRequest>()) << "no name";
    type("Anna");
    desk.click("students.rename");
    EXPECT_FALSE(desk.last<StudentRequest>()) << "the name is taken";
    desk.panels.sheets.student_name.text.clear();
    type("Ben");
    desk.click("students.add");
    EXPECT_EQ(asked().edit, StudentEdit::add);
    EXPECT_EQ(asked().name, "Ben");
    type("Cy");
    desk.click("students.rename");
    EXPECT_EQ(asked().edit, StudentEdit::rename);
    EXPECT_EQ(asked().name, "Cy");
    type("Dee r");
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_EQ(asked().edit, StudentEdit::add);
    EXPECT_EQ(asked().name, "Dee r") << "typing is no shortcut";
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(StudentSheet, ForgetsTheProgressAndTakesThatBack) {
    desk.click("students.reset");
    EXPECT_FALSE(desk.last<StudentRequest>()) << "nothing to forget";
    students.current = 1;
    desk.frame(2);
    desk.click("students.reset");
    EXPECT_EQ(asked().edit, StudentEdit::reset);
    students.before_reset = std::exchange(students.all[1], StudentProgress{"Anna", {}});
    desk.frame(2);
    desk.click("students.reset");
    EXPECT_EQ(asked().edit, StudentEdit::restore);
    desk.click("students.export");
    EXPECT_EQ(asked().edit, StudentEdit::save);
    desk.click("students.save_progress");
    EXPECT_EQ(asked().edit, StudentEdit::save_progress);
}

TEST_F(StudentSheet, SaysOnAPageThatTheBrowserKeepsTheProgress) {
    EXPECT_TRUE(desk.says(desk.strings("students.what")));
    desk.view.program.uploads = true;
    desk.frame(2);
    EXPECT_TRUE(desk.says(desk.strings("students.what_page")));
    EXPECT_FALSE(desk.says(desk.strings("students.what")));
}

TEST_F(StudentSheet, FitsTheWindowWithManyStudentsInEveryLanguage) {
    for (int i = 0; i < 40; ++i) students.all.push_back({"A student with a long name number " + std::to_string(i), {}});
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.frame(3);
        const Rect card = desk.where("card.students");
        for (const char* id : {"students.add", "students.rename", "students.close", "students.reset", "students.export",
                               "students.save_progress"}) {
            const Rect r = desk.where(id);
            EXPECT_GE(r.x, card.x) << language << id;
            EXPECT_LE(r.x + r.w, card.x + card.w) << language << id;
        }
    }
}

TEST_F(StudentSheet, EnterDoesNotAddAStudentOfATakenName) {
    type("Anna");
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_FALSE(desk.last<StudentRequest>());
}

}  // namespace braitenlab::tests::student_sheet_test
