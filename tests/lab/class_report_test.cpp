#include "app/reports/class_report.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "core/brain/four_neurons.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"
#include "tests/folder.h"
#include "tests/languages.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::class_report_test {
namespace {

std::shared_ptr<const Exercise> aggressor() {
    static const auto loaded = std::make_shared<const Exercise>(*load_exercise(*find_shipped("05-aggressor")));
    return loaded;
}

HandIn hand_in(const std::string& student, BrainGraph brain, const std::string& written = "") {
    HandIn made{.student = student, .exercise = "05-aggressor", .written = written};
    made.submission = with_brain(*aggressor(), std::move(brain));
    return made;
}

ClassRow row(const std::string& file, const HandIn& made) {
    return row_of_hand_in(*aggressor(), file, write_hand_in(made));
}

// The report of these rows, graded.
ClassReport graded(std::vector<ClassRow> rows) {
    mark_replaced(rows);
    const Exercise& exercise = *aggressor();
    static const Grade shipped = grade(exercise, as_shipped(exercise));
    static const std::vector<Grade> wrong = [&] {
        std::vector<Grade> grades;
        for (const Answer& answer : exercise.wrong) grades.push_back(grade(exercise, answer.submission));
        return grades;
    }();
    for (ClassRow& each : rows)
        if (each.submission) judge(exercise, each, grade(exercise, *each.submission), shipped, wrong);
    return {aggressor(), 1, std::move(rows)};
}

// The table row of the student in the page.
std::string line_of(const std::string& page, const std::string& student) {
    const std::size_t name = page.find(">" + student + "</a>");
    if (name == page.npos) return "";
    const std::size_t begin = page.rfind("<tr", name);
    return page.substr(begin, page.find("</tr>", name) - begin);
}

const BrainGraph good = make_graph({.LR = 1.4f, .RL = 1.4f, .LM = 0.1f, .RM = 0.1f});
const BrainGraph four_wires = make_graph({.LL = 1.4f, .LR = 1.4f, .RL = 1.4f, .RR = 1.4f, .LM = 0.1f, .RM = 0.1f});
const BrainGraph as_at_first = make_graph({.LL = 1.5f, .RR = 1.5f, .LM = 0.1f, .RM = 0.1f});

}  // namespace

TEST(ClassReport, AHandInWithoutTheTablesOfItsSensorsIsNotGraded) {
    HandIn made = hand_in("A", good);
    made.submission.sensors.clear();
    const ClassReport report = graded({row("a", made), row("b", hand_in("B", good))});
    ASSERT_TRUE(report.rows[0].problem);
    EXPECT_EQ(report.rows[0].problem->key, "report.no_sensors");
    EXPECT_FALSE(report.rows[0].grade);
    EXPECT_FALSE(report.rows[1].problem);
}

TEST(ClassReport, ANameOfAFolderInDecomposedLettersIsTheSameName) {
    for (const char* folder : {"M\u00FCller Anna", "Mu\u0308ller Anna"}) {
        ClassRow made = row("a", hand_in("Anna M\u00FCller", good));
        made.submitter.name = folder;
        EXPECT_EQ(other_name(made), "") << folder;
    }
}

TEST(ClassReport, TheTextOfAWrongAnswerIsSaidOnlyOfABrainWithItsWires) {
    ClassReport report = graded({row("b", hand_in("B", four_wires))});
    ClassRow& like = report.rows[0];
    ASSERT_TRUE(like.resembles);
    const std::string text = aggressor()->wrong[*like.resembles].text;
    for (const std::string& language : shipped_codes()) {
        const Strings& strings = speaking(language);
        like.submission->brain = four_wires;
        EXPECT_TRUE(has_wires_of_mistake(report, like));
        EXPECT_NE(feedback(report, like, strings).find(strings.find(text, text)), std::string::npos);
        like.submission->brain = make_graph({.LR = 1.4f, .LM = 0.1f, .RM = 0.1f});
        EXPECT_FALSE(has_wires_of_mistake(report, like));
        const std::string other = feedback(report, like, strings);
        EXPECT_EQ(other.find(strings.find(text, text)), std::string::npos) << other;
        EXPECT_NE(other.find(strings("report.alike_with_other_wires")), std::string::npos) << other;
        like.submission->brain = make_graph({.LL = 1.4f, .LR = 1.4f, .RL = -1.4f, .RR = 1.4f});
        EXPECT_FALSE(has_wires_of_mistake(report, like)) << "another sign is another wire";
    }
}

