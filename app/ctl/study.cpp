// braitenctl study: the runs of a study as a table, with medians and quartiles.
#include "core/insight/study.h"

#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/parts.h"
#include "app/ctl/progress.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/files/study_files.h"
#include "app/reports/study_drawing.h"
#include "app/terminal.h"
#include "core/insight/study_table.h"
#include "core/io/checked_json.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;
using insight::Study;
using insight::StudyBase;
using insight::StudyRow;
using insight::StudySummary;

// Another process reads the same files; the fingerprint tells whether they are the same there.
std::string text_of_runs(const fs::path& path, const StudyBase& base, std::size_t first) {
    return fmt::format("study\n{} {}\n{}", base.fingerprint(), first, fs::absolute(path).string());
}

Part part_of_runs(const std::shared_ptr<const StudyBase>& base, std::size_t first) {
    return [base, first](std::size_t part) { return insight::run_of(base, first + part); };
}

// Runs those that are missing. Returns false when the user has interrupted the program.
Result<bool> compute(const fs::path& path, const std::shared_ptr<const StudyBase>& base, int threads,
                     StudyTable& table) {
    PartRunner runner(threads);
    Progress progress = progress_of("runs", base->study().runs(), table.rows().size());
    const std::size_t batch = 4 * static_cast<std::size_t>(std::max(1, runner.threads()));
    while (table.rows().size() < base->study().runs()) {
        const std::size_t first = table.rows().size();
        const auto results = runner.run({std::min(batch, base->study().runs() - first), part_of_runs(base, first),
                                         [&] { return text_of_runs(path, *base, first); }});
        if (!results) return results.error();
        if (results->empty()) return false;
        if (const auto error = table.add(*results)) return *error;
        progress.at(table.rows().size());
    }
    return true;
}

std::string cell_text(double number) {
    if (std::isnan(number)) return "–";
    return std::isinf(number) ? "never" : fmt::format("{:.4g}", number);
}

std::string range_text(double low, double high) { return fmt::format("{} .. {}", cell_text(low), cell_text(high)); }

std::string difference_text(double number) { return std::isnan(number) ? "–" : fmt::format("{:+.4g}", number); }

std::string heading_of(const Study& study, insight::StudyMeasure measure) {
    const insight::StudyMeasureTraits& traits = row_of(measure);
    const std::string name =
        fmt::format("{}{}", traits.word, traits.unit.empty() ? "" : fmt::format(" ({})", traits.unit));
    const std::string present = may_be_absent(measure) ? fmt::format(" {:>8}", fmt::format("of {}", study.seeds)) : "";
    return fmt::format("{:<28}{} {:>8}  {:^18} {:^18} {:>10} {:>5} {:>5}\n", name, present, "median", "quartiles",
                       "range", "difference", "more", "less");
}

std::string line_of(const Study& study, const std::vector<StudyRow>& rows, std::size_t combination,
                    std::size_t measure) {
    const StudySummary summary = summary_of(study, rows, combination, measure);
    const maths::Spread& s = summary.spread;
    std::string line = format_lines("{:<28}", combination_text(study, combination));
    if (may_be_absent(study.measures[measure])) line += fmt::format(" {:>8}", summary.present);
    // Without a run that has a number, the spread is that of no numbers.
    const double none = s.count == 0 ? NAN : 0;
    line += fmt::format(" {:>8}  {:^18} {:^18}", cell_text(s.median + none), range_text(s.lower + none, s.upper + none),
                        range_text(s.least + none, s.most + none));
    if (combination > 0)
        line += fmt::format(" {:>10} {:>5} {:>5}", difference_text(summary.paired), summary.more, summary.less);
    return line + '\n';
}

// A table for each measure. The last columns compare each run with the run of the first row that has the same seed.
std::string summary_text(const Study& study, const std::vector<StudyRow>& rows) {
    std::string text;
    bool has_absent = false, has_never = false;
    for (const StudyRow& row : rows)
        has_never |= std::any_of(row.begin(), row.end(), [](double number) { return std::isinf(number); });
    for (std::size_t measure = 0; measure < study.measures.size(); ++measure) {
        has_absent |= may_be_absent(study.measures[measure]);
        text += (measure > 0 ? "\n" : "") + heading_of(study, study.measures[measure]);
        for (std::size_t i = 0; i < study.combinations(); ++i) text += line_of(study, rows, i, measure);
    }
    text += fmt::format(
        "\n{} runs of each row. Difference, more and less: against the first row, run by run with the same seed.\n",
        study.seeds);
    if (has_absent)
        text += fmt::format("of {}: runs that have the number, i.e. touch or have an object. –: there is none.\n",
                            study.seeds);
    if (has_never)
        text +=
            "A median and a quartile count never as the longest time. The cell of such a run is empty in the CSV, so "
            "that the\n"
            "median of the column alone, as in pandas, is smaller.\n";
    return text;
}

