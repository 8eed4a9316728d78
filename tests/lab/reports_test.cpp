#include "app/files/reports.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"
#include "opened_lab.h"
#include "tests/folder.h"
#include "tests/languages.h"

namespace braitenlab::tests::reports_test {
namespace {

namespace fs = std::filesystem;

const WrittenAt noon = WrittenAt(std::chrono::seconds(1795262400));  // 2026-11-21T12:00:00Z

// The hand-ins in the folder "Braitenlab", by file name.
std::map<std::string, HandIn> hand_ins(const fs::path& documents) {
    std::map<std::string, HandIn> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(documents / "Braitenlab", none)) {
        const auto text = read_text(entry.path());
        EXPECT_TRUE(text);
        const auto hand_in = parse_hand_in(*text, entry.path().string());
        EXPECT_TRUE(hand_in) << hand_in.error().text();
        if (hand_in) found[entry.path().filename().string()] = *hand_in;
    }
    return found;
}

// Of ten starts.
Grade graded(int passed) {
    Grade grade{.count = passed, .good = passed >= 8};
    for (int i = 0; i < 10; ++i)
        grade.starts.push_back({.seed = static_cast<std::uint64_t>(i + 1), .passed = i < passed});
    return grade;
}

// The present submission has passed so many of its ten starts.
void grade_present(Lab& lab, Jobs& jobs, int passed) {
    Lesson& lesson = *lab.document.lesson;
    lesson.graded = GradedSubmission{submission_of(*lesson.exercise, lab.document.session.snapshot()), graded(passed)};
    update_grading(lab, jobs);
}

void request(Lab& lab, const Request& wanted, const fs::path& documents) {
    handle(lab, wanted);
    write_report_files(lab, english(), documents, noon);
}

}  // namespace

TEST(Reports, AHandInHoldsWhatTheStudentHasDone) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    handle(lab, PredictRequest{1});
    for (int i = 0; i < 5; ++i) tick(lab);
    handle(lab, Action::hint);
    handle(lab, Action::reset);
    tick(lab);
    lab.document.lesson->attempt.notes = "note";
    request(lab, HandInRequest{"Ana López"}, documents.path);
    EXPECT_EQ(lab.notice.key, "notice.handed_in");
    const auto found = hand_ins(documents.path);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found.begin()->first, "05-aggressor-ana-lopez.braiten-handin.toml");
    const HandIn& h = found.begin()->second;
    EXPECT_EQ(h.student, "Ana López");
    EXPECT_EQ(h.exercise, "05-aggressor");
    EXPECT_EQ(h.written, "2026-11-21T12:00:00Z");
    EXPECT_EQ(h.prediction, 2);
    EXPECT_EQ(h.runs, 2);
    EXPECT_EQ(h.hints, 1);
    EXPECT_EQ(h.graded_starts, 0);
    EXPECT_EQ(h.notes, "note");
    EXPECT_FALSE(h.solution_shown);
}

TEST(Reports, AHandInHoldsTheSubmissionThatTheVehicleHas) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    handle(lab, ShowMeRequest{});
    tick(lab);
    request(lab, HandInRequest{"Ana"}, documents.path);
    const auto found = hand_ins(documents.path);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found.begin()->second.solution_shown);
    EXPECT_EQ(read_dials(found.begin()->second.submission.brain),
              read_dials(with_solution(*lab.document.lesson->exercise).brain));
}

TEST(Reports, AHandInReplacesOnlyTheFileOfTheSameStudent) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    request(lab, HandInRequest{"Ana López"}, documents.path);
    tick(lab);
    request(lab, HandInRequest{"ana lópez "}, documents.path);
    request(lab, HandInRequest{"Ana-Lopez"}, documents.path);
    const auto found = hand_ins(documents.path);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found.at("05-aggressor-ana-lopez.braiten-handin.toml").runs, 1);
    EXPECT_EQ(found.at("05-aggressor-ana-lopez-2.braiten-handin.toml").student, "Ana-Lopez");
}

