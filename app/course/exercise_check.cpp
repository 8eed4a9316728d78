#include "app/course/exercise_check.h"

#include <utility>

#include <fmt/format.h>

#include "app/files/disk.h"
#include "app/jobs/grading.h"
#include "app/lab.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"
#include "core/lesson/warnings.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

namespace {

Notice notice_of(NoticeKind kind, const Error& error) { return {.kind = kind, .words = error.text(), .error = error}; }

void begin_check(ExerciseCheck& check, const std::filesystem::path& path, Jobs& jobs) {
    std::vector<Submission> submissions{as_shipped(*check.exercise), with_solution(*check.exercise)};
    for (const Answer& wrong : check.exercise->wrong) submissions.push_back(wrong.submission);
    for (const Submission& each : submissions) check.jobs.push_back(submit_grading(jobs, check.exercise, each));
    check.remarks_job = jobs.submit([exercise = check.exercise, toml = check.toml, path]() {
        return std::optional(
            ExerciseRemarks{prediction_fault(*exercise, toml, path), warnings_of(*exercise, toml, path)});
    });
    check.begun = true;
}

std::string of_starts(const Exercise& exercise, const Grade& grade) {
    return fmt::format("{}/{}", grade.count, exercise.starts);
}

// Takes what has ended. False while something runs; the error of a job ends the check.
Result<bool> has_ended(ExerciseCheck& check) {
    while (check.grades.size() < check.jobs.size()) {
        auto grade = check.jobs[check.grades.size()].take();
        if (!grade) return false;
        if (!*grade) return grade->error();
        check.grades.push_back(std::move(**grade));
    }
    if (check.remarks) return true;
    auto remarks = check.remarks_job.take();
    if (!remarks) return false;
    if (!*remarks) return remarks->error();
    check.remarks = std::move(**remarks);
    return true;
}

// ── What was found: first what can be the cause of failed starts ──

void add_failed_starts(const ExerciseCheck& check, std::vector<Finding>& found) {
    const Exercise& exercise = *check.exercise;
    for (const StartResult& start : check.grades[0].starts)
        if (start.passed)
            found.push_back({{NoticeKind::failure, "findings.passes_as_shipped", std::to_string(start.seed)}});
    for (const StartResult& start : check.grades[1].starts) {
        if (start.passed) continue;
        const std::size_t failed = failed_step(start);
        Finding& each = found.emplace_back();
        const bool is_valid = failed < start.verdicts.size();
        each.said = {NoticeKind::failure, is_valid ? "findings.start_fails" : "findings.start_invalid",
                     std::to_string(start.seed)};
        if (!is_valid) continue;
        each.said.more = fmt::format("{}. {}", failed + 1, exercise.steps[failed].text);
        each.measures = start.verdicts[failed].measures;
    }
}

std::vector<Finding> findings_of(const ExerciseCheck& check) {
    const Exercise& exercise = *check.exercise;
    std::vector<Finding> found;
    const auto add = [&](NoticeKind kind, const Error& error) { found.emplace_back().said = notice_of(kind, error); };
    if (check.remarks->prediction) add(NoticeKind::failure, *check.remarks->prediction);
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i)
        if (check.grades[i + 2].good)
            found.push_back({{NoticeKind::failure, "findings.wrong_passes", exercise.wrong[i].name}});
    for (const std::string& control : outside_offers(exercise, with_solution(exercise)))
        found.push_back({{NoticeKind::failure, "findings.not_offered", control}});
    if (changes_too_many(exercise, with_solution(exercise)))
        found.push_back({{NoticeKind::failure, "findings.many_changes", std::to_string(exercise.changes)}});
    for (const Error& warning : check.remarks->warnings) add(NoticeKind::notice, warning);
    add_failed_starts(check, found);
    return found;
}

Notice result_of(const ExerciseCheck& check) {
    const Exercise& exercise = *check.exercise;
    const Grade &shipped = check.grades[0], &solution = check.grades[1];
    const std::string before = of_starts(exercise, shipped), after = of_starts(exercise, solution);
    if (shipped.count > 0 || solution.count < exercise.starts)
        return {NoticeKind::failure, "author.unsound", before, after};
    const auto outside = outside_offers(exercise, with_solution(exercise));
    if (!outside.empty()) return {NoticeKind::failure, "author.not_offered", outside.front()};
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i)
        if (check.grades[i + 2].good) return {NoticeKind::failure, "author.wrong_passes", exercise.wrong[i].name};
    if (check.remarks->prediction) return {NoticeKind::failure, "author.contradicted"};
    if (doubt_answer(check.remarks->warnings)) return {NoticeKind::notice, "author.sound_untested", before, after};
    return {NoticeKind::done, "author.sound", before, after};
}

}  // namespace

void check_exercise_for_author(Lab& lab, CheckVoice voice) {
    lab.check.reset();
    const Document& now = lab.document;
    if (!now.lesson || ships(now.path)) return;
    auto text = read_text(now.path);
    lab.check = std::make_shared<ExerciseCheck>(
        ExerciseCheck{.exercise = now.lesson->exercise, .toml = text ? std::move(*text) : "", .voice = voice});
    if (voice == CheckVoice::usual) say(lab, {NoticeKind::notice, "author.checking", now.lesson->exercise->title});
}

std::optional<Error> list_errors_for_author(Lab& lab, const std::filesystem::path& path, std::string_view toml) {
    if (detect_kind(path, toml) != FileKind::exercise || ships(path)) return std::nullopt;
    lab.findings.clear();
    const std::vector<Error> errors = errors_of_exercise(toml, path);
    for (const Error& error : errors) lab.findings.emplace_back().said = notice_of(NoticeKind::failure, error);
    return errors.empty() ? std::nullopt : std::optional(errors.front());
}

void update_exercise_check(Lab& lab, Jobs& jobs) {
    if (!lab.check) return;
    ExerciseCheck& check = *lab.check;
    if (!lab.document.lesson || lab.document.lesson->exercise != check.exercise) return lab.check.reset();
    if (!check.begun) begin_check(check, lab.document.path, jobs);
    const auto ended = has_ended(check);
    if (!ended) {
        say(lab, ended.error());
        return lab.check.reset();
    }
    if (!*ended) return;
    constexpr double shown_seconds = 60;  // the author does not wait for it
    lab.findings = findings_of(check);
    const Notice result = result_of(check);
    if (check.voice == CheckVoice::usual || result.kind == NoticeKind::failure) say(lab, result, shown_seconds);
    lab.check.reset();
}

}  // namespace braitenlab
