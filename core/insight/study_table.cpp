#include "core/insight/study_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "core/io/csv.h"

namespace braitenlab::insight {

std::string study_header(const Study& study) {
    std::string line = "run,seed";
    for (const StudyValue& value : study.values)
        line += ',', io::add_csv_cell(line, std::string_view(column_name(value)));
    for (const StudyMeasure measure : study.measures) line += "," + column_name(row_of(measure));
    return line + '\n';
}

namespace {

std::string first_cells(const StudyBase& base, std::size_t run) {
    std::string line = fmt::format("{},{}", run + 1, base.seed_of(run));
    const std::vector<std::size_t> levels = levels_of(base.study(), base.combination_of(run));
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::vector<double>& all = base.study().values[i].levels;
        const bool are_whole =
            std::all_of(all.begin(), all.end(), [](double level) { return level == std::floor(level); });
        line += ',' + (are_whole ? fmt::format("{:.0f}", all[levels[i]]) : io::real_text(all[levels[i]], 10));
    }
    return line;
}

}  // namespace

std::string study_line(const StudyBase& base, std::size_t run, const StudyRow& row) {
    std::string line = first_cells(base, run);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const bool is_count = row_of(base.study().measures[i]).unit.empty();
        line += ',' + (is_count && std::isfinite(row[i]) ? fmt::format("{:.0f}", row[i]) : io::real_text(row[i]));
    }
    return line + '\n';
}

std::optional<StudyRow> read_study_line(const StudyBase& base, std::size_t run, std::string_view line) {
    const std::string first = first_cells(base, run);
    if (!line.starts_with(first) || !line.ends_with('\n')) return std::nullopt;
    std::string cells(line.substr(first.size(), line.size() - first.size() - 1));
    StudyRow row;
    for (std::size_t at = 0; at < cells.size();) {
        if (cells[at] != ',') return std::nullopt;
        const std::size_t end = std::min(cells.find(',', at + 1), cells.size());
        const std::string cell = cells.substr(at + 1, end - at - 1);
        char* rest = nullptr;
        const bool is_touch = row.size() < base.study().measures.size() &&
                              base.study().measures[row.size()] == StudyMeasure::time_to_touch;
        const double none =
            is_touch ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
        row.push_back(cell.empty() ? none : std::strtod(cell.c_str(), &rest));
        if (rest && *rest != '\0') return std::nullopt;
        at = end;
    }
    if (row.size() != base.study().measures.size()) return std::nullopt;
    return row;
}

StudySummary summary_of(const Study& study, const std::vector<StudyRow>& rows, std::size_t combination,
                        std::size_t measure) {
    const auto seeds = static_cast<std::size_t>(study.seeds);
    const auto number = [&](std::size_t of, std::size_t seed) {
        const std::size_t run = of * seeds + seed;
        return run < rows.size() && measure < rows[run].size() ? rows[run][measure]
                                                               : std::numeric_limits<double>::quiet_NaN();
    };
    StudySummary summary;
    std::vector<double> numbers, differences;
    for (std::size_t seed = 0; seed < seeds; ++seed) {
        const double own = number(combination, seed), first = number(0, seed);
        if (std::isnan(own)) continue;
        numbers.push_back(own);
        summary.present += std::isfinite(own);
        if (std::isnan(first)) continue;
        ++summary.pairs;
        summary.more += own > first, summary.less += own < first;
        if (std::isfinite(own) && std::isfinite(first)) differences.push_back(own - first);
    }
    summary.paired = differences.empty() ? std::numeric_limits<double>::quiet_NaN()
                                         : maths::spread_of(std::move(differences)).median;
    summary.spread = maths::spread_of(std::move(numbers));
    return summary;
}

}  // namespace braitenlab::insight
