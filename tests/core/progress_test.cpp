#include "core/lesson/progress.h"

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "tests/tells.h"

namespace braitenlab::tests::progress_test {
namespace {

StudentProgress anna() {
    const auto exercise =
        load_exercise(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/05-aggressor.toml");
    EXPECT_TRUE(exercise);
    StudentProgress made{"Anna Müller", {}};
    made.exercises["05-aggressor"] = {
        true, true, 9, 10, 3, "It turns away", true, true, "Line one,\n\"two\"", exercise->solution.submission};
    made.exercises["06-love"] = {.hints = 1};
    return made;
}

TEST(Progress, IsReadAsItWasWritten) {
    const auto read = read_progress(write_progress(anna()), "anna.json");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, anna());
    EXPECT_EQ(passed_count(*read), 1);
    EXPECT_EQ(find_progress(*read, "05-aggressor")->best, 9);
    EXPECT_EQ(find_progress(*read, "01-drive"), nullptr);
}

TEST(Progress, OfABrokenFileIsAnErrorWithFileAndLine) {
    const auto cut = read_progress("{\n \"format\": 1,\n \"student\": ", "anna.json");
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().file, "anna.json");
    EXPECT_EQ(cut.error().line, 3);
    for (const char* text : {"", "[]", "{}", "{\"format\": 2, \"exercises\": {}}", "{\"format\": 1}",
                             "{\"format\": 1, \"exercises\": {\"a\": 3}}",
                             "{\"format\": 1, \"exercises\": {\"a\": {\"best\": \"x\"}}}", "nonsense"})
        EXPECT_FALSE(read_progress(text, "f")) << text;
}

TEST(Progress, ClampsItsNumbersAndDropsASubmissionOfAnotherVersion) {
    const auto read = read_progress(
        R"({"format": 1, "exercises": {"a": {"best": 99, "starts": 10, "hints": -4, "new": 1, "submission": {}}}})",
        "f");
    ASSERT_TRUE(read) << read.error().text();
    const ExerciseProgress& a = read->exercises.at("a");
    EXPECT_EQ(a.best, 10);
    EXPECT_EQ(a.hints, 0);
    EXPECT_FALSE(a.submission);
}

TEST(Progress, HasATableOfAllStudents) {
    const std::string csv = progress_csv({StudentProgress{}, anna()});
    EXPECT_EQ(csv,
              "student,exercise,passed,solution_shown,best_starts,starts,hints,prediction,predicted_right,notes\n"
              "Anna Müller,05-aggressor,1,1,9,10,3,It turns away,1,\"Line one,\n\"\"two\"\"\"\n"
              "Anna Müller,06-love,0,0,0,0,1,,0,\n");
}

TEST(Progress, TheTableHasNoFormulasForASpreadsheet) {
    StudentProgress student{"=SUM(A1)", {}};
    student.exercises["05-aggressor"].notes = " -1+1";
    const std::string csv = progress_csv({student});
    EXPECT_NE(csv.find("\n'=SUM(A1),05-aggressor,"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",' -1+1\n"), std::string::npos) << csv;
}

TEST(Progress, TakesANameWithoutBlanksAtItsEndsAndOnce) {
    StudentBook book;
    book.all.push_back({"Anna", {}});
    EXPECT_EQ(tidy_student_name("  Ben\tB \n"), "Ben B");
    EXPECT_EQ(tidy_student_name(" \n"), "");
    EXPECT_LE(tidy_student_name(std::string(61, 'a') + "ü").size(), longest_student_name);
    EXPECT_TRUE(is_free_name(book, "Ben"));
    EXPECT_FALSE(is_free_name(book, " Anna "));
    EXPECT_FALSE(is_free_name(book, "anna")) << "the same student for hand-ins";
    EXPECT_FALSE(is_free_name(book, "  "));
}

TEST(Progress, CutsLongNotesBetweenTwoCharactersAndRefusesATooLargeFile) {
    StudentProgress student = anna();
    student.exercises["06-love"].notes = std::string(longest_notes - 1, 'n') + "ü";
    const auto read = read_progress(write_progress(student), "f");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->exercises.at("06-love").notes, std::string(longest_notes - 1, 'n'));
    const auto large = read_progress(write_progress(student) + std::string(std::size_t{17} << 20U, ' '), "f");
    ASSERT_FALSE(large);
    EXPECT_TRUE(tells(large.error(), message_of("too_large", 16)));
}