nlohmann::ordered_json number_or_null(double number) {
    return std::isfinite(number) ? nlohmann::ordered_json(number) : nullptr;
}

std::string summary_json(const Study& study, const std::vector<StudyRow>& rows) {
    nlohmann::ordered_json json;
    json["title"] = study.title, json["runs"] = study.runs(), json["seeds"] = study.seeds;
    auto& list = json["results"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < study.combinations(); ++i)
        for (std::size_t measure = 0; measure < study.measures.size(); ++measure) {
            const StudySummary summary = summary_of(study, rows, i, measure);
            nlohmann::ordered_json row;
            const std::vector<std::size_t> levels = levels_of(study, i);
            for (std::size_t k = 0; k < levels.size(); ++k)
                row["values"][study.values[k].name] = study.values[k].levels[levels[k]];
            row["measure"] = word(study.measures[measure]);
            const maths::Spread& s = summary.spread;
            row["runs"] = s.count, row["present"] = summary.present;
            row["median"] = number_or_null(s.median);
            row["quartiles"] = {number_or_null(s.lower), number_or_null(s.upper)};
            row["range"] = {number_or_null(s.least), number_or_null(s.most)};
            row["paired"] = {
                {"median", number_or_null(summary.paired)}, {"above", summary.more}, {"below", summary.less}};
            list.push_back(std::move(row));
        }
    return io::json_text(json, 2) + "\n";
}

}  // namespace

Result<Part> part_of_study(std::string_view text) {
    std::istringstream in{std::string(text)};
    std::uint64_t fingerprint = 0;
    std::size_t first = 0;
    std::string path;
    in >> fingerprint >> first >> std::ws;
    std::getline(in, path, '\0');
    const auto base = load_study(path);
    if (!base) return base.error();
    if ((*base)->fingerprint() != fingerprint) return Error{"the study or its scene is another one here", path};
    return part_of_runs(*base, first);
}

int study(const StudyOptions& options) {
    const auto path = find_shipped(options.file, Shipped::study);
    if (!path) return complain(path.error());
    const auto base = load_study(*path);
    if (!base) return complain_of_all(errors_of_study(*path));
    const bool prints = options.csv == standard_output;
    if (const auto error = json_beside_csv(options.csv, options.json)) return complain(*error);
    const auto style = style_of(options.table);
    if (!style) return complain(style.error());
    if (const auto error = ending_fault("--svg", options.svg, ".svg")) return complain(*error);
    const auto strings = strings_with(options.table.language, texts_of((*base)->study()));
    if (!strings) return complain(strings.error());
    StudyTable table(*base, prints ? "" : options.csv);
    if (const auto error = table.begin()) return complain(*error);
    const std::size_t kept = table.rows().size();
    if (kept > 0)
        std::cerr << format_lines("braitenctl: {} of {} runs are in {}\n", kept, (*base)->study().runs(),
                                  table.unfinished().string());
    const auto complete = compute(*path, *base, options.threads, table);
    if (!complete) return complain(complete.error());
    if (!*complete) {
        if (table.unfinished().empty()) return interrupted();
        std::cerr << format_lines("braitenctl: interrupted after {} of {} runs; the same command continues with {}\n",
                                  table.rows().size(), (*base)->study().runs(), table.unfinished().string());
        return exit_code::interrupted;
    }
    if (const auto error = table.finish(*style)) return complain(*error);
    const Study& done = (*base)->study();
    if (!options.svg.empty())
        if (const auto error = write_whole(options.svg, study_drawing(done, table.rows(), options.labels, *strings)))
            return complain(*error);
    if (prints) {
        const auto error = write_table(options.csv, *style, table.text());
        return error ? complain(*error) : exit_code::done;
    }
    std::cout << (options.json ? summary_json(done, table.rows()) : summary_text(done, table.rows()));
    return exit_code::done;
}

}  // namespace braitenlab