TEST(Reports, AHandInReplacesABetterOneOnlyWhenThatIsConfirmed) {
    const Folder documents;
    Jobs jobs{0};
    Lab lab = solved_exercise();
    const auto in_file = [&] { return hand_ins(documents.path).begin()->second; };
    grade_present(lab, jobs, 10);
    request(lab, HandInRequest{"Ana"}, documents.path);
    const HandIn solved = in_file();
    ASSERT_EQ(solved.passed_starts, 10);
    handle(lab, Action::undo);
    update_grading(lab, jobs);
    const RefusedHandIn& refused = lab.document.lesson->attempt.work.refused;

    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(refused.reason, HandInRefusal::earlier_is_better);
    EXPECT_EQ(refused.passed, 10);
    EXPECT_EQ(refused.starts, 10);
    EXPECT_EQ(in_file().submission.brain, solved.submission.brain) << "it is only asked";
    request(lab, HandInRequest{"Ana", EarlierHandIn::keep}, documents.path);
    EXPECT_EQ(refused.reason, HandInRefusal::none);
    EXPECT_EQ(in_file().submission.brain, solved.submission.brain);
    request(lab, HandInRequest{"Ana", EarlierHandIn::replace}, documents.path);
    EXPECT_EQ(refused.reason, HandInRefusal::none);
    EXPECT_EQ(in_file().passed_starts, 0);
    EXPECT_NE(in_file().submission.brain, solved.submission.brain);

    grade_present(lab, jobs, 9);
    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(in_file().passed_starts, 9) << "a better one is written without a question";
    EXPECT_EQ(hand_ins(documents.path).size(), 1u);
}

TEST(Reports, TheQuestionAboutABetterHandInEndsOncePresentWorkIsAsGood) {
    const Folder documents;
    Jobs jobs{0};
    Lab lab = solved_exercise();
    const RefusedHandIn& refused = lab.document.lesson->attempt.work.refused;
    grade_present(lab, jobs, 10);
    request(lab, HandInRequest{"Ana"}, documents.path);
    handle(lab, Action::undo);
    update_grading(lab, jobs);
    request(lab, HandInRequest{"Ana"}, documents.path);
    ASSERT_EQ(refused.reason, HandInRefusal::earlier_is_better);
    write_report_files(lab, english(), documents.path, noon);
    EXPECT_EQ(refused.reason, HandInRefusal::earlier_is_better) << "it stays until then";
    handle(lab, Action::redo);
    update_grading(lab, jobs);
    write_report_files(lab, english(), documents.path, noon);
    EXPECT_EQ(refused.reason, HandInRefusal::none);
}

TEST(Reports, TheQuestionStaysWhereTheSolutionWasShownInAnEarlierAttempt) {
    const Folder documents;
    Jobs jobs{0};
    Lab lab = solved_exercise();
    Lesson& lesson = *lab.document.lesson;
    grade_present(lab, jobs, 5);
    request(lab, HandInRequest{"Ana"}, documents.path);
    lab.students.student().exercises[lesson.key].shown = true;
    ASSERT_FALSE(lesson.attempt.work.solution_shown);
    request(lab, HandInRequest{"Ana"}, documents.path);
    ASSERT_EQ(lesson.attempt.work.refused.reason, HandInRefusal::earlier_is_better);
    write_report_files(lab, english(), documents.path, noon);
    EXPECT_EQ(lesson.attempt.work.refused.reason, HandInRefusal::earlier_is_better);
    grade_present(lab, jobs, 6);
    write_report_files(lab, english(), documents.path, noon);
    EXPECT_EQ(lesson.attempt.work.refused.reason, HandInRefusal::none);
}

TEST(Reports, AHandInThatTheExerciseDoesNotOfferIsNotWritten) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    Lesson& lesson = *lab.document.lesson;
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LM, 0.9f}});
    ASSERT_FALSE(
        outside_offers(*lesson.exercise, submission_of(*lesson.exercise, lab.document.session.snapshot())).empty());
    request(lab, HandInRequest{"Ana", EarlierHandIn::replace}, documents.path);
    EXPECT_EQ(lesson.attempt.work.refused.reason, HandInRefusal::outside_offers);
    EXPECT_TRUE(hand_ins(documents.path).empty());
    handle(lab, Action::undo);
    write_report_files(lab, english(), documents.path, noon);
    EXPECT_EQ(lesson.attempt.work.refused.reason, HandInRefusal::none) << "the change is taken back";
    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(hand_ins(documents.path).size(), 1u);
}

