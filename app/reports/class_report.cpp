#include "app/reports/class_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/io/csv.h"
#include "core/lesson/exercise_id.h"
#include "core/lesson/resemblance.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"
#include "ui/words/measure_text.h"

namespace braitenlab {

namespace {

// Without folders and ending.
std::string stem_of(std::string file) {
    file.erase(0, file.rfind('/') + 1);
    return is_hand_in(file) ? file.substr(0, file.size() - hand_in_ending.size()) : file.substr(0, file.rfind('.'));
}

// The controls that the submission changes and the exercise does not offer, "LR, curves".
std::string names_outside(const Exercise& exercise, const Submission& submission) {
    std::string names;
    for (const std::string& name : outside_offers(exercise, submission)) names += (names.empty() ? "" : ", ") + name;
    return names;
}

// True where the brain has sensors and the file none: its tables of the sensors are lost.
bool lacks_sensors(const Exercise& exercise, const Submission& submission) {
    const auto& nodes = submission.brain.nodes;
    const bool has_nodes =
        std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::sensor; });
    return has_nodes && submission.sensors.empty() && !as_shipped(exercise).sensors.empty();
}

std::optional<RowProblem> submission_problem(const Exercise& exercise, const ClassRow& row) {
    if (auto fault = check_scene(scene_with(exercise, *row.submission)))
        return RowProblem{{}, {}, error_of(message_of(*fault), row.file)};
    if (const std::string outside = names_outside(exercise, *row.submission); !outside.empty())
        return RowProblem{"report.outside", outside, {}};
    if (changes_too_many(exercise, *row.submission))
        return RowProblem{"report.too_many", std::to_string(exercise.changes), {}};
    return std::nullopt;
}

// Index of the wrong answer that is this submission, also where it behaves as the shipped brain does.
std::optional<std::size_t> same_wrong_answer(const Exercise& exercise, const Submission& submission) {
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i)
        if (is_same_submission(submission, exercise.wrong[i].submission)) return i;
    return std::nullopt;
}

// From, to, and whether the weight is positive.
using SignedWires = std::set<std::tuple<std::string, std::string, bool>>;

SignedWires signed_wires(const BrainGraph& brain) {
    SignedWires wires;
    for (const Wire& wire : brain.wires)
        if (wire.weight != 0 && !wire.cut)
            wires.emplace(find_node(brain, wire.from)->name, find_node(brain, wire.to)->name, wire.weight > 0);
    return wires;
}

std::string_view translated(const Strings& strings, const std::string& text) { return strings.find(text, text); }

std::string measures_text(const Strings& strings, const Verdict& verdict) {
    std::string text;
    for (const Measure& measure : verdict.measures)
        if (std::isfinite(measure.value))
            text += (text.empty() ? "" : "; ") + ui::measure_text(strings, measure, false);
    return text;
}

// The step that made most starts fail, with the first of these starts.
std::string failed_step_text(const ClassReport& report, const Grade& grade, const Strings& strings) {
    const Exercise& exercise = *report.exercise;
    std::vector<int> failed(exercise.steps.size());
    for (const StartResult& start : grade.starts)
        if (const std::size_t step = failed_step(start); !start.passed && step < failed.size()) ++failed[step];
    const auto worst = std::max_element(failed.begin(), failed.end());
    if (worst == failed.end() || *worst == 0) return std::string(strings("report.invalid"));
    const auto step = static_cast<std::size_t>(worst - failed.begin());
    const auto first = std::find_if(grade.starts.begin(), grade.starts.end(), [&](const StartResult& start) {
        return !start.passed && failed_step(start) == step;
    });
    std::string text =
        fill(strings("report.step_failed"), {std::to_string(step + 1), translated(strings, exercise.steps[step].text),
                                             std::to_string(*worst), std::to_string(grade.starts.size())});
    const std::string measured = measures_text(strings, first->verdicts[step]);
    if (!measured.empty())
        text += " " + fill(strings("report.start_measured"), {std::to_string(first->seed), measured});
    return text;
}

