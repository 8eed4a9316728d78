#include "core/lesson/write_exercise.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/exercise_schema.h"

namespace braitenlab::tests::write_exercise_test {
namespace {

namespace fs = std::filesystem;

const fs::path guided = fs::path(BRAITENLAB_SOURCE) / "exercises" / "guided";

// The visitor of core/scene/schema.h that compares every value of two structs.
template <class T>
struct Compared {
    const T& a;
    const T& b;
    std::string where;

    template <class Number>
    void number(const char* key, Number T::*member, const char*, Range, const char*) {
        EXPECT_EQ(a.*member, b.*member) << where << key;
    }
    void text(const char* key, std::string T::*member, std::size_t, const char*) {
        EXPECT_EQ(a.*member, b.*member) << where << key;
    }
    void flag(const char* key, bool T::*member, const char*) { EXPECT_EQ(a.*member, b.*member) << where << key; }
    void texts(const char* key, std::vector<std::string> T::*member, std::size_t, std::size_t, const char*) {
        EXPECT_EQ(a.*member, b.*member) << where << key;
    }
    void choice(const char* key, int T::*member, std::vector<std::string> T::*, const char*) {
        EXPECT_EQ(a.*member, b.*member) << where << key;
    }
    void brain_keys(BrainText T::*, const char*) { EXPECT_EQ(a.submission, b.submission) << where; }
    void settings(const char* key, std::vector<Setting> T::*member, const char*) {
        ASSERT_EQ((a.*member).size(), (b.*member).size()) << where << key;
        for (std::size_t i = 0; i < (a.*member).size(); ++i) {
            EXPECT_EQ((a.*member)[i].path, (b.*member)[i].path);
            EXPECT_EQ((a.*member)[i].value, (b.*member)[i].value);
        }
    }
    template <class Part>
    void part(Part T::*member) {
        compare(a.*member, b.*member, where);
    }
    template <class Inner>
    void table(const char* key, Inner T::*member, const char*) {
        compare(a.*member, b.*member, where + key + ".");
    }
    template <class Element>
    void list(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        ASSERT_EQ((a.*member).size(), (b.*member).size()) << where << key;
        for (std::size_t i = 0; i < (a.*member).size(); ++i)
            compare((a.*member)[i], (b.*member)[i], where + key + "." + std::to_string(i + 1) + ".");
    }
    template <class... Types>
    void variant(const char* key, std::variant<Types...> T::*member, const char*) {
        ASSERT_EQ((a.*member).index(), (b.*member).index()) << where << key;
        std::visit([&]<class Type>(const Type& value) { compare(value, std::get<Type>(b.*member), where); }, a.*member);
    }

    template <class Other>
    static void compare(const Other& a, const Other& b, const std::string& where) {
        Compared<Other> inner{a, b, where};
        describe(inner, Of<Other>{});
    }
};

// Expects that the exercise is the same once it has been written and read.
void expect_same_after_writing(const Exercise& exercise) {
    const std::string text = write_exercise(exercise);
    const auto read = parse_exercise(text, exercise.id + ".toml");
    ASSERT_TRUE(read) << read.error().text() << "\n" << text;
    Compared<Exercise>::compare(exercise, *read, exercise.id + ": ");
    EXPECT_EQ(exercise.scene, read->scene) << exercise.id;
    EXPECT_EQ(text, write_exercise(*read));
}

TEST(WriteExercise, EveryShippedExerciseIsTheSameOnceWrittenAndRead) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(guided)) {
        const auto exercise = load_exercise(entry.path());
        ASSERT_TRUE(exercise) << exercise.error().text();
        expect_same_after_writing(*exercise);
        ++count;
    }
    EXPECT_GE(count, 20);
}

TEST(WriteExercise, KeepsQuotesLinesAndConditionsOnTime) {
    auto exercise = load_exercise(guided / "05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    exercise->goal = "\"Strike\" the lamp \\ now\nor later.";
    const Check near{goals::Touches{"", 0.5f}, "", 2, 1, 9};
    Check both{goals::AllOf{{near, {goals::NoneOf{{{goals::Rests{0.1f}}}}, "", 0.5f}}}, "", 1};
    both.after = 1;
    exercise->steps.push_back({"It stays, but moves", both});
    exercise->steps.push_back({"It runs", {goals::Runs{3}}});
    expect_same_after_writing(*exercise);
}

TEST(WriteExercise, KeepsADialOfAnAnswerThatIsZero) {
    auto exercise = load_exercise(guided / "05-aggressor.toml");
    ASSERT_TRUE(exercise) << exercise.error().text();
    Answer blind{.name = "blind", .text = "It sees \"nothing\"."};
    blind.brain.given = {Dial::LM};
    exercise->wrong.push_back(blind);
    const auto read = parse_exercise(write_exercise(*exercise), "05-aggressor.toml");
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->wrong.size(), exercise->wrong.size());
    EXPECT_EQ(read->wrong.back().text, blind.text);
    EXPECT_EQ(read->wrong.back().submission.brain, make_graph(FourNeurons{}));
}

}  // namespace
}  // namespace braitenlab::tests::write_exercise_test
