// What is doubtful in an exercise that can be read: objects outside the arena, goals that are met at the start, sensors
// without a wire. It can be meant so; faults that cannot are errors of load_exercise().
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/result.h"

namespace braitenlab {

// Most words of goal, prediction question and options together: a student reads no more before the first action.
inline constexpr int most_first_words = 40;

// The words of a text, separated by blanks; a sign alone, such as an arrow, is no word.
int word_count(std::string_view);

// True if one of these warnings says that a wrong answer of the prediction would not be noticed.
bool doubt_answer(const std::vector<Error>& warnings);

// Each with file and line. `toml`: the text of the file from which the exercise was read. Runs two ticks of each graded
// start, all starts as shipped for an exercise with a MedianRule, and Prediction::after seconds for an untested answer
// or, with several other brains, for a tested one.
std::vector<Error> warnings_of(const Exercise&, std::string_view toml, const std::filesystem::path&);

// Why the run with the shipped brain contradicts the prediction's answer: it meets the checks of another option, or the
// first check of the answer that it does not meet. nullopt if the run shows what the answer says.
std::optional<Error> prediction_fault(const Exercise&, std::string_view toml, const std::filesystem::path&);

// One for each text of a shipped exercise that `translations` (exercises/words/de.toml …) lacks, at the text's line.
std::vector<Error> missing_translations(const Exercise&, std::string_view toml, const std::filesystem::path&,
                                        const std::filesystem::path& translations);

}  // namespace braitenlab