// True if each word of the name is in the text.
bool has_words_of(const std::string& text, std::string_view name) {
    constexpr std::string_view between = " ,.";
    for (std::size_t at = 0; (at = name.find_first_not_of(between, at)) != name.npos;) {
        const std::size_t end = std::min(name.find_first_of(between, at), name.size());
        if (text.find(name.substr(at, end - at)) == text.npos) return false;
        at = end;
    }
    return true;
}

bool counts(const ClassRow& row) { return !row.problem && row.grade; }

// True for two rows of one person, also where a file without a name is in that person's folder.
bool is_of(const ClassRow& row, const ClassRow& other) {
    const bool is_nameless = row.submitter.person.empty() && !row.hand_in && !row.submitter.folder.empty();
    return is_same_person(row, other) || (is_nameless && row.submitter.folder == other.submitter.folder);
}

}  // namespace

std::vector<const ClassRow*> people_without(const std::vector<ClassRow>& rows) {
    std::vector<const ClassRow*> people;
    for (const ClassRow& row : rows) {
        if (counts(row)) continue;
        const bool is_counted =
            std::any_of(rows.begin(), rows.end(), [&](const ClassRow& o) { return counts(o) && is_of(row, o); });
        const bool is_known =
            std::any_of(people.begin(), people.end(), [&](const ClassRow* o) { return is_of(row, *o); });
        if (!is_counted && !is_known) people.push_back(&row);
    }
    return people;
}

namespace {

// The problem for the student, without the platform's folders.
std::string own_problem_text(const ClassRow& row, const Strings& strings) {
    const std::string file = row.file.substr(row.file.rfind('/') + 1);
    if (!row.problem->error) {
        const bool is_of_folder = row.problem->key == "report.empty_folder";
        return (is_of_folder ? "" : file + ": ") + text_of(*row.problem, strings);
    }
    Error error = *row.problem->error;
    const bool is_syntax = !error.phrases.empty() && error.phrases.front().id == "not_toml";
    if (is_syntax)  // the words of the parser are for who grades
        return fill(strings(row.problem->key.empty() ? "report.unreadable_line" : row.problem->key),
                    {file, std::to_string(error.line)});
    if (!error.file.empty()) error.file = file;
    return text_of(error, strings);
}

// Why a hand-in does not pass, for the student: what it changes, or the line of a value outside its range.
std::string refusal_text(const ClassRow& row, const Strings& strings) {
    if (!row.refusal->error) return fill(strings("report.refused"), {text_of(*row.refusal, strings)});
    Error error = *row.refusal->error;
    error.file.erase(0, error.file.rfind('/') + 1);  // the platform's folders are not the student's
    return fill(strings("report.refused_value"), {text_of(error, strings)});
}

class CsvLine {
public:
    explicit CsvLine(std::string& out) : out_(out) {}
    void text(const std::string& cell) {
        io::add_csv_cell(out_, std::string_view(cell));
        out_ += ',';
    }
    void number(std::optional<int> cell) {
        if (cell) io::add_csv_cell(out_, std::int64_t{*cell});
        out_ += ',';
    }
    void yes_or_no(std::optional<bool> cell) { text(!cell ? "" : *cell ? "yes" : "no"); }
    void end() { out_.back() = '\n'; }

private:
    std::string& out_;
};

}  // namespace

namespace {

// True where the parser has met the end of the file within a value. The lab ends each file with a line end.
bool ends_early(std::string_view text, const Error& error) {
    if (text.ends_with('\n') || error.phrases.empty() || error.phrases.front().id != "not_toml") return false;
    const std::vector<std::string>& values = error.phrases.front().values;
    return !values.empty() && values.front().find("end-of-file") != std::string::npos;
}

// A hand-in for the exercise whose only errors are values outside their ranges, which the lab does not write, is one
// of a student who failed, from no start. False for another one.
bool refuse_out_of_range(const Exercise& exercise, ClassRow& row, ReadFile<HandIn> read) {
    const auto is_range = [](const Error& error) {
        return !error.phrases.empty() && error.phrases.front().id == "out_of_range";
    };
    HandIn& hand_in = read.object;
    const bool is_known = !hand_in.student.empty() && is_for_exercise(hand_in.exercise, exercise.id);
    if (!is_known || read.errors.empty() || !std::all_of(read.errors.begin(), read.errors.end(), is_range))
        return false;
    if (row.submitter.name.empty()) row.student = hand_in.student;
    row.hand_in = std::move(hand_in);
    row.refusal = RowProblem{{}, {}, read.errors.front()};
    row.grade = Grade{};
    return true;
}

}  // namespace

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

