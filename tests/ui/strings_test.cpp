#include "ui/strings.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <regex>
#include <set>

#include "core/brain/edit.h"
#include "core/brain/presets.h"
#include "core/brain/recogniser.h"
#include "core/export/export.h"
#include "core/insight/compare.h"
#include "core/io/run_file.h"
#include "core/lesson/author.h"
#include "core/lesson/exercise.h"
#include "core/lesson/lecture.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/scene/check.h"
#include "core/scene/enums.h"
#include "core/scene/scene_file.h"
#include "core/sensing/intensity.h"
#include "core/session/session.h"
#include "desk.h"
#include "tests/folder.h"
#include "ui/panels/course/glossary.h"
#include "ui/scene_input/edits.h"
#include "ui/shortcuts.h"
#include "ui/widgets/record_fields.h"

namespace braitenlab::tests::strings_test {

using namespace ui;

namespace {

fs::path folder() { return fs::path(BRAITENLAB_SOURCE) / "ui" / "strings"; }

// The gaps and the keys in brackets, sorted: a translation may change their order.
std::multiset<std::string> marks(const std::string& words) {
    std::multiset<std::string> found;
    const std::regex mark("\\{\\}|\\[[A-Za-z0-9_]+\\]");
    for (std::sregex_iterator at(words.begin(), words.end(), mark), end; at != end; ++at) found.insert(at->str());
    return found;
}

// What the groups of an expression match, in all sources that may name a key.
std::set<std::string> found_in_sources(const std::regex& expression, std::initializer_list<std::size_t> groups) {
    const fs::path root(BRAITENLAB_SOURCE);
    std::set<std::string> found;
    for (const char* folder : {"ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
            std::ifstream in(entry.path());
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
                for (const std::size_t group : groups)
                    if ((*at)[group].matched) found.insert((*at)[group]);
        }
    return found;
}

// Every quoted text in the form of a key.
std::set<std::string> quoted_in_sources() {
    return found_in_sources(std::regex("\"([a-z_]+(\\.[A-Za-z0-9_-]+)+)\""), {1});
}

// Keys given to ui.strings(…) as literals.
std::set<std::string> asked_in_sources() {
    return found_in_sources(
        std::regex("strings_?\\(\\s*(?:[^()\"]*\\?\\s*)?\"([^\"]+)\"(?:\\s*:\\s*\"([^\"]+)\")?\\s*\\)"), {1, 2});
}

// The visitor of core/scene/schema.h that collects the keys of the rows of a record.
template <class T>
struct FieldKeys : ValuesWithoutRow<T> {
    using ValuesWithoutRow<T>::word;

    explicit FieldKeys(std::set<std::string>& found) : keys(found) {}

    std::set<std::string>& keys;

    void add(const char* key) {
        const std::string stem = "field." + std::string(record_word(Of<T>{})) + "." + key;
        keys.insert(stem), keys.insert(stem + "_how");
    }
    template <class Number>
    void number(const char* key, Number T::*, const char*, Range, const char*) {
        add(key);
    }
    void angle(const char* key, float T::*, Range, const char*) { add(key); }
    void flag(const char* key, bool T::*, const char*) { add(key); }
    template <class Enum>
    void word(const char* key, Enum T::*, const char*) {
        add(key);
        for (const auto& row : table_of(Enum{})) {
            if constexpr (requires { row.is_source; })
                if (!row.is_source) continue;
            keys.insert(std::string(word_stem(Enum{})) + std::string(row.word));
        }
    }
    void text(const char* key, std::string T::*, std::size_t, const char*) { add(key); }
};

// Every goal that the sheet of the author offers, in a scene that has everything.
std::vector<Goal> authored_goals() {
    Scene scene;
    scene.kinds.resize(2);
    scene.kinds[0].name = "one", scene.kinds[1].name = "two";
    scene.kinds[0].role = Role::predator, scene.kinds[1].role = Role::prey;
    scene.kinds[0].sensors.resize(1);
    scene.starts = {{"first", "one"}, {"second", "two"}};
    scene.sources.resize(1), scene.obstacles.resize(2), scene.zones.resize(1);
    scene.zones[0].surface = Surface::tape, scene.zones[0].recharge = 1;
    return goals_for(scene, "first");
}

// Keys composed of a stem and a name of the program.
std::set<std::string> composed() {
    std::set<std::string> keys;
    for (int i = 0; i <= static_cast<int>(last_action); ++i)
        keys.insert("action." + std::string(name(static_cast<Action>(i))));
    for (int i = 0; i <= static_cast<int>(last_place); ++i)
        keys.insert("keys.place." + std::string(name(static_cast<KeyPlace>(i))));
    for (int i = 0; i <= static_cast<int>(Character::mixed); ++i)
        for (const char* stem : {"character.", "character_story.", "response."})
            keys.insert(stem + std::string(name(static_cast<Character>(i))));
    for (const ChannelTraits& channel : channel_table)
        for (const char* stem : {"view.channel.", "wiring.senses.", "sense."})
            keys.insert(stem + std::string(channel.word));
    for (const ChannelTraits& channel : channel_table)  // others fit the words of response.explorer
        if (!std::set<std::string_view>{"light", "heat", "smell", "oxygen"}.contains(channel.word))
            keys.insert("response_to.explorer_" + std::string(channel.word));
    for (const char* stem : {"character.", "character_story."}) keys.insert(stem + std::string("parts"));
    for (const char* stem : {"hide", "reveal", "rebuild", "compare"})
        keys.insert("mystery." + std::string(stem) + "_how");
    for (const auto& row : insight::compare_measure_table) keys.insert("slots.measure." + std::string(row.word));
    for (const auto part : offer_parts::all) keys.insert("author.part." + std::string(part));
    for (const Goal& each : authored_goals()) {
        Goal goal = each;
        keys.insert("author.goal." + std::string(word_of(goal)));
        for (const GoalValue& value : values_of(goal)) keys.insert("author.value." + std::string(value.key));
    }
    for (const NeuronKind& kind : neuron_kinds) keys.insert("wiring.kind." + std::string(kind.word));
    for (const RefusalName& refusal : refusals) keys.insert("wiring.refused." + std::string(refusal.word));
    for (const auto& driver : driver_table) {
        if (driver.value == Driver::brain) continue;
        keys.insert("driver." + std::string(driver.word));
        keys.insert("drive." + std::string(driver.word));
    }
    for (const Preset& preset : presets())
        for (const char* stem : {"preset.", "preset_story."}) keys.insert(stem + std::string(preset.name));
    for (const auto& row : sensor_shape_table) keys.insert("sensors." + std::string(row.word));
    for (const auto& row : sensor_response_table) keys.insert("sensors." + std::string(row.word));
    for (const std::string_view object : scene_object_words)
        if (object != "none") {
            if (object != "vehicle") keys.insert("thing." + std::string(object));
            for (const char* stem : {"thing.one_", "thing.many_"}) keys.insert(stem + std::string(object));
        }
    each_record([&]<class T>(Of<T> record) {
        FieldKeys<T> fields{keys};
        describe(fields, record);
    });
    for (const MessageText& message : message_table) keys.insert("error." + std::string(message.id));
    for (const char* row : {"kind.name", "kind.count", "body.track", "body.wheel_radius", "sensors.noise",
                            "sensors.latency"})  // ui/panels/kind_editor.cpp
        for (const char* end : {"", "_how"}) keys.insert("field." + std::string(row) + end);
    for (const char* unit : {"rounds", "laps", "contacts", "captures", "vehicles", "times"})
        keys.insert("unit." + std::string(unit));        // ui/panels/course/lesson_text.cpp
    for (const robots::Robot& robot : robots::robots())  // ui/panels/robot_sheet.cpp
        for (const char* stem : {"robot.to_", "robot.next_"}) keys.insert(stem + std::string(robot.word()));
    for (const char* role : {"predator", "prey"}) keys.insert("scene.goal_" + std::string(role));
    for (int chapter = 1; chapter <= 5; ++chapter) keys.insert("chapter." + std::to_string(chapter));
    for (const char* stem : {"character.", "character_story."}) keys.insert(stem + std::string("hidden"));
    for (const char* key : {"sensors.name", "sensors.name_how"}) keys.insert(key);  // ui/panels/sensor_card.cpp
    for (const GlossaryTerm& term : terms())
        for (const char* end : {".name", ".text", ".forms"}) keys.insert("glossary." + std::string(term.id) + end);
    for (const Channel channel : source_channels) keys.insert("source." + std::string(word(channel)));
    for (const auto& row : insight::behaviour_table) keys.insert("map.kind." + std::string(row.word));
    for (const auto& row : insight::study_measure_table) keys.insert("study.measure." + std::string(row.word));
    for (const auto& row : insight::map_measure_table) keys.insert("map.measure." + std::string(row.word));
    for (const char* group : {"brain", "body", "scene"}) keys.insert("map.group." + std::string(group));
    for (const char* value :  // ui/panels/map_choices.cpp
         {"sensor_angle", "sensor_field",     "sensor_range",       "sensor_half_distance",
          "sensor_noise", "sensor_latency",   "sensor_gain_spread", "body_top_speed",
          "body_mass",    "body_motor_force", "body_mismatch",      "body_dead_band",
          "start_x",      "start_y",          "start_heading",      "source_x",
          "source_y",     "source_strength",  "arena_ambient",      "arena_friction",
          "arena_grip"})
        keys.insert("map.value." + std::string(value));
    return keys;
}

// Sections whose keys need not exist: a kind may have any name, the tooltip of a button may be its label.
bool is_optional(const std::string& key) {
    return key.starts_with("kind.") || key.starts_with("kind_all.") || key.starts_with("name.") ||
           key.starts_with("tooltip.");
}

}  // namespace

TEST(Strings, HaveWordsForEveryKeyInTheSources) {
    const Strings strings = english();
    const auto asked = asked_in_sources();
    EXPECT_GT(asked.size(), 40u) << "the search finds keys";
    for (const std::string& key : asked) EXPECT_TRUE(strings.all().count(key)) << key;
    for (const std::string& key : composed()) EXPECT_TRUE(strings.all().count(key)) << key;
}

TEST(Strings, HaveNoUnusedWords) {
    const auto quoted = quoted_in_sources();
    const auto built = composed();
    const Strings strings = english();
    for (const auto& [key, words] : strings.all())
        EXPECT_TRUE(quoted.count(key) || built.count(key) || is_optional(key)) << key << " = " << words;
}

TEST(Strings, ListEnglishGermanAndSpanishByTheirNativeNames) {
    std::vector<std::string> codes, names;
    for (const Language& language : languages(folder())) codes.push_back(language.code), names.push_back(language.name);
    EXPECT_EQ(codes, (std::vector<std::string>{"de", "en", "es"}));
    EXPECT_EQ(names, (std::vector<std::string>{"Deutsch", "English", "Español"}));
}

TEST(Strings, HaveTheSameKeysGapsAndShortcutsInEveryLanguage) {
    const Strings strings = english();
    for (const Language& language : languages(folder())) {
        const auto other = Strings::load(folder() / (language.code + ".toml"));
        ASSERT_TRUE(other) << other.error().text();
        for (const auto& [key, words] : strings.all()) {
            ASSERT_TRUE(other->all().count(key)) << language.code << " lacks " << key;
            EXPECT_EQ(marks(other->all().at(key)), marks(words)) << language.code << ": " << key;
        }
        for (const auto& [key, words] : other->all())
            EXPECT_TRUE(strings.all().count(key)) << language.code << " only has " << key;
    }
}

TEST(Strings, AreTranslated) {
    const Strings strings = english();
    for (const char* code : {"de", "es"}) {
        const Strings other = speaking(code);
        int sentences = 0;
        for (const auto& [key, words] : strings.all()) {
            if (std::count(words.begin(), words.end(), ' ') < 3 || marks(words).size() > 2) continue;
            ++sentences;
            EXPECT_NE(other(key), words) << code << ": " << key;
        }
        EXPECT_GT(sentences, 50);
    }
}

TEST(Strings, ListTheLanguagesForAnUnknownOne) {
    const auto klingon = load_language(folder(), "tlh");
    ASSERT_FALSE(klingon);
    EXPECT_NE(klingon.error().text().find("de, en, es"), std::string::npos) << klingon.error().text();
    EXPECT_FALSE(load_language(folder(), "../strings/en")) << "a language is a name, not a path";
}

TEST(Strings, UseEnglishForMissingWords) {
    const Folder own;
    const fs::path& place = own.path;
    std::ofstream(place / "en.toml") << "format = 1\n[a]\nb = \"words\"\nc = \"more\"\n";
    std::ofstream(place / "xx.toml") << "format = 1\n[a]\nb = \"wxrds\"\n";
    std::ofstream(place / "yy.toml") << "format = 1\n[a]\nb = 3\n";
    const auto half = load_language(place, "xx");
    ASSERT_TRUE(half) << half.error().text();
    EXPECT_EQ((*half)("a.b"), "wxrds");
    EXPECT_EQ((*half)("a.c"), "more");
    const auto broken = load_language(place, "yy");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().line, 3);
}

TEST(Strings, ShowTheKeyForWordsMissingInEveryLanguage) {
    const auto strings = Strings::parse("format = 1\n[a]\nb = \"words\"", "test.toml");
    ASSERT_TRUE(strings);
    EXPECT_EQ((*strings)("a.b"), "words");
    EXPECT_EQ((*strings)("a.c"), "a.c");
    EXPECT_EQ(strings->find("a.c", "else"), "else");
}

TEST(Strings, ReportTheLineOfAnErrorInAFile) {
    const auto number = Strings::parse("format = 1\n[a]\nb = 3", "test.toml");
    ASSERT_FALSE(number);
    EXPECT_EQ(number.error().line, 3);
    EXPECT_EQ(number.error().file, "test.toml");
    EXPECT_FALSE(Strings::parse("[a]\nb = \"c\"", "test.toml")) << "without format = 1";
    EXPECT_FALSE(Strings::parse("format = 1\n[a", "test.toml"));
}

TEST(Strings, FillTheirGapsInOrder) {
    EXPECT_EQ(fill("Passed {} of {} starts", {"8", "10"}), "Passed 8 of 10 starts");
    EXPECT_EQ(fill("{}{}", {"a"}), "a{}");
    EXPECT_EQ(fill("{}", {"{}"}), "{}");
}

namespace {

// A line of ui/strings/unwanted_words.txt.
struct UnwantedWord {
    std::string language, word, instead;
};

std::vector<UnwantedWord> unwanted_words() {
    std::ifstream in(folder() / "unwanted_words.txt");
    std::vector<UnwantedWord> words;
    const std::regex row("(\\w+) \\| (.+) \\| (.+)");
    std::smatch parts;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        EXPECT_TRUE(std::regex_match(line, parts, row)) << "unwanted_words.txt: " << line;
        words.push_back({parts[1], parts[2], parts[3]});
    }
    return words;
}

std::string in_small_letters(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] >= 'A' && text[i] <= 'Z') text[i] = static_cast<char>(text[i] - 'A' + 'a');
        const bool is_capital = text[i] == '\xC3' && i + 1 < text.size() && text[i + 1] < '\x9F';  // Ä, É, Ñ …
        if (is_capital) text[i + 1] = static_cast<char>(text[i + 1] + 0x20), ++i;
    }
    return text;
}

