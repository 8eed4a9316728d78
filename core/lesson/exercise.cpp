#include "core/lesson/exercise.h"

#include <fmt/format.h>

#include "core/lesson/anchors.h"
#include "core/scene/format_table.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t steps = 32, hints = 32, options = 8;
}

// ── Every value of an exercise file, described once as core/scene/schema.h does for scenes ──

template <class Visitor>
void describe(Visitor& v, Of<Prediction>) {
    v.text("question", &Prediction::question, limits::text_length, "asked before the outcome is visible, never graded");
    v.texts("options", &Prediction::options, limits::options, limits::text_length, "two or more to choose from");
    v.choice("answer", &Prediction::answer, &Prediction::options, "the option that the run shows");
    v.text("outcome", &Prediction::outcome, limits::text_length,
           "shown once a run has shown it, beside the student's choice");
    v.number("after", &Prediction::after, "s", {0, 600},
             "of a run with the shipped brain, after which the outcome is visible");
}

template <class Visitor>
void describe(Visitor& v, Of<Check>) {
    v.variant("goal", &Check::goal, "what the vehicle must do; each goal has keys of its own, listed under Goals");
    v.text("vehicle", &Check::vehicle, limits::name_length,
           "NAME of the [vehicle.NAME] that must do it; without it, the scene's first");
    v.number("hold", &Check::hold, "s", {0, 600}, "the goal must stay met for so long without a break");
}

template <class Visitor>
void describe(Visitor& v, Of<Step>) {
    v.text("text", &Step::text, limits::text_length, "what is to be seen");
    v.part(&Step::check);
}

template <class Visitor>
void describe(Visitor& v, Of<Hint>) {
    v.text("text", &Hint::text, limits::text_length, "from a nudge to the whole solution, one after the other");
    v.text("anchor", &Hint::anchor, limits::title_length, "id of the widget that pulses, like slider.LR");
}

template <class Visitor>
void describe(Visitor& v, Of<Exercise>) {
    v.number("number", &Exercise::number, "", {0, 999}, "its position in the course");
    v.text("title", &Exercise::title, limits::title_length, "must be given");
    v.text("goal", &Exercise::goal, limits::text_length, "must be given");
    v.text("why", &Exercise::why, limits::text_length, "the mechanism, shown on request");
    v.number("seed", &Exercise::seed, "", {0, 1e15}, "of the run that the student sees");
    v.number("seconds", &Exercise::seconds, "s", {1, 600}, "duration of a graded run");
    v.number("starts", &Exercise::starts, "", {1, 100}, "number of seeds, from 1 on, that are graded");
    v.number("needed", &Exercise::needed, "", {1, 100}, "number of them that must pass every step");
    v.table("predict", &Exercise::prediction, "a prediction, to be made before the outcome is visible");
    v.list("step", &Exercise::steps, limits::steps, "what must happen; at least one");
    v.list("hint", &Exercise::hints, limits::hints, "help, in stages");
    v.table("solution", &Exercise::solution, "a brain that passes; must be given");
}

namespace {

// The settings of [set]: "kind.one.brain.LL" = 0.8, or kind.one.brain.LL = 0.8, which TOML nests.
void gather_settings(TomlFile& file, const TomlNode& table, const std::string& prefix, std::vector<Setting>& out) {
    for (const auto& [key, key_place, node] : *table.as_table()) {
        const std::string path = prefix + key;
        Setting setting{path, "", file.name, static_cast<int>(node.place.line)};
        if (node.as_table()) {
            gather_settings(file, node, path + ".", out);
            continue;
        } else if (const std::int64_t* whole = node.as_whole()) {
            setting.value = fmt::format("{}", *whole);
        } else if (const auto number = node.as_number()) {
            setting.value = fmt::format("{}", *number);
        } else if (const std::string* text = node.as_text()) {
            setting.value = *text;
        } else {
            return file.fail("set." + path, &node, fmt::format("{} should be a number or text", in_quotes(path)));
        }
        out.push_back(std::move(setting));
    }
}

// A part of the exercise file that is checked after reading: where it stands, and the scene that its names refer to.
struct ExercisePart {
    TomlFile& file;
    const TomlNode& table;
    std::string path;
    const Scene& scene;

