#include "core/lesson/exercise_id.h"

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/scene/file_kind.h"

namespace braitenlab::tests::exercise_id_test {

TEST(ExerciseId, IsTheNameOfTheFileWithoutWhatACopyAdds) {
    for (const char* name :
         {"charge", "charge (1)", "charge(12)", "charge - Copy", "charge - Kopie (2)", "charge - copia", "charge copy"})
        EXPECT_EQ(exercise_id_of(std::string("class.2/") + name + ".toml"), "charge") << name;
    for (const char* name : {"05-aggressor", "charge (a)", "charge (2026)", "charge ()", "(1)", " - Copy", "recopy"})
        EXPECT_EQ(without_copy_suffix(name), name);
}

TEST(ExerciseId, AHandInFromACopyOfTheFileIsForTheExercise) {
    EXPECT_TRUE(is_for_exercise("charge (1)", "charge"));
    EXPECT_TRUE(is_for_exercise("charge", "charge (3)"));
    EXPECT_FALSE(is_for_exercise("charge", "charge-2"));
}

TEST(ExerciseId, OfTheFileGoesBeforeItsName) {
    const std::filesystem::path shipped =
        std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/05-aggressor.toml";
    std::string text = *read_text(shipped);
    EXPECT_EQ(parse_exercise(text, shipped.parent_path() / "shy (1).toml")->id, "shy");
    text.insert(text.find('\n') + 1, "id = \"charge\"\n");
    EXPECT_EQ(parse_exercise(text, shipped.parent_path() / "shy (1).toml")->id, "charge");
}

}  // namespace braitenlab::tests::exercise_id_test