bool has_word(const std::string& text, const std::string& word) {
    const std::string small = in_small_letters(text);
    for (std::size_t at = small.find(word); at != small.npos; at = small.find(word, at + 1)) {
        const auto before = static_cast<unsigned char>(at == 0 ? ' ' : small[at - 1]);
        if (!(before >= 'a' && before <= 'z') && before < 0x80) return true;
    }
    return false;
}

}  // namespace

TEST(Strings, HaveOneWordForOneConcept) {
    EXPECT_TRUE(has_word("Die Drähte", "drähte"));
    EXPECT_TRUE(has_word("ÄNDERN", "ändern"));
    EXPECT_FALSE(has_word("ausgewählte", "gewählte"));
    const auto unwanted = unwanted_words();
    EXPECT_GT(unwanted.size(), 20u);
    for (const auto& [language, word, instead] : unwanted)
        for (const fs::path& file : {folder() / (language + ".toml"),
                                     fs::path(BRAITENLAB_SOURCE) / "exercises" / "words" / (language + ".toml")}) {
            const auto strings = fs::exists(file) ? Strings::load(file) : Result<Strings>(Strings{});
            ASSERT_TRUE(strings) << strings.error().text();
            for (const auto& [key, text] : strings->all())
                EXPECT_FALSE(has_word(text, word))
                    << file.filename() << ": " << key << " has '" << word << "'; use '" << instead << "'";
        }
}

