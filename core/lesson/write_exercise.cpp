#include "core/lesson/write_exercise.h"

#include "core/lesson/exercise_schema.h"
#include "core/scene/toml_writer.h"

namespace braitenlab {

std::string write_exercise(const Exercise& exercise) {
    TomlWriter<Scene> scene(exercise.scene, "scene.");
    describe(scene, Of<Scene>{});
    return write_top(exercise) + scene.text("[scene]", false);
}

}  // namespace braitenlab
