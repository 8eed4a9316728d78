// What ships is told in every language of the lab, and no translation is left over from words that are gone.
#include <set>

#include "core/lesson/exercise.h"
#include "core/scene/scene_file.h"
#include "desk.h"

namespace braitenlab::tests::shipped_words_test {

namespace {

namespace fs = std::filesystem;

const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";

std::set<std::string> texts_of(const Exercise& e) {
    std::set<std::string> texts{e.title, e.goal, e.why, e.prediction.question, e.prediction.outcome};
    texts.insert(e.prediction.options.begin(), e.prediction.options.end());
    for (const Step& step : e.steps) texts.insert(step.text);
    for (const Hint& hint : e.hints) texts.insert(hint.text);
    return texts;
}

std::set<std::string> all_texts() {
    std::set<std::string> texts;
    for (const auto& entry : fs::directory_iterator(shipped / "guided")) {
        const auto exercise = load_exercise(entry.path());
        EXPECT_TRUE(exercise) << entry.path();
        if (exercise) texts.merge(texts_of(*exercise));
    }
    for (const auto& entry : fs::directory_iterator(shipped / "scenes")) {
        const auto scene = load_scene(entry.path());
        EXPECT_TRUE(scene) << entry.path();
        if (scene) texts.insert({scene->title, scene->story});
    }
    texts.erase("");
    return texts;
}

Strings words_of_shipped(const std::string& code) {
    auto words = Strings::load(shipped / "words" / (code + ".toml"));
    EXPECT_TRUE(words) << words.error().text();
    return words ? *words : Strings{};
}

}  // namespace

TEST(ShippedWords, AreThereInEveryLanguage) {
    const auto texts = all_texts();
    EXPECT_GT(texts.size(), 40u) << "scenes and exercises are read at all";
    for (const Language& language : languages(fs::path(BRAITENLAB_SOURCE) / "ui" / "strings")) {
        if (language.code == "en") continue;
        const Strings words = words_of_shipped(language.code);
        for (const std::string& text : texts)
            EXPECT_TRUE(words.all().count(text)) << "exercises/words/" << language.code << ".toml lacks: " << text;
        for (const auto& [text, translation] : words.all())
            EXPECT_TRUE(texts.count(text)) << language.code << ".toml has what nothing says: " << text;
    }
}

TEST(ShippedWords, StandOnTheCardsInTheLanguageThatIsShown) {
    Desk desk(1280, 1400, 1, true);
    desk.strings = speaking("de");
    desk.strings.fall_back_on(words_of_shipped("de"));
    const auto exercise = load_exercise(shipped / "guided" / "05-aggressor.toml");
    ASSERT_TRUE(exercise);
    desk.opened = *exercise;
    desk.open_exercise();
    desk.frame(4);
    std::string all;
    for (const Written& w : desk.written) all += w.words + "\n";
    for (const std::string& text : texts_of(*exercise)) {
        if (text == exercise->title) continue;  // is the same in German
        EXPECT_EQ(all.find(text.substr(0, 20)), std::string::npos) << text;
    }
    EXPECT_NE(all.find("Es berührt die Lampe"), std::string::npos);
}

}  // namespace braitenlab::tests::shipped_words_test