TEST(ClassReport, ARowSaysWhatTheBehaviourResembles) {
    const ClassReport report =
        graded({row("a", hand_in("A", good)), row("b", hand_in("B", four_wires)), row("c", hand_in("C", as_at_first))});
    EXPECT_TRUE(report.rows[0].passed);
    EXPECT_EQ(report.rows[0].grade->count, 10);
    EXPECT_FALSE(report.rows[0].resembles);
    EXPECT_EQ(feedback(report, report.rows[0], speaking("en")), "Passed: 10 of 10 starts.");
    EXPECT_FALSE(report.rows[1].passed);
    ASSERT_TRUE(report.rows[1].resembles);
    EXPECT_EQ(aggressor()->wrong[*report.rows[1].resembles].name, "all four wires");
    const std::string said = feedback(report, report.rows[1], speaking("en"));
    EXPECT_NE(said.find("0 of 10 starts passed, 8 are needed. It behaves like this wrong answer: Each eye now drives "
                        "both wheels alike"),
              said.npos)
        << said;
    EXPECT_NE(said.find("Step 1 (“It turns towards the lamp”) is not done in 10 of 10 starts. Start 1: best"),
              said.npos)
        << said;
    EXPECT_TRUE(report.rows[2].unchanged);
    const std::string as_shipped = feedback(report, report.rows[2], speaking("en"));
    EXPECT_NE(as_shipped.find("It behaves as it did at first: change the offered controls. Step "), as_shipped.npos)
        << as_shipped;
    EXPECT_NE(as_shipped.find("of 10 starts. Start 1: "), as_shipped.npos) << as_shipped;
}

TEST(ClassReport, AHandInFromACopyOfTheFileOfTheExerciseCounts) {
    HandIn copied = hand_in("A", good);
    copied.exercise = "05-aggressor (1)";
    const ClassRow made = row("a", copied);
    EXPECT_FALSE(made.problem);
    EXPECT_TRUE(made.submission);
}

TEST(ClassReport, FeedbackTellsAnEditWithoutEffectFromNoEdit) {
    BrainGraph nearly = as_at_first;
    for (Wire& wire : nearly.wires) wire.weight += 0.01f;
    const ClassReport report = graded({row("a", hand_in("A", as_at_first)), row("b", hand_in("B", nearly))});
    for (const ClassRow& each : report.rows) EXPECT_TRUE(each.unchanged);
    const std::string of_none = feedback(report, report.rows[0], speaking("en")),
                      of_small = feedback(report, report.rows[1], speaking("en"));
    EXPECT_NE(of_none.find("as it did at first: change the offered controls"), std::string::npos) << of_none;
    EXPECT_NE(of_small.find("as it did at first, although the controls are not where they were"), std::string::npos)
        << of_small;
}

// The exercise with a wrong answer that behaves as the shipped brain does: a sensor sees a little further.
TEST(ClassReport, AWrongAnswerWhoseSensorsDifferWinsOverTheShippedBrain) {
    Exercise exercise = *aggressor();
    Answer& far_eyes = exercise.wrong.emplace_back();
    far_eyes.name = "Far eyes";
    far_eyes.submission = as_shipped(exercise);
    for (Sensor& sensor : far_eyes.submission.sensors) sensor.range += 0.001f;
    HandIn made = hand_in("A", as_at_first);
    made.submission = far_eyes.submission;
    ClassRow same = row("a", made), exact = same;
    made.submission.sensors[0].range += 0.002f;  // like it, and not it
    ClassRow alike = row("b", made);
    const Grade shipped = grade(exercise, as_shipped(exercise)), wrong = grade(exercise, far_eyes.submission);
    std::vector<Grade> grades(exercise.wrong.size() - 1, grade(exercise, exercise.wrong[0].submission));
    grades.push_back(wrong);
    for (ClassRow* each : {&same, &alike}) {
        each->problem.reset();
        judge(exercise, *each, grade(exercise, *each->submission), shipped, grades);
    }
    EXPECT_EQ(same.resembles, exercise.wrong.size() - 1);
    EXPECT_FALSE(same.unchanged);
    EXPECT_TRUE(alike.unchanged || alike.resembles) << "it is near both";
    exact.problem.reset();
    judge(exercise, exact, wrong, wrong, grades);
    EXPECT_EQ(exact.resembles, exercise.wrong.size() - 1) << "the shipped brain has the same grade";
    EXPECT_FALSE(exact.unchanged);
}

TEST(ClassReport, EveryStudentWhoFailsIsInOneRowOfTheMistakes) {
    std::vector<ClassRow> rows(4);
    rows[0].passed = true;
    rows[1].unchanged = true;
    rows[2].resembles = 0;
    for (ClassRow& each : rows) each.grade = Grade{};
    const ClassSummary summary = summary_of({aggressor(), 1, rows});
    EXPECT_EQ(summary.counted, 4);
    EXPECT_EQ(summary.other, 1) << "the one that resembles nothing";
    EXPECT_EQ(summary.passed + summary.unchanged + summary.resembling[0] + summary.other, summary.counted);
    const std::string page = class_page({aggressor(), 1, rows}, speaking("en"), "en");
    EXPECT_NE(page.find("<td>something else</td>"), page.npos);
}