ClassRow row_of_other_file(const std::string& file, const Submitter& submitter) {
    return {.file = file,
            .student = submitter.name.empty() ? stem_of(file) : submitter.name,
            .submitter = submitter,
            .problem = RowProblem{"report.no_hand_in", "", {}}};
}

ClassRow row_of_hand_in(const Exercise& exercise, const std::string& file, const Result<std::string>& text,
                        const Submitter& submitter) {
    ClassRow row = row_of_other_file(file, submitter);
    row.problem.reset();
    if (text && is_blank(*text)) {
        row.problem = RowProblem{"report.empty", "", {}};
        return row;
    }
    auto hand_in = text ? parse_hand_in(*text, file) : text.error();
    if (!hand_in && text && refuse_out_of_range(exercise, row, read_hand_in_fully(*text, file))) return row;
    if (!hand_in) {
        row.problem = RowProblem{{}, {}, hand_in.error()};
        if (text && ends_early(*text, hand_in.error())) row.problem->key = "report.ends_early";
        return row;
    }
    if (submitter.name.empty()) row.student = hand_in->student;
    row.hand_in = std::move(*hand_in);
    HandIn nameless = *row.hand_in;
    if (!nameless.written.empty()) nameless.student.clear();  // two students do not write in the same second
    row.fingerprint = write_hand_in(std::move(nameless));
    if (!is_for_exercise(row.hand_in->exercise, exercise.id))
        row.problem = RowProblem{"report.other_exercise", row.hand_in->exercise, {}};
    else if (lacks_sensors(exercise, row.hand_in->submission))
        row.problem = RowProblem{"report.no_sensors", "", {}};
    else
        row.submission = row.hand_in->submission;
    return row;
}

bool is_same_person(const ClassRow& a, const ClassRow& b) {
    if (!a.submitter.person.empty() || !b.submitter.person.empty()) return a.submitter.person == b.submitter.person;
    return a.submitter.folder == b.submitter.folder && is_same_student(a.student, b.student);
}

std::string other_name(const ClassRow& row) {
    if (!row.hand_in || row.submitter.name.empty()) return "";
    const std::string& named = row.hand_in->student;
    for (const Umlauts umlauts : {Umlauts::spelled, Umlauts::as_vowels})
        if (has_words_of(plain_letters(row.submitter.name, umlauts), plain_letters(named, umlauts))) return "";
    return named;
}

void mark_same(std::vector<ClassRow>& rows) {
    std::map<std::string_view, std::vector<ClassRow*>> by_fingerprint;
    for (ClassRow& row : rows)
        if (!row.fingerprint.empty()) by_fingerprint[row.fingerprint].push_back(&row);
    for (const auto& [fingerprint, same] : by_fingerprint)
        for (ClassRow* row : same) {
            const auto other = std::find_if(same.begin(), same.end(),
                                            [&](const ClassRow* each) { return !is_same_person(*each, *row); });
            if (other != same.end()) row->same_as = (*other)->file;
        }
}

void mark_replaced(std::vector<ClassRow>& rows) {
    const auto is_later = [](const ClassRow& a, const ClassRow& b) {
        return std::tie(a.hand_in->written, a.file) > std::tie(b.hand_in->written, b.file);
    };
    for (ClassRow& row : rows) {
        if (!row.hand_in || row.problem) continue;
        for (const ClassRow& other : rows) {
            const bool is_alternative = other.hand_in && (other.submission || other.refusal) && &other != &row &&
                                        is_same_person(other, row) && is_later(other, row);
            if (is_alternative) row.problem = RowProblem{"report.replaced", other.file, {}};
        }
    }
}

