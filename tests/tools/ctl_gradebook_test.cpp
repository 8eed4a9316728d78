// braitenctl grade --gradebook: marks as the import of a learning platform reads them.
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

namespace braitenlab::tests::ctl_gradebook_test {
namespace {

Ran grade_in(const Folder& folder, const std::string& arguments) {
    return shell("cd " + folder.path.string() + " && " BRAITENLAB_BINARY "/braitenctl grade 05-aggressor " + arguments);
}

enum class Work { solved, as_given, not_offered };

std::string handed_in(const std::string& student, Work work) {
    const auto exercise = load_exercise(*find_shipped("05-aggressor"));
    HandIn made{.student = student, .exercise = "05-aggressor"};
    made.submission = work == Work::as_given ? as_shipped(*exercise) : with_solution(*exercise);
    if (work == Work::not_offered) made.submission.sensors[0].range = 30;
    return write_hand_in(made);
}

// Anna 101 passes, Jan 102 fails, Olu 103 changes what is not offered, Kim 109 is not in the lists below.
void put_class(const Folder& folder) {
    const auto file = [](const std::string& person, Work work) {
        return Zipped{person + "_assignsubmission_file_/a.toml", handed_in(person, work), true};
    };
    put_text(folder / "class.zip", zip_of({file("Müller Anna_101", Work::solved), file("Nowak Jan_102", Work::as_given),
                                           file("Ode Olu_103", Work::not_offered)}));
}

TEST(CtlGradebook, FillsTheGradingWorksheetOfMoodle) {
    const Folder folder;
    put_class(folder);
    const std::string header =
        "Identifier,\"Full name\",\"Email address\",Status,Grade,\"Maximum Grade\",\"Grade can be changed\","
        "\"Last modified (submission)\",\"Last modified (grade)\",\"Feedback comments\"\n";
    put_text(folder / "list.csv",
             "\xEF\xBB\xBF" + header +
                 "\"Participant 101\",\"Anna Müller\",a@x,Submitted,,100.00,Yes,\"Monday, 5 October\",-,\n"
                 "\"Participant 102\",\"Jan Nowak\",j@x,Submitted,,100.00,Yes,-,-,\n"
                 "\"Participant 103\",\"=Olu Ode\",o@x,Submitted,,100.00,Yes,-,-,\n"
                 "\"Participant 104\",\"Zoe Zola\",z@x,\"No submission\",,100.00,Yes,-,-,\n");
    const Ran ran = grade_in(folder, "class.zip --gradebook moodle --list list.csv --marks marks.csv");
    EXPECT_EQ(ran.code, 0) << ran.out;
    const std::string marks = text_of(folder / "marks.csv");
    const std::string plain =
        "\xEF\xBB\xBFIdentifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
        "Last modified (submission),Last modified (grade),Feedback comments\n";
    EXPECT_TRUE(marks.starts_with(plain)) << "Excel knows the encoding by the mark of the list: " << marks;
    EXPECT_NE(
        marks.find("\nParticipant 101,Anna Müller,a@x,Submitted,100,100.00,Yes,\"Monday, 5 October\",-,Passed: 10 "
                   "of 10 starts.\n"),
        std::string::npos)
        << marks << "\nthe time of the last grade must stay, or Moodle leaves the row out";
    EXPECT_NE(marks.find("\nParticipant 102,Jan Nowak,j@x,Submitted,0,100.00,Yes,-,-,\"0 of 10 starts passed"),
              std::string::npos)
        << marks;
    EXPECT_NE(marks.find("\nParticipant 103,=Olu Ode,o@x,Submitted,0,100.00,Yes,-,-,Not passed: "), std::string::npos)
        << marks;
    EXPECT_NE(marks.find("\nParticipant 104,Zoe Zola,z@x,No submission,,100.00,Yes,-,-,\n"), std::string::npos)
        << marks;
    EXPECT_NE(ran.out.find("marks: 3\nin the list without a graded hand-in: 1: Zoe Zola\n"), std::string::npos)
        << ran.out;
}

TEST(CtlGradebook, WhoHasNoHandInThatCanBeGradedReadsWhy) {
    const Folder folder;
    const auto in = [](const std::string& person, const std::string& file, const std::string& content) {
        return Zipped{person + "_assignsubmission_file_/" + file, content, true};
    };
    put_text(folder / "class.zip",
             zip_of({in("Müller Anna_101", "a.toml", handed_in("Anna", Work::solved)),
                     in("Müller Anna_101", "a.pdf", "%PDF-1.7"), in("Nowak Jan_102", "report.pdf", "%PDF-1.7"),
                     in("Ode Olu_103", "b.toml", ""), in("Park Soo_104", "c.toml", "format = 1\nstudent = \""),
                     in("Quinn Ed_105", "d.pdf", "%PDF-1.7")}));
    put_text(folder / "list.csv",
             "ID,Vollständiger Name,Bewertung,Feedback als Kommentar\nTeilnehmer/in101,Anna Müller,,\n"
             "Teilnehmer/in102,Jan Nowak,,\nTeilnehmer/in103,Olu Ode,,\nTeilnehmer/in104,Soo Park,,\n"
             "Teilnehmer/in105,Ed Quinn,3,bleibt\nTeilnehmer/in106,Zoe Zola,,\n");
    const Ran ran = grade_in(folder, "class.zip --gradebook moodle --list list.csv --marks marks.csv --lang de");
    const std::string marks = text_of(folder / "marks.csv");
    for (const char* line :
         {"101,Anna Müller,10,Bestanden: 10 von 10 Starts.\n",
          "102,Jan Nowak,,\"Nicht bewertet: report.pdf: keine Abgabe, sondern ein PDF.\"\n",
          "103,Olu Ode,,Nicht bewertet: b.toml: die Datei ist leer.\n",
          "104,Soo Park,,\"Nicht bewertet: c.toml:2: ", "105,Ed Quinn,3,bleibt\n", "106,Zoe Zola,,\n"})
        EXPECT_NE(marks.find(line), std::string::npos) << line << "\n" << marks;
    EXPECT_NE(ran.out.find("Bewertungen: 1\nin der Liste ohne bewertete Abgabe: 5: Jan Nowak; "), std::string::npos)
        << ran.out;
}

TEST(CtlGradebook, MessagesNameEverybodyInTheLanguage) {
    const Folder folder;
    put_class(folder);
    put_text(folder / "site" / "page.html", "<!DOCTYPE html>");
    std::string list = "Identifier,Full name,Grade\nParticipant 101,Anna,\n", names;
    for (int i = 200; i < 249; ++i) {
        list += "Participant " + std::to_string(i) + ",Person " + std::to_string(i) + ",\n";
        names += (names.empty() ? "" : "; ") + ("Person " + std::to_string(i));
    }
    put_text(folder / "list.csv", list);
    const std::string command = "class.zip site --gradebook moodle --list list.csv --marks marks.csv --lang ";
    const std::string folders =
        "class.zip/Nowak Jan_102_assignsubmission_file_/a.toml; "
        "class.zip/Ode Olu_103_assignsubmission_file_/a.toml";
    const std::string en = grade_in(folder, command + "en").out, de = grade_in(folder, command + "de").out;
    for (const std::string& line : {std::string("left out: site/page.html\n"), std::string("marks: 1\n"),
                                    "in the list without a graded hand-in: 49: " + names + "\n",
                                    "braitenctl: graded without a place in the list: 2: " + folders + "\n"})
        EXPECT_NE(en.find(line), std::string::npos) << line << "\n" << en;
    for (const std::string& line : {std::string("ausgelassen: site/page.html\n"), std::string("Bewertungen: 1\n"),
                                    "in der Liste ohne bewertete Abgabe: 49: " + names + "\n",
                                    "braitenctl: bewertet, aber nicht in der Liste: 2: " + folders + "\n"})
        EXPECT_NE(de.find(line), std::string::npos) << line << "\n" << de;
}

TEST(CtlGradebook, SaysWhoHandedInTheSameFileOrThatOfAnotherPerson) {
    const Folder folder;
    const std::string file = handed_in("John Smith", Work::solved);
    for (const char* person : {"Smith John_101", "Smith Jane_102"})
        put_text(folder / "s" / (std::string(person) + "_assignsubmission_file_") / "a.toml", file);
    put_text(folder / "s" / "Nowak Jan_103_assignsubmission_file_" / "a.toml", handed_in("Jan Nowak", Work::as_given));
    const std::string told = grade_in(folder, "s --gradebook csv --marks marks.csv").out;
    EXPECT_NE(told.find("the same file from several people, marked as others: 2: Smith Jane; Smith John\n"),
              std::string::npos)
        << told;
    EXPECT_NE(told.find("the file names another person, marked as others: 1: Smith Jane (John Smith)\n"),
              std::string::npos)
        << told;
}

TEST(CtlGradebook, ReadsTheWorksheetInSpanishWithDecimalCommas) {
    const Folder folder;
    put_class(folder);
    put_text(folder / "list.csv",
             "Identificador;Nombre completo;Calificación;Calificación máxima;Comentarios de retroalimentación\n"
             "Participante 101;Anna;;7,50;\nParticipante 102;Jan;;7,50;\nParticipante 103;Olu;;7,50;\n");
    const Ran ran = grade_in(folder, "class.zip --gradebook moodle --list list.csv --marks - --lang es");
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("\nParticipante 101;Anna;7,5;7,50;"), std::string::npos) << ran.out;
}

TEST(CtlGradebook, AMarkWithoutAPlaceInTheListIsAnError) {
    const Folder folder;
    put_class(folder);
    put_text(folder / "list.csv", "Identifier,Full name,Grade\nParticipant 101,Anna,\n");
    const Ran ran = grade_in(folder, "class.zip --gradebook moodle --list list.csv --marks marks.csv");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("graded without a place in the list: 2: Nowak Jan_102"), std::string::npos) << ran.out;
    EXPECT_NE(text_of(folder / "marks.csv").find("Participant 101,Anna,10\n"), std::string::npos);
}