TEST(ClassReport, AnEmptyFileAndADocumentAreNamedAsSuch) {
    const ClassRow empty = row_of_hand_in(*aggressor(), "e.toml", Result<std::string>(std::string(" \r\n")));
    EXPECT_EQ(problem_text(empty, speaking("en")), "the file is empty");
    const ClassRow essay = row_of_other_file("essay.docx");
    EXPECT_EQ(problem_text(essay, speaking("de")), "keine Abgabe");
    EXPECT_EQ(essay.student, "essay");
}

TEST(ClassReport, ARowThatDoesNotCountSaysWhy) {
    HandIn other = hand_in("D", good);
    other.exercise = "06-love";
    HandIn wide = hand_in("E", good);
    wide.submission.sensors[0].range = 30;
    ClassRow broken = row_of_hand_in(*aggressor(), "f", Result<std::string>(std::string("format = 1\nstudent = \"")));
    const ClassReport report =
        graded({row("a", hand_in("A", four_wires, "2026-01-01T00:00:00Z")),
                row("b", hand_in(" a", good, "2026-01-02T00:00:00Z")), row("d", other), row("e", wide), broken});
    const auto problem = [&](std::size_t i) { return problem_text(report.rows[i], speaking("en")); };
    EXPECT_EQ(problem(0), "replaced by a later hand-in: b");
    EXPECT_EQ(problem(1), "");
    EXPECT_EQ(problem(2), "hand-in for another exercise: 06-love");
    EXPECT_EQ(problem(3), "");
    EXPECT_TRUE(problem(4).starts_with("f:2: the file ends early")) << problem(4);
    const ClassSummary summary = summary_of(report);
    EXPECT_EQ(summary.counted, 2);
    EXPECT_EQ(summary.passed, 1);
}

TEST(ClassReport, TheFeedbackOnAValueOutsideItsRangeNamesTheFileAsTheStudentKnowsIt) {
    std::string text = write_hand_in(hand_in("Olu", good));
    const std::size_t at = text.find("LR = ") + 5;
    text.replace(at, text.find('\n', at) - at, "9");
    const ClassReport report{aggressor(), 1, {row_of_hand_in(*aggressor(), "Olu_103_file_/a.toml", text)}};
    ASSERT_TRUE(report.rows[0].refusal);
    for (const std::string& code : shipped_codes()) {
        const Strings strings = speaking(code);
        const std::string told = feedback(report, report.rows[0], strings), start(strings("report.refused_value"));
        EXPECT_TRUE(told.starts_with(start.substr(0, start.find("{}")) + "a.toml:")) << told;
        EXPECT_EQ(told.find("Olu_103"), told.npos) << told;
    }
}

TEST(ClassReport, WhoChangesWhatIsNotOfferedFailsAndIsCountedEverywhere) {
    HandIn wide = hand_in("Eva", good);
    wide.submission.sensors[0].range = 30;
    const ClassReport report = graded({row("a", hand_in("Ana", good)), row("e", wide)});
    const std::string told = feedback(report, report.rows[1], speaking("en"));
    EXPECT_EQ(
        told,
        "Not passed: the hand-in changes what the exercise does not offer: sensors. Begin again from the exercise "
        "as it is given.");
    EXPECT_FALSE(report.rows[1].passed);
    const ClassSummary summary = summary_of(report);
    EXPECT_EQ(summary.counted, 2);
    EXPECT_EQ(summary.passed, 1);
    EXPECT_EQ(summary.refused, 1);
    EXPECT_EQ(summary.other, 0) << "once in the table of mistakes";
    const std::string csv = class_csv(report, speaking("en"));
    EXPECT_NE(csv.find("\nEva,,,e,no,"), csv.npos) << csv;
    EXPECT_NE(csv.find(told + ",\n"), csv.npos) << "feedback and no error: " << csv;
    const std::string page = class_page(report, speaking("en"), "en");
    EXPECT_NE(page.find("<td>not offered</td>"), page.npos);
    EXPECT_NE(line_of(page, "Eva").find("<td class=\"bad\">no</td>"), page.npos) << line_of(page, "Eva");
    EXPECT_NE(line_of(page, "Eva").find("does not offer: sensors"), page.npos) << line_of(page, "Eva");
}

