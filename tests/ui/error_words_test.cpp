// Errors in the language of the window.
#include <regex>
#include <set>

#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/lecture.h"
#include "core/messages.h"
#include "core/scene/check.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "desk.h"
#include "tests/folder.h"

namespace braitenlab::tests::error_words_test {

using namespace ui;

namespace {

// An exercise with a scene of its own, and its parts that a test replaces by wrong ones.
struct ExerciseText {
    std::string top = "title = \"t\"\ngoal = \"g\"\n", answers = "[solution]\n", text = "text = \"t\"\n",
                check = "goal = \"runs\"\nseconds = 1\n", of_vehicle, more;

    Error error() const {
        const std::string file = "format = 1\n" + top + answers + "[[step]]\n" + text + check + R"(
[scene.kind.k.sensor.SL]
[scene.kind.k.sensor.SR]
[scene.kind.k.brain]
LR = 1
[scene.source.lamp]
x = 3
[scene.vehicle.two]
kind = "k"
x = -4
[scene.vehicle.one]
kind = "k"
)" + of_vehicle + more;
        const auto exercise = parse_exercise(file, fs::path(BRAITENLAB_SOURCE) / "exercises/guided/x.toml");
        if (!exercise) return exercise.error();
        ADD_FAILURE() << "no error in\n" << file;
        return {};
    }
};

std::vector<Error> errors_of_exercises() {
    std::vector<Error> errors;
    const auto add = [&](std::string ExerciseText::*part, const std::vector<std::string>& mistakes) {
        for (const std::string& mistake : mistakes) {
            ExerciseText file;
            file.*part = mistake;
            errors.push_back(file.error());
        }
    };
    const std::string top = ExerciseText().top, check = ExerciseText().check, solution = ExerciseText().answers;
    const std::string follows = "goal = \"follows\"\nmetres = 1\ndegrees = 9\n";
    add(&ExerciseText::check, {"",
                               "goal = \"touches\"\nsource = \"lump\"\nmetres = 1\n",
                               "goal = \"enters\"\nzone = \"\"\n",
                               "goal = \"enters\"\nzone = \"z\"\n",
                               "goal = \"drives_through\"\nleft = \"\"\nright = \"\"\n",
                               "goal = \"drives_through\"\nleft = \"a\"\nright = \"b\"\n",
                               follows + "other = \"\"\n",
                               follows + "other = \"on\"\n",
                               follows + "other = \"two\"\n",
                               "goal = \"population\"\nkind = \"\"\ncount = 1\n",
                               "goal = \"population\"\nkind = \"j\"\ncount = 1\n",
                               "goal = \"speed_follows\"\nsensor = \"\"\ncorrelation = 0.5\nseconds = 1\n",
                               "goal = \"speed_follows\"\nsensor = \"SM\"\ncorrelation = 0.5\nseconds = 1\n",
                               "goal = \"matches\"\nmetres = 1\nseconds = 9\nvehicle = \"one\"\n",
                               "goal = \"keeps_speed\"\nfrom = 3\nto = 2\n",
                               "goal = \"recharges\"\nlow = 0.8\nhigh = 0.5\ncount = 1\n",
                               check + "after = 2\n",
                               check + "latest = 1\nearliest = 2\n",
                               "goal = \"any_of\"\ncheck = []\n",
                               "goal = \"touches\"\nsource = \"lamp\"\n",
                               check + "metres = 1\n",
                               check + "metrs = 1\n"});
    add(&ExerciseText::text, {""});
    ExerciseText two_sources{.check = "goal = \"turns_to\"\nsource = \"\"\ndegrees = 9\n"};
    two_sources.more = "[scene.source.fire]\nx = -3\n";
    errors.push_back(two_sources.error());
    add(&ExerciseText::top,
        {"", top + "offers = [\"LX\"]\n", top + "offers = [\"LL\", \"LL\"]\n", top + "offers = [1]\n",
         top + "offers = [\"LL=LM\"]\n", top + "hides = [\"k\"]\n", top + "offers = [\"LL\"]\n[selection]\n",
         top + "changes = 1\n", top + "changes = 1\noffers = [\"wiring\"]\n", top + "starts = 2\nneeded = 3\n",
         top + "[median]\nstep = 3\n", top + "[median]\n", top + "[predict]\n",
         top + "[predict]\nquestion = \"q\"\npath = \"on\"\n", top + "[[hint]]\ntext = \"h\"\nanchor = \"slider.LM\"\n",
         top + "[[hint]]\nanchor = \"slider.LL\"\n",
         top + "[predict]\nquestion = \"q\"\noptions = [\"a\", \"b\"]\nanswer = \"a\"\n[[predict.shows]]\n" +
             "option = \"c\"\n" + check,
         top + "[set]\n\"kind.k.brain.LX\" = 1\n", top + "[set]\n\"kind.k.brain.LL\" = [1]\n"});
    add(&ExerciseText::answers, {"", "[solution.set]\n\"source.lamp.x\" = 2\n", "[solution]\nLR = 3\n"});
    add(&ExerciseText::of_vehicle, {"[scene.vehicle.two.brain]\nLL = 1\n", "[scene.vehicle.two.sensor.S]\n"});
    add(&ExerciseText::more, {"[scene.zone]\nx = 1\n", "[[scene.source.lamp.on]]\nfrom = 3\nuntil = 2\n"});
    const std::string start = "format = 1\n" + top, bare = start + "scene = \"../scenes/2b-aggressor.toml\"\n";
    for (const std::string& text :
         {start, start + "scene = \"none.toml\"\n", bare, bare + solution, start + "scene = {}\n"})
        errors.push_back(parse_exercise(text, fs::path(BRAITENLAB_SOURCE) / "exercises/guided/x.toml").error());
    return errors;
}

std::vector<Error> errors_of_lectures() {
    const fs::path exercises = fs::path(BRAITENLAB_SOURCE) / "exercises";
    const std::string top = "format = 1\ntitle = \"t\"\nminutes = 5\n",
                      page = top + "[[page]]\nscene = \"2a-coward\"\n";
    const auto read = [&](const std::string& text) { return parse_lecture(text, "/nowhere/own.toml", exercises); };
    std::vector<Error> errors;
    for (const std::string& text :
         {top, top + "page = []\n", top + "[[page]]\nscene = \"2a-cowerd\"\n", top + "[[page]]\nexercise = \"99\"\n",
          top + "[[page]]\n", page + "exercise = \"01-drive\"\n", page + "steps = [\" \"]\n",
          page + "steps = [\"brian\"]\n", page + "[page.question]\noptions = [\"left\"]\n",
          page + "[page.question]\noptions = [\"left\", \"right\"]\n"}) {
        const auto lecture = read(text);
        EXPECT_FALSE(lecture) << text;
        if (!lecture) errors.push_back(lecture.error());
    }
    const auto unknown = check_pages(*read(page + "select = \"two\"\n"));
    EXPECT_TRUE(unknown);
    if (unknown) errors.push_back(*unknown);
    return errors;
}

// The errors of scenes that the window can make and a file cannot.
std::vector<Error> errors_of_scenes() {
    Scene coloured, twins, many;
    coloured.kinds.resize(1), coloured.kinds[0].name = "k", coloured.kinds[0].colour = "red";
    twins.kinds.resize(2), twins.kinds[0].name = twins.kinds[1].name = "k";
    many.kinds.resize(limits::kinds + 1);
    std::vector<Error> errors;
    for (const Scene& scene : {coloured, twins, many}) {
        const auto fault = find_fault(scene);
        EXPECT_TRUE(fault);
        if (fault) errors.push_back(error_of(fault->what));
    }
    return errors;
}

// The ids of messages in a source.
std::set<std::string> messages_in(const fs::path& source) {
    const std::string text = text_of(fs::path(BRAITENLAB_SOURCE) / source);
    std::set<std::string> found;
    for (const MessageText& row : message_table)
        if (text.find('"' + std::string(row.id) + '"') != text.npos) found.emplace(row.id);
    return found;
}

}  // namespace

