// braitenctl check: whether exercises are sound, and whether a brain passes one.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/exercises.h"
#include "app/files/data.h"
#include "app/terminal.h"
#include "core/io/checked_json.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/warnings.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace {

using CheckJson = nlohmann::ordered_json;

// ── One grade, as text and as JSON ──────────────────────────────────────────────────────────────────────────────────

std::string value_text(float value, std::string_view unit) {
    return format_lines("{:.2f}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string measure_text(const Measure& measure) {
    const std::string value = std::isfinite(measure.value) ? value_text(measure.value, measure.unit) : "nothing";
    if (measure.needed_most)
        return format_lines("{} measured, {:.2f} to {} needed", value, measure.needed,
                            value_text(*measure.needed_most, measure.unit));
    return format_lines("{} measured, at {} {} needed", value, measure.at_most ? "most" : "least",
                        value_text(measure.needed, measure.unit));
}

// The step that made the start fail, and how far it is from being done.
std::string failure_text(const Exercise& exercise, const StartResult& start) {
    const std::size_t failed = failed_step(start);
    if (failed >= start.verdicts.size()) return "the brain or the sensors are not valid";
    std::string text = format_lines("step {} \"{}\"", failed + 1, exercise.steps[failed].text);
    for (const Measure& measure : start.verdicts[failed].measures) text += "; " + measure_text(measure);
    return text;
}

std::string failures_text(const Exercise& exercise, const Grade& grade) {
    std::string text;
    for (const StartResult& start : grade.starts)
        if (!start.passed) text += format_lines("  start {} fails {}\n", start.seed, failure_text(exercise, start));
    return text;
}

CheckJson measure_json(const Measure& measure) {
    CheckJson json{
        {"measured", nullptr}, {"needed", measure.needed}, {"unit", measure.unit}, {"at_most", measure.at_most}};
    if (std::isfinite(measure.value)) json["measured"] = measure.value;
    if (measure.needed_most) json["needed_most"] = *measure.needed_most;
    return json;
}

CheckJson step_json(const Step& step, const Verdict& verdict) {
    CheckJson json{{"text", step.text}, {"done", verdict.done}, {"measured", nullptr}, {"needed", nullptr}};
    CheckJson measures = CheckJson::array();
    for (const Measure& measure : verdict.measures) measures.push_back(measure_json(measure));
    if (!measures.empty()) json["measured"] = measures[0]["measured"], json["needed"] = measures[0]["needed"];
    json["measures"] = measures;
    return json;
}

CheckJson grade_json(const Exercise& exercise, const Grade& grade) {
    CheckJson json{{"passed", grade.count}, {"needed", exercise.needed}, {"good", grade.good}};
    for (const StartResult& start : grade.starts) {
        CheckJson row{{"seed", start.seed}, {"passed", start.passed}, {"steps", CheckJson::array()}};
        for (std::size_t i = 0; i < start.verdicts.size(); ++i)
            row["steps"].push_back(step_json(exercise.steps[i], start.verdicts[i]));
        json["starts"].push_back(row);
    }
    return json;
}

// ── Soundness ───────────────────────────────────────────────────────────────────────────────────────────────────────

// An exercise and the file it was read from.
struct ReadExercise {
    SharedExercise exercise;
    std::filesystem::path path;
    std::string toml;
};

Result<ReadExercise> read_with_text(const std::filesystem::path& path) {
    auto exercise = read_exercise(path);
    if (!exercise) return exercise.error();
    auto text = read_text(path);
    if (!text) return text.error();
    return ReadExercise{std::move(*exercise), path, std::move(*text)};
}

// What is doubtful; of an exercise that ships with the program also the texts that are not translated.
std::vector<Error> all_warnings(const ReadExercise& read) {
    std::vector<Error> found = warnings_of(*read.exercise, read.toml, read.path);
    const auto shipped = shipped_exercises();
    if (std::find(shipped.begin(), shipped.end(), read.path) == shipped.end()) return found;
    for_each_entry(read.path.parent_path().parent_path() / "words", [&](const std::filesystem::directory_entry& words) {
        for (Error& each : missing_translations(*read.exercise, read.toml, read.path, words.path()))
            found.push_back(std::move(each));
    });
    return found;
}

// The grades that decide whether an exercise is sound.
struct Soundness {
    Grade shipped, solution;
    std::vector<Grade> wrong;                   // as Exercise::wrong
    std::vector<std::string> solution_outside;  // controls that the solution uses and the exercise does not offer
    bool too_many_changes = false;              // the solution changes more than Exercise::changes controls
    bool prediction = false;                    // no check contradicts the prediction's answer
    bool sound = false;
    std::optional<Error> prediction_fault;
    std::vector<Error> warnings;  // they do not make an exercise unsound
};

// With the seeds from 1 on, every start must pass with the solution; with others nine of ten, and one of ten may pass
// as shipped.
bool is_sound(const Exercise& exercise, const Soundness& found, std::uint64_t first_seed) {
    const int slack = first_seed == 1 ? 0 : exercise.starts / 10;
    return found.shipped.count <= slack && found.solution.count >= exercise.starts - slack &&
           std::none_of(found.wrong.begin(), found.wrong.end(), [](const Grade& grade) { return grade.good; }) &&
           found.solution_outside.empty() && !found.too_many_changes && found.prediction;
}

Result<Soundness> soundness(const ReadExercise& read, std::uint64_t first_seed) {
    const SharedExercise& exercise = read.exercise;
    std::vector<Submission> submissions{as_shipped(*exercise), with_solution(*exercise)};
    for (const Answer& wrong : exercise->wrong) submissions.push_back(wrong.submission);
    auto grades = grade_several(exercise, submissions, first_seed);
    if (!grades) return grades.error();
    Soundness found{std::move((*grades)[0]), std::move((*grades)[1]), {}, {}};
    for (std::size_t i = 2; i < grades->size(); ++i) found.wrong.push_back(std::move((*grades)[i]));
    found.solution_outside = outside_offers(*exercise, with_solution(*exercise));
    found.too_many_changes = changes_too_many(*exercise, with_solution(*exercise));
    found.prediction_fault = prediction_fault(*exercise, read.toml, read.path);
    found.prediction = !found.prediction_fault;
    found.warnings = all_warnings(read);
    found.sound = is_sound(*exercise, found, first_seed);
    return found;
}

// "FILE:LINE: warning: what".
std::string warning_text(Error warning) {
    warning.what = "warning: " + warning.what;
    return warning.text();
}

std::string soundness_text(const Exercise& exercise, const Soundness& found) {
    const std::string_view verdict = !found.sound ? "wrong"
                                     : doubt_answer(found.warnings)
                                         ? "good, but a wrong answer of its prediction would not be noticed"
                                         : "good";
    std::string text =
        format_lines("{}: as shipped {} of {} starts pass (none should), with its solution {} (all should): {}\n",
                     exercise.id, found.shipped.count, exercise.starts, found.solution.count, verdict);
    // First: a lamp outside the arena is the cause of what fails below.
    for (const Error& warning : found.warnings) text += format_lines("  {}\n", warning_text(warning));
    for (const StartResult& start : found.shipped.starts)
        if (start.passed) text += format_lines("  start {} passes as shipped\n", start.seed);
    text += failures_text(exercise, found.solution);
    for (std::size_t i = 0; i < found.wrong.size(); ++i)
        text += format_lines("  wrong answer \"{}\": {} of {} starts pass (fewer than {} should){}\n",
                             exercise.wrong[i].name, found.wrong[i].count, exercise.starts, exercise.needed,
                             found.wrong[i].good ? ": it passes; change it, or the steps" : "");
    for (const std::string& control : found.solution_outside)
        text += format_lines("  the solution changes '{}', which the exercise does not offer\n", control);
    if (found.too_many_changes)
        text += format_lines("  the solution changes more than {} controls\n", exercise.changes);
    if (found.prediction_fault) text += format_lines("  {}\n", found.prediction_fault->text());
    return text;
}

CheckJson soundness_json(const Exercise& exercise, const Soundness& found) {
    CheckJson json{{"exercise", exercise.id}, {"sound", found.sound}};
    json.update(grade_json(exercise, found.solution));
    json["shipped"] = grade_json(exercise, found.shipped);
    json["solution_outside"] = found.solution_outside;
    json["too_many_changes"] = found.too_many_changes;
    json["prediction"] = found.prediction;
    json["prediction_tested"] = !doubt_answer(found.warnings);
    json["warnings"] = CheckJson::array();
    for (const Error& each : found.warnings)
        json["warnings"].push_back({{"file", each.file}, {"line", each.line}, {"what", each.what}});
    json["wrong"] = CheckJson::array();
    for (std::size_t i = 0; i < found.wrong.size(); ++i) {
        CheckJson answer{{"name", exercise.wrong[i].name}};
        answer.update(grade_json(exercise, found.wrong[i]));
        json["wrong"].push_back(answer);
    }
    return json;
}

// Prints every error of an exercise that cannot be read; `error` where the file itself cannot.
int complain_of_exercise(const std::filesystem::path& path, const Error& error) {
    const auto text = read_text(path);
    const std::vector<Error> errors = text ? errors_of_exercise(*text, path) : std::vector<Error>{};
    return errors.empty() ? complain(error) : complain_of_all(errors);
}

// Prints whether the exercise is sound. Returns the exit code.
int check_sound(const ReadExercise& read, std::uint64_t first_seed, CheckJson* json) {
    const auto found = soundness(read, first_seed);
    if (!found) return complain(found.error());
    if (json)
        json->push_back(soundness_json(*read.exercise, *found));
    else
        std::cout << soundness_text(*read.exercise, *found);
    return found->sound ? exit_code::done : exit_code::failed;
}

int check_brain(const SharedExercise& exercise, const CheckOptions& options) {
    auto found = brain_of_file(options.brain, options.choice);
    if (!found) return complain(found.error());
    const Submission submission = submission_with(*exercise, *found);
    auto grades = grade_several(exercise, {submission}, options.seed);
    if (!grades) return complain(grades.error());
    Grade& grade = grades->front();
    const std::string fault = offers_fault(*exercise, submission);
    grade.good = grade.good && fault.empty();
    if (options.json) {
        CheckJson json{{"exercise", exercise->id}};
        json["outside_offers"] = outside_offers(*exercise, submission);
        json["too_many_changes"] = changes_too_many(*exercise, submission);
        json.update(grade_json(*exercise, grade));
        std::cout << io::json_text(json, 2) << "\n";
    } else {
        if (!found->owner.empty()) std::cout << format_lines("brain of {} in {}\n", found->owner, options.brain);
        std::cout << format_lines("{}: {} of {} starts pass, {} needed: {}\n", exercise->id, grade.count,
                                  grade.starts.size(), exercise->needed, grade.good ? "passed" : "not passed");
        if (!fault.empty()) std::cout << format_lines("  {}\n", fault);
        std::cout << failures_text(*exercise, grade);
    }
    return grade.good ? exit_code::done : exit_code::failed;
}

// Prints whether each shipped exercise is sound.
int check_all(std::uint64_t first_seed, bool as_json) {
    int result = exit_code::done;
    CheckJson json = CheckJson::array();
    for (const auto& path : shipped_exercises()) {
        const auto read = read_with_text(path);
        if (!read) return complain_of_exercise(path, read.error());
        result = std::max(result, check_sound(*read, first_seed, as_json ? &json : nullptr));
    }
    if (as_json) std::cout << io::json_text(json, 2) << "\n";
    return result;
}

}  // namespace

int check(const CheckOptions& options) {
    if (options.all) return check_all(options.seed, options.json);
    if (options.exercise.empty()) return complain({"check needs an EXERCISE or --all"});
    const auto path = find_shipped(options.exercise, Shipped::exercise);
    if (!path) return complain(path.error());
    if (const auto text = read_text(*path)) {
        if (detect_kind(*path, *text) == FileKind::lecture) return check_lecture(*path, options.json);
        if (const auto error = other_than_exercise(*path, *text, "check")) return complain(*error);
    }
    const auto read = read_with_text(*path);
    if (!read) return complain_of_exercise(*path, read.error());
    if (options.brain.empty() && !(options.choice.kind.empty() && options.choice.vehicle.empty()))
        return complain({"--kind and --vehicle need --brain FILE, from which the brain is taken"});
    if (!options.brain.empty()) return check_brain(read->exercise, options);
    CheckJson json;
    const int result = check_sound(*read, options.seed, options.json ? &json : nullptr);
    if (options.json && !json.empty()) std::cout << io::json_text(json[0], 2) << "\n";
    return result;
}

}  // namespace braitenlab