TEST(ClassReport, TwoPeopleInTwoFoldersMayHaveOneName) {
    const auto in = [](const std::string& folder, const std::string& person, HandIn made) {
        const Submitter submitter{folder, "", "", person};
        return row_of_hand_in(*aggressor(), folder + "/a.toml", write_hand_in(std::move(made)), submitter);
    };
    const HandIn first = hand_in("Anna Müller", good, "2026-01-01T00:00:00Z"),
                 later = hand_in("Anna Müller", four_wires, "2026-01-02T00:00:00Z");
    for (const bool is_told : {false, true}) {
        const ClassReport two =
            graded({in("one", is_told ? "A_1" : "", first), in("two", is_told ? "A_2" : "", later)});
        EXPECT_TRUE(two.rows[0].passed);
        EXPECT_FALSE(two.rows[0].problem) << "not replaced by another person";
        EXPECT_EQ(summary_of(two).counted, 2);
    }
    HandIn renamed = later;
    renamed.student = "A. M.";
    const ClassReport one = graded({in("file", "A_1", first), in("again", "A_1", renamed)});
    EXPECT_TRUE(is_superseded(one.rows[0])) << "one person of the platform, whatever is typed";
}

TEST(ClassReport, OneFileOfTwoPeopleIsMarked) {
    HandIn copied = hand_in("Ben", good, "2026-01-01T10:00:00Z");
    const HandIn original = hand_in("Ana", good, "2026-01-01T10:00:00Z");
    std::vector<ClassRow> rows{row("a", original), row("b", copied), row("c", hand_in("Eva", good)),
                               row("d", hand_in("Zoe", good))};
    mark_same(rows);
    EXPECT_EQ(rows[0].same_as, "b");
    EXPECT_EQ(rows[1].same_as, "a") << "it differs by the name alone";
    EXPECT_EQ(rows[2].same_as, "") << "the same brain, found by two students";
    const ClassReport report = graded(rows);
    EXPECT_TRUE(report.rows[1].passed) << "the lecturer decides";
    const std::string page = class_page(report, speaking("en"), "en");
    EXPECT_NE(line_of(page, "Ben").find("<td class=\"bad\">the same file as a</td>"), page.npos)
        << line_of(page, "Ben");
    EXPECT_NE(class_csv(report, speaking("en")).find("2026-01-01T10:00:00Z,,,,a,Passed"), std::string::npos);
}

TEST(ClassReport, ANameInTheFileIsNotedIfItIsNotThePersonsOnThePlatform) {
    struct Named {
        const char *platform, *file;
        bool is_other;
    };
    for (const Named& each : {Named{"Müller Anna", "Anna Müller", false},
                              {"Mueller Anna", "ANNA  Müller", false},
                              {"Müller Anna", "Muller", false},
                              {"muelleranna", "Müller, Anna", false},
                              {"Müller Anna", "Anna", false},
                              {"Nowak Jan", "Anna Müller", true},
                              {"Müller Jan", "Anna Müller", true},
                              {"", "Anna Müller", false}}) {
        const ClassRow made = row_of_hand_in(*aggressor(), "a.toml", write_hand_in(hand_in(each.file, good)),
                                             {"f", "7", each.platform, "p"});
        EXPECT_EQ(other_name(made), each.is_other ? each.file : "") << each.platform << " " << each.file;
        const std::string person = *each.platform ? each.platform : each.file;
        EXPECT_EQ(made.student, person);
        for (const auto& [language, name] : shipped_languages()) {
            const std::string page = class_page({aggressor(), 1, {made}}, speaking(language), language);
            const std::string note = fill(speaking(language)("report.other_name"), {each.file});
            EXPECT_EQ(line_of(page, person).find(note) != page.npos, each.is_other)
                << language << line_of(page, person);
            EXPECT_EQ(xml_fault(page), "") << language;
        }
    }
}

TEST(ClassReport, TheSummaryHasQuartilesAndTheStepThatFailedMost) {
    std::vector<ClassRow> rows;
    for (const int passed : {0, 2, 4, 10}) {
        ClassRow made{.file = "x"};
        Grade grades;
        for (int start = 0; start < 10; ++start) {
            StartResult& result = grades.starts.emplace_back();
            result.passed = start < passed;
            result.verdicts = std::vector<Verdict>(3, Verdict{.done = true});
            result.verdicts[1].done = result.passed;
        }
        grades.count = passed;
        made.grade = grades;
        rows.push_back(made);
    }
    const ClassSummary summary = summary_of({aggressor(), 1, rows});
    EXPECT_EQ(summary.starts.median, 3);
    EXPECT_EQ(summary.starts.lower, 1.5);
    EXPECT_EQ(summary.starts.upper, 5.5);
    EXPECT_EQ(summary.worst_step, 1u);
    EXPECT_EQ(summary.failed[1], 24);
}

