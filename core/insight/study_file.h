// A study as its author writes it: one scene, values that are varied, seeds, and measures. The file format:
// docs/study-format.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/result.h"
#include "core/scene/toml_tree.h"
#include "core/scene/translatable.h"

namespace braitenlab::insight {

namespace limits {
inline constexpr std::size_t study_runs = 10'000, study_values = 6, study_levels = 100, study_paths = 16;
}

// What is measured in a run. The last four are about one vehicle, as core/insight/behaviour.h defines them.
enum class StudyMeasure {
    captures,
    deaths,
    births,
    contacts,
    falls,
    predators,
    prey,
    closest,
    final_distance,
    time_to_touch,
    survival
};
struct StudyMeasureTraits {
    StudyMeasure value;
    std::string_view word, unit;  // the unit ends the name of its column: closest_m
    bool of_vehicle;
    std::string_view meaning;
};
inline constexpr auto study_measure_table = std::to_array<StudyMeasureTraits>({
    {StudyMeasure::captures, "captures", "", false, "bites by which predators have taken energy from prey"},
    {StudyMeasure::deaths, "deaths", "", false, "vehicles that have left without energy or over an edge"},
    {StudyMeasure::births, "births", "", false, "vehicles that have replaced others"},
    {StudyMeasure::contacts, "contacts", "", false, "begins of contacts of vehicles with anything"},
    {StudyMeasure::falls, "falls", "", false, "falls over an open edge"},
    {StudyMeasure::predators, "predators", "", false, "predators at the end"},
    {StudyMeasure::prey, "prey", "", false, "prey at the end"},
    {StudyMeasure::closest, "closest", "m", true,
     "closest approach: least distance of the run from the middle of the vehicle to the nearest source it senses, else "
     "to any source or, without sources, to another vehicle"},
    {StudyMeasure::final_distance, "final", "m", true, "its distance from the nearest such object at the end"},
    {StudyMeasure::time_to_touch, "touch", "s", true, "time until it touches the object; empty: never"},
    {StudyMeasure::survival, "survival", "s", true, "time until the vehicle leaves the world"},
});
static_assert(is_complete_table<study_measure_table>());
inline std::string column_name(const StudyMeasureTraits& row) {
    return std::string(row.word) + (row.unit.empty() ? "" : "_") + std::string(row.unit);
}
constexpr const auto& table_of(StudyMeasure) { return study_measure_table; }

// True if a run can have no number of it: the vehicle never touches, or the scene has no object.
constexpr bool may_be_absent(StudyMeasure measure) {
    return measure == StudyMeasure::closest || measure == StudyMeasure::final_distance ||
           measure == StudyMeasure::time_to_touch;
}

// One value that is varied.
struct StudyValue {
    std::string name, unit;
    std::vector<std::string> paths;  // of the scene, as --set takes them; with '-' first: gets the negative level
    std::vector<double> levels;
    std::vector<int> lines{};  // of the paths in the file; empty for a study that was not read
};

// The name with the unit as columns have it: mass in kg is mass_kg, eyes in ° eyes_deg, speed in m/s speed_m_s. A name
// that ends so already stays.
std::string column_name(const StudyValue&);

// The words at the axes of a figure; empty: see study_drawing().
struct StudyLabels {
    std::string x, y;
};

struct Study {
    std::string id;    // the file's name without folder and ending
    std::string file;  // as given, for messages; empty for a study that was not read
    std::string title, story;
    std::string scene;     // a name or a path, as in the file
    std::string vehicle;   // NAME of a [vehicle.NAME]; empty: the first
    int vehicle_line = 0;  // of this key in the file; 0: it has none
    float seconds = 60;    // of each run
    int seeds = 20;
    std::uint64_t first_seed = 1;
    std::vector<StudyValue> values;
    std::vector<std::string> measure_words;
    std::vector<StudyMeasure> measures;  // of the words
    StudyLabels axis;

    std::size_t combinations() const;
    std::size_t runs() const { return combinations() * static_cast<std::size_t>(seeds); }
};

// Errors carry file and line: syntax, unknown keys, missing values, unknown measures, names given twice, more than
// limits::study_runs runs.
Result<Study> parse_study(std::string_view toml, const std::string& file_name);

// As parse_study(), with every independent error by line.
ReadFile<Study> read_study_fully(std::string_view toml, const std::string& file_name);

// The file of a study, without values at their defaults. parse_study(write_study(s)) is s, but for its id.
std::string write_study(const Study&);

// By ids like "study.prey-eyes.value.1".
std::vector<TranslatableText> texts_of(const Study&);

// Index of the level of each value in a combination; the last value varies fastest.
std::vector<std::size_t> levels_of(const Study&, std::size_t combination);

// "eyes 80°, speed 1.3 m/s".
std::string combination_text(const Study&, std::size_t combination);
// "80°", "1.3 m/s".
std::string level_text(const StudyValue&, std::size_t level);

// The tables of docs/study-format.md, in Markdown.
std::string describe_study_format();

}  // namespace braitenlab::insight
