// The check of the open exercise for its author, in the background: how many starts pass as shipped, with the solution
// and with each wrong answer, and what is doubtful in the file. The result is a notice that stays for a minute, and a
// card lists what was found: the same as `braitenctl check` prints.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/jobs/jobs.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

struct Lab;

// What is said of an exercise beside its grades.
struct ExerciseRemarks {
    std::optional<Error> prediction;  // why the run contradicts the prediction's answer
    std::vector<Error> warnings;
};

// quiet: no notice of the check itself, and of its result only if the exercise is not ready. For a file that a student
// may have dropped on the window.
enum class CheckVoice { usual, quiet };

struct ExerciseCheck {
    std::shared_ptr<const Exercise> exercise;
    std::string toml{};  // of its file, as it is now
    CheckVoice voice = CheckVoice::usual;
    Job<ExerciseRemarks> remarks_job{};
    std::optional<ExerciseRemarks> remarks{};
    std::vector<Job<Grade>> jobs{};  // as shipped, with the solution, with each wrong answer
    std::vector<Grade> grades{};     // of the jobs that have ended, in their order
    bool begun = false;              // the jobs are submitted
};

// Checks the exercise of the document from now on. Does nothing without an exercise, and for one that ships.
void check_exercise_for_author(Lab&, CheckVoice = CheckVoice::usual);

// Lists every error of a file that cannot be read as an exercise, and returns that of its first line. Does nothing for
// a file of another kind, and for one that ships.
std::optional<Error> list_errors_for_author(Lab&, const std::filesystem::path&, std::string_view toml);

// Call once per turn, after Jobs::deliver. Shows the result once every start has been run. A check ends without a
// result if another exercise has been opened.
void update_exercise_check(Lab&, Jobs&);

}  // namespace braitenlab