TEST(ClassReport, TheTableIsSafeForSpreadsheets) {
    HandIn made = hand_in("=HYPERLINK(\"http://x\")", good);
    made.prediction = 1, made.hints = 2;
    const std::string csv = class_csv(graded({row("+a,b.toml", made)}), speaking("en"));
    const std::size_t second = csv.find('\n') + 1;
    EXPECT_TRUE(
        csv.substr(second).starts_with("\"'=HYPERLINK(\"\"http://x\"\")\",,,\"'+a,b.toml\",yes,10,10,8,10,10,10,yes,"))
        << csv;
    EXPECT_NE(csv.find(",yes,2,0,no,,,,,,,,Passed: 10 of 10 starts.,\n"), csv.npos) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
}

TEST(ClassReport, ThePageIsWellFormedAndEscapesNames) {
    HandIn made = hand_in("<script>alert(1)</script>", four_wires);
    made.notes = "a < b\n&";
    for (const auto& [language, name] : shipped_languages()) {
        const std::string page =
            class_page(graded({row("a", made), row("b", hand_in("B", good))}), speaking(language), language);
        EXPECT_EQ(xml_fault(page), "") << language;
        EXPECT_EQ(page.find("<script>alert"), page.npos);
        EXPECT_EQ(page.find("report."), page.npos) << "a text is missing in " << language;
        EXPECT_EQ(page.find("{}"), page.npos) << "a gap is left";
    }
}

TEST(ClassReport, ASpreadsheetTakesAFormulaAfterSpacesAsText) {
    HandIn made = hand_in("A", good);
    made.student = "  @sum";
    const std::string csv = class_csv(graded({row("a", made)}), speaking("en"));
    EXPECT_NE(csv.find("\n'  @sum,,,a,yes"), csv.npos) << csv;
}

TEST(ClassReport, TheTableHasTheStartsThatPassedInTheStudentsOwnLab) {
    HandIn made = hand_in("A", good);
    made.graded_starts = 10, made.passed_starts = 4;
    const std::string csv = class_csv(graded({row("a", made)}), speaking("en"));
    EXPECT_NE(csv.find(",0,0,no,4,yes,,,,"), csv.npos) << csv;
}

TEST(ClassReport, ARowThatChangesTooManyControlsDoesNotPass) {
    const Exercise overrun = *load_exercise(*find_shipped("08-overrun"));
    ASSERT_EQ(overrun.changes, 1);
    HandIn made{.student = "A", .exercise = "08-overrun"};
    made.submission = as_shipped(overrun);
    for (const Offer& offer : offered_dials(overrun))
        for (const Dial dial : offer.dials) turn(made.submission.brain, dial, 0.25f);
    ASSERT_TRUE(outside_offers(overrun, made.submission).empty());
    ASSERT_GT(changed_controls(overrun, made.submission), 1);
    ClassRow wide = row_of_hand_in(overrun, "a", write_hand_in(made));
    const Grade shipped = grade(overrun, as_shipped(overrun));
    judge(overrun, wide, grade(overrun, *wide.submission), shipped, {});
    ASSERT_TRUE(wide.refusal);
    EXPECT_EQ(wide.refusal->key, "report.too_many");
    EXPECT_EQ(wide.refusal->value, "1");
    EXPECT_FALSE(wide.passed);
}

namespace {

// The words of the language and of the exercise, as `braitenctl grade --lang` reads them.
Strings words_with_exercise(const std::string& language) {
    Strings strings = speaking(language);
    add_translations(strings, texts_of(*aggressor()),
                     *Strings::load(std::string(BRAITENLAB_SOURCE) + "/exercises/words/" + language + ".toml"));
    return strings;
}

}  // namespace

TEST(ClassReport, NamesOfWrongAnswersAreInTheLanguageOfTheReport) {
    const ClassReport report = graded({row("b", hand_in("B", four_wires))});
    const std::string page = class_page(report, words_with_exercise("de"), "de");
    EXPECT_NE(line_of(page, "B").find("alle vier Leitungen"), std::string::npos) << line_of(page, "B");
    EXPECT_EQ(page.find("all four wires"), page.npos);
}

TEST(ClassReport, FaultsOfAHandInAreInTheLanguageOfTheReport) {
    const auto problem = [](const std::string& text) {
        return problem_text(row_of_hand_in(*aggressor(), "f", Result<std::string>(text)), speaking("de"));
    };
    EXPECT_NE(problem("format = 1\nexercise = \"05-aggressor\"\n").find("'student' fehlt"), std::string::npos);
    EXPECT_NE(problem("format = 1\nstudent = \" \"\nexercise = \"a\"\n[submission.brain]\n").find("ist leer"),
              std::string::npos);
    EXPECT_NE(problem("format = 1\nstudent = \"A\"\nexercise = \"a\"\npassed_starts = 2\n[submission.brain]\n")
                  .find("größer als 'graded_starts'"),
              std::string::npos);
}

