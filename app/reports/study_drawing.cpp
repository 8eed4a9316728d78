#include "app/reports/study_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/reports/axes.h"
#include "app/reports/svg_file.h"
#include "ui/words/measure_text.h"

namespace braitenlab {

namespace {

using insight::Study;

constexpr float panel_width = 520, panel_height = 260, panel_step = 350, panel_left = 92, panel_top = 60,
                panel_legend = 260;             // px
constexpr float wanted_aside = 6;               // px, between bars; several are within a point of 8 px
constexpr float never_row = 16, never_gap = 6;  // px, of each series in the strip above the frame
std::string with_unit(std::string_view name, std::string_view unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

struct SeriesPoint {
    double x = 0;
    maths::Spread spread;
    std::size_t never = 0;  // runs
};

class StudyPanels {
public:
    StudyPanels(const Study& study, const std::vector<insight::StudyRow>& rows, const Strings& strings)
        : study_(study), rows_(rows), strings_(strings) {
        for (std::size_t i = 1; i < study.values.size(); ++i)
            if (study.values[i].levels.size() > study.values[across_].levels.size()) across_ = i;
        for (std::size_t i = 0; i < study.combinations(); ++i)
            if (const std::string name = series_of(i); std::find(names_.begin(), names_.end(), name) == names_.end())
                names_.push_back(name);
        const auto [low, high] = std::minmax_element(levels().begin(), levels().end());
        const double room = *high > *low ? (*high - *low) * 0.05 : 0.5;
        from_ = *low - room, to_ = *high + room;
        aside_ = room_aside();
    }

    std::string x_label() const { return with_unit(name_of(across_), study_.values[across_].unit); }

    std::string panel(std::size_t measure, const std::string& x_label, const std::string& y_label) const {
        const std::vector<std::vector<SeriesPoint>> series = points_of(measure);
        double low = INFINITY, high = -INFINITY;
        for (const auto& points : series)
            for (const SeriesPoint& point : points)
                for (const double number : {point.spread.lower, point.spread.median, point.spread.upper})
                    if (point.spread.count > 0 && std::isfinite(number))
                        low = std::min(low, number), high = std::max(high, number);
        if (low > high) low = 0, high = 1;
        constexpr double small_difference = 0.25;  // of the numbers: from 0 on, a small difference looks small
        if (low >= 0 && high - low < small_difference * high) low = 0;
        const double room = high > low ? (high - low) * 0.08 : 0.5;  // no point is on the frame
        const double below = high > low || low < 0 ? room : 0.1 * room;
        const float strip = height_of_never(series);
        const PlotFrame frame{panel_width, panel_height - strip, {from_, to_}, {low - below, high + room}};
        std::string out = frame_svg(frame, x_label, y_label, strings_);
        for (std::size_t i = 0; i < series.size(); ++i) out += line(series[i], i, frame);
        out += empty_places(series, frame);
        return strip > 0 ? placed(0, strip, out) + never_strip(series, frame, strip - never_gap) : out;
    }

    bool has_series() const { return names_.size() > 1; }

    // True if a run has no finite number because it never comes to it.
    bool has_never(std::size_t measure) const { return height_of_never(points_of(measure)) > 0; }

    bool has_every_value(std::size_t measure) const {
        for (std::size_t i = 0; i < study_.combinations(); ++i)
            if (!has_value(insight::summary_of(study_, rows_, i, measure).spread)) return false;
        return true;
    }

    std::string legend() const {
        std::string out;
        for (std::size_t i = 0; i < names_.size() && !names_.front().empty(); ++i) {
            const float y = 8 + 22 * static_cast<float>(i);
            out += fmt::format("<path d=\"M0 {:.1f}h22\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", y, colour(i),
                               dashes(i)) +
                   words_at(30, y + 5, names_[i]);
        }
        return out;
    }

private:
    static bool has_value(const maths::Spread& spread) { return spread.count > 0; }

    // By series, in the order of the levels.
    std::vector<std::vector<SeriesPoint>> points_of(std::size_t measure) const {
        std::vector<std::vector<SeriesPoint>> series(names_.size());
        for (std::size_t i = 0; i < study_.combinations(); ++i) {
            const insight::StudySummary summary = insight::summary_of(study_, rows_, i, measure);
            const auto name =
                static_cast<std::size_t>(std::find(names_.begin(), names_.end(), series_of(i)) - names_.begin());
            series[name].push_back({levels()[levels_of(study_, i)[across_]], summary.spread,
                                    summary.spread.count - std::min(summary.present, summary.spread.count)});
        }
        for (auto& points : series)
            std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        return series;
    }

    // Of the strip with a row for each series, and the gap below it; 0 without a run that never comes to a number.
    float height_of_never(const std::vector<std::vector<SeriesPoint>>& series) const {
        for (const auto& points : series)
            for (const SeriesPoint& point : points)
                if (point.never > 0) return never_row * static_cast<float>(names_.size()) + never_gap;
        return 0;
    }

    // Above the frame, at the side of more: how many runs never come to a number, beside a ring at the level where the
    // median does not.
    std::string never_strip(const std::vector<std::vector<SeriesPoint>>& series, const PlotFrame& frame,
                            float height) const {
        std::string out = fmt::format("<rect width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"{}\"/>\n",
                                      frame.width, height, axis_ink) +
                          words_at(-8, height / 2 + 5, strings_("map.never"), " text-anchor=\"end\"");
        for (std::size_t i = 0; i < series.size(); ++i)
            for (const SeriesPoint& point : series[i]) {
                if (point.never == 0) continue;
                const float x = frame.x_of(point.x), y = never_row * (static_cast<float>(i) + 0.5f);
                const bool has_ring = !std::isfinite(point.spread.median);
                if (has_ring) out += ring(x, y, i);
                out += words_at(
                    has_ring ? x + 8 : x, y + 5, std::to_string(point.never),
                    fmt::format(" text-anchor=\"{}\" style=\"fill:{}\"", has_ring ? "start" : "middle", colour(i)));
            }
        return out;
    }

    static std::string ring(float x, float y, std::size_t series) {
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"#fff\" stroke=\"{}\"/>\n", x, y,
                           colour(series));
    }

    const std::vector<double>& levels() const { return study_.values[across_].levels; }

    // The other values of a combination, "speed 1.3 m/s"; empty for a study of one value.
    std::string series_of(std::size_t combination) const {
        const std::vector<std::size_t> levels = levels_of(study_, combination);
        std::string text;
        for (std::size_t i = 0; i < levels.size(); ++i)
            if (i != across_)
                text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name_of(i),
                                    ui::level_words(strings_, study_.values[i], levels[i]));
        return text;
    }

