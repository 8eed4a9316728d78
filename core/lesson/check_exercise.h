// What an exercise's file must contain beyond the types and ranges of its values: texts, names that the scene has,
// times and offers that can be kept. Inside core/lesson only.
#pragma once

#include "core/lesson/exercise.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

// Each adds the errors to the file, with their lines. `top`: the file from which the exercise has been read, also with
// errors.
void check_exercise(TomlTable& top, const Exercise&);       // texts, numbers and offers
void check_against_scene(TomlTable& top, const Exercise&);  // names; precondition: a valid scene with a start

}  // namespace braitenlab