TEST(ClassReport, ASupersededHandInIsGreyAndNoFailure) {
    const ClassReport report = graded({row("a", hand_in("Ana", four_wires, "2026-01-01T00:00:00Z")),
                                       row("b", hand_in("ana", good, "2026-01-02T00:00:00Z"))});
    EXPECT_TRUE(is_superseded(report.rows[0]));
    EXPECT_FALSE(is_superseded(report.rows[1]));
    const std::string page = class_page(report, speaking("en"), "en"), line = line_of(page, "Ana");
    EXPECT_TRUE(line.starts_with("<tr class=\"superseded\"")) << line;
    EXPECT_NE(line.find("<td>superseded</td>"), line.npos) << line;
    EXPECT_EQ(line.find("class=\"bad\""), line.npos) << line;
    EXPECT_NE(page.find("class=\"student superseded\""), page.npos);
    EXPECT_EQ(line_of(page, "ana").find("superseded"), std::string::npos);
    const std::string csv = class_csv(report, speaking("en"));
    EXPECT_NE(csv.find("\nAna,,,a,,0,10,"), csv.npos) << "neither yes nor no: " << csv;
}

TEST(ClassReport, AStatedResultThatIsNotTheGradeIsMarked) {
    HandIn honest = hand_in("Ana", good), other = hand_in("Ben", four_wires), ungraded = hand_in("Eva", four_wires);
    honest.graded_starts = honest.passed_starts = 10;
    other.graded_starts = 10, other.passed_starts = 9;
    ClassReport report = graded({row("a", honest), row("b", other), row("e", ungraded)});
    EXPECT_FALSE(states_another_result(report, report.rows[0]));
    EXPECT_TRUE(states_another_result(report, report.rows[1]));
    EXPECT_FALSE(states_another_result(report, report.rows[2])) << "it states none";
    const std::string page = class_page(report, speaking("en"), "en");
    const std::string said = "the file states 9 starts passed, graded here: 0";
    EXPECT_NE(line_of(page, "Ben").find(said), std::string::npos) << line_of(page, "Ben");
    EXPECT_EQ(line_of(page, "Ana").find("states"), std::string::npos);
    const std::string csv = class_csv(report, speaking("en"));
    EXPECT_NE(csv.find(",9,yes,"), csv.npos) << csv;
    EXPECT_NE(csv.find(",10,no,"), csv.npos) << csv;
    report.first_seed = 7;
    EXPECT_FALSE(states_another_result(report, report.rows[1])) << "the lab has graded other starts";
}

TEST(ClassReport, TheHeadingSaysThatAStartCountsForItsFirstFailedStep) {
    const std::string page = class_page(graded({row("b", hand_in("B", four_wires))}), speaking("en"), "en");
    EXPECT_NE(page.find("starts that fail at this step first"), page.npos);
}

TEST(ClassReport, APassWithTheSolutionShownIsCountedApart) {
    HandIn shown = hand_in("Ana", good), failed = hand_in("Ben", four_wires);
    shown.solution_shown = failed.solution_shown = true;
    const ClassReport report = graded({row("a", shown), row("b", failed), row("e", hand_in("Eva", good))});
    const ClassSummary summary = summary_of(report);
    EXPECT_EQ(summary.passed, 2);
    EXPECT_EQ(summary.passed_shown, 1);
    const std::string page = class_page(report, speaking("en"), "en");
    EXPECT_NE(page.find("<b>2 (1 with the solution shown) / 3</b>"), page.npos);
    EXPECT_NE(class_page(report, speaking("de"), "de").find("<b>2 (1 mit gezeigter Lösung) / 3</b>"), page.npos);
    EXPECT_NE(class_page(report, speaking("es"), "es").find("<b>2 (1 con la solución mostrada) / 3</b>"), page.npos);
    EXPECT_NE(line_of(page, "Ana").find("<td class=\"shown\">yes (solution shown)</td>"), page.npos);
    EXPECT_NE(line_of(page, "Ben").find("<td>solution shown"), page.npos) << line_of(page, "Ben");
    EXPECT_EQ(line_of(page, "Eva").find("shown"), page.npos);
    for (const std::string& code : shipped_codes()) {
        const Strings strings = speaking(code);
        const std::string said(strings("report.passed_after_solution"));
        EXPECT_TRUE(feedback(report, report.rows[0], strings).ends_with(said)) << code;
        for (const std::size_t other : {1u, 2u})
            EXPECT_EQ(feedback(report, report.rows[other], strings).find(said), said.npos) << code;
    }
}

