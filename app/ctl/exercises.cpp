#include "app/ctl/exercises.h"

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/jobs/grading.h"
#include "core/lesson/exercise_file.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

Result<SharedExercise> read_exercise(const std::filesystem::path& path) {
    auto exercise = load_exercise(path);
    if (!exercise) return exercise.error();
    return std::make_shared<const Exercise>(std::move(*exercise));
}

Result<SharedExercise> find_exercise(const std::string& name) {
    const auto path = find_shipped(name, Shipped::exercise);
    if (!path) return path.error();
    if (const auto text = read_text(*path))
        if (auto error = other_than_exercise(*path, *text, "grade")) return *error;
    return read_exercise(*path);
}

std::optional<Error> other_than_exercise(const std::filesystem::path& path, std::string_view text,
                                         std::string_view command) {
    const FileKind kind = detect_kind(path, text);
    if (kind == FileKind::study)
        return Error{fmt::format("this is a study, and '{}' takes an exercise; run it by 'braitenctl study {}'",
                                 command, path.stem().string()),
                     path.string()};
    if (kind == FileKind::breeding)
        return Error{
            fmt::format("this is a breeding, and '{}' takes an exercise; run it by 'braitenctl breed'", command),
            path.string()};
    if (kind == FileKind::lecture)
        return Error{fmt::format("this is a lecture, and '{}' takes an exercise; test it by 'check'", command),
                     path.string()};
    return std::nullopt;
}

Result<std::vector<Grade>> grade_several(const SharedExercise& exercise, const std::vector<Submission>& submissions,
                                         std::uint64_t first_seed) {
    Jobs jobs(threads_for(0));
    std::vector<Job<Grade>> running;
    for (const Submission& submission : submissions)
        running.push_back(submit_grading(jobs, exercise, submission, first_seed));
    jobs.finish();
    std::vector<Grade> grades;
    for (Job<Grade>& job : running) {
        auto grade = job.take();
        if (!*grade) return grade->error();
        grades.push_back(std::move(**grade));
    }
    return grades;
}

std::string offers_fault(const Exercise& exercise, const Submission& submission) {
    std::string names;
    for (const std::string& control : outside_offers(exercise, submission))
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", control);
    if (!names.empty()) return fmt::format("it changes {}, which the exercise does not offer", names);
    if (!changes_too_many(exercise, submission)) return "";
    return fmt::format("it changes {} controls; the exercise allows {}", changed_controls(exercise, submission),
                       exercise.changes);
}

}  // namespace braitenlab
