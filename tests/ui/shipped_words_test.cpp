// Every text of shipped exercises, scenes and lectures has a translation in every language, and every translation has a
// text.
#include <algorithm>
#include <map>
#include <set>

#include "core/evolve/breeding_file.h"
#include "core/insight/study_file.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/lecture.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "desk.h"
#include "ui/words/strings.h"

namespace braitenlab::tests::shipped_words_test {

using namespace ui;

namespace {

namespace fs = std::filesystem;

const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";

std::vector<TranslatableText> all_texts() {
    std::vector<TranslatableText> texts;
    const auto add = [&](const std::vector<TranslatableText>& more) {
        texts.insert(texts.end(), more.begin(), more.end());
    };
    for (const auto& entry : fs::directory_iterator(shipped / "guided")) {
        const auto exercise = load_exercise(entry.path());
        EXPECT_TRUE(exercise) << entry.path();
        if (exercise) add(texts_of(*exercise));
    }
    for (const char* folder : {"scenes", "robots"})
        for (const auto& entry : fs::directory_iterator(shipped / folder)) {
            const auto scene = load_scene(entry.path());
            EXPECT_TRUE(scene) << entry.path();
            if (scene) add(texts_of(*scene));
        }
    for (const auto& entry : fs::directory_iterator(shipped / "lectures")) {
        const auto lecture = load_lecture(entry.path(), shipped);
        EXPECT_TRUE(lecture) << entry.path();
        if (lecture) add(texts_of(*lecture));
    }
    for (const auto& entry : fs::directory_iterator(shipped / "studies")) {
        const auto study = insight::parse_study(*read_text(entry.path()), entry.path().string());
        EXPECT_TRUE(study) << entry.path();
        if (study) add(texts_of(*study));
    }
    for (const auto& entry : fs::directory_iterator(shipped / "breeding")) {
        if (!entry.is_regular_file()) continue;
        const auto breeding = evolve::parse_breeding(*read_text(entry.path()), entry.path().string());
        EXPECT_TRUE(breeding) << entry.path();
        if (breeding) add(texts_of(*breeding));
    }
    return texts;
}

Strings words_of_shipped(const std::string& code) {
    auto words = Strings::load(shipped / "words" / (code + ".toml"));
    EXPECT_TRUE(words) << words.error().text();
    return words ? *words : Strings{};
}

std::vector<std::string> other_languages() {
    std::vector<std::string> codes;
    for (const Language& language : languages(fs::path(BRAITENLAB_SOURCE) / "ui" / "strings"))
        if (language.code != "en") codes.push_back(language.code);
    return codes;
}

}  // namespace

TEST(ShippedWords, EveryTextHasATranslationAndEveryTranslationATextInEveryLanguage) {
    std::set<std::string> ids;
    for (const TranslatableText& text : all_texts()) EXPECT_TRUE(ids.insert(text.id).second) << text.id << " twice";
    EXPECT_GT(ids.size(), 40u) << "scenes and exercises are found";
    EXPECT_TRUE(ids.count("05-aggressor.step.1.text"));
    EXPECT_TRUE(ids.count("scene.2a-coward.story"));
    for (const std::string& code : other_languages()) {
        const Strings words = words_of_shipped(code);
        for (const std::string& id : ids)
            EXPECT_TRUE(words.all().count(id)) << "exercises/words/" << code << ".toml lacks " << id;
        for (const auto& [id, translation] : words.all())
            EXPECT_TRUE(ids.count(id)) << "exercises/words/" << code << ".toml: no text has the id " << id;
    }
}

TEST(ShippedWords, TheSameTextHasTheSameTranslationEverywhere) {
    for (const std::string& code : other_languages()) {
        const Strings words = words_of_shipped(code);
        std::map<std::string, std::string> translations;
        for (const TranslatableText& text : all_texts()) {
            const std::string translation(words.find(text.id, {}));
            const auto first = translations.try_emplace(text.text, translation).first;
            EXPECT_EQ(first->second, translation) << code << ": " << text.id << ": " << text.text;
        }
    }
}

TEST(ShippedWords, AreShownOnTheCardInTheChosenLanguage) {
    const auto exercise = load_exercise(shipped / "guided" / "05-aggressor.toml");
    ASSERT_TRUE(exercise);
    Desk desk(1280, 1400, 1, true);
    desk.strings = speaking("de");
    add_translations(desk.strings, texts_of(*exercise), words_of_shipped("de"));
    desk.opened = *exercise;
    desk.open_exercise();
    desk.frame(4);
    std::string all;
    for (const Written& w : desk.written) all += w.words + "\n";
    for (const TranslatableText& text : texts_of(*exercise)) {
        if (text.text == exercise->title) continue;  // the same in German
        EXPECT_EQ(all.find(text.text.substr(0, 20)), std::string::npos) << text.text;
    }
    EXPECT_NE(all.find("Es berührt die Lampe"), std::string::npos);
}

TEST(ShippedWords, TheQuestionOfEachExerciseIsShownWholeInASmallWindow) {
    for (const std::string& code : shipped_codes())
        for (const auto& file : fs::directory_iterator(shipped / "guided")) {
            SCOPED_TRACE(code + " " + file.path().filename().string());
            const auto exercise = load_exercise(file.path());
            ASSERT_TRUE(exercise);
            if (exercise->prediction.question.empty()) continue;
            Desk desk(1024, 768, 1, true);
            desk.strings = speaking(code);
            if (code != std::string("en")) add_translations(desk.strings, texts_of(*exercise), words_of_shipped(code));
            desk.opened = *exercise;
            desk.open_exercise();
            World::create(exercise->scene, 1)->capture(desk.now);
            desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
            desk.frame(6);
            const std::string question(desk.strings.find(exercise->prediction.question, exercise->prediction.question));
            bool found = false;
            for (Written w : desk.written) {
                std::replace(w.words.begin(), w.words.end(), '\n', ' ');
                if (w.words != question) continue;
                found = true;
                EXPECT_GE(w.rect.y, w.clip.y);
                EXPECT_LE(w.rect.y + w.rect.h, w.clip.y + w.clip.h);
            }
            EXPECT_TRUE(found) << question;
        }
}

}  // namespace braitenlab::tests::shipped_words_test
