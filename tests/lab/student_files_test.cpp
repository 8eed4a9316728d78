#include "app/files/student_files.h"

#include <gtest/gtest.h>

#include "core/messages.h"
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
    EXPECT_FALSE(files.write(none).failed);
    EXPECT_FALSE(fs::exists(folder / "students")) << "nothing to keep yet";
    StudentBook two = two_students();
    EXPECT_FALSE(files.write(two).failed);
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

TEST(StudentFiles, KeepAsideWhatIsNoFile) {
    if (!fs::exists("/dev/null")) GTEST_SKIP() << "a system without devices in its folders";
    const Folder folder;
    fs::create_directories(folder / "students");
    fs::create_symlink("/dev/null", folder / "students/ben.json");
    StudentBook book;
    const auto errors = StudentFiles(folder / "students").read(book, "ben");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].text().find(message_of("not_a_file").text), std::string::npos) << errors[0].text();
    EXPECT_TRUE(fs::is_symlink(folder / "students/ben.json.broken"));
}

TEST(StudentFiles, GiveEachStudentAFileAndWriteOnlyWhatHasChanged) {
    const Folder folder;
    StudentFiles files(folder.path);
    StudentBook book = two_students();
    book.all.push_back({"Zoë Z", {}});
    EXPECT_FALSE(files.write(book).failed);
    EXPECT_TRUE(fs::exists(folder / "zo-z.json"));
    EXPECT_TRUE(fs::exists(folder / "zo-z-2.json"));
    fs::remove(folder / "zo-z.json");
    book.all[2].exercises["01-drive"].notes = "x";
    EXPECT_FALSE(files.write(book).failed);
    EXPECT_FALSE(fs::exists(folder / "zo-z.json")) << "unchanged";
    EXPECT_NE(text_of(folder / "zo-z-2.json").find("\"notes\": \"x\""), std::string::npos);
}

TEST(StudentFiles, ReportAnErrorOfWritingOnce) {
    const Folder folder;
    put_text(folder / "file", "");
    StudentFiles files(folder / "file");
    StudentBook book = two_students();
    EXPECT_TRUE(files.write(book).failed);
    EXPECT_FALSE(files.write(book).failed);
}

TEST(StudentFiles, TryAgainAfterAFailedAttempt) {
    const Folder folder;
    put_text(folder / "students", "");
    StudentFiles files(folder / "students");
    StudentBook book = two_students();
    EXPECT_TRUE(files.write(book).failed);
    fs::remove(folder / "students");
    EXPECT_FALSE(files.write(book).failed);
    StudentFiles again(folder / "students");
    StudentBook read;
    again.read(read, "");
    EXPECT_EQ(read.all.size(), two_students().all.size());
}

// Two windows that have read the same file of one student.
struct TwoWindows {
    Folder folder;
    StudentFiles one{folder.path}, other{folder.path};
    StudentBook ours, theirs;

    TwoWindows() {
        StudentBook book = two_students();
        EXPECT_FALSE(one.write(book).failed);
        one.read(ours, "zo-z"), other.read(theirs, "zo-z");
    }
};

TEST(StudentFiles, KeepWhatAnotherWindowHasWritten) {
    TwoWindows windows;
    windows.ours.student().exercises["06-love"].hints = 2;
    windows.theirs.student().exercises["09-explorer"].notes = "x";
    EXPECT_FALSE(windows.one.write(windows.ours).merged);
    EXPECT_TRUE(windows.other.write(windows.theirs).merged);
    EXPECT_EQ(windows.theirs.student().exercises.size(), 3u);
    StudentBook read;
    StudentFiles(windows.folder.path).read(read, "zo-z");
    EXPECT_EQ(read, windows.theirs);
    windows.ours.student().exercises["06-love"].hints = 3;
    windows.one.write(windows.ours);
    EXPECT_EQ(windows.ours.student().exercises["06-love"].hints, 3);
    EXPECT_EQ(windows.ours.student().exercises["09-explorer"].notes, "x");
    windows.ours.student().exercises.clear();
    EXPECT_FALSE(windows.one.write(windows.ours).merged) << "nothing has changed since";
    StudentFiles(windows.folder.path).read(read, "zo-z");
    EXPECT_TRUE(read.student().exercises.empty());
}

