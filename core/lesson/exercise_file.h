// Files of exercises: reading, and what is derived from their schema. Format: docs/exercise-format.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/result.h"
#include "core/scene/settings.h"
#include "core/scene/translatable.h"

namespace braitenlab {

// Errors carry file and line; those in the scene carry the scene's. The scene's path is relative to the exercise's
// file. `more`: settings of the scene, applied after the exercise's own.
Result<Exercise> load_exercise(const std::filesystem::path&, const std::vector<Setting>& more = {});
Result<Exercise> parse_exercise(std::string_view toml, const std::filesystem::path& file,
                                const std::vector<Setting>& more = {});

// Every independent error of the file and of its scene, by lines, those without a line first; after a syntax error this
// one only. What an error hides, such as a name in a scene that cannot be read, is found once it is mended. Empty if
// parse_exercise() reads the file.
std::vector<Error> errors_of_exercise(std::string_view toml, const std::filesystem::path& file);

// By ids like "05-aggressor.step.1.text" and "scene.2a-coward.story".
std::vector<TranslatableText> texts_of(const Exercise&);  // those that are not empty
std::vector<TranslatableText> texts_of(const Scene&);

// The tables of docs/exercise-format.md, in Markdown.
std::string describe_exercise_format();

}  // namespace braitenlab
