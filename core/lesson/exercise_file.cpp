#include "core/lesson/exercise_file.h"

#include <utility>

#include <fmt/format.h>

#include "core/lesson/anchors.h"
#include "core/lesson/check_exercise.h"
#include "core/lesson/exercise_id.h"
#include "core/lesson/exercise_schema.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/scene/format_table.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

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
    if (!scene_path) {
        file.add("scene", error_of(message_of("key_missing", "scene", "scene = \"../scenes/NAME.toml\""), file.name));
        return std::nullopt;
    }
    const std::filesystem::path scene_file = (path.parent_path() / *scene_path).lexically_normal();
    std::error_code problem;
    if (!std::filesystem::is_regular_file(scene_file, problem)) {
        top.fail("scene", message_of("no_scene_of_exercise", in_quotes(scene_file.string())));
        return std::nullopt;
    }
    const auto text = read_text(scene_file);
    auto parsed = text ? parse_toml(*text, scene_file.string()) : text.error();
    if (!parsed) return file.add("scene", parsed.error()), std::nullopt;
    return SceneText{std::move(*parsed), ""};
}

// What the student changes is of the first vehicle's kind, so that vehicle has no brain and no sensors of its own.
void check_first_start(const SceneText& text, const Scene& scene, TomlFile& file) {
    const Start& first = scene.starts.front();
    const std::string path = (text.table.empty() ? "" : text.table + ".") + "vehicle." + first.name;
    const auto fail = [&](const std::string& part, MessageId<1> id) {
        file.add(path + part, text.file.fault_at(path + part, message_of(id, first.kind)));
    };
    if (first.brain) fail(".brain", "brain_of_first");
    if (first.sensors) fail(".sensor", "sensors_of_first");
}

// What the student would hand in to have the exercise's scene as it is here. Precondition: the scene has a start.
Submission submission_for(const Scene& scene) {
    return submission_of(scene.kinds[static_cast<std::size_t>(subject_kind(scene))]);
}

bool differs_in_submission_only(const Exercise& exercise, const Scene& scene) {
    return scene_with(exercise, submission_for(scene)) == scene;
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
    return error_of(message_of("outside_answer", in_quotes(culprit->path)), culprit->file, culprit->line);
}

// The submission of an answer whose keys have been read from `table`.
void resolve(Answer& answer, const std::string& path, const TomlNode& table, const SceneText& text,
             const std::vector<Setting>& before, const Exercise& exercise, TomlFile& file) {
    std::vector<Setting> settings = before;
    settings.insert(settings.end(), answer.settings.begin(), answer.settings.end());
    // Without settings of its own the scene is the exercise's, which has been read.
    const auto scene = answer.settings.empty() ? exercise.scene : read_scene(text.file, text.table, settings);
    if (!scene) return file.add(path + ".set", scene.error());
    if (!differs_in_submission_only(exercise, *scene))
        return file.add(path + ".set", setting_outside_submission(exercise, text, before, answer.settings));
    answer.submission = submission_for(*scene);
    for (const Dial dial : all_dials)
        if (table.contains(name(dial))) answer.brain.given.push_back(dial);
    if (answer.brain.given.empty() && answer.brain.nodes.empty() && answer.brain.wires.empty()) return;
    answer.submission.brain = {};
    std::optional<Fault> fault = to_graph(answer.brain, answer.submission.brain);
    if (!fault) fault = find_fault(answer.submission.brain);
    const std::string place = fault && !fault->path.empty() ? path + "." + fault->path : path;
    if (fault) file.add(place, file.fault_at(place, fault->what));
}

void resolve_answers(TomlTable& top, const SceneText& text, const std::vector<Setting>& settings, Exercise& exercise) {
    const auto resolve_one = [&](Answer& answer, const std::string& path, const TomlNode* table) {
        if (table && !top.file().failed_at(path)) resolve(answer, path, *table, text, settings, exercise, top.file());
    };
    resolve_one(exercise.solution, "solution", top.content().get("solution"));
    const TomlNode* wrong = top.content().get("wrong");
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i)  // none where `wrong` is no list
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

// The scene's text, and whether the exercise's own values could be put into it.
struct SceneOfExercise {
    SceneText text;
    bool is_set = true;
};

// The exercise's scene is read into `exercise`; without its own values where these have errors, so that names can be
// judged: no value changes one. nullopt if the scene has errors or no vehicle.
std::optional<SceneOfExercise> read_scene_of(TomlTable& top, const std::filesystem::path& path,
                                             const std::vector<Setting>& settings, Exercise& exercise) {
    auto text = scene_text(top, path);
    if (!text) return std::nullopt;
    ReadScene read = read_scene_fully(text->file, text->table, settings);
    for (Error& each : read.errors) top.file().faults.push_back({"scene", std::move(each)});
    const bool is_set = read.errors.empty();
    if (!is_set) read = read_scene_fully(text->file, text->table, {});
    if (!read.errors.empty()) return std::nullopt;
    if (read.scene.starts.empty()) return top.fail("scene", message_of("exercise_without_vehicle")), std::nullopt;
    exercise.scene = std::move(read.scene);
    return SceneOfExercise{std::move(*text), is_set};
}

// Reads the whole file. What refers to the scene is judged only if the scene has no error of its own.
Exercise read_exercise_file(TomlFile& file, const std::filesystem::path& path, const std::vector<Setting>& more) {
    check_format(file);
    Exercise exercise;
    TomlTable top(file, file.root, "");
    top.find("format");
    std::vector<Setting> settings;
    if (const TomlNode* set = top.table("set")) top.gather_settings(*set, "set", "", settings);
    settings.insert(settings.end(), more.begin(), more.end());
    const auto scene = read_scene_of(top, path, settings, exercise);
    TomlReader<Exercise> reader(top, exercise);
    describe(reader, Of<Exercise>{});
    top.done();
    if (exercise.id.empty()) exercise.id = exercise_id_of(path);
    check_exercise(top, exercise);
    if (!scene) return exercise;
    check_against_scene(top, exercise);
    if (!scene->is_set) return exercise;
    check_first_start(scene->text, exercise.scene, file);
    resolve_answers(top, scene->text, settings, exercise);
    return exercise;
}

}  // namespace

Result<Exercise> parse_exercise(std::string_view toml, const std::filesystem::path& path,
                                const std::vector<Setting>& more) {
    return read_whole(toml, path.string(), [&](TomlFile& file) { return read_exercise_file(file, path, more); });
}

std::vector<Error> errors_of_exercise(std::string_view toml, const std::filesystem::path& path) {
    return read_fully(toml, path.string(), [&](TomlFile& file) { return read_exercise_file(file, path, {}); }).errors;
}

Result<Exercise> load_exercise(const std::filesystem::path& path, const std::vector<Setting>& more) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse_exercise(*text, path, more);
}

std::string describe_exercise_format() {
    return describe_top<Exercise>() + describe_goals(Goal{}) + describe_anchors();
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
    add_list("wrong", exercise.wrong, ".name", [](const Answer& answer) { return answer.name; });
    add_list("wrong", exercise.wrong, ".text", [](const Answer& answer) { return answer.text; });
    return texts;
}

std::vector<TranslatableText> texts_of(const Scene& scene) {
    std::vector<TranslatableText> texts;
    if (!scene.title.empty()) texts.push_back({"scene." + scene.name + ".title", scene.title});
    if (!scene.story.empty()) texts.push_back({"scene." + scene.name + ".story", scene.story});
    return texts;
}

}  // namespace braitenlab