TEST(ErrorWords, HaveATranslationOfEachErrorMessage) {
    std::set<std::string> keys{"error.english"};
    for (const MessageText& row : message_table) {
        const std::string key = "error." + std::string(row.id);
        EXPECT_EQ(english().find(key, ""), row.english);
        EXPECT_TRUE(keys.insert(key).second) << key << " twice";
    }
    for (const Language& language : shipped_languages()) {
        const auto in_file = Strings::load(fs::path(BRAITENLAB_SOURCE) / "ui" / "strings" / (language.code + ".toml"));
        ASSERT_TRUE(in_file);
        std::set<std::string> found;
        for (const auto& [key, words] : in_file->all())
            if (key.starts_with("error.")) found.insert(key);
        // The English texts are in core/messages.h alone.
        EXPECT_EQ(found, language.code == "en" ? std::set<std::string>{"error.english"} : keys) << language.code;
    }
}

TEST(ErrorWords, TranslateAnErrorOfSeveralParts) {
    const auto scene = parse_scene("format = 1\n[arena]\nwidht = 4\n", "mine.toml");
    ASSERT_FALSE(scene);
    EXPECT_EQ(text_of(scene.error(), english()), scene.error().text());
    EXPECT_EQ(text_of(scene.error(), speaking("de")),
              "mine.toml:3: es gibt keinen Schlüssel 'widht' in [arena]; am nächsten kommt 'width'");
    const auto number = parse_scene("format = 1\n[arena]\nwidth = \"wide\"\n", "mine.toml");
    ASSERT_FALSE(number);
    EXPECT_EQ(text_of(number.error(), speaking("es")), "mine.toml:3: width: hace falta un número, pero hay un texto");
    EXPECT_EQ(number.error().text(), "mine.toml:3: 'width' should be a number, not text");
    Scene crowded;
    crowded.ecology.population = 3;
    const auto refused = check_scene(crowded);
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->text(), "ecology.population: there is no [kind.NAME] to populate the arena with");
    EXPECT_EQ(text_of(*refused, speaking("de")),
              "Ecology.population: es gibt keine Tabelle [kind.NAME] für die Fahrzeuge der Arena");
    EXPECT_EQ(text_of(Error{"odd", "a.toml", 2}, speaking("de")), "a.toml:2: Meldung auf Englisch: odd");
}

