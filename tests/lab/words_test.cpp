// The texts of a person's own file beside those of shipped files.
#include "app/words.h"

#include <filesystem>
#include <string>

#include "core/lesson/exercise_file.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::words_test {
namespace {

Words words_in(const char* language) {
    auto words = load_words(std::filesystem::path(BRAITENLAB_SOURCE) / "ui" / "strings", language);
    EXPECT_TRUE(words) << words.error().text();
    return std::move(*words);
}

}  // namespace

TEST(Words, AnOwnFileIsShownAsItIsWrittenAlsoWhereAShippedFileHasTheSameText) {
    for (const char* language : {"de", "es"}) {
        Words words = words_in(language);
        const Lab lab = opened_lab("05-aggressor");
        const Exercise shipped = *lab.document.lesson->exercise;
        const std::string option = shipped.prediction.options.front();
        const std::string translated(words.strings(option));
        ASSERT_NE(translated, option);
        leave_own_texts(words, open_texts(lab));
        EXPECT_EQ(words.strings(option), translated) << "it ships";
        Exercise own = shipped;
        own.title = "My exercise";
        leave_own_texts(words, {texts_of(own)});
        EXPECT_EQ(words.strings(option), option);
        EXPECT_NE(words.strings("button.play"), "button.play");
        leave_own_texts(words, open_texts(lab));
        EXPECT_EQ(words.strings(option), translated) << "the own file is closed";
        leave_own_texts(words, {texts_of(own)});
        ASSERT_FALSE(change_language(words, "en"));
        ASSERT_FALSE(change_language(words, language));
        EXPECT_EQ(words.strings(option), translated) << "the other language is told again";
    }
}

}  // namespace braitenlab::tests::words_test