TEST(Reports, ALabRecordReplacesNoOther) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    for (int i = 0; i < 2; ++i) request(lab, LabRecordRequest{"Ana"}, documents.path);
    EXPECT_TRUE(std::filesystem::exists(documents.path / "Braitenlab" / "05-aggressor-ana.html"));
    EXPECT_TRUE(std::filesystem::exists(documents.path / "Braitenlab" / "05-aggressor-ana-2.html"));
}

TEST(Reports, ALabRecordIsOpenedOrItsPathIsCopied) {
    const Folder documents;
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    setenv("PATH", documents.path.c_str(), 1);  // without a program that opens files
    Lab lab = opened_lab("05-aggressor");
    request(lab, OpenWrittenRequest{}, documents.path);
    EXPECT_TRUE(lab.window.to_copy.empty()) << "nothing is written yet";
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    request(lab, OpenWrittenRequest{}, documents.path);
    EXPECT_EQ(lab.window.to_copy, (documents.path / "Braitenlab" / "05-aggressor-ana.html").string());
    setenv("PATH", path.c_str(), 1);
}

TEST(Reports, TheViewHasThePathOfTheLastFile) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    EXPECT_EQ(view_of(lab).lesson->attempt.work.written, "");
    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(view_of(lab).lesson->attempt.work.written,
              (documents.path / "Braitenlab" / "05-aggressor-ana.braiten-handin.toml").string());
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    EXPECT_TRUE(view_of(lab).lesson->attempt.work.written.ends_with(".html"));
}

TEST(Reports, ALabRecordTellsNoTitleBeforeThePrediction) {
    const Folder documents;
    Lab lab = opened_lab("05-aggressor");
    request(lab, LabRecordRequest{"before"}, documents.path);
    handle(lab, PredictRequest{0});
    request(lab, LabRecordRequest{"answered"}, documents.path);
    tick(lab);
    handle(lab, Action::reset);  // no drawing of a run
    request(lab, LabRecordRequest{"after"}, documents.path);
    const auto page = [&](const char* name) {
        std::ifstream file(documents.path / "Braitenlab" / name);
        return std::string{std::istreambuf_iterator<char>(file), {}};
    };
    EXPECT_EQ(page("05-aggressor-before.html").find("Aggressor"), std::string::npos);
    EXPECT_NE(page("05-aggressor-answered.html"), "");
    EXPECT_EQ(page("05-aggressor-answered.html").find("Aggressor"), std::string::npos) << "it can still be changed";
    EXPECT_NE(page("05-aggressor-after.html").find("Aggressor"), std::string::npos);
}

TEST(Reports, AFolderThatCannotBeWrittenIsANotice) {
    const Folder documents;
    std::ofstream(documents.path / "Braitenlab") << "a file";
    Lab lab = opened_lab("05-aggressor");
    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
    Lab scene = opened_lab("2b-aggressor");
    const Folder other;
    request(scene, HandInRequest{"Ana"}, other.path);
    EXPECT_TRUE(fs::is_empty(other.path)) << "no exercise is open";
}

TEST(Reports, AHandInLeavesAFileThatIsNone) {
    const Folder documents;
    const fs::path taken = documents.path / "Braitenlab" / "05-aggressor-ana.braiten-handin.toml";
    put_text(taken, "mine");
    Lab lab = opened_lab("05-aggressor");
    request(lab, HandInRequest{"Ana"}, documents.path);
    EXPECT_EQ(text_of(taken), "mine");
    EXPECT_TRUE(fs::exists(documents.path / "Braitenlab" / "05-aggressor-ana-2.braiten-handin.toml"));
}

std::size_t drawings(const std::string& page) {
    std::size_t found = 0;
    for (std::size_t at = page.find("<svg"); at != page.npos; at = page.find("<svg", at + 1)) ++found;
    return found;
}

