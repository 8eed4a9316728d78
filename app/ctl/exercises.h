// Exercises and grades for the commands of braitenctl.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/result.h"

namespace braitenlab {

using SharedExercise = std::shared_ptr<const Exercise>;

Result<SharedExercise> read_exercise(const std::filesystem::path&);
// Fails for a file of another kind.
Result<SharedExercise> find_exercise(const std::string& path_or_name);

// Why the file, of the given content, cannot be read as an exercise by `command`: it is a file of another kind. nullopt
// for an exercise and for a text of no kind; reading them reports what is wrong.
std::optional<Error> other_than_exercise(const std::filesystem::path&, std::string_view text, std::string_view command);

// The grades of the submissions, in their order. Their starts run on all processors.
Result<std::vector<Grade>> grade_several(const SharedExercise&, const std::vector<Submission>&,
                                         std::uint64_t first_seed = 1);

// Why the submission does not keep to the offered controls, e.g. "it changes 'LR', which the exercise does not offer";
// empty if it does.
std::string offers_fault(const Exercise&, const Submission&);

}  // namespace braitenlab