    std::string name_of(std::size_t value) const {
        return std::string(strings_.find(study_.values[value].name, study_.values[value].name));
    }
    static const char* colour(std::size_t i) { return series_colours[i % series_colours.size()]; }
    static const char* dashes(std::size_t i) { return i < series_colours.size() ? "" : " stroke-dasharray=\"6 4\""; }
    // Bars of several series stand side by side, within half of the gap between two levels. Points and lines are at
    // the level.
    float room_aside() const {
        std::vector<double> sorted = levels();
        std::sort(sorted.begin(), sorted.end());
        double gap = to_ - from_;
        for (std::size_t i = 1; i < sorted.size(); ++i)
            if (sorted[i] > sorted[i - 1]) gap = std::min(gap, sorted[i] - sorted[i - 1]);
        const auto pixels = static_cast<float>(gap / (to_ - from_)) * panel_width;
        return std::min(wanted_aside, 0.5f * pixels / static_cast<float>(names_.size()));
    }

    // At the edge of the frame: a quartile that is not finite.
    static float y_of(const PlotFrame& frame, double y) {
        if (!std::isfinite(y)) return y > 0 ? 0 : frame.height;
        return frame.y_of(y);
    }

    // A gap where the median is no number.
    std::string line(const std::vector<SeriesPoint>& points, std::size_t index, const PlotFrame& frame) const {
        std::string path, bars, dots;
        bool goes_on = false;
        for (const SeriesPoint& point : points) {
            const bool has_median = has_value(point.spread) && std::isfinite(point.spread.median);
            const float x = frame.x_of(point.x), y = has_median ? y_of(frame, point.spread.median) : 0;
            if (has_median) {
                path += fmt::format("{}{:.1f} {:.1f}", goes_on ? 'L' : 'M', x, y);
                dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>\n", x, y);
            }
            goes_on = has_median;
            if (has_value(point.spread) && std::isfinite(point.spread.lower))
                bars += fmt::format("M{:.1f} {:.1f}V{:.1f}", x + aside_of(index), y_of(frame, point.spread.lower),
                                    y_of(frame, point.spread.upper));
        }
        if (path.empty() && bars.empty()) return "";
        return fmt::format(
            "<g stroke=\"{0}\" fill=\"{0}\"><path d=\"{1}\" fill=\"none\" stroke-width=\"2\"{2}/>\n"
            "<path d=\"{3}\" fill=\"none\" stroke-width=\"1.5\"/>\n{4}</g>\n",
            colour(index), path, dashes(index), bars, dots);
    }