TEST(StudentFiles, FollowWhatAnotherWindowHasWrittenWhereNothingIsToBeWritten) {
    TwoWindows windows;
    windows.ours.student().exercises["06-love"].hints = 2;
    windows.one.write(windows.ours);
    const std::string text = text_of(windows.folder / "zo-z.json");
    EXPECT_TRUE(windows.other.write(windows.theirs).merged);
    EXPECT_EQ(windows.theirs, windows.ours);
    EXPECT_FALSE(windows.other.write(windows.theirs).merged) << "once";
    EXPECT_EQ(text_of(windows.folder / "zo-z.json"), text);
}

TEST(StudentFiles, GoOnWithTheStudentWhomAnotherWindowNames) {
    for (const bool has_name : {false, true}) {
        TwoWindows windows;
        windows.ours.current = 0, windows.theirs.current = has_name ? 1 : 0;
        put_text(windows.folder / "broken.json", "{");
        EXPECT_FALSE(windows.other.write(windows.theirs).merged);
        windows.ours.all.push_back({"Cy", {{"06-love", {.hints = 1}}}});
        windows.ours.current = 2;
        windows.one.write(windows.ours);
        EXPECT_EQ(windows.other.write(windows.theirs).merged, !has_name);
        EXPECT_EQ(windows.theirs.student().name, has_name ? "Zoë / Z" : "Cy");
        if (has_name) continue;
        EXPECT_EQ(windows.theirs, windows.ours);
        EXPECT_EQ(windows.other.current_file(windows.theirs), "cy");
        EXPECT_FALSE(windows.other.write(windows.theirs).merged) << "once";
        windows.theirs.current = 0;
        EXPECT_FALSE(windows.other.write(windows.theirs).merged) << "the person chooses to have no name";
    }
}

TEST(StudentFiles, AddAStudentOnceIfTwoWindowsAddHim) {
    TwoWindows windows;
    windows.ours.all.push_back({"Ben", {{"06-love", {.hints = 1}}}});
    windows.theirs.all.push_back({"ben", {{"09-explorer", {.hints = 2}}}});
    windows.one.write(windows.ours);
    windows.other.write(windows.theirs);
    EXPECT_FALSE(fs::exists(windows.folder / "ben-2.json"));
    StudentBook read;
    EXPECT_TRUE(StudentFiles(windows.folder.path).read(read, "").empty());
    ASSERT_EQ(read.all.size(), 3u);
    EXPECT_EQ(read.all[1].exercises.size(), 2u);
}

TEST(StudentFiles, KeepAFileAsideThatHasBecomeBroken) {
    TwoWindows windows;
    put_text(windows.folder / "zo-z.json", "{ oh");
    windows.ours.student().exercises["06-love"].hints = 2;
    const auto written = windows.one.write(windows.ours);
    ASSERT_TRUE(written.failed);
    EXPECT_EQ(text_of(windows.folder / "zo-z.json.broken"), "{ oh");
    EXPECT_NE(text_of(windows.folder / "zo-z.json").find("06-love"), std::string::npos);
}

TEST(StudentFiles, ReportEachFileThatIsNotUsed) {
    const Folder folder;
    put_text(folder / "anna.json", write_progress({"Anna", {}}));
    put_text(folder / "anna-2.json", write_progress({"anna", {{"06-love", {.hints = 1}}}}));
    put_text(folder / "unnamed.json", write_progress({"", {}}));
    StudentFiles files(folder.path);
    StudentBook book;
    const auto errors = files.read(book, "");
    ASSERT_EQ(errors.size(), 2u);
    EXPECT_EQ(errors[0].file, (folder / "anna.json").string());
    EXPECT_NE(errors[0].what.find("anna-2.json"), std::string::npos) << errors[0].what;
    EXPECT_EQ(errors[1].file, (folder / "unnamed.json").string());
    EXPECT_TRUE(fs::exists(folder / "anna.json")) << "it stays as it is";
    ASSERT_EQ(book.all.size(), 2u);
    EXPECT_EQ(book.all[1].exercises.size(), 1u);
}

}  // namespace
}  // namespace braitenlab::tests::student_files_test