// Green and yellow are those whom the tile "passed" counts; a hand-in that changes what is not offered is neither.
TEST(ClassReport, TheHistogramAgreesWithTheTile) {
    HandIn shown = hand_in("Ana", good), outside = hand_in("Olu", good);
    shown.solution_shown = true;
    outside.submission.sensors[0].range = 30;
    const ClassReport report = graded(
        {row("a", shown), row("b", hand_in("Ben", four_wires)), row("e", hand_in("Eva", good)), row("o", outside)});
    ASSERT_FALSE(report.rows[3].passed);
    const std::string page = class_page(report, speaking("en"), "en");
    const std::size_t begin = page.find("Students by number of starts passed");
    const std::string histogram = page.substr(begin, page.find("</p>", begin) - begin);
    const auto count = [&](const std::string& part) {
        int found = 0;
        for (std::size_t at = 0; (at = histogram.find(part, at)) != histogram.npos; at += part.size()) ++found;
        return found;
    };
    EXPECT_NE(page.find("<b>2 (1 with the solution shown) / 4</b>"), page.npos);
    EXPECT_EQ(count("</span> passed alone: 1"), 1);
    EXPECT_EQ(count("</span> passed with the solution shown: 1"), 1);
    EXPECT_EQ(count("</span> not passed: 2"), 1);
    for (const char* colour : {"#0b6e4f", "#c98a00"}) EXPECT_EQ(count(std::string("fill=\"") + colour), 1) << colour;
}

TEST(ClassReport, PeopleWithoutAHandInThatCanBeGradedAreCounted) {
    const auto of_person = [](ClassRow made, const std::string& folder, const std::string& person) {
        made.submitter.folder = folder, made.submitter.person = person;
        return made;
    };
    HandIn other = hand_in("Eva", good);
    other.exercise = "06-love";
    const auto empty = [](const std::string& file) {
        return row_of_hand_in(*aggressor(), file, Result<std::string>(std::string()));
    };
    const ClassReport report = graded({
        of_person(row("1/a", hand_in("Ana", good)), "1", "Ana_1"),
        of_person(row_of_other_file("1/a.pdf"), "1", "Ana_1"),  // beside a hand-in that counts
        of_person(row_of_other_file("2/b.pdf"), "2", "Ben_2"),
        of_person(empty("2/c"), "2", "Ben_2"),  // a second file of Ben
        of_person(row("3/d", other), "3", "Eva_3"),
        of_person(row("kim/k", hand_in("Kim", four_wires)), "kim", ""),
        of_person(row_of_other_file("kim/notes.pdf"), "kim", ""),  // in Kim's folder
        of_person(row_of_other_file("lou/x.pdf"), "lou", ""),
        of_person(empty("lou/y"), "lou", ""),  // in Lou's folder
        row("m", hand_in("Mo", four_wires, "2026-01-01T00:00:00Z")),
        row("n", hand_in("Mo", good, "2026-01-02T00:00:00Z")),
        row_of_other_file("zoe.docx"),
    });
    const ClassSummary summary = summary_of(report);
    EXPECT_EQ(summary.counted, 3) << "Ana, Kim, Mo";
    EXPECT_EQ(summary.without, 4) << "Ben, Eva, Lou, Zoe";
    EXPECT_EQ(summary.students, 7);
    int in_table = summary.refused + summary.unchanged + summary.other + summary.without;
    for (const int students : summary.resembling) in_table += students;
    EXPECT_EQ(summary.passed + in_table, summary.students) << "each student who does not pass is one mistake";
    for (const auto& [language, name] : shipped_languages()) {
        const std::string page = class_page(report, speaking(language), language);
        const auto tile = [words = speaking(language)](const std::string& value, const std::string& key) {
            return "<div class=\"tile\"><b>" + value + "</b>" + std::string(words(key)) + "</div>";
        };
        for (const std::string& each : {tile("7", "report.students"), tile("2 / 7", "report.passed"),
                                        tile("4", "report.without"), tile("5", "report.not_counted")})
            EXPECT_NE(page.find(each), page.npos) << language << " " << each;
    }
}

TEST(ClassReport, TheMostFrequentMistakeIsFirst) {
    std::vector<ClassRow> rows(10);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ClassRow& each = rows[i];
        each.grade = Grade{};
        each.student = each.file = std::to_string(i);
        if (i < 1) each.resembles = 0;
        if (i >= 1 && i < 4) each.unchanged = true;
        if (i >= 4 && i < 6) each.refusal = RowProblem{"report.too_many", "1", {}};
    }
    const Strings& strings = english();
    const std::string page = class_page({aggressor(), 1, rows}, strings, "en");
    std::size_t before = page.find(strings("report.resembled"));
    for (const std::string_view name :
         {strings("report.other_mistakes"), strings("report.as_shipped"), strings("report.refused_mistake"),
          std::string_view(aggressor()->wrong[0].name)}) {
        const std::size_t at = page.find("<tr><td>" + std::string(name) + "</td>");
        ASSERT_NE(at, page.npos) << name;
        EXPECT_GT(at, before) << name << ": 4, 3, 2, 1 students";
        before = at;
    }
}