TEST(Progress, OfTwoWindowsIsMergedByExercise) {
    const StudentProgress before = anna();
    StudentProgress ours = before, theirs = before;
    ours.exercises["01-drive"].notes = "mine";
    ours.exercises.erase("06-love");
    theirs.exercises["02-circle"] = {.passed = true, .best = 8, .starts = 10};
    StudentProgress both = merged_progress(before, ours, theirs);
    EXPECT_EQ(both.name, "Anna Müller");
    EXPECT_EQ(both.exercises.size(), 3u);
    EXPECT_EQ(both.exercises["01-drive"].notes, "mine");
    EXPECT_EQ(both.exercises["02-circle"].best, 8);
    EXPECT_FALSE(both.exercises.contains("06-love")) << "only one window has changed it";
    theirs.exercises["06-love"].hints = 4;
    EXPECT_EQ(merged_progress(before, ours, theirs).exercises["06-love"].hints, 4) << "a change is kept";
    EXPECT_EQ(merged_progress(before, theirs, ours).exercises["06-love"].hints, 4);
}

TEST(Progress, OfOneExerciseInTwoWindowsKeepsThePassAndTheLargerNumbers) {
    const StudentProgress before{"Ben", {{"a", {.best = 2, .starts = 10, .notes = "old"}}}};
    StudentProgress ours = before, theirs = before;
    ours.exercises["a"] = {.passed = true, .best = 9, .starts = 10, .hints = 1, .notes = "old"};
    theirs.exercises["a"] = {.shown = true, .best = 3, .starts = 10, .hints = 3, .prediction = "left", .notes = "new"};
    for (const auto& [one, other] : {std::pair{ours, theirs}, std::pair{theirs, ours}}) {
        const ExerciseProgress both = merged_progress(before, one, other).exercises.at("a");
        EXPECT_TRUE(both.passed);
        EXPECT_FALSE(both.shown) << "it was passed without the solution";
        EXPECT_EQ(both.best, 9);
        EXPECT_EQ(both.hints, 3);
        EXPECT_EQ(both.prediction, "left");
        EXPECT_EQ(both.notes, "new");
    }
    theirs.exercises["a"].notes = "theirs", ours.exercises["a"].notes = "ours";
    EXPECT_EQ(merged_progress(before, ours, theirs).exercises.at("a").notes, "ours\ntheirs");
}

TEST(Progress, OfNotesInTwoWindowsHasTheWordsOfBothOnce) {
    struct Case {
        std::string before, ours, theirs, both;
    };
    const std::vector<Case> cases{
        {"", "ours", "theirs", "ours\ntheirs"},
        {"old", "old ours", "old theirs", "old ours\ntheirs"},
        {"old", "old ours", "old ours\ntheirs", "old ours\ntheirs"},  // it has taken ours over
        {"old", "old ours\ntheirs", "old theirs", "old ours\ntheirs"},
        {"ours", "ours too", "theirs\nours", "ours too\ntheirs"},
        {"the cat sat", "the cat sat down", "the cow sat", "the cat sat down\ncow"},
        {"old", "old ours", "", "old ours"},
        {"", "13 cm", "3 cm", "13 cm\n3 cm"},
        {"3 m", "3 m", "4 m", "4 m"},
        {"", "grö", "grü", "grö\ngrü"},
    };
    for (const Case& each : cases) {
        const auto with = [](const std::string& notes) { return StudentProgress{"Ben", {{"a", {.notes = notes}}}}; };
        const StudentProgress both = merged_progress(with(each.before), with(each.ours), with(each.theirs));
        EXPECT_EQ(both.exercises.at("a").notes, each.both) << each.before << " | " << each.ours << " | " << each.theirs;
    }
    const std::string full(longest_notes - 1, 'n');
    const StudentProgress ours{"Ben", {{"a", {.notes = full}}}}, theirs{"Ben", {{"a", {.notes = "ü"}}}};
    EXPECT_EQ(merged_progress({"Ben", {}}, ours, theirs).exercises.at("a").notes, full + "\n");
}

}  // namespace
}  // namespace braitenlab::tests::progress_test