TEST(CtlGradebook, WritesOneColumnForCanvas) {
    const Folder folder;
    put_text(folder / "c" / "muelleranna_101_99001_a.toml", handed_in("Anna", Work::solved));
    put_text(folder / "c" / "nowakjan_LATE_102_99002_a-1.toml", handed_in("Jan", Work::as_given));
    put_text(folder / "list.csv",
             "Student,ID,SIS User ID,SIS Login ID,Section,Essay (7),Aggressor (8),Final Score\n"
             "    Points Possible,,,,,10,20,(read only)\n"
             "\"Müller, Anna\",101,,am,G1,4,,40\n\"Nowak, Jan\",102,,jn,G1,5,3,50\n\"Zola, Zoe\",103,,zz,G1,6,,60\n");
    const std::string list = " --list list.csv --marks -";
    const Ran ran = grade_in(folder, "c --gradebook canvas --column Aggressor" + list);
    EXPECT_EQ(ran.code, 0) << ran.out;
    const std::string person = "Student,ID,SIS User ID,SIS Login ID,Section,";
    EXPECT_TRUE(ran.out.starts_with(person +
                                    "Aggressor (8)\n    Points Possible,,,,,20\n\"Müller, Anna\",101,,am,G1,20\n"
                                    "\"Nowak, Jan\",102,,jn,G1,0\n\"Zola, Zoe\",103,,zz,G1,\n"))
        << ran.out;
    const Ran fresh = grade_in(folder, "c --gradebook canvas --column New --points 5" + list);
    EXPECT_TRUE(fresh.out.starts_with(person + "New\n    Points Possible,,,,,5\n\"Müller, Anna\",101,,am,G1,5\n"))
        << fresh.out;
}

