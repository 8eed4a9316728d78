// braitenctl grade with a folder: what is in it that is no hand-in, and the table for Excel.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/submission.h"
#include "tests/folder.h"
#include "tests/shell.h"

namespace braitenlab::tests::ctl_class_test {
namespace {

Ran grade_in(const fs::path& folder, const std::string& arguments) {
    return shell("cd " + folder.string() + " && " BRAITENLAB_BINARY "/braitenctl grade " + arguments);
}

void hand_in(const fs::path& file, const std::string& exercise) {
    const auto loaded = load_exercise(*find_shipped("05-aggressor"));
    HandIn made{.student = "Ana", .exercise = exercise};
    made.submission = with_solution(*loaded);
    put_text(file, write_hand_in(made));
}

TEST(CtlGrade, TakesAHandInForACopyOfTheExercise) {
    const Folder folder;
    std::string text = text_of(*find_shipped("05-aggressor"));
    const std::string relative = "../scenes/2b-aggressor.toml";
    text.replace(text.find(relative), relative.size(), find_shipped("2b-aggressor")->string());
    put_text(folder / "charge (1).toml", text);
    hand_in(folder / "class" / "ana.braiten-handin.toml", "charge");
    const Ran ran = grade_in(folder.path, "'charge (1).toml' class");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("\nAna,ana.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
}

TEST(CtlGrade, SaysOfADocumentAndOfAnEmptyFileWhatTheyAre) {
    const Folder folder;
    hand_in(folder / "class" / "ana.braiten-handin.toml", "05-aggressor");
    put_text(folder / "class" / "essay.docx", std::string("PK\x03\x04\0\0", 6));
    put_text(folder / "class" / "picture.toml", std::string("\x89PNG\0\0", 6));
    put_text(folder / "class" / "notes.txt", "My vehicle turns.");
    put_text(folder / "class" / "empty.toml", "");
    const Ran ran = grade_in(folder.path, "05-aggressor class --csv t.csv");
    EXPECT_EQ(ran.code, 2);
    for (const char* line : {"essay.docx: not a hand-in\n", "picture.toml: not a hand-in\n",
                             "notes.txt: not a hand-in\n", "empty.toml: the file is empty\n"})
        EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out;
    EXPECT_EQ(ran.out.find("TOML"), std::string::npos) << ran.out;
    EXPECT_NE(text_of(folder / "t.csv").find("\nAna,"), std::string::npos);
}

TEST(CtlGrade, AMistypedFolderIsAnErrorAndNoStudent) {
    const Folder folder;
    hand_in(folder / "class" / "ana.braiten-handin.toml", "05-aggressor");
    for (const char* arguments : {"05-aggressor clas", "05-aggressor class clas", "05-aggressor clas --html t.html"}) {
        const Ran ran = grade_in(folder.path, arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_EQ(ran.out, "braitenctl: clas: there is no such file or folder, and no shipped scene of this name\n");
    }
    EXPECT_FALSE(fs::exists(folder / "t.html"));
}

TEST(CtlGrade, ATableForExcelBeginsWithAByteOrderMark) {
    const Folder folder;
    hand_in(folder / "class" / "ana.braiten-handin.toml", "05-aggressor");
    EXPECT_TRUE(grade_in(folder.path, "05-aggressor class").out.starts_with("student,"));
    EXPECT_TRUE(grade_in(folder.path, "05-aggressor class --excel").out.starts_with("\xEF\xBB\xBFstudent,"));
    EXPECT_TRUE(grade_in(folder.path, "05-aggressor 2a-coward --excel")
                    .out.starts_with("\xEF\xBB\xBF"
                                     "brain,"));
    const std::string german = grade_in(folder.path, "05-aggressor class --excel --lang de").out;
    EXPECT_TRUE(german.starts_with("\xEF\xBB\xBFstudent;file;passed;"))
        << "a German Excel takes a comma as a decimal mark";
    EXPECT_NE(german.find("Ana;ana.braiten-handin.toml;"), std::string::npos) << german;
}

}  // namespace
}  // namespace braitenlab::tests::ctl_class_test
