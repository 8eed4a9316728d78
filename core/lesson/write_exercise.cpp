#include "core/lesson/write_exercise.h"

#include "core/lesson/exercise_schema.h"
#include "core/scene/toml_writer.h"

namespace braitenlab {

std::string write_exercise(const Exercise& exercise) {
    TomlWriter<Exercise> texts(exercise, "");
    describe(texts, Of<Exercise>{});
    TomlWriter<Scene> scene(exercise.scene, "scene.");
    describe(scene, Of<Scene>{});
    return "format = 1\n" + texts.text("", false) + scene.text("[scene]", false);
}

}  // namespace braitenlab
