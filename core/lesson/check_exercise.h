// What an exercise's file must contain beyond the types and ranges of its values: texts, names that the scene has,
// times and offers that can be kept. Inside core/lesson only.
#pragma once

#include "core/lesson/exercise.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

// Sets the file's error to the first fault, with its line. `top`: the file from which the exercise has been read.
void check_exercise(TomlTable& top, const Exercise&);

}  // namespace braitenlab