void sort_by_student(std::vector<ClassRow>& rows) {
    const auto key = [](const ClassRow& row) {
        const std::string name = for_comparison(row.student);
        return std::tuple(plain_letters(name, Umlauts::as_vowels), name, row.submitter.folder, row.file);
    };
    std::stable_sort(rows.begin(), rows.end(), [&](const ClassRow& a, const ClassRow& b) { return key(a) < key(b); });
}

bool is_superseded(const ClassRow& row) { return row.problem && row.problem->key == "report.replaced"; }

bool passed_with_solution_shown(const ClassRow& row) {
    return row.passed && row.hand_in && row.hand_in->solution_shown;
}

bool states_another_result(const ClassReport& report, const ClassRow& row) {
    if (!row.hand_in || !row.grade || report.first_seed != 1) return false;
    const int own = row.hand_in->graded_starts, all = static_cast<int>(row.grade->starts.size());
    return own == all && row.hand_in->passed_starts != row.grade->count;
}

void judge(const Exercise& exercise, ClassRow& row, Grade grade, const Grade& shipped,
           const std::vector<Grade>& wrong) {
    row.refusal = submission_problem(exercise, row);
    row.passed = grade.good && !row.problem && !row.refusal;
    row.edited = is_edited(exercise, *row.submission);
    if (!grade.good) row.resembles = same_wrong_answer(exercise, *row.submission);
    if (!grade.good && !row.resembles) {
        row.resembles = most_alike(grade, wrong);
        const float to_shipped = behaviour_distance(grade, shipped);
        const bool is_nearest = !row.resembles || to_shipped <= behaviour_distance(grade, wrong[*row.resembles]);
        row.unchanged = to_shipped < alike && is_nearest;
        if (row.unchanged) row.resembles.reset();
    }
    row.grade = std::move(grade);
}

int starts_done(const Grade& grade, std::size_t step) {
    return static_cast<int>(std::count_if(grade.starts.begin(), grade.starts.end(), [&](const StartResult& start) {
        return step < start.verdicts.size() && start.verdicts[step].done;
    }));
}

ClassSummary summary_of(const ClassReport& report) {
    ClassSummary summary;
    summary.failed.resize(report.exercise->steps.size());
    summary.resembling.resize(report.exercise->wrong.size());
    std::vector<double> passed_starts;
    for (const ClassRow& row : report.rows) {
        if (!counts(row)) continue;
        ++summary.counted;
        summary.passed += row.passed;
        summary.passed_shown += passed_with_solution_shown(row);
        if (row.refusal)
            ++summary.refused;
        else if (row.resembles)
            ++summary.resembling[*row.resembles];
        else if (!row.passed)
            ++(row.unchanged ? summary.unchanged : summary.other);
        passed_starts.push_back(row.grade->count);
        for (const StartResult& start : row.grade->starts)
            if (const std::size_t step = failed_step(start); step < summary.failed.size() && !start.passed)
                ++summary.failed[step];
    }
    summary.without = static_cast<int>(people_without(report.rows).size());
    summary.students = summary.counted + summary.without;
    summary.starts = maths::spread_of(passed_starts);
    const auto worst = std::max_element(summary.failed.begin(), summary.failed.end());
    if (worst != summary.failed.end() && *worst > 0)
        summary.worst_step = static_cast<std::size_t>(worst - summary.failed.begin());
    return summary;
}

std::string text_of(const RowProblem& problem, const Strings& strings) {
    if (!problem.error) return fill(strings(problem.key), {problem.value});
    if (problem.key.empty()) return text_of(*problem.error, strings);
    return fill(strings(problem.key), {problem.error->file, std::to_string(problem.error->line)});
}

std::string problem_text(const ClassRow& row, const Strings& strings) {
    return row.problem ? text_of(*row.problem, strings) : "";
}

bool has_wires_of_mistake(const ClassReport& report, const ClassRow& row) {
    return !row.submission ||
           signed_wires(row.submission->brain) == signed_wires(report.exercise->wrong[*row.resembles].submission.brain);
}