TEST(CtlGradebook, WritesTheStatusFileOfIlias) {
    const Folder folder;
    put_text(folder / "s" / "Mueller_Anna_am_101" / "a.toml", handed_in("Anna", Work::solved));
    put_text(folder / "s" / "Nowak_Jan_jn_102" / "a.toml", handed_in("Jan", Work::as_given));
    const std::string header =
        "update,usr_id,login,lastname,firstname,status,mark,notice,comment,plagiarism,plag_comment\n";
    const Ran ran = grade_in(folder, "s --gradebook ilias --marks -");
    EXPECT_TRUE(ran.out.starts_with(header +
                                    "1,101,am,Mueller,Anna,passed,10,,Passed: 10 of 10 starts.,,\n1,102,jn,Nowak,Jan,"))
        << ran.out;
    put_text(folder / "status.csv", header +
                                        "0,101,am,Mueller,Anna,notgraded,,,,,\n0,103,zz,Zola,Zoe,notgraded,,,,,\n"
                                        "0,102,jn,Nowak,Jan,notgraded,,late,,,\n");
    const Ran filled = grade_in(folder, "s --gradebook ilias --list status.csv --marks -");
    EXPECT_NE(filled.out.find("\n0,103,zz,Zola,Zoe,notgraded,,,,,\n1,102,jn,Nowak,Jan,failed,0,late,"),
              std::string::npos)
        << filled.out;
}

