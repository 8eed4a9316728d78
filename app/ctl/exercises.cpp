#include "app/ctl/exercises.h"

#include <algorithm>
#include <array>

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
    struct Other {
        FileKind kind;
        std::string_view what, advice;
    };
    static constexpr std::array others{
        Other{FileKind::scene, "scene", "run it by 'braitenctl run'"},
        Other{FileKind::brain, "brain", "test it by 'braitenctl check EXERCISE --brain FILE'"},
        Other{FileKind::run, "saved run", "continue it by 'braitenctl run'"},
        Other{FileKind::study, "study", "run it by 'braitenctl study'"},
        Other{FileKind::breeding, "breeding", "run it by 'braitenctl breed'"},
        Other{FileKind::lecture, "lecture", "test it by 'braitenctl check'"},
    };
    const auto kind = find_kind(path, text);
    const auto other = std::find_if(others.begin(), others.end(), [&](const Other& each) { return kind == each.kind; });
    if (other == others.end()) return std::nullopt;
    return Error{fmt::format("this is a {}, and '{}' takes an exercise; {}", other->what, command, other->advice),
                 path.string()};
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
