#include "core/lesson/exercise.h"

#include <fmt/format.h>

#include "core/lesson/anchors.h"
#include "core/lesson/check_exercise.h"
#include "core/lesson/submission.h"
#include "core/scene/format_table.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t hints = 32, options = 8, offers = 16, wrong_answers = 16;
}

// ── Every value of an exercise file, described once as core/scene/schema.h does for scenes ──

template <class Visitor>
void describe(Visitor& v, Of<Check>) {
    v.variant("goal", &Check::goal, "what the vehicle must do; each goal has keys of its own, listed under Goals");
    v.text("vehicle", &Check::vehicle, limits::name_length,
           "NAME of the [vehicle.NAME] that must do it; without it, the scene's first");
    v.number("hold", &Check::hold, "s", {0, 600}, "the goal must stay met for so long without a break");
    v.number("earliest", &Check::earliest, "s", {0, 600}, "it is not judged before this time");
    v.number("latest", &Check::latest, "s", {0, 600}, "it is not judged after this time; 0: no limit");
    v.number("after", &Check::after, "", {0, limits::steps}, "number of a step that must be done first; 0: none");
}

template <class Visitor>
void describe(Visitor& v, Of<Prediction>) {
    v.text("question", &Prediction::question, limits::text_length, "asked before the outcome is visible, never graded");
    v.texts("options", &Prediction::options, limits::options, limits::text_length, "two or more to choose from");
    v.choice("answer", &Prediction::answer, &Prediction::options, "the option that the run shows");
    v.text("outcome", &Prediction::outcome, limits::text_length,
           "shown once a run has shown it, beside the student's choice");
    v.number("after", &Prediction::after, "s", {0, 600},
             "of a run with the shipped brain, after which the outcome is visible");
    v.flag("hides_brain", &Prediction::hides_brain,
           "until the prediction is made, the brain's picture and the wires on the deck are not shown");
    v.list("shows", &Prediction::shows, limits::checks,
           "a check that the run with the shipped brain must meet by then; `check` tests that the answer is true");
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
void describe(Visitor& v, Of<Answer>) {
    v.text("name", &Answer::name, limits::title_length, "of a wrong answer: what it is");
    v.text("text", &Answer::text, limits::text_length, "of a wrong answer: what to tell a student who gives it");
    v.brain_keys(&Answer::brain, "a brain in place of the shipped one");
    v.settings("set", &Answer::settings, "values of the scene, by their paths, that differ from those as shipped");
}

template <class Visitor>
void describe(Visitor& v, Of<Exercise>) {
    v.number("number", &Exercise::number, "", {0, 999}, "its position in the course");
    v.number("chapter", &Exercise::chapter, "", {0, 99}, "its chapter in the course, from 1; 0: none");
    v.text("title", &Exercise::title, limits::title_length, "must be given");
    v.text("goal", &Exercise::goal, limits::text_length, "must be given");
    v.text("why", &Exercise::why, limits::text_length, "the mechanism, shown on request");
    v.text("question", &Exercise::question, limits::text_length, "asked afterwards, never graded");
    v.texts("offers", &Exercise::offers, limits::offers, limits::name_length,
            "the controls that are shown: dials like \"LR\", dials that move together like \"LL=RR\", \"curves\", "
            "\"sensors\", \"wiring\"; default: all");
    v.texts("hides", &Exercise::hides, limits::kinds, limits::name_length,
            "names of kinds of the scene whose brains are never shown; not the first vehicle's");
    v.number("changes", &Exercise::changes, "", {0, 16}, "most offered controls that may be changed; 0: any number");
    v.number("seed", &Exercise::seed, "", {0, 1e15}, "of the run that the student sees");
    v.number("seconds", &Exercise::seconds, "s", {1, 600}, "duration of a graded run");
    v.number("starts", &Exercise::starts, "", {1, 100}, "number of seeds, from 1 on, that are graded");
    v.number("needed", &Exercise::needed, "", {1, 100}, "number of them that must pass every step");
    v.table("predict", &Exercise::prediction, "a prediction, to be made before the outcome is visible");
    v.list("step", &Exercise::steps, limits::steps, "what must happen; at least one");
    v.list("hint", &Exercise::hints, limits::hints, "help, in stages");
    v.table("solution", &Exercise::solution,
            "an answer that passes: a brain in place of the shipped one, or values that differ; must be given");
    v.list("wrong", &Exercise::wrong, limits::wrong_answers, "a plausible answer that must fail");
}

namespace {

// The file that holds the exercise's scene, and the scene's table in it; empty: the whole file.
struct SceneText {
    TomlFile file;
    std::string table;
};

// The scene's text: table `scene` of the exercise, or the file that `scene` names.
std::optional<SceneText> scene_text(TomlTable& top, const std::filesystem::path& path) {
    TomlFile& file = top.file();
    if (const TomlNode* inner = top.find("scene"); inner && inner->as_table()) return SceneText{file, "scene"};
    const auto scene_path = top.text("scene", limits::text_length);
    if (!scene_path && !file.error)
        file.error = Error{"'scene' is missing; add scene = \"../scenes/NAME.toml\", or a scene as [scene]", file.name};
    if (file.error) return std::nullopt;
    const std::filesystem::path scene_file = (path.parent_path() / *scene_path).lexically_normal();
    std::error_code problem;
    if (!std::filesystem::is_regular_file(scene_file, problem)) {
        top.fail("scene", message_of("no_scene_of_exercise", in_quotes(scene_file.string())));
        return std::nullopt;
    }
    const auto text = read_text(scene_file);
    auto parsed = text ? parse_toml(*text, scene_file.string()) : text.error();
    if (!parsed) return file.error = parsed.error(), std::nullopt;
    return SceneText{std::move(*parsed), ""};
}

// What the student changes is of the first vehicle's kind, so that vehicle has no brain and no sensors of its own.
void check_first_start(const SceneText& text, const Scene& scene, TomlFile& file) {
    const Start& first = scene.starts.front();
    const std::string path = (text.table.empty() ? "" : text.table + ".") + "vehicle." + first.name;
    if (first.brain)
        file.error = text.file.fault_at(
            path + ".brain",
            fmt::format("the first vehicle of an exercise has no brain of its own, as the student changes "
                        "that of its kind; set it in [kind.{}]",
                        first.kind));
    else if (first.sensors)
        file.error = text.file.fault_at(
            path + ".sensor", fmt::format("the first vehicle of an exercise has no sensors of its own, as the student "
                                          "changes those of its kind; set them in [kind.{}]",
                                          first.kind));
}

// What the student would hand in to have the exercise's scene as it is here.
Submission submission_for(Exercise exercise, const Scene& scene) {
    exercise.scene = scene;
    return as_shipped(exercise);
}

bool differs_in_submission_only(const Exercise& exercise, const Scene& scene) {
    return scene_with(exercise, submission_for(exercise, scene)) == scene;
}

// The error at the first of an answer's settings, applied after `before`, that changes something else.
Error setting_outside_submission(const Exercise& exercise, const SceneText& text, std::vector<Setting> before,
                                 const std::vector<Setting>& of_answer) {
    auto culprit = of_answer.begin();
    for (; culprit != of_answer.end() - 1; ++culprit) {
        before.push_back(*culprit);
        const auto scene = read_scene(text.file, text.table, before);
        if (scene && !differs_in_submission_only(exercise, *scene)) break;
    }
    return {fmt::format("the student cannot change {}; an answer sets the brain, the sensors and the body of the first "
                        "vehicle's kind",
                        in_quotes(culprit->path)),
            culprit->file, culprit->line};
}

// The submission of an answer whose keys have been read from `table`.
void resolve(Answer& answer, const std::string& path, const TomlNode& table, const SceneText& text,
             const std::vector<Setting>& before, const Exercise& exercise, TomlFile& file) {
    std::vector<Setting> settings = before;
    settings.insert(settings.end(), answer.settings.begin(), answer.settings.end());
    // Without settings of its own the scene is the exercise's, which has been read.
    const auto scene = answer.settings.empty() ? exercise.scene : read_scene(text.file, text.table, settings);
    if (!scene) return void(file.error = scene.error());
    if (!differs_in_submission_only(exercise, *scene))
        return void(file.error = setting_outside_submission(exercise, text, before, answer.settings));
    answer.submission = submission_for(exercise, *scene);
    for (const Dial dial : all_dials)
        if (table.contains(name(dial))) answer.brain.given.push_back(dial);
    if (answer.brain.given.empty() && answer.brain.nodes.empty() && answer.brain.wires.empty()) return;
    answer.submission.brain = {};
    std::optional<Fault> fault = to_graph(answer.brain, answer.submission.brain);
    if (!fault) fault = find_fault(answer.submission.brain);
    if (fault) file.error = file.fault_at(fault->path.empty() ? path : path + "." + fault->path, fault->what);
}

void resolve_answers(TomlTable& top, const SceneText& text, const std::vector<Setting>& settings, Exercise& exercise) {
    const auto resolve_one = [&](Answer& answer, const std::string& path, const TomlNode* table) {
        if (table && !top.file().error) resolve(answer, path, *table, text, settings, exercise, top.file());
    };
    resolve_one(exercise.solution, "solution", top.content().get("solution"));
    const TomlNode* wrong = top.content().get("wrong");
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i)
        resolve_one(exercise.wrong[i], fmt::format("wrong.{}", i + 1), &wrong->as_list()->at(i));
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
    std::vector<Setting> settings;
    if (const TomlNode* set = top.table("set")) top.gather_settings(*set, "set", "", settings);
    settings.insert(settings.end(), more.begin(), more.end());
    const auto text = scene_text(top, path);
    if (!text) return *file->error;
    auto scene = read_scene(text->file, text->table, settings);
    if (!scene) return scene.error();
    exercise.scene = std::move(*scene);
    TomlReader<Exercise> reader(top, exercise);
    describe(reader, Of<Exercise>{});
    top.done();
    if (!file->error) check_exercise(top, exercise);
    if (!file->error) check_first_start(*text, exercise.scene, *file);
    if (!file->error) resolve_answers(top, *text, settings, exercise);
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
    add("question", exercise.question);
    add("predict.question", exercise.prediction.question);
    add_list("predict.option", exercise.prediction.options, "", [](const std::string& option) { return option; });
    add("predict.outcome", exercise.prediction.outcome);
    add_list("step", exercise.steps, ".text", [](const Step& step) { return step.text; });
    add_list("hint", exercise.hints, ".text", [](const Hint& hint) { return hint.text; });
    add_list("wrong", exercise.wrong, ".text", [](const Answer& answer) { return answer.text; });
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