TEST(CtlGradebook, APlainTableNamesThoseWithoutAMarkAndTheReason) {
    const Folder folder;
    put_text(folder / "s" / "Mueller Anna_101_assignsubmission_file_" / "a.toml", handed_in("Anna", Work::solved));
    put_text(folder / "s" / "Mueller Anna_101_assignsubmission_file_" / "a.pdf", "%PDF");
    put_text(folder / "s" / "Nowak Jan_102_assignsubmission_file_" / "a.pdf", "%PDF");
    put_text(folder / "s" / "Zola Zoe_103_assignsubmission_file_" / "a.toml", "format = 1\nstudent\n");
    const Ran ran = grade_in(folder, "s --gradebook csv --marks marks.csv");
    const std::string marks = text_of(folder / "marks.csv");
    EXPECT_EQ(std::count(marks.begin(), marks.end(), '\n'), 4) << marks;
    EXPECT_NE(marks.find("\nNowak Jan,102,Nowak Jan_102_assignsubmission_file_,,10,,"), std::string::npos) << marks;
    EXPECT_NE(marks.find("PDF"), std::string::npos);
    EXPECT_NE(marks.find("a.toml:2: cannot be read here"), std::string::npos)
        << "not in words of the parser: " << marks;
    EXPECT_EQ(marks.find("TOML:"), std::string::npos) << marks;
    EXPECT_NE(ran.out.find("2: Nowak Jan; Zola Zoe"), std::string::npos) << ran.out;
}

TEST(CtlGradebook, ATableForIliasNeedsItsListWhereTheNamesAreOfAnotherPlatform) {
    const Folder folder;
    put_text(folder / "s" / "Mueller Anna_101_assignsubmission_file_" / "a.toml", handed_in("Anna", Work::solved));
    const Ran ran = grade_in(folder, "s --gradebook ilias --marks marks.csv");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("--list"), std::string::npos) << ran.out;
    EXPECT_FALSE(fs::exists(folder / "marks.csv"));
}

TEST(CtlGradebook, AListMustBeUtf8) {
    const Folder folder;
    put_class(folder);
    put_text(folder / "list.csv", "Identifier,Full name,Grade\nParticipant 101,M\xFCller Anna,\n");
    const Ran ran = grade_in(folder, "class.zip --gradebook moodle --list list.csv --marks marks.csv");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("list.csv: is not in UTF-8"), std::string::npos) << ran.out;
}