TEST(Reports, ALabRecordHasTheBrainOnceAnAnsweredExerciseIsRun) {
    const Folder documents;
    Lab lab = opened_lab("08-overrun");
    ASSERT_TRUE(lab.document.lesson->exercise->prediction.hides_brain);
    const fs::path file = documents.path / "Braitenlab" / lab_record_name("08-overrun", "Ana");
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    EXPECT_EQ(lab.notice.key, "notice.lab_record");
    EXPECT_EQ(drawings(text_of(file)), 0u);
    handle(lab, PredictRequest{0});
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    const std::string answered = text_of(documents.path / "Braitenlab" / lab_record_name("08-overrun", "Ana", 2));
    EXPECT_NE(answered, "");
    EXPECT_EQ(drawings(answered), 0u) << "the answer can still be changed";
    tick(lab);
    handle(lab, Action::reset);  // no drawing of a run
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    const std::string last = text_of(documents.path / "Braitenlab" / lab_record_name("08-overrun", "Ana", 3));
    EXPECT_EQ(drawings(last), 1u);
    EXPECT_NE(last.find("2026-11-21"), std::string::npos);
}

// The path data of the last run in the lab record of 02-circle that is written now, as the record `number` of Ana.
std::string drawn_run(Lab& lab, const fs::path& documents, int number) {
    request(lab, LabRecordRequest{"Ana"}, documents);
    const std::string page = text_of(documents / "Braitenlab" / lab_record_name("02-circle", "Ana", number));
    const std::size_t begin = page.find("<path d=\"M", page.rfind("<svg")) + 9, end = page.find('"', begin);
    return begin < end ? page.substr(begin, end - begin) : "";
}

std::string first_place(const std::string& data) { return data.substr(0, data.find('L')); }

TEST(Reports, ALabRecordDrawsALongRunFromItsStart) {
    const Folder documents;
    Lab lab = opened_lab("02-circle");
    for (int i = 0; i < 2 * path_ticks; ++i) tick(lab);
    const std::string early = drawn_run(lab, documents.path, 1);
    while (lab.document.session.snapshot().tick < 200 * 60) tick(lab);
    ASSERT_GT(lab.document.session.earliest(), 0u) << "the session does not record the start any more";
    const std::string late = drawn_run(lab, documents.path, 2);
    EXPECT_EQ(first_place(late), first_place(early));
    EXPECT_GT(std::count(late.begin(), late.end(), 'L'), 250) << "thinned to at most 400 places";
}

TEST(Reports, ALabRecordAfterGoingBackDrawsTheRunUpToThatTick) {
    const Folder documents;
    Lab lab = opened_lab("02-circle");
    for (int i = 0; i < 2000; ++i) tick(lab);
    handle(lab, Action::set_bookmark);
    const std::string marked = drawn_run(lab, documents.path, 1);
    while (lab.document.session.snapshot().tick < 100 * 60) tick(lab);
    const std::string late = drawn_run(lab, documents.path, 2);
    handle(lab, SeekRequest{95 * 60, false});
    for (int i = 0; i < 60; ++i) tick(lab);
    handle(lab, SeekRequest{100 * 60, false});
    EXPECT_EQ(drawn_run(lab, documents.path, 3), late) << "a look at the past loses nothing";
    handle(lab, Action::reset);
    for (int i = 0; i < 400; ++i) tick(lab);
    handle(lab, BookmarkRequest{0, false});
    EXPECT_EQ(drawn_run(lab, documents.path, 4), marked);
}

TEST(Reports, ALabRecordDrawsTheRunOfTheFirstVehicleOnly) {
    const Folder documents;
    Lab lab = opened_lab("02-circle");
    ASSERT_EQ(lab.document.session.snapshot().vehicles.size(), 2u);
    for (int i = 0; i < 4 * path_ticks; ++i) tick(lab);
    request(lab, LabRecordRequest{"Ana"}, documents.path);
    const std::string page = text_of(documents.path / "Braitenlab" / lab_record_name("02-circle", "Ana"));
    const std::size_t begin = page.find("<path d=\"M", page.rfind("<svg")) + 9, end = page.find('"', begin);
    ASSERT_LT(begin, end);
    const std::string line = page.substr(begin, end - begin);
    EXPECT_EQ(std::count(line.begin(), line.end(), ' '), 5) << "places from tick 0 on: " << line;
}

}  // namespace braitenlab::tests::reports_test