TEST(Strings, HaveTheEllipsisAndMarksOfTheLanguage) {
    const Strings spanish = speaking("es");
    for (const auto& [key, text] : spanish.all()) {
        EXPECT_EQ(text.find(" …"), std::string::npos) << key << ": no space before the ellipsis";
        const auto count = [&](std::string_view mark) {
            std::size_t found = 0;
            for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) ++found;
            return found;
        };
        EXPECT_EQ(count("?"), count("¿")) << key << ": " << text;
        EXPECT_EQ(count("!"), count("¡")) << key << ": " << text;
    }
}

TEST(Strings, NameTheKindsOfEveryShippedSceneThatHasSeveral) {
    int kinds = 0;
    std::map<std::string, Strings> words;  // without those of English for missing ones
    for (const Language& language : shipped_languages())
        words[language.code] =
            *Strings::load(std::string(BRAITENLAB_SOURCE) + "/ui/strings/" + language.code + ".toml");
    const std::filesystem::path shipped = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises";
    std::vector<Scene> scenes;
    for (const auto& file : std::filesystem::directory_iterator(shipped / "scenes"))
        if (const auto scene = load_scene(file.path())) scenes.push_back(*scene);
    for (const auto& file : std::filesystem::directory_iterator(shipped / "guided"))
        if (const auto exercise = load_exercise(file.path())) scenes.push_back(exercise->scene);
    EXPECT_GT(scenes.size(), 40u);
    for (const Scene& scene : scenes) {
        if (scene.kinds.size() < 2) continue;
        for (const Kind& kind : scene.kinds) {
            ++kinds;
            for (const auto& [language, own] : words)
                EXPECT_TRUE(own.all().contains("kind." + kind.name)) << kind.name << " in " << language;
        }
    }
    EXPECT_GT(kinds, 10);
}

