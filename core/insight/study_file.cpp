#include "core/insight/study_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "core/messages.h"
#include "core/scene/format_table.h"
#include "core/scene/nearest.h"
#include "core/scene/toml_reader.h"
#include "core/scene/toml_writer.h"

namespace braitenlab {

using insight::Study;
using insight::StudyLabels;
using insight::StudyValue;

void describe(auto& v, Of<StudyValue>) {
    v.text("name", &StudyValue::name, limits::name_length, "of the column in the table; must be given");
    v.text("unit", &StudyValue::unit, 8,
           "shown behind the levels, and at the end of the column's name: `mass_kg`, `eyes_deg`, `speed_m_s`");
    v.texts("paths", &StudyValue::paths, insight::limits::study_paths, limits::text_length,
            "of the values of the scene that get the level; a path that begins with `-` gets the negative level");
    v.numbers("levels", &StudyValue::levels, insight::limits::study_levels, {-1e6, 1e6}, "one set of runs for each");
}

void describe(auto& v, Of<StudyLabels>) {
    v.text("x", &StudyLabels::x, limits::title_length,
           "of the horizontal axis, with the unit; without it, the name of the value");
    v.text("y", &StudyLabels::y, limits::title_length,
           "of the vertical axis of the first measure; without it, the measure");
}

void describe(auto& v, Of<Study>) {
    v.text("title", &Study::title, limits::title_length, "must be given");
    v.text("story", &Study::story, limits::text_length, "what the study asks, in a sentence or two");
    v.text("scene", &Study::scene, limits::text_length,
           "name of a shipped scene, or a path relative to this file; must be given");
    v.text("vehicle", &Study::vehicle, limits::name_length,
           "NAME of the [vehicle.NAME] that is measured; without it, the first vehicle");
    v.number("seconds", &Study::seconds, "s", {1, 3600}, "simulated time of each run");
    v.number("seeds", &Study::seeds, "", {1, 1000}, "runs of each combination");
    v.number("first_seed", &Study::first_seed, "", {0, 1e15},
             "seed of the first of these runs; then one more for each");
    v.texts("measures", &Study::measure_words, insight::study_measure_table.size(), limits::name_length,
            "what is measured in each run; at least one");
    v.table("axis", &Study::axis, "words at the axes of its figure");
    v.list("value", &Study::values, insight::limits::study_values, "a value that is varied; at least one");
}

namespace insight {

namespace {

// A list that the study has read, so that its entries are sound.
const TomlNode::List& list_at(const TomlTable& top, std::string_view key) { return *top.content().get(key)->as_list(); }

void read_measures(TomlTable& top, Study& study) {
    for (std::size_t i = 0; i < study.measure_words.size(); ++i) {
        const std::string& word = study.measure_words[i];
        const auto measure = find_word(study_measure_table, word);
        if (measure)
            study.measures.push_back(*measure);
        else
            top.file().fail(
                fmt::format("measures.{}", i + 1), &list_at(top, "measures")[i],
                message_of("no_measure", in_quotes(word)) + nearest_of(word, words_of(study_measure_table)));
    }
}

void note_lines(const TomlTable& top, Study& study) {
    if (const TomlNode* vehicle = top.content().get("vehicle"))
        study.vehicle_line = static_cast<int>(vehicle->place.line);
    for (std::size_t i = 0; i < study.values.size(); ++i)
        if (const TomlNode* paths = list_at(top, "value")[i].get("paths"); paths && paths->as_list())
            for (const TomlNode& path : *paths->as_list())
                study.values[i].lines.push_back(static_cast<int>(path.place.line));
}

// A misspelt key is an error already.
void check_value(TomlTable table, const StudyValue& value) {
    const auto need = [&](std::string_view key, bool is_empty) {
        if (is_empty && !table.fail_if_misspelt(key, {"name", "unit", "paths", "levels"}, {}))
            table.fail_missing(key, message_of("missing_in_value", key));
    };
    need("name", value.name.empty()), need("paths", value.paths.empty()), need("levels", value.levels.empty());
}

// The names of all columns differ, those of values also without their units: a figure and its words have no other name.
void check_names(TomlTable& top, const Study& study) {
    std::set<std::string> names{"run", "seed"};
    for (const StudyMeasure measure : study.measures)
        if (!names.insert(column_name(row_of(measure))).second)
            top.fail("measures", message_of("column_twice", in_quotes(word(measure))));
    std::set<std::string> without_units;
    for (std::size_t i = 0; i < study.values.size(); ++i) {
        const StudyValue& value = study.values[i];
        if (value.name.empty()) continue;
        const bool is_new = without_units.insert(value.name).second;
        if (names.insert(column_name(value)).second && is_new) continue;
        top.file().fail(fmt::format("value.{}.name", i + 1), list_at(top, "value")[i].get("name"),
                        message_of("column_twice", in_quotes(is_new ? column_name(value) : value.name)));
    }
}

void check_study(TomlTable& top, Study& study) {
    TomlFile& file = top.file();
    for (const char* needed : {"title", "scene", "measures", "value"})
        if (!top.has(needed) && !top.fail_if_misspelt(needed, {}, {}))
            file.add(needed, error_of(message_of("missing_in_study", needed), file.name));
    for (std::size_t i = 0; i < study.values.size(); ++i)
        check_value({file, list_at(top, "value")[i], fmt::format("value.{}", i + 1)}, study.values[i]);
    if (top.has("measures") && study.measure_words.empty())
        top.fail("measures", message_of("missing_in_study", "measures"));
    read_measures(top, study);
    check_names(top, study);
    if (!file.failed() && study.runs() > limits::study_runs)
        top.fail("value", message_of("too_many_runs", study.runs(), limits::study_runs));
}

Study read_study_file(TomlFile& file) {
    Study study;
    study.id = std::filesystem::path(file.name).stem().string();
    study.file = file.name;
    TomlTable top = read_top(file, study);
    check_study(top, study);
    note_lines(top, study);
    return study;
}

}  // namespace

std::size_t Study::combinations() const {
    std::size_t product = 1;
    for (const StudyValue& value : values) product *= value.levels.size();
    return product;
}

Result<Study> parse_study(std::string_view toml, const std::string& file_name) {
    return read_whole(toml, file_name, read_study_file);
}

ReadFile<Study> read_study_fully(std::string_view toml, const std::string& file_name) {
    return read_fully(toml, file_name, read_study_file);
}

std::string write_study(const Study& study) { return write_top(study); }

std::vector<std::size_t> levels_of(const Study& study, std::size_t combination) {
    std::vector<std::size_t> levels(study.values.size());
    for (std::size_t i = levels.size(); i-- > 0;) {
        const std::size_t count = study.values[i].levels.size();
        levels[i] = combination % count;
        combination /= count;
    }
    return levels;
}

std::string column_name(const StudyValue& value) {
    struct Sign {
        std::string_view sign, words;
    };
    constexpr std::array signs{Sign{"°", "deg"}, Sign{"%", "percent"}, Sign{"²", "2"}, Sign{"³", "3"}, Sign{"µ", "u"},
                               Sign{"Ω", "ohm"}, Sign{"·", "_"},       Sign{"/", "_"}, Sign{" ", "_"}};
    std::string ending;
    for (std::string_view unit = value.unit; !unit.empty();) {
        const auto known =
            std::find_if(signs.begin(), signs.end(), [&](const Sign& each) { return unit.starts_with(each.sign); });
        ending += known == signs.end() ? unit.substr(0, 1) : known->words;
        unit.remove_prefix(known == signs.end() ? 1 : known->sign.size());
    }
    if (ending.empty() || value.name.ends_with("_" + ending)) return value.name;
    return value.name + "_" + ending;
}

std::string level_text(const StudyValue& value, std::size_t level) {
    const bool is_word = !value.unit.empty() && std::isalpha(static_cast<unsigned char>(value.unit.front()));
    return fmt::format("{:g}{}{}", value.levels[level], is_word ? " " : "", value.unit);
}

std::string combination_text(const Study& study, std::size_t combination) {
    const std::vector<std::size_t> levels = levels_of(study, combination);
    std::string text;
    for (std::size_t i = 0; i < levels.size(); ++i)
        text += fmt::format("{}{} {}", i > 0 ? ", " : "", study.values[i].name, level_text(study.values[i], levels[i]));
    return text;
}

std::vector<TranslatableText> texts_of(const Study& study) {
    const std::string begin = "study." + study.id + ".";
    std::vector<TranslatableText> texts{{begin + "title", study.title}};
    if (!study.story.empty()) texts.push_back({begin + "story", study.story});
    for (std::size_t i = 0; i < study.values.size(); ++i)
        texts.push_back({fmt::format("{}value.{}", begin, i + 1), study.values[i].name});
    if (!study.axis.x.empty()) texts.push_back({begin + "axis.x", study.axis.x});
    if (!study.axis.y.empty()) texts.push_back({begin + "axis.y", study.axis.y});
    return texts;
}

std::string describe_study_format() {
    std::string text = describe_top<Study>() +
                       "\n## Measures\n\nThe words of `measures`.\n\n| Measure | Unit | Meaning |\n|---|---|---|\n";
    for (const StudyMeasureTraits& row : study_measure_table)
        text += fmt::format("| `{}` | {} | {} |\n", row.word, row.unit, row.meaning);
    return text;
}

}  // namespace insight

}  // namespace braitenlab
