#include "core/lesson/exercise.h"

#include <fmt/format.h>

#include "core/lesson/exercise_fields.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

namespace {

// The settings of [set]: "kind.one.brain.LL" = 0.8, or kind.one.brain.LL = 0.8, which TOML nests.
void gather_settings(TomlFile& file, const toml::table& table, const std::string& prefix, std::vector<Setting>& out) {
    for (const auto& [key, node] : table) {
        const std::string path = prefix + std::string(key.str());
        Setting setting{path, "", file.name, static_cast<int>(node.source().begin.line)};
        if (const toml::table* inner = node.as_table()) {
            gather_settings(file, *inner, path + ".", out);
            continue;
        } else if (node.is_integer()) {
            setting.value = fmt::format("{}", node.ref<std::int64_t>());
        } else if (node.is_floating_point()) {
            setting.value = fmt::format("{}", node.ref<double>());
        } else if (node.is_string()) {
            setting.value = node.ref<std::string>();
        } else {
            return file.fail("set." + path, &node, fmt::format("{} should be a number or text", in_quotes(path)));
        }
        out.push_back(std::move(setting));
    }
}

struct NeededKey {
    const char* key;
    std::vector<Goal> goals;
};

// Which goals need which of a step's keys.
const std::vector<NeededKey>& needed_keys() {
    static const std::vector<NeededKey> keys{{"source", {Goal::turns_to, Goal::touches, Goal::speeds_up}},
                                             {"metres", {Goal::touches, Goal::speeds_up}},
                                             {"seconds", {Goal::runs}},
                                             {"degrees", {Goal::turns_to}},
                                             {"factor", {Goal::speeds_up}}};
    return keys;
}

// A step must say all that its goal needs and nothing else.
void check_step(TomlFile& file, const toml::table& table, const std::string& path, const Step& step,
                const Scene& scene) {
    if (step.text.empty()) return file.fail(path, &table, "a step needs a text: text = \"It …\"");
    if (!table.contains("goal"))
        return file.fail(path, &table, "a step needs a goal: \"runs\", \"turns_to\", \"touches\" or \"speeds_up\"");
    const std::string_view goal = word(step.check.goal);
    for (const NeededKey& needed : needed_keys()) {
        const bool wanted = std::find(needed.goals.begin(), needed.goals.end(), step.check.goal) != needed.goals.end();
        const toml::node* given = table.get(needed.key);
        if (wanted && !given)
            return file.fail(path, &table, fmt::format("the goal '{}' needs '{}'; add it", goal, needed.key));
        if (!wanted && given)
            return file.fail(path + "." + needed.key, given,
                             fmt::format("the goal '{}' has no '{}'; take it out", goal, needed.key));
    }
    if (step.check.source.empty() || find_source(scene, step.check.source) >= 0) return;
    std::vector<std::string_view> names;
    for (const Source& source : scene.sources) names.emplace_back(source.name);
    file.fail(
        path + ".source", table.get("source"),
        "the scene has no source called " + in_quotes(step.check.source) + name_nearest(step.check.source, names));
}

void check_prediction(TomlTable& top, const Prediction& prediction) {
    const toml::table* table = top.content()["predict"].as_table();
    if (!table) return;
    if (prediction.question.empty() || prediction.options.size() < 2 || !table->contains("answer"))
        top.fail("predict", "a prediction needs a question, two or more options, and one of them as its answer");
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
        file.error = Error{"there is no [[step]]; say what must come to pass", file.name};
    if (exercise.scene.starts.empty())
        top.fail("scene", "this scene places no vehicle; an exercise is about its first [vehicle.NAME]");
    const toml::array* steps = top.content()["step"].as_array();
    for (std::size_t i = 0; i < exercise.steps.size() && !file.error; ++i)
        check_step(file, *steps->get(i)->as_table(), fmt::format("step.{}", i + 1), exercise.steps[i], exercise.scene);
}

// The scene that the exercise names, with the exercise's settings and then those that came from outside.
void load_its_scene(TomlTable& top, const std::filesystem::path& path, const std::vector<Setting>& more,
                    Exercise& exercise) {
    const auto scene_path = top.text("scene", limits::text_length);
    std::vector<Setting> settings;
    if (const toml::table* set = top.table("set")) gather_settings(top.file(), *set, "", settings);
    settings.insert(settings.end(), more.begin(), more.end());
    TomlFile& file = top.file();
    if (!scene_path && !file.error)
        file.error = Error{"'scene' is missing; add scene = \"../scenes/NAME.toml\"", file.name, 1};
    if (file.error) return;
    const std::filesystem::path place = (path.parent_path() / *scene_path).lexically_normal();
    std::error_code trouble;
    if (!std::filesystem::is_regular_file(place, trouble))
        return top.fail("scene", "there is no scene " + in_quotes(place.string()) + "; its path counts from this file");
    auto scene = load_scene(place, settings);
    if (scene)
        exercise.scene = std::move(*scene);
    else
        file.error = scene.error();
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
    const auto text = read_text(path.string());
    if (!text) return text.error();
    return parse_exercise(*text, path, more);
}

int pupil_kind(const Scene& scene) { return find_kind(scene, scene.starts.front().kind); }

}  // namespace braitenlab