std::string feedback(const ClassReport& report, const ClassRow& row, const Strings& strings) {
    if (is_superseded(row)) return problem_text(row, strings);
    if (row.problem) return fill(strings("report.not_judged"), {own_problem_text(row, strings)});
    if (!row.grade) return "";
    if (row.refusal) return refusal_text(row, strings);
    const Grade& grade = *row.grade;
    const std::string count = std::to_string(grade.count), of = std::to_string(grade.starts.size());
    if (row.passed) {
        const std::string passed = fill(strings("report.passed_from"), {count, of});
        return passed_with_solution_shown(row) ? passed + " " + std::string(strings("report.passed_after_solution"))
                                               : passed;
    }
    const std::string needed = std::to_string(report.exercise->needed);
    const std::string text = fill(strings("report.failed_from"), {count, of, needed}) + " ";
    const std::string step = failed_step_text(report, grade, strings);
    if (row.unchanged)
        return text + std::string(strings(row.edited ? "report.no_effect" : "report.unchanged")) + " " + step;
    if (!row.resembles) return text + step;
    // The behaviour is alike. What the text of the other answer says of wires is true only of a brain with the same.
    if (!has_wires_of_mistake(report, row))
        return text + std::string(strings("report.alike_with_other_wires")) + " " + step;
    const std::string words(translated(strings, report.exercise->wrong[*row.resembles].text));
    return text + fill(strings("report.alike"), {words}) + " " + step;
}

std::string class_csv(const ClassReport& report, const Strings& strings) {
    const Exercise& exercise = *report.exercise;
    std::string out = "student,folder,id,file,passed,starts_passed,starts,needed";
    for (std::size_t step = 1; step <= exercise.steps.size(); ++step) out += fmt::format(",step_{}", step);
    for (int start = 1; start <= exercise.starts; ++start) out += fmt::format(",start_{}", start);
    out +=
        ",prediction_right,hints,runs,solution_shown,own_starts_passed,own_result_differs,written,notes,resembles,"
        "name_in_file,same_as,feedback,error\n";
    for (const ClassRow& row : report.rows) {
        CsvLine line(out);
        const auto& grade = row.grade;
        line.text(row.student), line.text(row.submitter.folder), line.text(row.submitter.id), line.text(row.file);
        line.yes_or_no(grade && !is_superseded(row) ? std::optional(row.passed) : std::nullopt);
        line.number(grade ? std::optional(grade->count) : std::nullopt);
        line.number(exercise.starts), line.number(exercise.needed);
        for (std::size_t step = 0; step < exercise.steps.size(); ++step)
            line.number(grade ? std::optional(starts_done(*grade, step)) : std::nullopt);
        for (std::size_t i = 0; i < static_cast<std::size_t>(exercise.starts); ++i)
            line.yes_or_no(grade && i < grade->starts.size() ? std::optional(grade->starts[i].passed) : std::nullopt);
        const auto& h = row.hand_in;
        line.yes_or_no(h && h->prediction > 0 ? std::optional(h->prediction - 1 == exercise.prediction.answer)
                                              : std::nullopt);
        line.number(h ? std::optional(h->hints) : std::nullopt), line.number(h ? std::optional(h->runs) : std::nullopt);
        line.yes_or_no(h ? std::optional(h->solution_shown) : std::nullopt);
        line.number(h && h->graded_starts > 0 ? std::optional(h->passed_starts) : std::nullopt);
        line.yes_or_no(h && h->graded_starts > 0 ? std::optional(states_another_result(report, row)) : std::nullopt);
        line.text(h ? h->written : ""), line.text(h ? h->notes : "");
        line.text(std::string(row.unchanged   ? strings("report.as_shipped")
                              : row.resembles ? translated(strings, exercise.wrong[*row.resembles].name)
                                              : ""));
        line.text(other_name(row));
        line.text(row.same_as);
        line.text(row.problem ? "" : feedback(report, row, strings));
        line.text(problem_text(row, strings));
        line.end();
    }
    return out;
}

}  // namespace braitenlab