TEST(Strings, HaveATranslationOfEachErrorMessage) {
    const Strings words = english();
    std::set<std::string> ids;
    for (const MessageText& row : message_table) {
        const std::string key = "error." + std::string(row.id);
        EXPECT_EQ(words.find(key, ""), row.english) << "as in core/messages.h";
        EXPECT_TRUE(ids.insert(key).second) << key << " twice";
    }
    const auto is_message = [&](const auto& each) {
        return ids.count(each.first) > 0 || each.first == "error.english";
    };
    for (const auto& each : words.all())
        EXPECT_TRUE(!each.first.starts_with("error.") || is_message(each)) << each.first << " is no message";
}

TEST(Strings, TranslateAnErrorOfSeveralParts) {
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

TEST(Strings, TranslateErrorsOfFiles) {
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

TEST(Strings, TranslateEveryMistakeInExercisesAndLectures) {
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
        for (const char* code : {"de", "es"})
            EXPECT_NE(text_of(error, speaking(code)), error.text()) << "not in " << code;
    }
    for (const char* source : {"check_exercise.cpp", "exercise.cpp", "lecture.cpp"})
        for (const std::string& id : messages_in(fs::path("core/lesson") / source))
            EXPECT_TRUE(seen.contains(id)) << id << " of " << source << ": add a file with this mistake";
    for (const char* id : {"no_colour", "same_name", "too_many_times", "off_before_on", "no_such_value",
                           "a_plain_value", "named_tables", "short_texts", "key_of_other", "key_of_own"})
        EXPECT_TRUE(seen.contains(id)) << id << ": add a file with this mistake";
}

}  // namespace braitenlab::tests::strings_test
