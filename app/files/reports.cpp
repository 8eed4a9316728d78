#include "app/files/reports.h"

#include <algorithm>
#include <utility>

#include <fmt/chrono.h>

#include "app/course/lesson_view.h"
#include "app/files/file_commands.h"
#include "app/files/pages.h"
#include "app/files/safe_file.h"
#include "app/platform/platform.h"
#include "app/reports/lab_record.h"
#include "app/reports/study_drawing.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

std::string utc_text(WrittenAt at) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

// The file of this student's hand-in, and what it has now; nullopt: it does not exist.
struct HandInFile {
    fs::path path;
    std::optional<HandIn> earlier{};
};

// A file with a hand-in of another student, or that is none, is passed over.
HandInFile hand_in_file(const fs::path& folder, const std::string& exercise, const std::string& student) {
    for (int number = 1;; ++number) {
        HandInFile file{folder / hand_in_name(exercise, student, number)};
        std::error_code none;
        if (!fs::exists(file.path, none)) return file;
        const auto text = read_text(file.path);
        auto there = text ? parse_hand_in(*text, file.path.string()) : text.error();
        if (!there || !is_same_student(there->student, student)) continue;
        file.earlier = std::move(*there);
        return file;
    }
}

// True if a hand-in with more starts passed, or with as many without help, would be lost.
bool is_better(const HandIn& earlier, const HandIn& now) {
    const auto worth = [](const HandIn& each) { return std::pair(each.passed_starts, !each.solution_shown); };
    return earlier.passed_starts > 0 && worth(earlier) > worth(now);
}

// Why the hand-in is not written, or HandInRefusal::none.
RefusedHandIn refusal_of(const Exercise& exercise, const HandIn& now, const std::optional<HandIn>& earlier,
                         EarlierHandIn wanted) {
    if (!outside_offers(exercise, now.submission).empty()) return {HandInRefusal::outside_offers};
    if (changes_too_many(exercise, now.submission)) return {HandInRefusal::too_many_changes};
    if (wanted != EarlierHandIn::ask || !earlier || !is_better(*earlier, now)) return {};
    const bool needs_more = now.solution_shown && !earlier->solution_shown;  // as many are worth less; see is_better()
    return {HandInRefusal::earlier_is_better, earlier->passed_starts, earlier->graded_starts,
            earlier->passed_starts + (needs_more ? 1 : 0)};
}

// Clears the refusal when it no longer applies.
void follow_refusal(Lab& lab) {
    if (!lab.document.lesson) return;
    RefusedHandIn& refused = lab.document.lesson->attempt.work.refused;
    if (refused.reason == HandInRefusal::none) return;
    const Exercise& exercise = *lab.document.lesson->exercise;
    const Submission now = submission_of(exercise, lab.document.session.snapshot());
    const Grade* grade = grade_of(*lab.document.lesson);
    if (refused.reason == HandInRefusal::earlier_is_better ? grade && grade->count >= refused.needed
                                                           : keeps_to_offers(exercise, now))
        refused = {};
}

// Tells where the file is; `downloaded`: key of the string with its name among the downloads, `saved`: with its path.
void say_written(Lab& lab, std::string_view downloaded, std::string_view saved, const fs::path& path) {
    std::string& written = lab.document.lesson->attempt.work.written;
    if (saves_by_download()) return written = path.filename().string(), say_downloaded(lab, downloaded, path);
    written = path.string();
    say(lab, {NoticeKind::done, std::string(saved), written});
}

std::optional<Error> hand_in(Lab& lab, const HandInRequest& request, const fs::path& folder, WrittenAt at) {
    RefusedHandIn& refused = lab.document.lesson->attempt.work.refused;
    refused = {};
    if (request.earlier == EarlierHandIn::keep) return std::nullopt;
    const Exercise& exercise = *lab.document.lesson->exercise;
    const HandIn now = hand_in_of(lab, request.student, at);
    const HandInFile file = hand_in_file(folder, exercise.id, request.student);
    refused = refusal_of(exercise, now, file.earlier, request.earlier);
    if (refused.reason != HandInRefusal::none) return std::nullopt;
    if (auto error = write_whole(file.path, write_hand_in(now))) return error;
    say_written(lab, "notice.handed_in_download", "notice.handed_in", file.path);
    return std::nullopt;
}

// The run from its start to the present tick, with the verdicts of now.
StartResult last_run(const Lab& lab) {
    const Session& session = lab.document.session;
    StartResult run{.seed = session.snapshot().seed, .verdicts = referee_of(lab.document).verdicts()};
    for (const RunPlace& place : lab.document.lesson->path)
        if (place.tick < session.earliest()) run.path.push_back(place.at);
    const auto add = [&](const Snapshot& now) {
        if (now.tick % path_ticks != 0 && now.tick != session.snapshot().tick) return;
        for (const VehicleView& vehicle : now.vehicles)
            if (vehicle.start == 0) run.path.push_back({vehicle.x, vehicle.y});
    };
    session.replay(session.earliest(), {add, [](const Snapshot&, const Command&) {}});
    run.passed = !run.verdicts.empty() &&
                 std::all_of(run.verdicts.begin(), run.verdicts.end(), [](const Verdict& v) { return v.done; });
    return run;
}

