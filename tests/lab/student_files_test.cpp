#include "app/files/student_files.h"

#include <gtest/gtest.h>

#include "tests/folder.h"

namespace braitenlab::tests::student_files_test {
namespace {

StudentBook two_students() {
    StudentBook book;
    book.all.push_back({"Zoë / Z", {{"01-drive", {.passed = true, .best = 8, .starts = 10}}}});
    book.current = 1;
    return book;
}

TEST(StudentFiles, AreReadAsTheyWereWritten) {
    const Folder folder;
    StudentFiles files(folder / "students");
    StudentBook none;
    EXPECT_TRUE(files.read(none, "").empty());
    EXPECT_FALSE(files.write(none));
    EXPECT_FALSE(fs::exists(folder / "students")) << "nothing to keep yet";
    EXPECT_FALSE(files.write(two_students()));
    EXPECT_EQ(files.current_file(two_students()), "zo-z");
    StudentFiles again(folder / "students");
    StudentBook read;
    EXPECT_TRUE(again.read(read, "zo-z").empty());
    EXPECT_EQ(read, two_students());
    EXPECT_TRUE(again.read(read, "gone").empty());
    EXPECT_EQ(read.current, 0u);
}

TEST(StudentFiles, KeepABrokenFileAsideAndReportIt) {
    const Folder folder;
    put_text(folder / "students/ben.json", "{\n oh");
    put_text(folder / "students/ben.json.broken", "earlier");
    StudentFiles files(folder / "students");
    StudentBook book;
    const auto errors = files.read(book, "ben");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].line, 2);
    EXPECT_NE(errors[0].text().find("ben.json.broken2"), std::string::npos) << errors[0].text();
    EXPECT_EQ(text_of(folder / "students/ben.json.broken2"), "{\n oh");
    EXPECT_EQ(text_of(folder / "students/ben.json.broken"), "earlier");
    EXPECT_EQ(book, StudentBook{});
}

TEST(StudentFiles, GiveEachStudentAFileAndWriteOnlyWhatHasChanged) {
    const Folder folder;
    StudentFiles files(folder.path);
    StudentBook book = two_students();
    book.all.push_back({"Zoë Z", {}});
    EXPECT_FALSE(files.write(book));
    EXPECT_TRUE(fs::exists(folder / "zo-z.json"));
    EXPECT_TRUE(fs::exists(folder / "zo-z-2.json"));
    fs::remove(folder / "zo-z.json");
    book.all[2].exercises["01-drive"].notes = "x";
    EXPECT_FALSE(files.write(book));
    EXPECT_FALSE(fs::exists(folder / "zo-z.json")) << "unchanged";
    EXPECT_NE(text_of(folder / "zo-z-2.json").find("\"notes\": \"x\""), std::string::npos);
}

TEST(StudentFiles, ReportAnErrorOfWritingOnce) {
    const Folder folder;
    put_text(folder / "file", "");
    StudentFiles files(folder / "file");
    EXPECT_TRUE(files.write(two_students()));
    EXPECT_FALSE(files.write(two_students()));
}

TEST(StudentFiles, TryAgainAfterAFailedAttempt) {
    const Folder folder;
    put_text(folder / "students", "");
    StudentFiles files(folder / "students");
    EXPECT_TRUE(files.write(two_students()));
    fs::remove(folder / "students");
    EXPECT_FALSE(files.write(two_students()));
    StudentFiles again(folder / "students");
    StudentBook read;
    again.read(read, "");
    EXPECT_EQ(read.all.size(), two_students().all.size());
}

}  // namespace
}  // namespace braitenlab::tests::student_files_test
