#include "app/course/exercise_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/jobs/grading.h"
#include "app/lab.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

void begin_check(ExerciseCheck& check, Jobs& jobs) {
    std::vector<Submission> submissions{as_shipped(*check.exercise), with_solution(*check.exercise)};
    for (const Answer& wrong : check.exercise->wrong) submissions.push_back(wrong.submission);
    for (const Submission& each : submissions) check.jobs.push_back(submit_grading(jobs, check.exercise, each));
    check.begun = true;
}

std::string of_starts(const Exercise& exercise, const Grade& grade) {
    return fmt::format("{}/{}", grade.count, exercise.starts);
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
    if (!shows_prediction(exercise)) return {NoticeKind::failure, "author.contradicted"};
    return {NoticeKind::done, "author.sound", before, after};
}

}  // namespace

void check_exercise_for_author(Lab& lab) {
    lab.check.reset();
    if (!lab.document.lesson) return;
    lab.check = std::make_shared<ExerciseCheck>(ExerciseCheck{lab.document.lesson->exercise});
    say(lab, {NoticeKind::notice, "author.checking", lab.document.lesson->exercise->title});
}

void update_exercise_check(Lab& lab, Jobs& jobs) {
    if (!lab.check) return;
    ExerciseCheck& check = *lab.check;
    if (!lab.document.lesson || lab.document.lesson->exercise != check.exercise) return lab.check.reset();
    if (!check.begun) begin_check(check, jobs);
    while (check.grades.size() < check.jobs.size()) {
        auto grade = check.jobs[check.grades.size()].take();
        if (!grade) return;
        if (!*grade) {
            say(lab, grade->error());
            return lab.check.reset();
        }
        check.grades.push_back(std::move(**grade));
    }
    constexpr double shown_seconds = 60;  // the author does not wait for it
    say(lab, result_of(check), shown_seconds);
    lab.check.reset();
}

}  // namespace braitenlab
