// The keys of the words: each key in the sources has words, and no words are without a key.
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>

#include "core/brain/edit.h"
#include "core/brain/presets.h"
#include "core/brain/recogniser.h"
#include "core/evolve/breeding_file.h"
#include "core/export/export.h"
#include "core/insight/compare.h"
#include "core/lesson/author.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/scene_file.h"
#include "core/sensing/intensity.h"
#include "desk.h"
#include "tests/folder.h"
#include "ui/panels/course/glossary.h"
#include "ui/scene_input/edits.h"
#include "ui/shortcuts.h"
#include "ui/widgets/record_fields.h"

namespace braitenlab::tests::string_keys_test {

using namespace ui;

namespace {

// What the groups of an expression match, in all sources that may name a key.
std::set<std::string> found_in_sources(const std::regex& expression, std::initializer_list<std::size_t> groups) {
    const fs::path root(BRAITENLAB_SOURCE);
    std::set<std::string> found;
    for (const char* folder : {"ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path kind = entry.path().extension();
            if (kind != ".cpp" && kind != ".h" && kind != ".def") continue;
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
        for (const char* stem : {"view.channel.", "wiring.senses.", "wiring.word.", "sense."})
            keys.insert(stem + std::string(channel.word));
    for (const ChannelTraits& channel : channel_table)  // others fit the words of response.explorer
        if (!std::set<std::string_view>{"light", "heat", "smell", "oxygen"}.contains(channel.word))
            keys.insert("response_to.explorer_" + std::string(channel.word));
    for (const char* stem : {"character.", "character_story."})
        for (const char* instead : {"parts", "single_sensors"}) keys.insert(stem + std::string(instead));
    for (const char* stem : {"hide", "reveal", "rebuild", "compare"})
        keys.insert("mystery." + std::string(stem) + "_how");
    for (const auto& row : insight::compare_measure_table) keys.insert("slots.measure." + std::string(row.word));
    for (const auto part : offer_parts::all) keys.insert("author.part." + std::string(part));
    for (const Goal& each : authored_goals()) {
        Goal goal = each;
        keys.insert("author.goal." + std::string(word_of(goal)));
        for (const GoalValue& value : values_of(goal)) {
            const std::string key(value.key), how = "author.value_how.",
                                              own = how + std::string(word_of(goal)) + "_" + key;
            keys.insert("author.value." + key);
            if (!value.name) keys.insert(english().all().count(own) ? own : how + key);
        }
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
                            "sensors.latency"})  // ui/panels/kind/kind_editor.cpp
        for (const char* end : {"", "_how"}) keys.insert("field." + std::string(row) + end);
    for (const char* unit : {"rounds", "laps", "contacts", "captures", "vehicles", "times"})
        keys.insert("unit." + std::string(unit));        // ui/panels/course/lesson_text.cpp
    for (const robots::Robot& robot : robots::robots())  // ui/panels/robots/robot_sheet.cpp
        for (const char* stem : {"robot.to_", "robot.next_"}) keys.insert(stem + std::string(robot.word()));
    for (const char* role : {"predator", "prey"}) keys.insert("scene.goal_" + std::string(role));
    for (int chapter = 1; chapter <= 5; ++chapter) keys.insert("chapter." + std::to_string(chapter));
    for (const char* stem : {"character.", "character_story."}) keys.insert(stem + std::string("hidden"));
    for (const char* key : {"sensors.name", "sensors.name_how"}) keys.insert(key);  // ui/panels/kind/sensor_card.cpp
    for (const GlossaryTerm& term : terms())
        for (const char* end : {".name", ".text", ".forms"}) keys.insert("glossary." + std::string(term.id) + end);
    for (const Channel channel : source_channels) keys.insert("source." + std::string(word(channel)));
    for (const auto& row : insight::behaviour_table) keys.insert("map.kind." + std::string(row.word));
    for (const auto& row : insight::study_measure_table) keys.insert("study.measure." + std::string(row.word));
    for (const auto& row : evolve::opponents_table)  // ui/panels/breeding/breeding_sheet.cpp
        for (const char* end : {"", "_how"}) keys.insert("breeding.opponents_" + std::string(row.word) + end);
    for (const char* number : {"generations", "population", "seed"})
        for (const char* end : {"", "_how"}) keys.insert("breeding." + std::string(number) + end);
    for (const auto& row : insight::map_measure_table) keys.insert("map.measure." + std::string(row.word));
    for (const char* group : {"brain", "body", "scene"}) keys.insert("map.group." + std::string(group));
    for (const char* value :  // ui/panels/map/map_choices.cpp
         {"sensor_angle", "sensor_field",     "sensor_range",       "sensor_half_distance",
          "sensor_noise", "sensor_latency",   "sensor_gain_spread", "body_top_speed",
          "body_mass",    "body_motor_force", "body_mismatch",      "body_dead_band",
          "start_x",      "start_y",          "start_heading",      "source_x",
          "source_y",     "source_strength",  "arena_ambient",      "arena_friction",
          "arena_grip"})
        keys.insert("map.value." + std::string(value));
    const auto exercises = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "guided";
    for (const auto& file : std::filesystem::directory_iterator(exercises))  // ui/panels/files/file_lists.cpp
        keys.insert("search." + file.path().stem().string());
    return keys;
}

// Sections whose keys need not exist: a kind may have any name, the tooltip of a button may be its label.
bool is_optional(const std::string& key) {
    return key.starts_with("kind.") || key.starts_with("kind_all.") || key.starts_with("name.") ||
           key.starts_with("neuron.") || key.starts_with("tooltip.");
}

}  // namespace

TEST(StringKeys, HaveWordsForEveryKeyInTheSources) {
    const Strings strings = english();
    const auto asked = asked_in_sources();
    EXPECT_GT(asked.size(), 40u) << "the search finds keys";
    for (const std::string& key : asked) EXPECT_TRUE(strings.all().count(key)) << key;
    for (const std::string& key : composed()) EXPECT_TRUE(strings.all().count(key)) << key;
}

TEST(StringKeys, HaveNoUnusedWords) {
    const auto quoted = quoted_in_sources();
    const auto built = composed();
    const Strings strings = english();
    for (const auto& [key, words] : strings.all())
        EXPECT_TRUE(quoted.count(key) || built.count(key) || is_optional(key)) << key << " = " << words;
}

TEST(StringKeys, NameTheKindsOfEveryShippedSceneThatHasSeveral) {
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

}  // namespace braitenlab::tests::string_keys_test