    template <class Named>
    void check_name(const char* key, const std::string& name, const std::vector<Named>& known, const char* what) const {
        std::vector<std::string_view> names;
        for (const Named& each : known) names.emplace_back(each.name);
        if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
        file.fail(path + "." + key, table.get(key),
                  fmt::format("the scene has no {} called {}{}", what, in_quotes(name), name_nearest(name, names)));
    }
};

template <class... Goals>
std::string listed_words(const std::variant<Goals...>&) {
    std::string all;
    ((all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", Goals::traits.word)), ...);
    return all;
}

void check_check(const ExercisePart& part, const Check& check) {
    if (!part.table.contains("goal"))
        return part.file.fail(part.path, &part.table, "'goal' is missing; it is one of " + listed_words(Goal{}));
    part.check_name("vehicle", check.vehicle, part.scene.starts, "vehicle");
    const auto check_goal = [&]<class G>(const G& goal) {
        if constexpr (requires { goal.source; }) part.check_name("source", goal.source, part.scene.sources, "source");
        if constexpr (requires { goal.checks; }) {
            const TomlNode* checks = part.table.get("check");
            if (goal.checks.empty())
                part.file.fail(part.path, &part.table,
                               fmt::format("the goal '{}' needs at least one check of its own", G::traits.word));
            for (std::size_t i = 0; i < goal.checks.size() && !part.file.error; ++i)
                check_check(
                    {part.file, checks->as_list()->at(i), fmt::format("{}.check.{}", part.path, i + 1), part.scene},
                    goal.checks[i]);
        }
    };
    std::visit(check_goal, check.goal);
}

void check_prediction(TomlTable& top, const Prediction& prediction) {
    const TomlNode* table = top.content().get("predict");
    if (!table || !table->as_table()) return;
    if (prediction.question.empty() || prediction.options.size() < 2 || !table->contains("answer"))
        top.fail("predict", "a prediction needs a question, two or more options, and one of them as its answer");
}

void check_anchors(TomlTable& top, const Exercise& exercise) {
    const std::vector<std::string> anchors = anchors_of(exercise);
    const std::vector<std::string_view> known(anchors.begin(), anchors.end());
    const TomlNode* hints = top.content().get("hint");
    for (std::size_t i = 0; i < exercise.hints.size(); ++i) {
        const std::string& anchor = exercise.hints[i].anchor;
        if (anchor.empty() || std::find(known.begin(), known.end(), anchor) != known.end()) continue;
        top.file().fail(fmt::format("hint.{}.anchor", i + 1), hints->as_list()->at(i).get("anchor"),
                        fmt::format("the window has no widget {}{}", in_quotes(anchor), name_nearest(anchor, known)));
    }
}

void check_exercise(TomlTable& top, const Exercise& exercise) {
    TomlFile& file = top.file();
    for (const char* key : {"title", "goal"})
        if (!top.has(key) && !file.error)
            file.error = Error{fmt::format("'{}' is missing; add {} = \"…\"", key, key), file.name, 1};
    check_prediction(top, exercise.prediction);
    if (exercise.needed > exercise.starts)
        top.fail("needed", fmt::format("'needed' is {}, more than the {} starts", exercise.needed, exercise.starts));
    if (!top.has("solution") && !file.error)
        file.error = Error{"there is no [solution]; add the brain that passes", file.name};
    if (exercise.steps.empty() && !file.error)
        file.error = Error{"there is no [[step]]; add at least one check of what must happen", file.name};
    if (exercise.scene.starts.empty())
        top.fail("scene", "this scene places no vehicle; an exercise is about its first [vehicle.NAME]");
    const TomlNode* steps = top.content().get("step");
    for (std::size_t i = 0; i < exercise.steps.size() && !file.error; ++i) {
        const ExercisePart part{file, steps->as_list()->at(i), fmt::format("step.{}", i + 1), exercise.scene};
        if (exercise.steps[i].text.empty()) file.fail(part.path, &part.table, "a step needs a text: text = \"It …\"");
        check_check(part, exercise.steps[i].check);
    }
    if (!file.error) check_anchors(top, exercise);
}

// The scene that the exercise names, with the exercise's settings and then the given ones.
void load_its_scene(TomlTable& top, const std::filesystem::path& path, const std::vector<Setting>& more,
                    Exercise& exercise) {
    const auto scene_path = top.text("scene", limits::text_length);
    std::vector<Setting> settings;
    if (const TomlNode* set = top.table("set")) gather_settings(top.file(), *set, "", settings);
    settings.insert(settings.end(), more.begin(), more.end());
    TomlFile& file = top.file();
    if (!scene_path && !file.error)
        file.error = Error{"'scene' is missing; add scene = \"../scenes/NAME.toml\"", file.name, 1};
    if (file.error) return;
    const std::filesystem::path scene_file = (path.parent_path() / *scene_path).lexically_normal();
    std::error_code problem;
    if (!std::filesystem::is_regular_file(scene_file, problem))
        return top.fail("scene", message_of("no_scene_of_exercise", in_quotes(scene_file.string())));
    auto scene = load_scene(scene_file, settings);
    if (scene)
        exercise.scene = std::move(*scene);
    else
        file.error = scene.error();
}

template <class G>
std::string describe_goal() {
    const std::string heading = fmt::format("\n### `{}`\n\nMet when {}.\n", G::traits.word, G::traits.meaning);
    FormatTable<G> table("", G{});
    describe(table, Of<G>{});
    return heading + (table.rows().empty() ? "" : "\n" + table.text());
}

template <class... Goals>
std::string describe_goals(const std::variant<Goals...>&) {
    std::string text = "\n## Goals\n\nA step must give all keys of its goal and no key of another goal.\n";
    ((text += describe_goal<Goals>()), ...);
    FormatTable<Check> check("step.check.", "`[[step.check]]`",
                             fmt::format("a check of the goals all_of and any_of; up to {}", limits::checks));
    describe(check, Of<Check>{});
    return text + check.text();
}

}  // namespace

Result<Exercise> parse_exercise(std::string_view toml, const std::filesystem::path& path,
                                const std::vector<Setting>& more) {
    auto file = parse_toml(toml, path.string());
    if (!file) return file.error();
    check_format(*file);
    Exercise exercise;
    exercise.id = path.stem().string();
    TomlTable top(*file, file->root, "");
    top.find("format");
    load_its_scene(top, path, more, exercise);
    TomlReader<Exercise> reader(top, exercise);
    describe(reader, Of<Exercise>{});
    top.done();
    if (!file->error) check_exercise(top, exercise);
    if (file->error) return *file->error;
    return exercise;
}

Result<Exercise> load_exercise(const std::filesystem::path& path, const std::vector<Setting>& more) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse_exercise(*text, path, more);
}

std::string describe_exercise_format() {
    FormatTable<Exercise> table("", "The top of the file", "");
    describe(table, Of<Exercise>{});
    return table.text() + describe_goals(Goal{}) + describe_anchors();
}

std::vector<TranslatableText> texts_of(const Exercise& exercise) {
    std::vector<TranslatableText> texts;
    const auto add = [&](const std::string& key, const std::string& text) {
        if (!text.empty()) texts.push_back({exercise.id + "." + key, text});
    };
    const auto add_list = [&](const std::string& list, const auto& elements, const std::string& key, auto text_of) {
        for (std::size_t i = 0; i < elements.size(); ++i)
            add(fmt::format("{}.{}{}", list, i + 1, key), text_of(elements[i]));
    };
    add("title", exercise.title);
    add("goal", exercise.goal);
    add("why", exercise.why);
    add("predict.question", exercise.prediction.question);
    add_list("predict.option", exercise.prediction.options, "", [](const std::string& option) { return option; });
    add("predict.outcome", exercise.prediction.outcome);
    add_list("step", exercise.steps, ".text", [](const Step& step) { return step.text; });
    add_list("hint", exercise.hints, ".text", [](const Hint& hint) { return hint.text; });
    return texts;
}

std::vector<TranslatableText> texts_of(const Scene& scene) {
    std::vector<TranslatableText> texts;
    if (!scene.title.empty()) texts.push_back({"scene." + scene.name + ".title", scene.title});
    if (!scene.story.empty()) texts.push_back({"scene." + scene.name + ".story", scene.story});
    return texts;
}

int subject_kind(const Scene& scene) { return find_kind(scene, scene.starts.front().kind); }

}  // namespace braitenlab