TEST(CtlGradebook, FindsPeopleByNameWhereTheFilesHaveNoNumber) {
    const Folder folder;
    put_text(folder / "c" / "1.toml", handed_in("Anna Mueller", Work::solved));
    put_text(folder / "c" / "2.toml", handed_in("Jan Nowak", Work::solved));
    put_text(folder / "list.csv",
             "Identifier,Full name,Grade\nParticipant 1,\"Müller, Anna\",\nParticipant 2,Jan Nowak,\n"
             "Participant 3,Jan Nowak,\n");
    const Ran ran = grade_in(folder, "c --gradebook moodle --list list.csv --marks marks.csv");
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("graded without a place in the list: 1: 2.toml"), std::string::npos)
        << "two people have this name: " << ran.out;
    EXPECT_NE(text_of(folder / "marks.csv").find("Participant 1,\"Müller, Anna\",10\n"), std::string::npos) << ran.out;
}

TEST(CtlGradebook, SaysWhatIsMissing) {
    const Folder folder;
    put_class(folder);
    put_text(folder / "list.csv", "a,b\n1,2\n");
    const auto says = [&](const std::string& arguments, const std::string& words) {
        const Ran ran = grade_in(folder, "class.zip " + arguments);
        EXPECT_EQ(ran.code, 2) << arguments;
        EXPECT_NE(ran.out.find(words), std::string::npos) << ran.out;
    };
    says("--gradebook moodle --marks m.csv", "export it and give it with --list");
    says("--gradebook moodle", "--marks FILE");
    says("--gradebook modle --marks m.csv", "there is no platform 'modle'; the nearest is 'moodle'");
    says("--gradebook canvas --list list.csv --marks m.csv", "list.csv: this is not the list");
    says("--marks m.csv", "belong to --gradebook");
    EXPECT_FALSE(fs::exists(folder / "m.csv"));
}

TEST(CtlGradebook, APlainTableNeedsNoList) {
    const Folder folder;
    put_class(folder);
    const Ran ran = grade_in(folder, "class.zip --gradebook csv --points 100 --marks -");
    EXPECT_EQ(ran.code, 0);
    EXPECT_TRUE(
        ran.out.starts_with("student,id,folder,mark,points,passed,solution_shown,feedback\nMüller Anna,101,Müller "
                            "Anna_101_assignsubmission_file_,100,100,yes,no,Passed: 10 of 10 starts.\n"))
        << ran.out;
    EXPECT_EQ(ran.out.find("with the solution shown"), std::string::npos) << ran.out;
}

// A pass after the lab has set the solution is a pass, and is said: in the feedback, the table and on standard error.
TEST(CtlGradebook, APassWithTheSolutionShownIsSaid) {
    const Folder folder;
    const auto exercise = load_exercise(*find_shipped("05-aggressor"));
    HandIn made{.student = "Anna", .exercise = "05-aggressor", .solution_shown = true};
    made.submission = with_solution(*exercise);
    put_text(folder / "s" / "Mueller_Anna_am_101" / "a.toml", write_hand_in(made));
    put_text(folder / "s" / "Nowak_Jan_jn_102" / "a.toml", handed_in("Jan", Work::solved));
    put_text(folder / "grades.csv", "Student,ID,SIS User ID,SIS Login ID,Section\n\"Mueller, Anna\",101,,am,G1\n");
    const std::string told = "Passed: 10 of 10 starts. The lab had shown the solution.";
    for (const char* platform : {"ilias", "csv", "canvas --list grades.csv"}) {
        const Ran ran = grade_in(folder, std::string("s --marks - --gradebook ") + platform + " 2>&1");
        EXPECT_NE(ran.out.find("passed with the solution shown, marked as others: 1: Mueller Anna"), std::string::npos)
            << ran.out;
        if (std::string(platform).starts_with("canvas")) continue;  // takes no feedback
        EXPECT_NE(ran.out.find(told), std::string::npos) << ran.out;
    }
    EXPECT_NE(grade_in(folder, "s --marks - --gradebook csv").out.find(",yes,yes,Passed"), std::string::npos);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_gradebook_test