TEST(ClassReport, StudentsAreSortedByLettersWithoutAccents) {
    const std::vector<std::string> sorted{"Ångström Åsa", "Böhm Ida",   "Braun Leo", "Çelik Can",  "Dvořák Jan",
                                          "Köhler Ute",   "Krüger Ole", "Łoś Ewa",   "Muller Eva", "Müller Eva",
                                          "Nowak Jan",    "Öztürk Nil", "Zola Zoe"};
    std::vector<ClassRow> rows;
    for (std::size_t i = sorted.size(); i-- > 0;) rows.push_back(row(std::to_string(i), hand_in(sorted[i], good)));
    sort_by_student(rows);
    std::vector<std::string> students;
    for (const ClassRow& each : rows) students.push_back(each.student);
    EXPECT_EQ(students, sorted);
}

TEST(ClassReport, TheTableHasTheNotes) {
    HandIn made = hand_in("Ana", good, "2026-01-01T10:00:00Z");
    made.notes = "It turns,\n=1+1 \"soon\".";
    const std::string csv = class_csv(graded({row("a", made)}), speaking("en"));
    EXPECT_NE(csv.find(",written,notes,resembles,"), csv.npos) << csv;
    EXPECT_NE(csv.find("2026-01-01T10:00:00Z,\"It turns,\n=1+1 \"\"soon\"\".\",,"), csv.npos) << csv;
    made.notes = "=1+1";
    EXPECT_NE(class_csv(graded({row("a", made)}), speaking("en")).find("Z,'=1+1,"), std::string::npos);
}

TEST(ClassReport, FeedbackOnAFileThatIsNotGradedSaysWhyWithoutFolders) {
    const ClassReport report =
        graded({row_of_other_file("Müller Anna_1_assignsubmission_file_/essay.docx"),
                row_of_hand_in(*aggressor(), "x/f.toml", Result<std::string>(std::string("format = 1\nstudent = \""))),
                row("a", hand_in("Ana", good, "2026-01-01T00:00:00Z")),
                row("b", hand_in("Ana", good, "2026-01-02T00:00:00Z"))});
    for (const auto& [language, name] : shipped_languages()) {
        const Strings& strings = speaking(language);
        const std::string essay = "essay.docx: " + std::string(strings("report.no_hand_in"));
        EXPECT_EQ(feedback(report, report.rows[0], strings), fill(strings("report.not_judged"), {essay}));
        const std::string broken = feedback(report, report.rows[1], strings),
                          begin = fill(strings("report.not_judged"), {"f.toml:2: "});
        EXPECT_TRUE(broken.starts_with(begin.substr(0, begin.size() - 1))) << broken;
        EXPECT_EQ(feedback(report, report.rows[2], strings), problem_text(report.rows[2], strings)) << "superseded";
    }
}

// The page measures itself.
TEST(ClassReport, ThePageFitsAWindowOf1000Pixels) {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "Chromium is not installed";
    const Folder folder;
    HandIn shown = hand_in("Maximilian-Alexander Müller-Lüdenscheidt", four_wires);
    shown.prediction = 1, shown.solution_shown = true, shown.graded_starts = 10, shown.passed_starts = 9;
    ClassRow copied = row("b", shown);
    copied.same_as = "Müller-Lüdenscheidt_Maximilian_101_assignsubmission_file_/05-aggressor_maximilian.toml";
    const ClassReport report = graded({row("a", hand_in("Ana", good)), copied});
    for (const auto& [language, name] : shipped_languages()) {
        std::string page = class_page(report, speaking(language), language);
        page.insert(page.find("</body>"),
                    "<script>document.title = \"wide \" + document.documentElement.scrollWidth;</script>");
        put_text(folder / "page.html", page);
        const std::string file = (folder / "page").string();
        ASSERT_EQ(std::system(("HOME=" + folder.path.string() +
                               " timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
                               "--hide-scrollbars --window-size=1000,800 --dump-dom file://" +
                               file + ".html >" + file + ".txt 2>/dev/null")
                                  .c_str()),
                  0);
        EXPECT_NE(text_of(folder / "page.txt").find("<title>wide 1000</title>"), std::string::npos) << language;
    }
}

TEST(ClassReport, HandInsOfOneStudentAreTogether) {
    std::vector<ClassRow> rows{row("1", hand_in("ben", good)), row("2", hand_in("Zoe", good)),
                               row("3", hand_in("Ben", good)), row("4", hand_in("Ana", good))};
    sort_by_student(rows);
    std::vector<std::string> files;
    for (const ClassRow& each : rows) files.push_back(each.file);
    EXPECT_EQ(files, (std::vector<std::string>{"4", "1", "3", "2"}));
}

}  // namespace braitenlab::tests::class_report_test
