// braitenctl grade with a folder: what is in it that is no hand-in, and the table for Excel.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/submission.h"
#include "tests/folder.h"
#include "tests/shell.h"
#include "tests/zip.h"

namespace braitenlab::tests::ctl_class_test {
namespace {

Ran grade_in(const fs::path& folder, const std::string& arguments) {
    return shell("cd " + folder.string() + " && " BRAITENLAB_BINARY "/braitenctl grade " + arguments);
}

std::string handed_in(const std::string& student, bool is_solved = true) {
    const auto loaded = load_exercise(*find_shipped("05-aggressor"));
    HandIn made{.student = student, .exercise = "05-aggressor"};
    made.submission = is_solved ? with_solution(*loaded) : as_shipped(*loaded);
    return write_hand_in(made);
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
    EXPECT_NE(ran.out.find("\nAna,,,ana.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
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
    for (const char* line : {"essay.docx: not a hand-in\n", "picture.toml: not a hand-in but a picture\n",
                             "notes.txt: not a hand-in\n", "empty.toml: the file is empty\n"})
        EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out;
    EXPECT_EQ(ran.out.find("TOML"), std::string::npos) << ran.out;
    EXPECT_NE(text_of(folder / "t.csv").find("\nAna,"), std::string::npos);
}

TEST(CtlGrade, SaysOfAFileThatIsCutOffThatItEndsEarly) {
    const std::string whole = handed_in("Ana");
    const std::size_t in_brain = whole.find("LR = ");
    for (const std::string& cut :
         {whole.substr(0, whole.find("exercise") + 3), whole.substr(0, in_brain + 4),
          whole.substr(0, in_brain) + "cut = fal", whole.substr(0, in_brain) + "[submission.bo"}) {
        const Folder folder;
        put_text(folder / "class" / "ana.braiten-handin.toml", cut);
        const Ran ran = grade_in(folder.path, "05-aggressor class --csv t.csv");
        EXPECT_EQ(ran.code, 2);
        const auto line = std::to_string(1 + std::count(cut.begin(), cut.end(), '\n'));
        EXPECT_NE(ran.out.find("ana.braiten-handin.toml:" + line + ": the file ends early"), std::string::npos)
            << ran.out;
        EXPECT_NE(text_of(folder / "t.csv").find("the file ends early"), std::string::npos);
        EXPECT_EQ(ran.out.find("quotes"), std::string::npos) << ran.out;
    }
}

TEST(CtlGrade, AValueOutsideItsRangeFailsAndALaterHandInReplacesIt) {
    const Folder folder;
    const auto written = [](std::string text, const std::string& time) {
        return text.insert(text.find("\n[submission"), "written = \"" + time + "\"\n");
    };
    std::string wrong = handed_in("Ana");
    const std::size_t at = wrong.find("LR = ") + 5;
    wrong.replace(at, wrong.find('\n', at) - at, "9");
    put_text(folder / "c" / "a.braiten-handin.toml", written(wrong, "2026-11-22T16:00:00Z"));
    const Ran failed = grade_in(folder.path, "05-aggressor c --html c.html");
    EXPECT_EQ(failed.code, 0) << failed.out;
    EXPECT_EQ(text_of(folder / "c.html").find("without a hand-in"), std::string::npos);
    const Ran ran = grade_in(folder.path, "05-aggressor c");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("\nAna,,,a.braiten-handin.toml,no,0,"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("'LR' is 9, outside -2 .. 2"), std::string::npos) << ran.out;
    put_text(folder / "c" / "b.braiten-handin.toml", written(handed_in("Ana"), "2026-11-22T17:00:00Z"));
    const Ran later = grade_in(folder.path, "05-aggressor c");
    EXPECT_NE(later.out.find("\nAna,,,a.braiten-handin.toml,,"), std::string::npos) << later.out;
    EXPECT_NE(later.out.find("\nAna,,,b.braiten-handin.toml,yes,10,"), std::string::npos) << later.out;
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
    EXPECT_TRUE(german.starts_with("\xEF\xBB\xBFstudent;folder;id;file;passed;"))
        << "a German Excel takes a comma as a decimal mark";
    EXPECT_NE(german.find("Ana;;;ana.braiten-handin.toml;yes;10;10;8;"), std::string::npos)
        << "headings, yes and no are the same in every language: " << german;
    EXPECT_NE(german.find(";Bestanden: 10 von 10 Starts.;"), std::string::npos) << german;
}

// What Moodle exports: two people of one name, a text beside a file, a PDF, a saved page, a folder without a file.
std::vector<Zipped> moodle_export() {
    return {
        {"Müller Anna_101_assignsubmission_file_/"},
        {"Müller Anna_101_assignsubmission_file_/05-aggressor.braiten-handin.toml", handed_in("Anna Müller"), true},
        {"Müller Anna_101_assignsubmission_onlinetext_/onlinetext.html", "<p>See file</p>"},
        {"Müller Anna_102_assignsubmission_file_/05-aggressor.braiten-handin.toml", handed_in("Anna Müller", false)},
        {"Nowak Jan_103_assignsubmission_file_/report.pdf", "%PDF-1.7 text without a zero byte"},
        {"Ode Olu_104_assignsubmission_file_/05-aggressor.html", "<!DOCTYPE html>"},
        {"Park Soo_105_assignsubmission_file_/"},
        {"Quinn Ed_106_assignsubmission_file_/mine.zip", zip_of({{"a.toml", "x = 1"}})},
        {"Rau Ute_107_assignsubmission_file_/.DS_Store", "x"},
        {"Sol Ida_108_assignsubmission_file_/__MACOSX/._a.toml", "x"},
        {"__MACOSX/._report.pdf", "x"}};
}

void expect_the_moodle_class(const Ran& ran) {
    EXPECT_EQ(ran.code, 2);
    const std::string first = "Müller Anna_101_assignsubmission_file_",
                      second = "Müller Anna_102_assignsubmission_file_", file = "/05-aggressor.braiten-handin.toml";
    for (const std::string& line :
         {"\nMüller Anna," + first + ",101," + first + file + ",yes,10,",
          "\nMüller Anna," + second + ",102," + second + file + ",no,0,",
          std::string("report.pdf: not a hand-in but a PDF\n"),
          std::string("Ode Olu_104_assignsubmission_file_: no hand-in in this folder\n"),
          std::string("Park Soo_105_assignsubmission_file_: no hand-in in this folder\n"),
          std::string("Rau Ute_107_assignsubmission_file_: no hand-in in this folder\n"),
          std::string("Sol Ida_108_assignsubmission_file_: no hand-in in this folder\n"),
          std::string("mine.zip: not a hand-in but a ZIP archive; unpack it into this folder\n"),
          std::string("\nNowak Jan,Nowak Jan_103_assignsubmission_file_,103,"),
          std::string("left out: Müller Anna_101_assignsubmission_onlinetext_/onlinetext.html, Ode ")})
        EXPECT_NE(ran.out.find(line), std::string::npos) << line << "\n" << ran.out;
    EXPECT_EQ(ran.out.find("MACOSX"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("Müller Anna_101_assignsubmission_onlinetext_: no"), std::string::npos) << "she has a file";
}

TEST(CtlGrade, TakesTheZipOfMoodle) {
    const Folder folder;
    put_text(folder / "class.zip", zip_of(moodle_export()));
    expect_the_moodle_class(grade_in(folder.path, "05-aggressor class.zip"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), {}), 1) << "nothing is unpacked to the disk";
}

TEST(CtlGrade, TakesTheFoldersOfMoodleAndWhatIsAroundThem) {
    const Folder folder;
    for (const Zipped& file : moodle_export())
        if (file.name.ends_with('/'))
            fs::create_directories(folder / "class" / file.name);
        else
            put_text(folder / "class" / file.name, file.content);
    expect_the_moodle_class(grade_in(folder.path, "05-aggressor class"));
    fs::create_directories(folder / "outer");
    fs::rename(folder / "class", folder / "outer" / "Sheet 5");
    const Ran ran = grade_in(folder.path, "05-aggressor outer");
    EXPECT_NE(ran.out.find("\nMüller Anna,Müller Anna_101_assignsubmission_file_,101,Sheet 5/Müller"),
              std::string::npos)
        << ran.out;
}

TEST(CtlGrade, WhoHandsInTheFileOfAnotherStandsUnderTheOwnName) {
    const Folder folder;
    const std::string file = "/05-aggressor.braiten-handin.toml";
    for (const auto& [platform, anna, jan] :
         {std::array{"Moodle", "Müller Anna_101_assignsubmission_file_", "Nowak Jan_102_assignsubmission_file_"},
          std::array{"ILIAS", "Mueller_Anna_am_101", "Nowak_Jan_jn_102"}}) {
        for (const std::string person : {anna, jan})
            put_text(folder / platform / (person + file), handed_in("Anna Müller"));
        const Ran ran = grade_in(folder.path, "05-aggressor " + std::string(platform) + " --html page.html");
        EXPECT_EQ(ran.code, 0) << ran.out;
        const std::string table = grade_in(folder.path, "05-aggressor " + std::string(platform)).out;
        const auto row_of = [&](const std::string& begin) {
            const std::size_t at = table.find("\n" + begin);
            return at == table.npos ? "" : table.substr(at + 1, table.find('\n', at + 1) - at - 1);
        };
        const std::string of_jan = row_of("Nowak Jan," + std::string(jan) + ",102,");
        EXPECT_NE(of_jan.find(",Anna Müller," + std::string(anna) + file + ",Passed"), std::string::npos) << table;
        const std::string of_anna = row_of(std::string(platform) == "Moodle" ? "Müller Anna," : "Mueller Anna,");
        EXPECT_NE(of_anna.find(",," + std::string(jan) + file + ",Passed"), std::string::npos) << table;
        const std::string page = text_of(folder / "page.html");
        EXPECT_NE(page.find(">Nowak Jan</a> <span class=\"quiet\">102</span>"), std::string::npos) << platform;
        EXPECT_NE(page.find("the file names Anna Müller; the same file as " + std::string(anna)), std::string::npos)
            << platform;
    }
}

TEST(CtlGrade, TakesAFileInASubfolderBesideOthers) {
    const Folder folder;
    put_text(folder / "class" / "a.braiten-handin.toml", handed_in("Ana"));
    put_text(folder / "class" / "late" / "ben.braiten-handin.toml", handed_in("Ben"));
    const Ran ran = grade_in(folder.path, "05-aggressor class");
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.out.find("\nBen,late,,late/ben.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
}

TEST(CtlGrade, TakesFlatNamesOfMoodleAndCopiesOfCanvas) {
    const Folder folder;
    put_text(folder / "c" / "Lee Kim_7_assignsubmission_file_05-aggressor.toml", handed_in("K"));
    put_text(folder / "c" / "nowakjan_4711_99001_05-aggressor-jan.braiten-handin-1.toml", handed_in("Jan"));
    const Ran ran = grade_in(folder.path, "05-aggressor c");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("\nLee Kim,,7,Lee Kim_7"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\nnowakjan,,4711,nowakjan_4711"), std::string::npos) << ran.out;
}

TEST(CtlGrade, TwoFoldersMayHaveTheSameNames) {
    const Folder folder;
    for (const char* group : {"a", "b"}) put_text(folder / group / "x.braiten-handin.toml", handed_in("Ana"));
    const Ran ran = grade_in(folder.path, "05-aggressor a b");
    EXPECT_NE(ran.out.find("\nAna,a,,a/x.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\nAna,b,,b/x.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find(",b/x.braiten-handin.toml,Passed"), std::string::npos) << "the same file: " << ran.out;
}

TEST(CtlGrade, ListedFilesInTwoFoldersAreOfTwoStudents) {
    const Folder folder;
    for (const char* group : {"c/a", "c/b"}) put_text(folder / group / "x.braiten-handin.toml", handed_in("Ana"));
    const Ran ran = grade_in(folder.path, "05-aggressor c/a/x.braiten-handin.toml c/b/x.braiten-handin.toml");
    EXPECT_NE(ran.out.find("\nAna,a,,c/a/x.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\nAna,b,,c/b/x.braiten-handin.toml,yes,"), std::string::npos) << ran.out;
}

TEST(CtlGrade, AnEmptyFolderBesideOthersIsARow) {
    const Folder folder;
    put_text(folder / "c" / "hand-ins" / "ana" / "x.braiten-handin.toml", handed_in("Ana"));
    fs::create_directories(folder / "c" / "hand-ins" / "ben");
    const Ran ran = grade_in(folder.path, "05-aggressor c");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("\nAna,ana,,hand-ins/ana/x"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("ben: no hand-in in this folder\n"), std::string::npos) << ran.out;
}

TEST(CtlGrade, ADamagedArchiveIsAnErrorAndADamagedFileARow) {
    const Folder folder;
    const std::string whole = zip_of({{"a/x.toml", handed_in("Ana"), true, 1}, {"b/x.toml", handed_in("Ben"), true}});
    put_text(folder / "half.zip", whole.substr(0, whole.size() / 2));
    const Ran half = grade_in(folder.path, "05-aggressor half.zip");
    EXPECT_EQ(half.code, 2);
    EXPECT_EQ(half.out, "braitenctl: half.zip: this is no ZIP archive, or it is damaged; download it again\n");
    put_text(folder / "whole.zip", whole);
    const Ran ran = grade_in(folder.path, "05-aggressor whole.zip --lang de");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("a/x.toml: lässt sich nicht entpacken"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("\nBen,b,,b/x.toml,yes,"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace braitenlab::tests::ctl_class_test
