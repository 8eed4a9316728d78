#include "core/lesson/progress.h"

#include <algorithm>
#include <utility>

#include "core/io/csv.h"
#include "core/io/json.h"
#include "core/lesson/hand_in.h"
#include "core/messages.h"
#include "core/text_parts.h"
#include "core/utf8.h"

namespace braitenlab {

using io::Json;

namespace {

constexpr int progress_format = 1;
constexpr std::size_t most_progress_bytes = std::size_t{16} << 20U, most_exercises = 1000;
constexpr int most_counted = 10000;  // starts or hints

Json submission_json(const Submission& submission) {
    return {{"brain", submission.brain}, {"sensors", submission.sensors}, {"body", submission.body}};
}

// nullopt for a submission of another version: the rest of the progress is still valid.
std::optional<Submission> read_submission(const Json& json) {
    try {
        Submission read;
        json.at("brain").get_to(read.brain);
        json.at("sensors").get_to(read.sensors);
        json.at("body").get_to(read.body);
        return read;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

Json exercise_progress_json(const ExerciseProgress& progress) {
    Json json{{"passed", progress.passed},
              {"shown", progress.shown},
              {"best", progress.best},
              {"starts", progress.starts},
              {"hints", progress.hints},
              {"prediction", progress.prediction},
              {"predicted_right", progress.predicted_right},
              {"drew_path", progress.drew_path},
              {"notes", progress.notes}};
    if (progress.submission) json["submission"] = submission_json(*progress.submission);
    return json;
}

ExerciseProgress read_exercise_progress(const Json& json) {
    ExerciseProgress read;
    read.passed = json.value("passed", false);
    read.shown = json.value("shown", false);
    read.starts = std::clamp(json.value("starts", 0), 0, most_counted);
    read.best = std::clamp(json.value("best", 0), 0, read.starts);
    read.hints = std::clamp(json.value("hints", 0), 0, most_counted);
    read.prediction = json.value("prediction", std::string());
    read.predicted_right = json.value("predicted_right", false);
    read.drew_path = json.value("drew_path", false);
    read.notes = utf8_cut(json.value("notes", std::string()), longest_notes);
    if (json.contains("submission")) read.submission = read_submission(json.at("submission"));
    return read;
}

int line_of_byte(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

int passed_count(const StudentProgress& student) {
    return static_cast<int>(std::count_if(student.exercises.begin(), student.exercises.end(),
                                          [](const auto& each) { return each.second.passed; }));
}

const ExerciseProgress* find_progress(const StudentProgress& student, std::string_view exercise) {
    const auto found = student.exercises.find(std::string(exercise));
    return found == student.exercises.end() ? nullptr : &found->second;
}

namespace {

template <class Value>
const Value& changed(const Value& before, const Value& ours, const Value& theirs) {
    return ours != before ? ours : theirs;
}

bool is_blank(char c) { return c == ' ' || c == '\n'; }

// Whether the text has these words one after the other; true for no words.
bool has_words(std::string_view text, std::string_view words) {
    for (auto at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
        const std::size_t end = at + words.size();
        if ((at == 0 || is_blank(text[at - 1])) && (end == text.size() || is_blank(text[end]))) return true;
    }
    return words.empty();
}

// The words of `now` between those with which both texts begin and end.
std::string_view changed_words(std::string_view before, std::string_view now) {
    const auto ends_word = [](std::string_view text, std::size_t at) {
        return at == 0 || at == text.size() || is_blank(text[at]) || is_blank(text[at - 1]);
    };
    const std::size_t shorter = std::min(before.size(), now.size());
    std::size_t begin = 0, end = 0;  // equal bytes at the beginning and at the end
    while (begin < shorter && before[begin] == now[begin]) ++begin;
    while (!ends_word(before, begin) || !ends_word(now, begin)) --begin;
    while (end < shorter - begin && before[before.size() - 1 - end] == now[now.size() - 1 - end]) ++end;
    while (!ends_word(before, before.size() - end) || !ends_word(now, now.size() - end)) --end;
    return trimmed(now.substr(begin, now.size() - begin - end), " \n");
}

// Ours; where both have changed, with what theirs adds below, unless one has the words of the other.
std::string merged_notes(const std::string& before, const std::string& ours, const std::string& theirs) {
    if (ours == before || theirs == before) return changed(before, ours, theirs);
    const std::string_view added = changed_words(before, theirs);
    if (has_words(ours, added)) return ours;
    if (has_words(theirs, ours)) return theirs;
    return utf8_cut(ours + "\n" + std::string(added), longest_notes);
}

bool passed_alone(const ExerciseProgress& progress) { return progress.passed && !progress.shown; }

ExerciseProgress merged(const ExerciseProgress& before, const ExerciseProgress& ours, const ExerciseProgress& theirs) {
    const bool ours_is_best = ours.best > theirs.best || theirs.starts == 0;
    ExerciseProgress both = ours_is_best ? ours : theirs;  // best and starts
    both.passed = ours.passed || theirs.passed;
    both.shown = (ours.shown || theirs.shown) && !passed_alone(ours) && !passed_alone(theirs);
    both.hints = std::max(ours.hints, theirs.hints);
    const ExerciseProgress& predicted = ours.prediction != before.prediction ? ours : theirs;
    both.prediction = predicted.prediction, both.predicted_right = predicted.predicted_right;
    both.drew_path = ours.drew_path || theirs.drew_path;
    both.notes = merged_notes(before.notes, ours.notes, theirs.notes);
    both.submission = ours.passed != theirs.passed ? (ours.passed ? ours : theirs).submission
                                                   : changed(before.submission, ours.submission, theirs.submission);
    return both;
}

}  // namespace

StudentProgress merged_progress(const StudentProgress& before, const StudentProgress& ours,
                                const StudentProgress& theirs) {
    StudentProgress both{changed(before.name, ours.name, theirs.name), {}};
    std::map<std::string, ExerciseProgress> every = ours.exercises;
    every.insert(theirs.exercises.begin(), theirs.exercises.end());
    const auto same = [](const ExerciseProgress* a, const ExerciseProgress* b) { return a && b ? *a == *b : a == b; };
    for (const auto& [id, _] : every) {
        const ExerciseProgress *was = find_progress(before, id), *our = find_progress(ours, id),
                               *their = find_progress(theirs, id);
        const bool ours_changed = !same(was, our), theirs_changed = !same(was, their);
        // Where one has removed what the other has changed, the change is kept.
        const ExerciseProgress* kept = theirs_changed && (their || !ours_changed) ? their : our;
        if (ours_changed && theirs_changed && our && their)
            both.exercises[id] = merged(was ? *was : ExerciseProgress{}, *our, *their);
        else if (kept)
            both.exercises[id] = *kept;
    }
    return both;
}

std::string tidy_student_name(std::string_view typed) {
    std::string name;
    for (const char letter : typed) name += static_cast<unsigned char>(letter) < ' ' || letter == 127 ? ' ' : letter;
    return std::string(trimmed(utf8_cut(std::string(trimmed(name, " ")), longest_student_name), " "));
}

bool is_free_name(const StudentBook& book, std::string_view name) {
    const std::string wanted = tidy_student_name(name);
    return !wanted.empty() && std::none_of(book.all.begin(), book.all.end(), [&](const StudentProgress& each) {
        return is_same_student(each.name, wanted);
    });
}

std::string write_progress(const StudentProgress& student) {
    Json json{{"format", progress_format}, {"student", student.name}, {"exercises", Json::object()}};
    for (const auto& [id, progress] : student.exercises) json["exercises"][id] = exercise_progress_json(progress);
    return io::json_text(json, 1) + "\n";
}

Result<StudentProgress> read_progress(std::string_view text, std::string file) {
    if (text.size() > most_progress_bytes)
        return error_of(message_of("too_large", most_progress_bytes >> 20U), std::move(file));
    try {
        const Json json = Json::parse(text);
        if (json.value("format", 0) != progress_format)
            return error_of(message_of("not_progress", "format = 1"), std::move(file));
        StudentProgress read{tidy_student_name(json.value("student", std::string())), {}};
        for (const auto& [id, progress] : json.at("exercises").items())
            if (read.exercises.size() < most_exercises) read.exercises[id] = read_exercise_progress(progress);
        return read;
    } catch (const Json::parse_error& problem) {
        return error_of(message_of("not_progress", "JSON"), std::move(file), line_of_byte(text, problem.byte));
    } catch (const Json::exception& problem) {
        return error_of(message_of("not_progress", problem.what()), std::move(file));
    }
}

namespace {

struct ProgressRow {
    const std::string& student;
    const std::string& exercise;
    const ExerciseProgress& progress;
    const std::string& notes;
};

const std::vector<io::CsvColumn<ProgressRow>>& progress_columns() {
    using io::CsvValue;
    using Row = const ProgressRow&;
    static const std::vector<io::CsvColumn<ProgressRow>> columns{
        {"student", [](Row r) { return CsvValue(std::string_view(r.student)); }},
        {"exercise", [](Row r) { return CsvValue(std::string_view(r.exercise)); }},
        {"passed", [](Row r) { return CsvValue(std::int64_t{r.progress.passed}); }},
        {"solution_shown", [](Row r) { return CsvValue(std::int64_t{r.progress.shown}); }},
        {"best_starts", [](Row r) { return CsvValue(std::int64_t{r.progress.best}); }},
        {"starts", [](Row r) { return CsvValue(std::int64_t{r.progress.starts}); }},
        {"hints", [](Row r) { return CsvValue(std::int64_t{r.progress.hints}); }},
        {"prediction", [](Row r) { return CsvValue(std::string_view(r.progress.prediction)); }},
        {"predicted_right", [](Row r) { return CsvValue(std::int64_t{r.progress.predicted_right}); }},
        {"notes", [](Row r) { return CsvValue(std::string_view(r.notes)); }}};
    return columns;
}

}  // namespace

std::string progress_csv(const std::vector<StudentProgress>& students) {
    std::string text = io::csv_header(progress_columns());
    for (const StudentProgress& student : students)
        for (const auto& [id, progress] : student.exercises)
            io::add_csv_row(text, progress_columns(), ProgressRow{student.name, id, progress, progress.notes});
    return text;
}

}  // namespace braitenlab