TEST(ErrorWords, TranslateErrorsOfFiles) {
    const auto expect_german = [](const Error& error, std::string_view words) {
        const std::string text = text_of(error, speaking("de"));
        EXPECT_NE(text.find(words), std::string::npos) << text;
        EXPECT_EQ(text.find("Meldung auf Englisch"), std::string::npos) << text;
    };
    const auto scene = load_scene(fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2a-coward.toml");
    ASSERT_TRUE(scene);
    const std::string run = std::regex_replace(io::write_run(Session::open(*scene, 1)->save()),
                                               std::regex("\"next_id\": *[0-9]+"), "\"next_id\": 0");
    expect_german(io::read_run(run, "a.run").error(), "die Nummern der Fahrzeuge");
    expect_german(io::read_run("{}", "a.run").error(), "es ist eine andere Datei");
    expect_german(io::read_run("{\"braitenlab_run\": 99}", "a.run").error(), "seine Version ist 99");
    expect_german(io::read_run("[1e99]", "a.run").error(), "eine Zahl ist zu groß");
    expect_german(parse_exercise("format = 1\ntitle = \"t\"\n", "own.toml").error(), "scene fehlt");
}

TEST(ErrorWords, TranslateEveryMistakeInExercisesAndLectures) {
    std::vector<Error> errors = errors_of_exercises();
    for (const auto& more : {errors_of_lectures(), errors_of_scenes()})
        errors.insert(errors.end(), more.begin(), more.end());
    std::set<std::string> seen;
    for (const Error& error : errors) {
        EXPECT_FALSE(error.phrases.empty()) << error.text();
        for (const Phrase& phrase : error.phrases) {
            EXPECT_FALSE(phrase.id.empty()) << "no translation of '" << error.what << "'";
            seen.emplace(phrase.id);
        }
        for (const std::string& code : shipped_codes()) {
            if (code == "en") continue;
            EXPECT_NE(text_of(error, speaking(code)), error.text()) << "not in " << code;
        }
    }
    for (const char* source : {"check_exercise.cpp", "exercise_file.cpp", "lecture.cpp"})
        for (const std::string& id : messages_in(fs::path("core/lesson") / source))
            EXPECT_TRUE(seen.contains(id)) << id << " of " << source << ": add a file with this mistake";
    for (const char* id : {"no_colour", "same_name", "too_many_times", "off_before_on", "no_such_value",
                           "a_plain_value", "named_tables", "short_texts", "key_of_other", "key_of_own"})
        EXPECT_TRUE(seen.contains(id)) << id << ": add a file with this mistake";
}

}  // namespace braitenlab::tests::error_words_test
