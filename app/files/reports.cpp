#include "app/files/reports.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include <fmt/chrono.h>

#include "app/course/lesson_view.h"
#include "app/files/safe_file.h"
#include "app/platform/platform.h"
#include "app/reports/lab_record.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

std::string utc_text(WrittenAt at) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(at)));
}

// True if a hand-in of another student, or a file that is none, has this path.
bool is_taken(const fs::path& path, const std::string& student) {
    std::error_code none;
    if (!fs::exists(path, none)) return false;
    const auto text = read_text(path);
    const auto there = text ? parse_hand_in(*text, path.string()) : text.error();
    return !there || !is_same_student(there->student, student);
}

// Tells where the file is; `downloaded`: key of the string with its name among the downloads, `saved`: with its path.
void say_written(Lab& lab, std::string_view downloaded, std::string_view saved, const fs::path& path) {
    const bool downloads = saves_by_download();
    lab.document.lesson->attempt.work.written = downloads ? path.filename().string() : path.string();
    say(lab,
        {NoticeKind::done, std::string(downloads ? downloaded : saved), lab.document.lesson->attempt.work.written});
}

std::optional<Error> write_hand_in_file(Lab& lab, const std::string& student, const fs::path& folder, WrittenAt at) {
    const std::string& exercise = lab.document.lesson->exercise->id;
    fs::path path = folder / hand_in_name(exercise, student);
    for (int number = 2; is_taken(path, student); ++number) path = folder / hand_in_name(exercise, student, number);
    if (auto error = write_whole(path, write_hand_in(hand_in_of(lab, student, at)))) return error;
    say_written(lab, "notice.handed_in_download", "notice.handed_in", path);
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
    const Known known{.predicted = has_predicted(answers), .outcome = work.outcome_known, .passed = has_passed(lesson)};
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

void write_student_files(Lab& lab, const Strings& strings, const fs::path& documents, WrittenAt at) {
    const fs::path folder = reports_folder(documents);
    for (const Request& request : std::exchange(lab.window.reports, {})) {
        if (!lab.document.lesson) continue;
        std::optional<Error> error;
        if (const auto* hand_in = std::get_if<HandInRequest>(&request))
            error = write_hand_in_file(lab, hand_in->student, folder, at);
        if (const auto* record = std::get_if<LabRecordRequest>(&request))
            error = write_lab_record(lab, record->student, strings, folder, at);
        if (error) say(lab, *error);
    }
}

}  // namespace braitenlab