LabRecord lab_record_of(const Lab& lab, WrittenAt at) {
    const Lesson& lesson = *lab.document.lesson;
    const Attempt::Answers& answers = lesson.attempt.answers;
    const Attempt::Work& work = lesson.attempt.work;
    LabRecord record{.exercise = lesson.exercise, .date = utc_text(at).substr(0, 10)};
    record.prediction = answers.prediction, record.outcome_known = work.outcome_known;
    // On paper: a lecture hides nothing of it.
    const Known known{.predicted = has_predicted(answers),
                      .outcome = work.outcome_known,
                      .passed = has_passed(lesson),
                      .has_run = work.has_run};
    const Disclosure may = disclosure_of(lesson.exercise.get(), known);
    record.shows_title = may.outcome, record.shows_brain = may.brains;
    if (!work.real_path.empty() && !answers.drawn_path.empty()) record.path_difference = work.path_difference;
    record.runs = work.runs, record.hints = answers.hints_shown, record.solution_shown = work.solution_shown;
    if (lab.document.session.snapshot().tick > 0) record.last_run = last_run(lab);
    if (const Grade* grade = grade_of(lesson)) record.grade = *grade;
    record.submission = submission_of(*lesson.exercise, lab.document.session.snapshot());
    record.notes = lesson.attempt.notes;
    return record;
}

std::optional<Error> write_lab_record(Lab& lab, const std::string& student, const Strings& strings,
                                      const fs::path& folder, WrittenAt at) {
    LabRecord record = lab_record_of(lab, at);
    record.student = student;
    std::error_code none;
    fs::path path = folder / lab_record_name(record.exercise->id, student);
    for (int number = 2; fs::exists(path, none); ++number)  // an earlier record stays
        path = folder / lab_record_name(record.exercise->id, student, number);
    if (auto error = write_whole(path, lab_record_html(record, strings, lab.preferences.language))) return error;
    say_written(lab, "notice.lab_record_download", "notice.lab_record", path);
    return std::nullopt;
}

void open_written(Lab& lab, const fs::path& folder) {
    const std::string& written = lab.document.lesson->attempt.work.written;
    if (written.empty()) return;
    const fs::path file = folder / fs::path(written).filename();
    std::error_code none;
    open_or_copy(lab, fs::is_regular_file(file, none), file, {file.filename().string(), written});
}

bool has_all_runs(const StudyRuns& study) { return study.base && study.rows.size() == study.base->study().runs(); }

std::optional<Error> write_figure(Lab& lab, const Strings& strings, const fs::path& folder) {
    const insight::Study& study = lab.study.base->study();
    return write_new(lab, folder, "braitenlab-" + study.id, ".svg", study_drawing(study, lab.study.rows, {}, strings),
                     "notice.figure");
}

}  // namespace

HandIn hand_in_of(const Lab& lab, const std::string& student, WrittenAt at) {
    const Lesson& lesson = *lab.document.lesson;
    const Attempt& attempt = lesson.attempt;
    HandIn hand_in{.student = student, .exercise = lesson.exercise->id, .written = utc_text(at)};
    hand_in.prediction = attempt.answers.prediction + 1;
    hand_in.runs = attempt.work.runs;
    const ExerciseProgress* known = find_progress(lab.students.student(), lesson.key);
    hand_in.hints = std::max(attempt.answers.hints_shown, known ? known->hints : 0);  // of earlier attempts, too
    hand_in.solution_shown = attempt.work.solution_shown || (known && known->shown);
    if (const Grade* grade = grade_of(lesson)) {
        hand_in.graded_starts = static_cast<int>(grade->starts.size());
        hand_in.passed_starts = grade->count;
    }
    hand_in.notes = attempt.notes;
    hand_in.submission = submission_of(*lesson.exercise, lab.document.session.snapshot());
    return hand_in;
}

fs::path reports_folder(const fs::path& documents) { return documents / "Braitenlab"; }

void write_report_files(Lab& lab, const Strings& strings, const fs::path& documents, WrittenAt at) {
    const fs::path folder = reports_folder(documents);
    follow_refusal(lab);
    for (const Request& request : std::exchange(lab.window.reports, {})) {
        std::optional<Error> error;
        if (std::holds_alternative<StudyRequest>(request) && has_all_runs(lab.study))
            error = write_figure(lab, strings, folder);
        if (const auto* given = std::get_if<HandInRequest>(&request); given && lab.document.lesson)
            error = hand_in(lab, *given, folder, at);
        if (const auto* record = std::get_if<LabRecordRequest>(&request); record && lab.document.lesson)
            error = write_lab_record(lab, record->student, strings, folder, at);
        if (std::holds_alternative<OpenWrittenRequest>(request) && lab.document.lesson) open_written(lab, folder);
        if (error) say(lab, *error);
    }
}

}  // namespace braitenlab