    float aside_of(std::size_t series) const {
        return aside_ * (static_cast<float>(series) - static_cast<float>(names_.size() - 1) / 2);
    }

    // Rings above each other at the lower edge for the series without a value at a level, and words where no series has
    // one.
    std::string empty_places(const std::vector<std::vector<SeriesPoint>>& series, const PlotFrame& frame) const {
        std::string out;
        std::map<double, std::size_t> series_without;
        for (std::size_t i = 0; i < series.size(); ++i)
            for (const SeriesPoint& point : series[i]) {
                if (has_value(point.spread)) continue;
                const float x = frame.x_of(point.x);
                std::size_t& without = series_without[point.x];
                out += ring(x, frame.height - 7 - 9 * static_cast<float>(without), i);
                if (++without == names_.size())
                    out += words_at(0, 0, strings_("report.no_value"),
                                    fmt::format(" transform=\"translate({:.1f} {:.1f}) rotate(-90)\"", x + 5,
                                                frame.height - 9 - 9 * static_cast<float>(without)));
            }
        return out;
    }

    const Study& study_;
    const std::vector<insight::StudyRow>& rows_;
    const Strings& strings_;
    std::size_t across_ = 0;          // the value along the horizontal axis
    std::vector<std::string> names_;  // of the series
    double from_ = 0, to_ = 1;        // of the horizontal axis
    float aside_ = 0;                 // px, between two series
};

}  // namespace

std::string study_drawing(const Study& study, const std::vector<insight::StudyRow>& rows, const FigureLabels& given,
                          const Strings& strings) {
    const StudyPanels panels(study, rows, strings);
    const auto first_of = [](const std::string& one, std::string_view other) {
        return one.empty() ? std::string(other) : one;
    };
    const auto own = [&](const std::string& words) { return strings.find(words, words); };
    const FigureLabels labels{given.title, first_of(given.x, own(study.axis.x)), first_of(given.y, own(study.axis.y))};
    const std::string x_label = first_of(labels.x, panels.x_label());
    std::string drawn;
    for (std::size_t i = 0; i < study.measures.size(); ++i) {
        const insight::StudyMeasureTraits& traits = row_of(study.measures[i]);
        const bool is_labelled = i == 0 && !labels.y.empty();
        const std::string y_label =
            is_labelled ? labels.y : with_unit(strings("study.measure." + std::string(traits.word)), traits.unit);
        drawn += placed(panel_left, panel_top + panel_step * static_cast<float>(i), panels.panel(i, x_label, y_label));
    }
    drawn += placed(panel_left + panel_width + 24, panel_top, panels.legend());
    std::vector<std::string> caption{
        fill(strings("report.study_bars"), {std::to_string(study.seeds), tick_text(study.seconds, 1, strings)})};
    bool has_every_value = true, has_never = false;
    for (std::size_t i = 0; i < study.measures.size(); ++i)
        has_every_value &= panels.has_every_value(i), has_never |= panels.has_never(i);
    if (!has_every_value) caption[0] += " ○: " + std::string(strings("report.no_value")) + ".";
    if (has_never) caption.emplace_back(fill(strings("report.study_never"), {std::to_string(study.seeds)}));
    if (panels.has_series()) caption.emplace_back(strings("report.study_aside"));
    constexpr float line = 18;
    float below = panel_top + panel_step * static_cast<float>(study.measures.size()) - line;
    for (const std::string& words : caption) drawn += words_at(panel_left, below, words), below += line;
    return svg_file(labels.title.empty() ? strings.find(study.title, study.title) : labels.title,
                    panel_left + panel_width + panel_legend, below + 10, drawn);
}

}  // namespace braitenlab
